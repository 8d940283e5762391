//! The ball.

use crate::geom::Vec3;
use crate::scalar::Scalar;

/// All points within `radius` of `center`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ball<S: Scalar> {
    pub(crate) center: Vec3<S>,
    pub(crate) radius: S,
}

impl<S: Scalar> Ball<S> {
    /// The point of the sphere nearest to a point beside it.
    pub(crate) fn onto(&self, near: Vec3<S>) -> Vec3<S> {
        let outward = S::with_length((near - self.center).to_array(), self.radius);
        self.center + Vec3::from(outward)
    }
}
