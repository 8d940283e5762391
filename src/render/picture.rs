//! Pictures and their scanlines: solid → view → row → pixels, without a frame buffer.

use super::{Camera, Pixel, Shader, Size};
use crate::geom::{Column, Extent, Line, Rays, Vec3};
use crate::scalar::{Number, Scalar};
use crate::solid::{Project, Rgb, Row, Seen, Shape, Solid, View, first_seen};
use crate::span::{Face, Span, SpanList};
use core::ops::Range;

/// A solid, looked at by a camera, ready to be rendered row by row in any order.
///
/// It holds what the camera decides about every primitive, and no pixels.
///
/// ```
/// use scancsg::geom::vec3;
/// use scancsg::render::{Gray8, Lambert, Orthographic, Picture, Size};
/// use scancsg::solid::Cylinder;
/// use scancsg::span::SpanList;
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
/// let picture = Picture::new(&part, &camera, size, light, Gray8(0));
/// let mut spans = SpanList::<_, 4>::new();
/// let mut pixels = [Gray8(0); 32];
/// for scanline in picture.scanlines() {
///     scanline.render(&mut spans, &mut pixels)?;
///     // Send the pixels, show them, or count them.
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Picture<'a, T: Project<R>, R, H, P> {
    solid: &'a T,
    view: T::View<'a>,
    rays: R,
    size: Size,
    shader: H,
    background: P,
}

/// Why a row can't be rendered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum RowError {
    /// The index of a row or column is not inside the picture.
    Index,
    /// The caller's slice has not as many pixels as there are columns to fill.
    Length,
}

crate::error_text!(RowError {
    Index => "the index of a row or column is not inside the picture",
    Length => "the slice for the pixels is shorter or longer than the row or run",
});

impl<'a, T, R, H, P> Picture<'a, T, R, H, P>
where
    R: Rays,
    T: Solid<Scalar = R::Scalar> + Project<R>,
    H: Shader<R::Scalar>,
    P: Pixel,
{
    /// Gets ready to render `solid`, with `background` where no surface is seen.
    pub fn new<C: Camera<Rays = R>>(
        solid: &'a T,
        camera: &C,
        size: Size,
        shader: H,
        background: P,
    ) -> Self {
        let rays = camera.rays(size);
        Self { solid, view: solid.view(&rays), rays, size, shader, background }
    }

    /// The size in pixels.
    #[must_use]
    pub fn size(&self) -> Size {
        self.size
    }

    /// Row `y`, counted from the top.
    ///
    /// # Errors
    /// [`RowError::Index`].
    pub fn scanline(&self, y: u16) -> Result<Scanline<'_, 'a, T, R, H, P>, RowError> {
        if y < self.size.height() { Ok(self.prepare(y)) } else { Err(RowError::Index) }
    }

    /// All rows from the top to the bottom.
    pub fn scanlines(&self) -> impl Iterator<Item = Scanline<'_, 'a, T, R, H, P>> {
        (0..self.size.height()).map(|y| self.prepare(y))
    }

    fn prepare(&self, y: u16) -> Scanline<'_, 'a, T, R, H, P> {
        let from_middle = from_middle(y, self.size.height());
        Scanline { picture: self, y, from_middle, row: self.view.row(from_middle) }
    }
}

/// The centre of a pixel, in half pixels from the middle of the picture.
fn from_middle(index: u16, count: u16) -> i32 {
    2 * i32::from(index) + 1 - i32::from(count)
}

/// Columns next to each other that are rendered together.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Run {
    /// The columns.
    pub columns: Range<u16>,
    /// Whether nothing but background can be there.
    pub is_background: bool,
}

/// A row of a picture, ready to be rendered as a whole or run by run.
pub struct Scanline<'p, 'a, T: Project<R>, R, H, P>
where
    T::View<'a>: 'p,
{
    picture: &'p Picture<'a, T, R, H, P>,
    y: u16,
    from_middle: i32,
    row: <T::View<'a> as View>::Row<'p>,
}

