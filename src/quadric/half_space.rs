//! The half-space.

use crate::geom::{Direction, Vec3};
use crate::quadric::planes::is_forward;
use crate::scalar::Scalar;

/// The points p with `normal · p ≤ offset`: a plane and all that lies behind it.
///
/// Use it to cut a solid, and as a face of a [`Polyhedron`](crate::solid::Polyhedron). The offset is
/// stored as it was given, so a half-space and a [`Slab`](crate::solid::Slab) with a plane in common
/// cross every line at the same bits there.
///
/// ```
/// use scancsg::constant;
/// use scancsg::geom::vec3;
/// use scancsg::solid::{HalfSpace, Intersection, Sphere};
///
/// const DOME: Intersection<Sphere<f32>, HalfSpace<f32>> = Intersection::new(
///     constant!(Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)),
///     constant!(HalfSpace::<f32>::new(vec3(0.0, 0.0, -1.0), 0.0)),
/// );
/// # let _ = DOME;
/// ```
///
/// One face.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HalfSpace<S: Scalar> {
    pub(crate) normal: Direction<S>,
    pub(crate) offset: S,
}

impl<S: Scalar> HalfSpace<S> {
    /// Whether a line along the plane is inside, by how far the plane is above it.
    ///
    /// As for two planes: of two half-spaces on either side of a plane exactly one has it.
    pub(crate) fn has_below<T: PartialOrd>(&self, height: T, zero: T) -> bool {
        if is_forward(&self.normal) { zero < height } else { zero <= height }
    }

    /// The point of the plane nearest to a point beside it.
    pub(crate) fn onto_plane(&self, near: Vec3<S>) -> Vec3<S> {
        self.normal.onto_plane(self.offset, near)
    }

    /// The normal, with the digits of a length.
    #[inline]
    pub(crate) fn outward(&self) -> Vec3<S> {
        self.normal.times(S::ONE)
    }
}
