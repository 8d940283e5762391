//! Pictures on the displays of `embedded-graphics`, beside its text and shapes.

use super::error::DisplayError;
use crate::render::pixel::same_bits::same_bits;
use crate::render::pixel::{Pixel, narrow, scale};
use crate::render::{Gray8, Mono, Rgb, Rgb565, Rgb888, RowError, RowSource};
use core::fmt;
use core::ops::Range;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::pixelcolor::{
    self, BinaryColor, GrayColor, RgbColor,
    raw::{RawData, RawU16},
};
use embedded_graphics_core::primitives::Rectangle;

/// Why a picture can't be drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum DrawError<E> {
    /// A row can't be rendered.
    Render(RowError),
    /// The target can't draw.
    Target(E),
}

impl<E> DrawError<E> {
    /// What is wrong, in a sentence. Of a target's own error only that there is one:
    /// [`source`](core::error::Error::source) has the rest.
    #[must_use]
    pub const fn as_str(&self) -> &'static str {
        match self {
            Self::Render(error) => error.as_str(),
            Self::Target(_) => "drawing on the target failed",
        }
    }
}

impl<E> From<RowError> for DrawError<E> {
    fn from(error: RowError) -> Self {
        Self::Render(error)
    }
}

impl<E> From<DrawError<E>> for crate::Error {
    fn from(error: DrawError<E>) -> Self {
        match error {
            DrawError::Render(error) => error.into(),
            DrawError::Target(_) => DisplayError::Draw.into(),
        }
    }
}

impl<E> fmt::Display for DrawError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

impl<E: core::error::Error + 'static> core::error::Error for DrawError<E> {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Render(error) => Some(error),
            Self::Target(error) => Some(error),
        }
    }
}

/// Pixels of one colour from here on are a rectangle of their own. A display takes 11 bytes for where a
/// rectangle is, and two more rectangles can be needed.
const FILLED: usize = 16;

/// Draws a picture with its upper left corner `at` a point of the target, as far as it lies inside `window`.
///
/// Rows outside aren't rendered. `row` is memory, as long as the picture is wide. Pixels of one colour next to
/// each other, such as the background, are filled; the others of a row go to the target together.
///
/// ```
/// use embedded_graphics::mock_display::MockDisplay;
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
/// use embedded_graphics::prelude::*;
/// use embedded_graphics::primitives::Rectangle;
/// use scancsg::geom::vec3;
/// use scancsg::interop::embedded_graphics::draw;
/// use scancsg::render::{self, Lambert, Orthographic, Picture};
/// use scancsg::solid::Sphere;
///
/// let ball = Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)?;
/// let (eye, target, up) = (vec3(0.0, 0.0, 5.0), vec3(0.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
/// let camera = Orthographic::look_at(eye, target, up, 2.0)?;
/// let light = Lambert::new(vec3(0.0, 0.0, 1.0), 1.0)?; // all of it ambient
/// // Pixels of the crate, or the target's own as here.
/// let mut picture =
///     Picture::new(&ball, &camera, render::Size::new(8, 8)?, light, Rgb565::BLUE);
///
/// let mut display = MockDisplay::<Rgb565>::new();
/// let mut row = [Rgb565::BLUE; 8];
/// let window = Rectangle::new(Point::zero(), Size::new(8, 4));
/// draw(&mut picture, Point::new(2, 1), &mut row, &mut display, &window)?;
/// display.assert_pattern(&[
///     "        ", // outside of the picture
///     "  BBWWWW", // and of the window
///     "  BWWWWW",
///     "  WWWWWW",
/// ]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`DrawError::Render`] with what the source says; [`RowError::Length`] is about `row`.
/// [`DrawError::Target`] with what the target says. Rows above are drawn then.
pub fn draw<S, D>(
    source: &mut S,
    at: Point,
    row: &mut [S::Pixel],
    target: &mut D,
    window: &Rectangle,
) -> Result<(), DrawError<D::Error>>
where
    S: RowSource + ?Sized,
    S::Pixel: Copy + PartialEq + Into<D::Color>,
    D: DrawTarget,
{
    let (size, areas) = (source.size(), [*window, target.bounding_box()]);
    let columns = common(at.x, size.width(), areas.map(|area| (area.top_left.x, area.size.width)));
    let rows = common(at.y, size.height(), areas.map(|area| (area.top_left.y, area.size.height)));
    if columns.is_empty() {
        return Ok(());
    }
    for y in rows {
        source.render(y, row)?;
        let pixels = row.get(usize::from(columns.start)..usize::from(columns.end));
        let left = at.x.saturating_add(columns.start.into());
        let corner = Point::new(left, at.y.saturating_add(y.into()));
        draw_row(pixels.unwrap_or_default(), corner, target).map_err(DrawError::Target)?;
    }
    Ok(())
}

