//! Pictures with smooth edges: n × n samples a pixel, but only where an edge is.

use super::picture::{Picture, RowError, Scanline};
use super::{Blend, Camera, Palette, Pixel, Shader, Size};
use crate::geom::Rays;
use crate::scan::{ColumnRun, Scan};
use crate::solid::{Seen, Solid};
use crate::span::Face;
use core::ops::Range;

/// What a smooth picture remembers of a column: of the corner at its left, and of the pixel before.
#[derive(Clone, Copy)]
pub struct SmoothColumn<P: Blend> {
    sum: P::Sum,
    corner: Face,
    is_edge: bool,
}

impl<P: Blend> SmoothColumn<P> {
    /// Memory for a column.
    pub const EMPTY: Self = Self { sum: P::EMPTY, corner: NOTHING, is_edge: false };
}

/// No solid has this face: their number is a `u16`, too.
const NOTHING: Face = Face(u16::MAX);

crate::error_text! {
    /// Why a picture can't be smoothed.
    pub enum SmoothError {
        /// The number of samples is not between 1 and [`Smoothing::MOST_SAMPLES`].
        Samples => "the number of samples across a pixel is not between 1 and 16",
        /// Width or height, times the number of samples, are more than 32,767.
        Size => "the picture has more samples across than there can be",
        /// The memory is not one column longer than the picture is wide.
        Memory => "the memory for smoothing is not one column longer than the picture is wide",
    }
}

/// How a picture is smoothed, and the memory that it takes.
pub struct Smoothing<'m, P: Blend> {
    size: Size,
    samples: u16,
    /// As many columns and rows as steps across the picture, and as corners and points between
    /// them: one more. There are `2n` steps from a corner to the next; the samples are at the odd
    /// ones.
    grid: [Size; 2],
    columns: &'m mut [SmoothColumn<P>],
    /// The row whose upper corners are known, and the columns of which they are.
    held: Option<(u16, Range<u16>)>,
}

impl<'m, P: Blend> Smoothing<'m, P> {
    /// The most samples across a pixel.
    pub const MOST_SAMPLES: u16 = 16;

    /// A picture of `size`, whose edge pixels are the mean of `samples` × `samples` of a regular
    /// grid. `columns` is memory, one column longer than the picture is wide.
    ///
    /// # Errors
    /// [`SmoothError`].
    pub fn new(
        size: Size,
        samples: u16,
        columns: &'m mut [SmoothColumn<P>],
    ) -> Result<Self, SmoothError> {
        if samples == 0 || samples > Self::MOST_SAMPLES {
            return Err(SmoothError::Samples);
        }
        let across = |count: u16, more: u16| count.checked_mul(2 * samples)?.checked_add(more);
        let grid = |more| Size::new(across(size.width(), more)?, across(size.height(), more)?).ok();
        let (Some(without), Some(with)) = (grid(0), grid(1)) else {
            return Err(SmoothError::Size);
        };
        if columns.len() != usize::from(size.width()) + 1 {
            return Err(SmoothError::Memory);
        }
        Ok(Self { size, samples, grid: [without, with], columns, held: None })
    }

    /// The steps from a corner to the next, and the corners of a run of pixels.
    fn part(&mut self, run: &Range<u16>) -> (u32, &mut [SmoothColumn<P>]) {
        let corners = usize::from(run.start)..=usize::from(run.end);
        (2 * u32::from(self.samples), self.columns.get_mut(corners).unwrap_or_default())
    }
}

