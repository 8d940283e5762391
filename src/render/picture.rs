//! Pictures and their scanlines: solid → view → row → pixels, without a frame buffer.

use super::sample::Sample;
use super::{Camera, Palette, Pixel, Shader, Size};
use crate::geom::Rays;
use crate::scalar::Scalar;
use crate::scan::{ColumnRun, Empty, Scan};
use crate::solid::{Rgb, Seen, Solid};
use crate::span::walk::{Cold, Hot, Step};
use crate::span::{Crossing, Face, Span, SpanList, check_room};
use core::ops::Range;

/// A solid, looked at by a camera, ready to be rendered row by row in any order.
///
/// It holds what the camera decides about every primitive, what the present row does, and no
/// pixels: all the memory that rendering needs besides the caller's row.
///
/// ```
/// use scancsg::geom::vec3;
/// use scancsg::render::{Gray8, Lambert, Orthographic, Picture, Size};
/// use scancsg::solid::Cylinder;
///
/// let part = Cylinder::<f32>::along_x(0.0, 0.0, 1.0, -1.5, 1.5)?
///     - Cylinder::<f32>::along_x(0.0, 0.0, 0.5, -2.0, 2.0)?;
/// let camera = Orthographic::look_at(
///     vec3(3.0, 2.0, 4.0), // the eye
///     vec3(0.0, 0.0, 0.0), // looks here
///     vec3(0.0, 1.0, 0.0), // up
///     4.0,                 // units from the upper to the lower edge
/// )?;
/// let light = Lambert::new(vec3(0.2, 1.0, 0.5), 0.1)?;
/// let size = Size::new(32, 24)?;
///
/// let mut picture = Picture::new(&part, &camera, size, light, Gray8(0));
/// let mut pixels = [Gray8(0); 32];
/// for y in 0..size.height() {
///     picture.scanline(y)?.render(&mut pixels)?;
///     // Send the pixels, show them, or count them.
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Picture<'a, T: Scan<R>, R: Rays, H, P> {
    solid: &'a T,
    view: T::View,
    row: T::Row,
    rays: R,
    /// Whether the view is set: the first row that is asked for does that.
    has_view: bool,
    /// Just before what the camera sees.
    before: R::Scalar,
    size: Size,
    shader: H,
    background: P,
}

crate::error_text! {
    /// Why a row can't be rendered.
    pub enum RowError {
        /// The index of a row or column is not inside the picture.
        Index => "the index of a row or column is not inside the picture",
        /// The caller's slice has not as many pixels as there are columns to fill.
        Length => "the slice for the pixels is shorter or longer than the row or run",
        /// The picture shows more of the scene than its number type can: in fixed point, its width and height
        /// together, in the plane through the target, must be less than the number type's range (32,768 in
        /// `I16F16`), and in perspective a pixel times [`Scalar::MAX_COORDINATE`] less than 2³⁰
        /// and (1 + width/height) · tan(field of view / 2) less than 7.
        Range => "the picture shows more of the scene than its number type's range",
    }
}

