//! The infinite cylinder.

use crate::geom::{Axis, Direction, Vec3};
use crate::scalar::Scalar;
use crate::span::Face;

/// The face of a cylinder's wall. Faces 0 and 1 are the planes of its caps.
pub(crate) const WALL: Face = Face(2);

/// All points within `radius` of a line through `base`. The line's direction, the axis, is the normal
/// of the planes that cut the wall.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Wall<S: Scalar> {
    pub(crate) base: Vec3<S>,
    pub(crate) radius: S,
    /// 1/radius.
    pub(crate) curvature: S::Scale,
}

impl<S: Scalar> Wall<S> {
    /// The point of the wall nearest to a point beside it.
    pub(crate) fn onto(&self, axis: &Direction<S>, near: Vec3<S>) -> Vec3<S> {
        let u = near - self.base;
        let along = axis.times(axis.dot(u));
        let outward = S::with_length((u - along).to_array(), self.radius);
        self.base + (along + Vec3::from(outward))
    }

    /// Whether a point is within the radius.
    pub(crate) fn has(&self, axis: &Direction<S>, point: Vec3<S>) -> bool {
        let u = point - self.base;
        S::length((u - axis.times(axis.dot(u))).to_array()) <= self.radius
    }

    /// The outward normal at a point of the wall: (0, y, z)/r in the cylinder's own frame; and what
    /// `then` makes of it, in a place for each kind of axis.
    #[inline(always)]
    pub(crate) fn normal<T>(
        &self,
        axis: &Direction<S>,
        at: Vec3<S>,
        then: impl Fn(Vec3<S>) -> T,
    ) -> T {
        match axis.along() {
            Some(along) => self.normal_along(along, at, then),
            None => {
                let u = at - self.base;
                let outward = u - axis.times(axis.dot(u));
                then(outward.map(|coordinate| coordinate.scaled(self.curvature)))
            }
        }
    }

    /// The same for an axis along a coordinate axis.
    #[inline(always)]
    pub(crate) fn normal_along<T>(
        &self,
        along: Axis,
        at: Vec3<S>,
        then: impl Fn(Vec3<S>) -> T,
    ) -> T {
        let u = at - self.base;
        let scaled = |coordinate: S| coordinate.scaled(self.curvature);
        let [first, second] = along.across(u).map(scaled);
        match along {
            Axis::X => then(Vec3::new(S::ZERO, first, second)),
            Axis::Y => then(Vec3::new(second, S::ZERO, first)),
            Axis::Z => then(Vec3::new(first, second, S::ZERO)),
        }
    }
}