/// The part of the pixels `0..count`, the first of them at `at`, that lies in both areas, as far as points
/// have coordinates.
fn common(at: i32, count: u16, areas: [(i32, u32); 2]) -> Range<u16> {
    let (mut start, mut end) = (0, i64::from(count).min((1 << 31) - i64::from(at)));
    for (low, length) in areas {
        let low = i64::from(low) - i64::from(at);
        start = start.max(low);
        end = end.min(low + i64::from(length));
    }
    let [start, end] = [start, end].map(|index| u16::try_from(index.max(0)).unwrap_or(count));
    start..end
}

fn draw_row<P, D>(pixels: &[P], corner: Point, target: &mut D) -> Result<(), D::Error>
where
    P: Copy + PartialEq + Into<D::Color>,
    D: DrawTarget,
{
    let area = |start: usize, count: usize| {
        let left = corner.x.saturating_add(start as i32);
        Rectangle::new(Point::new(left, corner.y), Size::new(count as u32, 1))
    };
    let mixed = |target: &mut D, start: usize, end: usize| match pixels.get(start..end) {
        Some(colors @ [_, ..]) => {
            let colors = colors.iter().map(|pixel| (*pixel).into());
            target.fill_contiguous(&area(start, end - start), colors)
        }
        _ => Ok(()),
    };
    let (mut start, mut end) = (0, 0);
    for equal in pixels.chunk_by(PartialEq::eq) {
        if let [first, ..] = equal
            && equal.len() >= FILLED
        {
            mixed(target, start, end)?;
            target.fill_solid(&area(end, equal.len()), (*first).into())?;
            start = end + equal.len();
        }
        end += equal.len();
    }
    mixed(target, start, end)
}

same_bits! {
    Gray8 = pixelcolor::Gray8, Self::new, |color: pixelcolor::Gray8| color.luma();
    Mono = BinaryColor, Self::from, BinaryColor::is_on;
    Rgb565 = pixelcolor::Rgb565, |bits| RawU16::new(bits).into(), |color| RawU16::from(color).into_inner();
    Rgb888 = pixelcolor::Rgb888, |[r, g, b]: [u8; 3]| Self::new(r, g, b),
        |color: pixelcolor::Rgb888| [color.r(), color.g(), color.b()];
}

/// Its colours are pixels, too.
macro_rules! pixels {
    ($($Color:ident)+) => {$(
        impl Pixel for pixelcolor::$Color {
            fn shaded(color: Rgb, level: u8) -> Self {
                let channel = |value, max: u8| narrow(scale(value, level), max.into()) as u8;
                Self::new(
                    channel(color.r, Self::MAX_R),
                    channel(color.g, Self::MAX_G),
                    channel(color.b, Self::MAX_B),
                )
            }
        }
    )+};
}

pixels! { Rgb555 Bgr555 Rgb565 Bgr565 Rgb666 Bgr666 Rgb888 Bgr888 }

impl Pixel for pixelcolor::Gray8 {
    fn shaded(color: Rgb, level: u8) -> Self {
        Gray8::shaded(color, level).into()
    }
}

impl Pixel for BinaryColor {
    fn shaded(color: Rgb, level: u8) -> Self {
        Mono::shaded(color, level).into()
    }
}