impl<'a, T, R, H, P> Picture<'a, T, R, H, P>
where
    R: Rays,
    T: Solid<Scalar = R::Scalar> + Scan<R>,
    H: Shader<R::Scalar>,
    P: Pixel,
{
    /// Gets ready to render `solid`, with `background` where no surface is seen.
    // A picture is large, and what a function returns may be copied on its way. So nothing is set
    // here that isn't constant: always inline, that is done in place.
    #[inline(always)]
    pub fn new<C: Camera<Rays = R>>(
        solid: &'a T,
        camera: &C,
        size: Size,
        shader: H,
        background: P,
    ) -> Self {
        Self::along(solid, camera.rays(size), size, shader, background)
    }

    /// The same with rays that are as many as `size` says, but not made for it.
    #[inline(always)]
    pub(super) fn along(solid: &'a T, rays: R, size: Size, shader: H, background: P) -> Self {
        Self {
            solid,
            view: T::View::EMPTY,
            row: T::Row::EMPTY,
            rays,
            has_view: false,
            before: rays.start().next_below(),
            size,
            shader,
            background,
        }
    }

    /// The size in pixels.
    #[must_use]
    pub fn size(&self) -> Size {
        self.size
    }

    /// The colours of the solid's faces.
    #[must_use]
    pub fn palette(&self) -> Palette {
        (0..T::FACES).map(|face| self.solid.color(Face(face)).unwrap_or(Rgb::WHITE)).collect()
    }

    /// Does now what the first row would do otherwise: computes what the camera decides about every
    /// primitive. For those who want every row to take the same time.
    pub fn prepare(&mut self) {
        if !self.has_view && self.rays.fits(self.size.height()) {
            self.solid.view(&self.rays, &mut self.view);
            self.has_view = true;
        }
    }

    /// Row `y`, counted from the top. Rows may be rendered in any order, and again.
    ///
    /// # Errors
    /// [`RowError::Index`], [`RowError::Range`].
    pub fn scanline(&mut self, y: u16) -> Result<Scanline<'_, 'a, T, R, H, P>, RowError> {
        if y >= self.size.height() {
            return Err(RowError::Index);
        }
        self.prepare();
        if !self.has_view {
            return Err(RowError::Range);
        }
        let from_middle = from_middle(y.into(), self.size.height());
        let columns = self.size.width().into();
        self.solid.row(&self.view, from_middle, columns, &mut self.row);
        let rays = self.rays.row(from_middle);
        Ok(Scanline { picture: self, y, rays })
    }
}

/// The centre of a pixel, in half pixels from the middle of the picture.
fn from_middle(index: u32, count: u16) -> i32 {
    2 * index as i32 + 1 - i32::from(count)
}

/// Columns next to each other that are rendered together.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Run {
    /// The columns.
    pub columns: Range<u16>,
    /// Whether nothing but background can be there.
    pub is_background: bool,
}

/// A row of a picture, ready to be rendered as a whole or run by run.
pub struct Scanline<'p, 'a, T: Scan<R>, R: Rays, H, P> {
    picture: &'p mut Picture<'a, T, R, H, P>,
    y: u16,
    rays: R::Row,
}

