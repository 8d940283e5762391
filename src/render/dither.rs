//! Grey rows as rows of pixels that are lit or not.

use super::{Gray8, Mono, Palette, RowError, RowSource, RunSource, Size};
use core::ops::Range;

/// A pattern of thresholds that repeats all over the picture (B. E. Bayer, *An optimum method for
/// two-level rendition of continuous-tone pictures*, ICC 1973).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Bayer {
    /// 4 × 4 pixels: 17 shades, in a fine texture.
    Four,
    /// 8 × 8 pixels: 65 shades.
    Eight,
}

impl Bayer {
    /// Whether a pixel of this level is lit at a place. Level 0 never is, level 255 always.
    ///
    /// ```
    /// use scancsg::render::{Bayer, Gray8, Mono};
    ///
    /// let lit = |x| Bayer::Four.dithered(x, 0, Gray8(100)) == Mono(true);
    /// assert_eq!([0, 1, 2, 3].map(lit), [true, false, true, false]);
    /// ```
    #[must_use]
    pub const fn dithered(self, x: u16, y: u16, pixel: Gray8) -> Mono {
        let bits = match self {
            Self::Four => 2,
            Self::Eight => 3,
        };
        // The places that are lit first lie farthest apart: the lowest bits of x and y count most.
        let (mut order, mut bit) = (0, 0);
        while bit < bits {
            order = order << 2 | (x ^ y) >> bit << 1 & 2 | y >> bit & 1;
            bit += 1;
        }
        // Half-way between two of 4ᵇⁱᵗˢ + 1 shades: level/255 > (order + 1/2)/4ᵇⁱᵗˢ.
        let threshold = (2 * order as u32 + 1) * 255;
        Mono((pixel.0 as u32) << (2 * bits + 1) > threshold)
    }
}

/// A grey picture for a display that is black and white, such as an OLED or e-paper: shades become
/// patterns of dots.
///
/// Whether a dot is lit depends on its level and its place alone. So what rests stays as it is while
/// other things move, and rows may be rendered in any order.
///
/// ```
/// use scancsg::geom::vec3;
/// use scancsg::render::{Bayer, Dithered, Gray8, Lambert, Mono, Orthographic, Picture, RowSource, Size};
/// use scancsg::solid::Sphere;
///
/// let ball = Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)?;
/// let (eye, target, up) = (vec3(0.0, 0.0, 5.0), vec3(0.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
/// let camera = Orthographic::look_at(eye, target, up, 2.2)?;
/// let light = Lambert::new(vec3(-1.0, 1.0, 1.0), 0.1)?;
/// let mut grey = Picture::new(&ball, &camera, Size::new(24, 12)?, light, Gray8(0));
///
/// let mut memory = [Gray8(0); 24];
/// let mut picture = Dithered::new(&mut grey, Bayer::Four, &mut memory);
/// let mut row = [Mono(false); 24];
/// let mut art = Vec::new();
/// for y in 0..12 {
///     picture.render(y, &mut row)?;
///     art.push(row.map(|pixel| if pixel.0 { '#' } else { '.' }).iter().collect::<String>());
/// }
/// assert_eq!(art, [
///     "........................",
///     ".........###.#..........",
///     "........#####.#.........",
///     ".......#####.#..........",
///     ".......########.#.......",
///     ".......###.#.#..........",
///     ".......######.#.........",
///     ".......#.#.#............",
///     "........#.#.#...#.......",
///     ".........#..............",
///     "..........#...#.........",
///     "........................",
/// ]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Dithered<'m, S> {
    source: S,
    pattern: Bayer,
    row: &'m mut [Gray8],
}

impl<'m, S: RowSource<Pixel = Gray8>> Dithered<'m, S> {
    /// The rows of `source`, which may be a `&mut` to one, in dots. `row` is memory, as long as a row.
    pub const fn new(source: S, pattern: Bayer, row: &'m mut [Gray8]) -> Self {
        Self { source, pattern, row }
    }