/// A [`Picture`] with smooth edges, rendered row by row in any order.
///
/// A pixel is inside a surface if its four corners and its middle see the same face, or nothing: it
/// shows what its middle sees, once. Where they don't, it is an edge pixel, and the mean of n × n
/// samples; levels are averaged as they are. A detail smaller than a pixel that lies between the
/// five points isn't seen, as between the middles of an ordinary picture.
///
/// The samples' rays are those of an ordinary picture n times as wide and high, and an edge pixel is
/// the mean of n × n of its pixels; other pixels are an ordinary picture's of the same size. In
/// floating point that is so bit by bit (for pixels that aren't at an edge, if n is a power of two);
/// in fixed point, where the size of a pixel is rounded, there may be a difference in the last place.
///
/// What it costs, for a part of ten cylinders at 160×120, with n = 4 and an orthographic camera:
/// 1,718 pixels (9 %) are edge pixels, and all are found that have different samples. If edge pixels
/// were those that differ from a neighbour, there would be 2,474. Instructions a pixel:
///
/// | | an ordinary picture | with smooth edges | 640×480, for a mean of all |
/// |---|---:|---:|---:|
/// | x86-64, `f32` | 214 | 1,008 | 3,038 |
/// | Cortex-M4F, `f32` | 216 | 1,149 | |
/// | Cortex-M4F, `I16F16` | 637 | 2,648 | |
///
/// In time, on x86-64, that is 5.4 and 13.6 times as long, in `I16F16` 4.2 and 14.2.
///
/// Memory: that of a [`Picture`], and 6 bytes a column in grey, 10 in [`Rgb565`](super::Rgb565).
///
/// ```
/// use scancsg::geom::vec3;
/// use scancsg::render::{
///     Gray8, Lambert, Orthographic, Size, SmoothColumn, SmoothPicture, Smoothing,
/// };
/// use scancsg::solid::Sphere;
///
/// let ball = Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)?;
/// let (eye, target, up) = (vec3(0.0, 0.0, 5.0), vec3(0.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
/// let camera = Orthographic::look_at(eye, target, up, 3.0)?;
/// let light = Lambert::new(vec3(0.0, 0.0, 1.0), 1.0)?; // all of it ambient
///
/// let mut columns = [SmoothColumn::EMPTY; 32 + 1];
/// let smoothing = Smoothing::new(Size::new(32, 24)?, 4, &mut columns)?;
/// let mut picture = SmoothPicture::new(&ball, &camera, smoothing, light, Gray8(0));
/// let mut pixels = [Gray8(0); 32];
/// let mut sum = 0;
/// for y in 0..24 {
///     picture.render(y, &mut pixels)?;
///     sum += pixels.iter().map(|pixel| u32::from(pixel.0)).sum::<u32>();
/// }
/// let area = sum as f32 / 255.0 / 8.0 / 8.0; // a unit is 8 pixels
/// assert!((area - core::f32::consts::PI).abs() < 0.012); // and 3.25 without smoothing
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct SmoothPicture<'a, 'm, T: Scan<R>, R: Rays, H, P: Blend> {
    /// Of all points of the grid; asked for some of them.
    picture: Picture<'a, T, R, H, P>,
    smoothing: Smoothing<'m, P>,
}

