//! Unit vectors that know whether they point along a coordinate axis.

use super::Vec3;
use crate::scalar::Scalar;

/// A vector of length 1 (up to rounding).
///
/// Most axes and normals of a part point along a coordinate axis. For these, products with the
/// other coordinates' zeros are left out, and what is left is exact.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Direction<S> {
    vector: Vec3<S>,
    along: Option<Axis>,
}

/// A coordinate axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) enum Axis {
    X,
    Y,
    Z,
}

macro_rules! constructors {
    ($($Float:ident),+) => {$(
        impl Direction<$Float> {
            pub(crate) const X: Self = Self::new(Vec3::new(1.0, 0.0, 0.0));
            pub(crate) const Y: Self = Self::new(Vec3::new(0.0, 1.0, 0.0));
            pub(crate) const Z: Self = Self::new(Vec3::new(0.0, 0.0, 1.0));

            /// The direction of a vector that has length 1.
            pub(crate) const fn new(vector: Vec3<$Float>) -> Self {
                let Vec3 { x, y, z } = vector;
                let along = if y == 0.0 && z == 0.0 {
                    Some(Axis::X)
                } else if z == 0.0 && x == 0.0 {
                    Some(Axis::Y)
                } else if x == 0.0 && y == 0.0 {
                    Some(Axis::Z)
                } else {
                    None
                };
                Self { vector, along }
            }
        }
    )+};
}

constructors!(f32, f64);

impl<S: Scalar> Direction<S> {
    /// The vector.
    #[inline]
    pub(crate) fn vector(&self) -> Vec3<S> {
        self.vector
    }

    /// The coordinate axis that it lies along, in either direction.
    #[inline]
    pub(crate) fn along(&self) -> Option<Axis> {
        self.along
    }

    /// The scalar product with a vector: exact along a coordinate axis, else in twice the working
    /// precision and rounded.
    #[inline]
    pub(crate) fn dot(&self, other: Vec3<S>) -> S {
        match self.along {
            Some(Axis::X) => self.vector.x * other.x,
            Some(Axis::Y) => self.vector.y * other.y,
            Some(Axis::Z) => self.vector.z * other.z,
            None => self.vector.dot_compensated(other),
        }
    }
}

impl Axis {
    /// The other two coordinates of a vector, in cyclic order.
    #[inline]
    pub(crate) fn across<S: Copy>(self, v: Vec3<S>) -> [S; 2] {
        match self {
            Self::X => [v.y, v.z],
            Self::Y => [v.z, v.x],
            Self::Z => [v.x, v.y],
        }
    }
}