impl<'a, T, R, H, P> Scanline<'_, 'a, T, R, H, P>
where
    R: Rays,
    T: Solid<Scalar = R::Scalar> + Project<R>,
    H: Shader<R::Scalar>,
    P: Pixel,
{
    /// The index of the row, 0 at the top.
    #[must_use]
    pub fn y(&self) -> u16 {
        self.y
    }

    /// The row in runs from left to right, of background and of everything else.
    ///
    /// Together they cover each column once; none is empty.
    pub fn runs(&self) -> impl Iterator<Item = Run> + use<T, R, H, P> {
        let width = self.picture.size.width();
        let Extent { start, end } = self.row.extent();
        let column = |index: u32| u16::try_from(index).map_or(width, |index| index.min(width));
        let end = column(end);
        let start = column(start).min(end);
        [(0..start, true), (start..end, false), (end..width, true)]
            .into_iter()
            .filter(|(columns, _)| !columns.is_empty())
            .map(|(columns, is_background)| Run { columns, is_background })
    }

    /// Renders the whole row into `pixels`.
    ///
    /// # Errors
    /// [`RowError::Length`] if `pixels` is not as long as the picture is wide; nothing is
    /// written then.
    pub fn render<const N: usize>(
        &self,
        list: &mut SpanList<R::Scalar, N>,
        pixels: &mut [P],
    ) -> Result<(), RowError> {
        if pixels.len() != usize::from(self.picture.size.width()) {
            return Err(RowError::Length);
        }
        let mut rest = pixels;
        for run in self.runs() {
            let (now, later) =
                rest.split_at_mut_checked(run.columns.len()).ok_or(RowError::Length)?;
            self.render_run(&run, list, now)?;
            rest = later;
        }
        Ok(())
    }

    /// Renders one run into `pixels`.
    ///
    /// # Errors
    /// [`RowError::Length`] if `pixels` is not as long as the run, [`RowError::Index`] if the run
    /// ends beyond the picture; nothing is written then.
    pub fn render_run<const N: usize>(
        &self,
        run: &Run,
        list: &mut SpanList<R::Scalar, N>,
        pixels: &mut [P],
    ) -> Result<(), RowError> {
        if pixels.len() != run.columns.len() {
            return Err(RowError::Length);
        }
        if run.columns.end > self.picture.size.width() {
            return Err(RowError::Index);
        }
        if run.is_background {
            pixels.fill(self.picture.background);
            return Ok(());
        }
        for (pixel, x) in pixels.iter_mut().zip(run.columns.clone()) {
            *pixel = self.pixel(x, list);
        }
        Ok(())
    }

    /// The spans of the ray of column `x`. The parameter counts scene units along the viewing
    /// direction from the plane through the camera's target.
    pub fn spans<'l, const N: usize>(
        &self,
        x: u16,
        list: &'l mut SpanList<R::Scalar, N>,
    ) -> &'l [Span<R::Scalar>] {
        const {
            assert!(N >= T::STACK, "the span list is too small: see Shape::STACK of the solid");
        }
        let column = Column { index: u32::from(x), x: from_middle(x, self.picture.size.width()) };
        let mut stack = list.stack();
        if self.row.extent().contains(column.index) {
            self.row.spans(column, Face(0), &mut stack);
        }
        list.as_slice()
    }

    /// The surface that column `x` sees, if any; its parameter as in [`spans`](Self::spans).
    pub fn seen<const N: usize>(
        &self,
        x: u16,
        list: &mut SpanList<R::Scalar, N>,
    ) -> Option<Seen<R::Scalar>> {
        first_seen(self.spans(x, list), self.picture.rays.start())
    }

    fn pixel<const N: usize>(&self, x: u16, list: &mut SpanList<R::Scalar, N>) -> P {
        let Picture { solid, rays, size, shader, background, .. } = self.picture;
        let spans = self.spans(x, list);
        let Some(seen) = first_seen(spans, rays.start()) else { return *background };
        let x = from_middle(x, size.width());
        let sample = Sample { solid: *solid, rays, x, y: self.from_middle, spans, seen };
        let color = solid.color(seen.face).unwrap_or(Rgb::WHITE);
        P::shaded(color, shader.level(&sample))
    }
}

/// What a pixel sees: the input of a [`Shader`].
#[derive(Debug, Clone, Copy)]
pub struct Sample<'a, T: Shape, R> {
    solid: &'a T,
    rays: &'a R,
    x: i32,
    y: i32,
    /// The spans of the pixel's ray, also those behind the seen surface.
    pub spans: &'a [Span<T::Scalar>],
    /// The surface that is seen.
    pub seen: Seen<T::Scalar>,
}

impl<T: Solid, R: Rays<Scalar = T::Scalar>> Sample<'_, T, R> {
    /// The pixel's ray; its direction has length 1 only for orthographic cameras.
    #[must_use]
    pub fn line(&self) -> Line<T::Scalar> {
        self.rays.line(self.x, self.y)
    }

    /// The normal of length 1 on the side of the surface that is seen.
    #[must_use]
    pub fn normal(&self) -> Vec3<T::Scalar> {
        let outward = self.solid.normal(self.seen.face, self.line().at(self.seen.t));
        if self.seen.inside { -outward } else { outward }
    }

    /// The length of the ray inside the solid, in scene units.
    #[must_use]
    pub fn path_length(&self) -> T::Scalar {
        let start = self.rays.start();
        let inside = self.spans.iter().fold(T::Scalar::ZERO, |sum, span| {
            let enter = span.enter.t.max(start);
            sum.plus(span.exit.t.minus(enter).max(T::Scalar::ZERO))
        });
        inside.times(T::Scalar::length(self.line().direction.to_array()))
    }
}
