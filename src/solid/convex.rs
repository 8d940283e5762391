//! The door for primitives of your own.

use super::leaf::{Leaf, leaf};
use super::{Shape, Solid};
use crate::geom::{Extent, Line, RayRow, Rays, Vec3};
use crate::scalar::Scalar;
use crate::span::{Face, Span, SpanStack};

/// A convex solid: no line is inside it more than once.
///
/// Whoever implements this has a [`Solid`] that can be combined, traced and rendered like the
/// crate's own; only to the left of an operator it must be wrapped, as in `Union::new(a, b)`. It
/// is asked anew for every pixel; the crate's primitives do better by keeping what
/// the view and the row decide.
///
/// A half-space below a tilted roof, `n · p ≤ offset`:
///
/// ```
/// use scancsg::geom::{Line, Ray, Vec3, vec3};
/// use scancsg::solid::{Convex, Cylinder, Solid};
/// use scancsg::span::{Crossing, Face, Span, SpanList};
///
/// struct Below {
///     normal: Vec3<f32>,
///     offset: f32,
/// }
///
/// impl Convex for Below {
///     type Scalar = f32;
///     const FACES: u16 = 1;
///
///     fn span(&self, line: &Line<f32>) -> Option<Span<f32>> {
///         let speed = self.normal.dot(line.direction);
///         let above = self.normal.dot(line.origin) - self.offset;
///         let roof = Crossing { t: -above / speed, face: Face(0) };
///         let whole = Span::whole_line(Face(0));
///         match () {
///             () if speed > 0.0 => Span::new(whole.enter, roof),
///             () if speed < 0.0 => Span::new(roof, whole.exit),
///             () => (above < 0.0).then_some(whole),
///         }
///     }
///
///     fn normal(&self, _: Face, _: Vec3<f32>) -> Vec3<f32> {
///         self.normal
///     }
/// }
///
/// let tower = Cylinder::<f32>::along_y(0.0, 0.0, 1.0, 0.0, 5.0)?;
/// let roofed = tower & Below { normal: vec3(0.6, 0.8, 0.0), offset: 3.2 };
/// let from_above = Ray::new(vec3(0.0, 10.0, 0.0), vec3(0.0, -1.0, 0.0))?;
/// let hit = roofed.hit(&from_above, &mut SpanList::<_, 4>::new()).ok_or("a miss")?;
/// assert!((hit.t - 6.0).abs() < 1e-5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Convex {
    /// The number type.
    type Scalar: Scalar;

    /// The number of faces that [`span`](Self::span) tells apart.
    const FACES: u16;

    /// The part of the line that is inside, with faces below [`FACES`](Self::FACES), in the
    /// line's parameter. A span without length is none: see [`Span::new`]. One that doesn't keep
    /// to that, or has NaN in it, counts as none.
    fn span(&self, line: &Line<Self::Scalar>) -> Option<Span<Self::Scalar>>;

    /// The normal of length 1 that points out of the solid, at a point on one of its faces.
    fn normal(&self, face: Face, at: Vec3<Self::Scalar>) -> Vec3<Self::Scalar>;
}

impl<T: Convex> Shape for T {
    type Scalar = T::Scalar;
    const SPANS: usize = 1;
    const STACK: usize = 1;
    const FACES: u16 = T::FACES;
}

impl<T: Convex> Solid for T {
    fn spans(&self, line: &Line<T::Scalar>, first: Face, stack: &mut SpanStack<'_, T::Scalar>) {
        if let Some(span) = self.span(line).and_then(Span::checked) {
            stack.put(span.with_faces_from(first));
        }
    }

    fn normal(&self, face: Face, at: Vec3<T::Scalar>) -> Vec3<T::Scalar> {
        Convex::normal(self, face, at)
    }
}

impl<R: Rays<Scalar = T::Scalar>, T: Convex> Leaf<R> for T {
    type View = Option<R>;
    type Row = Option<R::Row>;

    fn seen_along(&self, rays: &R) -> Self::View {
        Some(*rays)
    }

    fn in_row(&self, rays: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        *row = rays.as_ref().map(|rays| rays.row(y));
        Extent::all(columns)
    }

    fn span(&self, _: &Self::View, row: &Self::Row, x: i32) -> Option<Span<T::Scalar>> {
        Convex::span(self, &row.as_ref()?.line(x)).and_then(Span::checked)
    }
}

leaf!([T: Convex] T);