impl<'a, 'm, T, R, H, P> SmoothPicture<'a, 'm, T, R, H, P>
where
    R: Rays,
    T: Solid<Scalar = R::Scalar> + Scan<R>,
    H: Shader<R::Scalar>,
    P: Blend,
{
    /// Gets ready to render `solid`, with `background` where no surface is seen.
    #[inline(always)]
    pub fn new<C: Camera<Rays = R>>(
        solid: &'a T,
        camera: &C,
        smoothing: Smoothing<'m, P>,
        shader: H,
        background: P,
    ) -> Self {
        // Steps are pixels of a picture, and its rays run through their middles. With one column
        // and one row more around the same middle, they run through the steps' ends instead.
        let [steps, points] = smoothing.grid;
        let picture = Picture::along(solid, camera.rays(steps), points, shader, background);
        Self { picture, smoothing }
    }

    /// The size in pixels.
    #[must_use]
    pub fn size(&self) -> Size {
        self.smoothing.size
    }

    /// The colours of the solid's faces.
    #[must_use]
    pub fn palette(&self) -> Palette {
        self.picture.palette()
    }

    /// Renders row `y`, counted from the top, into `pixels`.
    ///
    /// A row's bits don't depend on which rows were rendered before. Only its time does: a row
    /// below the last one shares its upper corners with it.
    ///
    /// # Errors
    /// [`RowError::Index`], [`RowError::Range`], [`RowError::Length`] if `pixels` is not as long as the picture is wide;
    /// nothing is written then.
    pub fn render(&mut self, y: u16, pixels: &mut [P]) -> Result<(), RowError> {
        self.render_run(y, 0..self.smoothing.size.width(), pixels)
    }

    /// Renders some columns of row `y`, as [`render`](Self::render) does all. Runs of the same columns share
    /// corners with the row above.
    ///
    /// # Errors
    /// As [`render`](Self::render), with `pixels` as long as there are columns.
    pub fn render_run(
        &mut self,
        y: u16,
        columns: Range<u16>,
        pixels: &mut [P],
    ) -> Result<(), RowError> {
        let Smoothing { size, samples, .. } = self.smoothing;
        if y >= size.height() || columns.end > size.width() {
            return Err(RowError::Index);
        }
        if pixels.len() != columns.len() {
            return Err(RowError::Length);
        }
        if columns.is_empty() {
            return Ok(());
        }
        let top = y * 2 * samples;
        if self.smoothing.held != Some((y, columns.clone())) {
            self.upper_corners(top, &columns)?;
        }
        self.smoothing.held = None;
        self.lower_corners(top + 2 * samples, &columns)?;
        if self.middles(top + samples, &columns, pixels)? {
            for sample in 0..samples {
                self.add_samples(top + 2 * sample + 1, &columns)?;
            }
            self.means(&columns, pixels);
        }
        self.smoothing.held = Some((y + 1, columns));
        Ok(())
    }

    /// Notes what the corners above a row see.
    fn upper_corners(&mut self, y: u16, run: &Range<u16>) -> Result<(), RowError> {
        let (step, columns) = self.smoothing.part(run);
        let (mut walk, mut x) = (Walk::new(self.picture.scanline(y)?), step * u32::from(run.start));
        for column in columns {
            column.corner = face(walk.seen(x));
            x += step;
        }
        Ok(())
    }

    /// Notes what the corners below a row see, and which pixels have corners that differ.
    fn lower_corners(&mut self, y: u16, run: &Range<u16>) -> Result<(), RowError> {
        let (step, columns) = self.smoothing.part(run);
        let (mut walk, mut x) = (Walk::new(self.picture.scanline(y)?), step * u32::from(run.start));
        let mut left = None;
        for column in columns {
            let lower = face(walk.seen(x));
            let both = (column.corner == lower).then_some(lower);
            column.is_edge = both.is_none() || both != left;
            column.corner = lower;
            left = both;
            x += step;
        }
        Ok(())
    }

    /// Renders the pixels whose middle sees what their corners see. Returns whether there are
    /// others.
    fn middles(&mut self, y: u16, run: &Range<u16>, pixels: &mut [P]) -> Result<bool, RowError> {
        let (step, columns) = self.smoothing.part(run);
        let (mut walk, mut x) =
            (Walk::new(self.picture.scanline(y)?), step * u32::from(run.start) + step / 2);
        let mut has_edges = false;
        for (column, pixel) in columns.iter_mut().skip(1).zip(pixels) {
            if !column.is_edge {
                let seen = walk.seen(x);
                column.is_edge = face(seen) != column.corner;
                if !column.is_edge {
                    *pixel = walk.shaded(x, seen);
                }
            }
            if column.is_edge {
                column.sum = P::EMPTY;
                has_edges = true;
            }
            x += step;
        }
        Ok(has_edges)
    }

    /// Adds one row of samples to the edge pixels' sums.
    fn add_samples(&mut self, y: u16, run: &Range<u16>) -> Result<(), RowError> {
        let (step, columns) = self.smoothing.part(run);
        let (mut walk, mut x) =
            (Walk::new(self.picture.scanline(y)?), step * u32::from(run.start) + 1);
        for column in columns.iter_mut().skip(1) {
            if column.is_edge {
                for x in (x..x + step).step_by(2) {
                    let seen = walk.seen(x);
                    walk.shaded(x, seen).add_to(&mut column.sum);
                }
            }
            x += step;
        }
        Ok(())
    }

    /// The edge pixels, when all samples are added up.
    fn means(&mut self, run: &Range<u16>, pixels: &mut [P]) {
        let count = self.smoothing.samples.pow(2);
        for (column, pixel) in self.smoothing.part(run).1.iter().skip(1).zip(pixels) {
            if column.is_edge {
                *pixel = P::mean(column.sum, count);
            }
        }
    }
}

fn face<S>(seen: Option<Seen<S>>) -> Face {
    seen.map_or(NOTHING, |seen| seen.face)
}

/// Points of a row of the grid, from the left to the right.
struct Walk<'p, 'a, T: Scan<R>, R: Rays, H, P> {
    line: Scanline<'p, 'a, T, R, H, P>,
    /// What was entered last.
    run: ColumnRun,
}

impl<'p, 'a, T, R, H, P> Walk<'p, 'a, T, R, H, P>
where
    R: Rays,
    T: Solid<Scalar = R::Scalar> + Scan<R>,
    H: Shader<R::Scalar>,
    P: Pixel,
{
    fn new(line: Scanline<'p, 'a, T, R, H, P>) -> Self {
        Self { line, run: ColumnRun { is_visible: false, until: 0 } }
    }

    /// What a column sees; not one to the left of the last.
    #[inline]
    fn seen(&mut self, column: u32) -> Option<Seen<R::Scalar>> {
        if column >= self.run.until {
            self.run = self.line.enter(column);
        }
        if self.run.is_visible { self.step(column) } else { None }
    }

    // Four loops ask for it, and its code is long.
    #[inline(never)]
    fn step(&mut self, column: u32) -> Option<Seen<R::Scalar>> {
        self.line.seen_at(self.line.x(column))
    }

    /// The pixel of what the column sees.
    #[inline(never)]
    fn shaded(&mut self, column: u32, seen: Option<Seen<R::Scalar>>) -> P {
        self.line.shaded(self.line.x(column), seen)
    }
}
