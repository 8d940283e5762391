//! The colours of a picture.

use super::Rgb;
use core::ops::Deref;

/// The colours that the surfaces of a picture have, before they are lit.
///
/// A link codes pixels by them: a lit pixel is a colour and a level. A picture says them by
/// [`RowSource::palette`](super::RowSource::palette). A colour that is left out costs bytes on the link,
/// and nothing else.
///
/// ```
/// use scancsg::render::{Palette, Rgb};
///
/// let (steel, brass) = (Rgb::new(150, 160, 170), Rgb::new(200, 170, 80));
/// let palette: Palette = [steel, brass, steel].into_iter().collect();
/// assert_eq!(*palette, [steel, brass]);
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Palette {
    /// Behind the last one, white ones: so equal palettes are equal bit by bit.
    colors: [Rgb; Self::CAPACITY],
    len: u8,
}

impl Palette {
    /// The most colours that are kept; more are left out.
    pub const CAPACITY: usize = 7;

    /// No colours.
    pub const EMPTY: Self = Self { colors: [Rgb::WHITE; Self::CAPACITY], len: 0 };

    /// Takes in a colour, unless it is here already or there is no place.
    pub fn add(&mut self, color: Rgb) {
        if !self.contains(&color)
            && let Some(place) = self.colors.get_mut(usize::from(self.len))
        {
            *place = color;
            self.len += 1;
        }
    }
}

impl Deref for Palette {
    type Target = [Rgb];

    fn deref(&self) -> &[Rgb] {
        self.colors.get(..usize::from(self.len)).unwrap_or_default()
    }
}

impl FromIterator<Rgb> for Palette {
    fn from_iter<I: IntoIterator<Item = Rgb>>(colors: I) -> Self {
        let mut palette = Self::EMPTY;
        colors.into_iter().for_each(|color| palette.add(color));
        palette
    }
}

impl Default for Palette {
    fn default() -> Self {
        Self::EMPTY
    }
}

impl core::fmt::Debug for Palette {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Palette {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "{=[?]}", **self);
    }
}
