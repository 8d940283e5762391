//! The infinite cylinder: the wall of everything in this module.
//!
//! With u = p − base, m = d × axis and q = u × axis, the points of a line at distance r from the
//! axis are the roots of `|q + t·m|² = r²`. Their middle is `−q·m/|m|²`, and their discriminant
//! `r²|m|² − (q × m)²`, whose last term is (u·m)²: no squares of large distances cancel. The axis
//! is never normalised away, and `|d × axis|²` is never 1 − d²: a line along the axis gives m = 0
//! exactly.

use crate::geom::{Line, Vec3};
use crate::scalar::Scalar;

/// All points within `radius` of the line through `base` along `axis`, which has length 1.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(in crate::solid) struct Tube<S> {
    pub(in crate::solid) base: Vec3<S>,
    pub(in crate::solid) axis: Vec3<S>,
    pub(in crate::solid) radius: S,
}

/// Where a line meets the wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::solid) enum Meeting<S> {
    /// Nowhere: the line passes it by.
    Beside,
    /// At `middle` ± `half`; `half` is zero for a tangent.
    Chord { middle: S, half: S },
    /// Nowhere: the line is parallel to the axis, inside the wall.
    Within,
    /// The line is parallel to the axis, outside the wall or on it.
    Along,
}

impl<S: Scalar> Tube<S> {
    pub(in crate::solid) fn meet(&self, line: &Line<S>) -> Meeting<S> {
        let u = line.origin - self.base;
        let m = line.direction.cross(self.axis);
        let q = u.cross(self.axis);
        let a = m.length_squared();
        if a <= S::ZERO {
            let inside = q.length_squared() < self.radius * self.radius;
            return if inside { Meeting::Within } else { Meeting::Along };
        }
        let k = u.dot_compensated(m);
        let discriminant = S::product_difference(self.radius * self.radius, a, k, k);
        if discriminant < S::ZERO {
            return Meeting::Beside;
        }
        Meeting::Chord { middle: -q.dot_compensated(m) / a, half: discriminant.sqrt() / a }
    }

    /// The outward normal at a point of the wall: (0, y, z)/r in the cylinder's own frame.
    pub(in crate::solid) fn normal(&self, at: Vec3<S>) -> Vec3<S> {
        let u = at - self.base;
        (u - self.axis * u.dot(self.axis)) * (S::ONE / self.radius)
    }
}
