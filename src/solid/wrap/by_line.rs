//! Solids that are asked line by line: solids of your own, and any solid along rays of your own.

use crate::geom::{Extent, Line, RayRow, Vec3};
use crate::scan::bounds::{Bounds, Outline, Silhouette};
use crate::scan::{Leaf, leaf};
use crate::solid::{Rgb, Solid};
use crate::span::{Face, Shape, Span, SpanList, SpanStack, check_room};

/// Any [`Solid`], seen along any [`Rays`](crate::geom::Rays): wrap a solid of your own in it, or one of the crate's that
/// is to be seen by a camera of your own.
///
/// `N` is the most spans that a line has with the solid, at least its [`Shape::STACK`]; less does not
/// compile. The solid is asked anew for every pixel inside its [bounds](Solid::bounds); the crate's
/// primitives do better by keeping what the view and the row decide.
///
/// An octahedron, |x| + |y| + |z| ≤ 1, with a silhouette:
///
/// ```
/// use scancsg::geom::{Line, Ray, Vec3, vec3};
/// use scancsg::solid::{Bounds, ByLine, Cylinder, RayCast, Solid};
/// use scancsg::span::{Crossing, Face, Shape, Span, SpanList, SpanStack};
///
/// struct Octahedron;
///
/// /// The normal of a face, times √3.
/// fn sides(face: u16) -> Vec3<f32> {
///     let sign = |bit: u16| if face >> bit & 1 == 0 { 1.0 } else { -1.0 };
///     vec3(sign(0), sign(1), sign(2))
/// }
///
/// impl Shape for Octahedron {
///     type Scalar = f32;
///     const SPANS: usize = 1;
///     const FACES: u16 = 8;
/// }
///
/// impl Solid for Octahedron {
///     fn spans(&self, line: &Line<f32>, first: Face, stack: &mut SpanStack<'_, f32>) {
///         let mut part = Some(Span::whole_line(first));
///         for face in 0..8 {
///             let (above, speed) = (1.0 - sides(face).dot(line.origin), sides(face).dot(line.direction));
///             let plane = Crossing { t: above / speed, face: first.offset(face) };
///             let whole = Span::whole_line(plane.face);
///             let half_space = match () {
///                 () if speed > 0.0 => Span::new(whole.enter, plane),
///                 () if speed < 0.0 => Span::new(plane, whole.exit),
///                 () => (above > 0.0).then_some(whole),
///             };
///             part = part.zip(half_space).and_then(|(part, half)| part.overlap(half));
///         }
///         if let Some(span) = part {
///             let _ = stack.push(span); // there is room for one
///         }
///     }
///
///     fn normal(&self, face: Face, _: Vec3<f32>) -> Vec3<f32> {
///         sides(face.0) * (1.0 / 3f32.sqrt())
///     }
///
///     fn bounds(&self) -> Bounds<f32> {
///         Bounds::Ball { center: vec3(0.0, 0.0, 0.0), radius: 1.0 }
///     }
/// }
///
/// let drilled = ByLine::<_, 1>::new(Octahedron) - Cylinder::<f32>::along_z(0.0, 0.0, 0.2, -2.0, 2.0)?;
/// let ray = Ray::new(vec3(0.5, 0.0, 9.0), vec3(0.0, 0.0, -1.0))?;
/// let hit = drilled.hit(&ray, &mut SpanList::<_, 4>::new()).ok_or("a miss")?;
/// assert_eq!(hit.t, 8.5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ByLine<T, const N: usize = 1> {
    solid: T,
}

impl<T: Shape, const N: usize> ByLine<T, N> {
    /// Wraps a solid whose lines have at most `N` spans.
    #[must_use]
    pub const fn new(solid: T) -> Self {
        const { check_room(N, T::STACK) };
        Self { solid }
    }

    /// The solid inside.
    #[must_use]
    pub const fn inner(&self) -> &T {
        &self.solid
    }
}

impl<T: Shape, const N: usize> Shape for ByLine<T, N> {
    type Scalar = T::Scalar;
    const SPANS: usize = T::SPANS;
    const STACK: usize = T::STACK;
    const FACES: u16 = T::FACES;
}

impl<T: Solid, const N: usize> Solid for ByLine<T, N> {
    fn spans(&self, line: &Line<T::Scalar>, first: Face, stack: &mut SpanStack<'_, T::Scalar>) {
        let start = stack.len();
        self.solid.spans(line, first, stack);
        stack.keep_ordered(start);
    }

    fn normal(&self, face: Face, at: Vec3<T::Scalar>) -> Vec3<T::Scalar> {
        self.solid.normal(face, at)
    }

    fn bounds(&self) -> Bounds<T::Scalar> {
        self.solid.bounds()
    }

    fn onto(&self, face: Face, near: Vec3<T::Scalar>) -> Vec3<T::Scalar> {
        self.solid.onto(face, near)
    }

    #[inline]
    fn cosine(
        &self,
        face: Face,
        at: impl FnOnce() -> Vec3<T::Scalar>,
        to: Vec3<T::Scalar>,
    ) -> T::Scalar {
        self.solid.cosine(face, at, to)
    }

    fn color(&self, face: Face) -> Option<Rgb> {
        self.solid.color(face)
    }
}

impl<R, T, const N: usize> Leaf<R> for ByLine<T, N>
where
    R: Outline<Scalar = T::Scalar>,
    T: Solid,
{
    type View = Option<(R, R::Silhouette)>;
    type Row = Option<R::Row>;
    type Spans = [Span<T::Scalar>; N];

    fn view(&self, rays: &R) -> Self::View {
        Some((*rays, rays.outline(&self.solid.bounds())))
    }

    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        view.as_ref().is_some_and(|(_, outline)| outline.is_in_rows(rows))
    }

    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        *row = view.as_ref().map(|(rays, _)| rays.row(y));
        view.as_ref().map_or(Extent::EMPTY, |(_, outline)| outline.extent(y, columns))
    }

    fn spans(&self, _: &Self::View, row: &Self::Row, x: i32, spans: &mut Self::Spans) {
        let mut list = SpanList::<T::Scalar, N>::new();
        if let Some(row) = row {
            Solid::spans(self, &row.line(x), Face(0), &mut list.stack());
        }
        *spans = [Span::NOWHERE; N];
        for (kept, span) in spans.iter_mut().zip(list.as_slice()) {
            *kept = *span;
        }
    }
}

leaf!([T: Solid, const N: usize] ByLine<T, N>);