    fn dots(
        &mut self,
        y: u16,
        columns: Range<u16>,
        pixels: &mut [Mono],
        render: impl FnOnce(&mut S, &mut [Gray8]) -> Result<(), RowError>,
    ) -> Result<(), RowError> {
        let row = self.row.get_mut(..pixels.len()).ok_or(RowError::Length)?;
        render(&mut self.source, row)?;
        for ((x, pixel), grey) in columns.zip(pixels).zip(row) {
            *pixel = self.pattern.dithered(x, y, *grey);
        }
        Ok(())
    }
}

impl<S: RowSource<Pixel = Gray8>> RowSource for Dithered<'_, S> {
    type Pixel = Mono;

    fn size(&self) -> Size {
        self.source.size()
    }

    fn render(&mut self, y: u16, pixels: &mut [Mono]) -> Result<(), RowError> {
        let columns = 0..self.size().width();
        self.dots(y, columns, pixels, |source, row| source.render(y, row))
    }

    fn palette(&self) -> Palette {
        self.source.palette()
    }
}

impl<S: RunSource<Pixel = Gray8>> RunSource for Dithered<'_, S> {
    fn render_run(
        &mut self,
        y: u16,
        columns: Range<u16>,
        pixels: &mut [Mono],
    ) -> Result<(), RowError> {
        self.dots(y, columns.clone(), pixels, |source, row| source.render_run(y, columns, row))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_shade_lights_its_share_of_a_tile() {
        for (pattern, side) in [(Bayer::Four, 4), (Bayer::Eight, 8)] {
            for level in 0..=255 {
                let places = (0..side * side).map(|place| (place % side, place / side));
                let lit = places.filter(|&(x, y)| pattern.dithered(x, y, Gray8(level)).0).count();
                let exact = f64::from(level) * f64::from(side * side) / 255.0;
                assert!((lit as f64 - exact).abs() <= 0.5, "{pattern:?} {level}: {lit}");
            }
        }
    }

    #[test]
    fn the_thresholds_are_those_of_bayer() {
        // Limb, Judice and Bayer's matrix: rows of how many dots are lit before this one.
        let order = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];
        for (y, row) in (0..).zip(order) {
            for (x, order) in (0..).zip(row) {
                let levels = (0..=255).filter(|&level| !Bayer::Four.dithered(x, y, Gray8(level)).0);
                let first = levels.count() as u32; // the lowest level that is lit
                assert_eq!(first, (2 * order + 1) * 255 / 32 + 1, "{x}, {y}");
            }
        }
    }

    /// Levels that run with the columns.
    struct Ramp;

    impl RowSource for Ramp {
        type Pixel = Gray8;

        fn size(&self) -> Size {
            Size::new(32, 8).unwrap()
        }

        fn render(&mut self, y: u16, pixels: &mut [Gray8]) -> Result<(), RowError> {
            self.render_run(y, 0..32, pixels)
        }
    }

    impl RunSource for Ramp {
        fn render_run(
            &mut self,
            _: u16,
            columns: Range<u16>,
            pixels: &mut [Gray8],
        ) -> Result<(), RowError> {
            columns.zip(pixels).for_each(|(x, pixel)| *pixel = Gray8(x as u8 * 8));
            Ok(())
        }
    }

    #[test]
    fn runs_have_the_dots_of_the_whole_row() {
        let (mut memory, mut row, mut run) = ([Gray8(0); 32], [Mono(false); 32], [Mono(false); 11]);
        let mut dithered = Dithered::new(Ramp, Bayer::Eight, &mut memory);
        for y in 0..8 {
            dithered.render(y, &mut row).unwrap();
            dithered.render_run(y, 13..24, &mut run).unwrap();
            assert_eq!(row[13..24], run);
        }
        assert!(row.iter().any(|pixel| pixel.0) && row.iter().any(|pixel| !pixel.0));
    }

    #[test]
    fn too_little_memory_is_an_error() {
        let mut memory = [Gray8(0); 31];
        let mut dithered = Dithered::new(Ramp, Bayer::Four, &mut memory);
        assert_eq!(dithered.render(0, &mut [Mono(false); 32]), Err(RowError::Length));
    }
}