impl<T, R, H, P> Scanline<'_, '_, T, R, H, P>
where
    R: Rays,
    T: Solid<Scalar = R::Scalar> + Scan<R>,
    H: Shader<R::Scalar>,
    P: Pixel,
{
    /// The index of the row, 0 at the top.
    #[must_use]
    pub fn y(&self) -> u16 {
        self.y
    }

    /// The run that begins with column `start`, or `None` behind the last column.
    ///
    /// Runs of background and of everything else take turns, so from column 0 on, each beginning
    /// where the last one ended, they cover the row.
    #[must_use]
    pub fn run(&mut self, start: u16) -> Option<Run> {
        let width = self.picture.size.width();
        let ColumnRun { is_visible, mut until } = self.enter(start.into());
        while until < u32::from(width) {
            let next = self.enter(until);
            if next.is_visible != is_visible {
                break;
            }
            until = next.until;
        }
        let end = u16::try_from(until).map_or(width, |until| until.min(width));
        (start < width).then_some(Run { columns: start..end, is_background: !is_visible })
    }

    /// Renders the whole row into `pixels`.
    ///
    /// # Errors
    /// [`RowError::Length`] if `pixels` is not as long as the picture is wide; nothing is
    /// written then.
    pub fn render(&mut self, pixels: &mut [P]) -> Result<(), RowError> {
        let columns = 0..self.picture.size.width();
        self.render_run(&Run { columns, is_background: false }, pixels)
    }

    /// Renders one run into `pixels`.
    ///
    /// # Errors
    /// [`RowError::Length`] if `pixels` is not as long as the run, [`RowError::Index`] if the run
    /// ends beyond the picture; nothing is written then.
    pub fn render_run(&mut self, run: &Run, pixels: &mut [P]) -> Result<(), RowError> {
        if pixels.len() != run.columns.len() {
            return Err(RowError::Length);
        }
        if run.columns.end > self.picture.size.width() {
            return Err(RowError::Index);
        }
        let mut column = u32::from(run.columns.start);
        let mut rest = pixels;
        while !rest.is_empty() {
            let ColumnRun { is_visible, until } = self.enter(column);
            let count = rest.len().min((until - column) as usize);
            let (now, later) = rest.split_at_mut_checked(count).ok_or(RowError::Length)?;
            if is_visible && !run.is_background {
                let mut x = self.x(column);
                for pixel in now {
                    *pixel = self.pixel(x);
                    x += 2;
                }
            } else {
                now.fill(self.picture.background);
            }
            rest = later;
            column = until;
        }
        Ok(())
    }

    /// The centre of a column, in half pixels from the middle of the picture.
    pub(super) fn x(&self, column: u32) -> i32 {
        from_middle(column, self.picture.size.width())
    }

    /// The spans of the ray of column `x`. The parameter counts scene units along the viewing
    /// direction from the plane through the camera's target.
    pub fn spans<'l, const N: usize>(
        &mut self,
        x: u16,
        list: &'l mut SpanList<R::Scalar, N>,
    ) -> &'l [Span<R::Scalar>] {
        const { check_room(N, T::SPANS) };
        let column = u32::from(x);
        let (x, lowest) = (self.x(column), R::Scalar::LOWEST);
        let is_visible = self.enter(column).is_visible;
        let mut stack = list.stack();
        if is_visible {
            let Picture { solid, view, row, .. } = &mut *self.picture;
            let mut step = |t| solid.step::<Cold>(view, row, x, t, Face(0));
            let Step { inside, mut next } = step(lowest);
            // Inside from the beginning: no surface is there.
            let mut enter = inside.then_some(Crossing { t: lowest, face: Face(0) });
            loop {
                match enter.take() {
                    Some(enter) => stack.put(Span { enter, exit: next }),
                    None if next.t >= R::Scalar::HIGHEST => break,
                    None => enter = Some(next),
                }
                next = step(next.t).next;
            }
        }
        list.as_slice()
    }

    /// The surface that column `x` sees, if any; its parameter as in [`spans`](Self::spans).
    pub fn seen(&mut self, x: u16) -> Option<Seen<R::Scalar>> {
        let column = u32::from(x);
        if !self.enter(column).is_visible {
            return None;
        }
        self.seen_at(self.x(column))
    }

    /// Prepares for the columns from this one on, as [`Scan::enter`] does.
    pub(super) fn enter(&mut self, column: u32) -> ColumnRun {
        T::enter(&mut self.picture.row, column)
    }

    #[inline]
    pub(super) fn seen_at(&mut self, x: i32) -> Option<Seen<R::Scalar>> {
        let Picture { solid, view, row, before, .. } = &mut *self.picture;
        let Step { inside, next: Crossing { t, face } } =
            solid.step::<Hot>(view, row, x, *before, Face(0));
        (t < R::Scalar::HIGHEST).then_some(Seen { t, face, inside })
    }

    #[inline]
    fn pixel(&mut self, x: i32) -> P {
        let seen = self.seen_at(x);
        self.shaded(x, seen)
    }

    /// What a pixel that sees this shows.
    #[inline]
    pub(super) fn shaded(&mut self, x: i32, seen: Option<Seen<R::Scalar>>) -> P {
        let Some(seen) = seen else { return self.picture.background };
        let Picture { solid, view, row, rays: camera, shader, .. } = &mut *self.picture;
        let color = solid.color(seen.face).unwrap_or(Rgb::WHITE);
        let sample = Sample { solid: *solid, view, row, camera, rays: &self.rays, x, seen };
        P::shaded(color, shader.level(sample))
    }
}
