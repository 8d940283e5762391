//! The cylinder that only a coordinate axis can have.

use super::{Cylinder, CylinderError};
use crate::geom::{Axis, Extent, Line, Vec3};
use crate::quadric::{WALL, meet};
use crate::query::Solid;
use crate::scalar::{Scalar, per_scalar};
use crate::scan::bounds::Bounds;
use crate::scan::{Leaf, leaf};
use crate::span::{Face, Shape, Span, SpanStack};
use core::ops::Range;

/// A [`Cylinder`] along a coordinate axis, known from its type: for firmware that traces single rays in
/// little flash.
///
/// It has the faces and the bits of that cylinder. A cylinder may have any axis, so it links what an oblique
/// one needs: in fixed point about 20 KB of integers with 256 bits. This type links none of it.
///
/// ```
/// use scancsg::geom::{Axis, Ray, vec3};
/// use scancsg::solid::{AxisCylinder, RayCast};
/// use scancsg::span::SpanList;
///
/// let post = AxisCylinder::<f32>::along(Axis::Z, [3.0, 0.0], 0.5, -1.0, 2.0)?;
/// let beam = Ray::new(vec3(0.0, 0.0, 0.0), vec3(1.0, 0.0, 0.0))?;
/// let hit = post.hit(&beam, &mut SpanList::<_, 1>::new()).ok_or("a miss")?;
/// assert_eq!(hit.t, 2.5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AxisCylinder<S: Scalar> {
    cylinder: Cylinder<S>,
}

leaf!([S: Scalar] AxisCylinder<S>);

per_scalar! { $S: impl[] AxisCylinder<$S> {
    /// As [`Cylinder::spanning`], for constants.
    ///
    /// ```
    /// use scancsg::constant;
    /// use scancsg::geom::Axis;
    /// use scancsg::solid::AxisCylinder;
    ///
    /// const POST: AxisCylinder<f32> =
    ///     constant!(AxisCylinder::<f32>::spanning(Axis::Z, -1.0..2.0, [3.0, 0.0], 0.5));
    /// # let _ = POST;
    /// ```
    ///
    /// # Errors
    /// As [`Cylinder::along_x`].
    pub const fn spanning(
        axis: Axis, range: Range<$S>, at: [$S; 2], radius: $S,
    ) -> Result<Self, CylinderError> {
        match Cylinder::<$S>::spanning(axis, range, at, radius) {
            Ok(cylinder) => Ok(Self { cylinder }),
            Err(error) => Err(error),
        }
    }
} }

impl<S: Scalar> AxisCylinder<S> {
    /// As [`Cylinder::along`], for any number type.
    ///
    /// # Errors
    /// As [`Cylinder::along_x`].
    pub fn along(
        axis: Axis,
        at: [S; 2],
        radius: S,
        low: S,
        high: S,
    ) -> Result<Self, CylinderError> {
        Ok(Self { cylinder: Cylinder::along(axis, at, radius, low, high)? })
    }
}

impl<S: Scalar> From<AxisCylinder<S>> for Cylinder<S> {
    fn from(along_axis: AxisCylinder<S>) -> Self {
        along_axis.cylinder
    }
}

impl<S: Scalar> Shape for AxisCylinder<S> {
    type Scalar = S;
    const SPANS: usize = 1;
    const FACES: u16 = Cylinder::<S>::FACES;
}

impl<S: Scalar> Solid for AxisCylinder<S> {
    #[inline(always)]
    fn spans(&self, line: &Line<S>, first: Face, stack: &mut SpanStack<'_, S>) {
        let Cylinder { wall, caps } = &self.cylinder;
        stack.put_all(meet::aligned_cylinder(wall, caps, line), first);
    }

    fn bounds(&self) -> Bounds<S> {
        self.cylinder.bounds()
    }

    fn onto(&self, face: Face, near: Vec3<S>) -> Vec3<S> {
        self.cylinder.onto(face, near)
    }

    fn normal(&self, face: Face, at: Vec3<S>) -> Vec3<S> {
        let Cylinder { wall, caps } = &self.cylinder;
        match caps.normal.along() {
            Some(along) if face == WALL => wall.normal_along(along, at, |normal| normal),
            _ => caps.face_normal(face),
        }
    }

    // As that of a cylinder.
    #[cfg_attr(not(all(target_arch = "arm", not(target_has_atomic = "32"))), inline(always))]
    fn cosine(&self, face: Face, at: impl FnOnce() -> Vec3<S>, to: Vec3<S>) -> S {
        let Cylinder { wall, caps } = &self.cylinder;
        match caps.normal.along() {
            Some(along) if face == WALL => wall.normal_along(along, at(), |normal| normal.dot(to)),
            _ => caps.face_cosine(face, to),
        }
    }
}

impl<S: Scalar, R> Leaf<R> for AxisCylinder<S>
where
    Cylinder<S>: Leaf<R, Scalar = S, Spans = [Span<S>; 1]>,
{
    type View = <Cylinder<S> as Leaf<R>>::View;
    type Row = <Cylinder<S> as Leaf<R>>::Row;
    type Spans = [Span<S>; 1];

    fn view(&self, rays: &R) -> Self::View {
        self.cylinder.view(rays)
    }

    #[inline]
    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        Leaf::is_in_rows(&self.cylinder, view, rows)
    }

    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        Leaf::row(&self.cylinder, view, y, columns, row)
    }

    #[inline(always)]
    fn spans(&self, view: &Self::View, row: &Self::Row, x: i32, spans: &mut Self::Spans) {
        Leaf::spans(&self.cylinder, view, row, x, spans);
    }

    #[inline(always)]
    fn may_contain(&self, view: &Self::View, row: &Self::Row, x: i32, t: S) -> bool {
        self.cylinder.may_contain(view, row, x, t)
    }
}
