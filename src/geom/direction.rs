//! Unit vectors that know whether they point along a coordinate axis.

use super::vec3::Vec3;
use crate::scalar::{ConstOps, FixedI32, Fraction, Number, Scalar};

/// A vector of length 1 (up to rounding).
///
/// Most axes and normals of a part point along a coordinate axis. For these, products with the
/// other coordinates' zeros are left out, and what is left is exact.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Direction<S: Scalar> {
    vector: Vec3<S::Unit>,
    along: Option<Axis>,
}

/// A coordinate axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Axis {
    /// The first.
    X,
    /// The second.
    Y,
    /// The third.
    Z,
}

macro_rules! constructors {
    ($([$($generics:tt)*] $Scalar:ty),+) => {$(
        impl<$($generics)*> Direction<$Scalar> {
            /// The direction of a vector that has length 1.
            pub(crate) const fn new(vector: [<$Scalar as Scalar>::Unit; 3]) -> Self {
                let along = match ConstOps::<$Scalar>::axis(vector) {
                    Some(0) => Some(Axis::X),
                    Some(1) => Some(Axis::Y),
                    Some(2) => Some(Axis::Z),
                    _ => None,
                };
                let [x, y, z] = vector;
                Self { vector: Vec3 { x, y, z }, along }
            }
        }
    )+};
}

constructors!([] f32, [] f64, [F: Fraction] FixedI32<F>);

impl<S: Scalar> Direction<S> {
    pub(crate) const X: Self = Self {
        vector: Vec3::new(S::Unit::ONE, S::Unit::ZERO, S::Unit::ZERO),
        along: Some(Axis::X),
    };
    pub(crate) const Y: Self = Self {
        vector: Vec3::new(S::Unit::ZERO, S::Unit::ONE, S::Unit::ZERO),
        along: Some(Axis::Y),
    };
    pub(crate) const Z: Self = Self {
        vector: Vec3::new(S::Unit::ZERO, S::Unit::ZERO, S::Unit::ONE),
        along: Some(Axis::Z),
    };

    /// The vector.
    #[inline]
    pub(crate) fn vector(&self) -> Vec3<S::Unit> {
        self.vector
    }

    /// The vector with more digits, for the set-up of views.
    pub(crate) fn wide(&self) -> Vec3<S::Wide> {
        self.vector.map(S::wide_unit)
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
            Some(Axis::X) => other.x.times_unit(self.vector.x),
            Some(Axis::Y) => other.y.times_unit(self.vector.y),
            Some(Axis::Z) => other.z.times_unit(self.vector.z),
            None => S::dot_unit(other.to_array(), self.vector.to_array()),
        }
    }

    /// As [`dot`](Self::dot), with more digits.
    pub(crate) fn dot_wide(&self, other: Vec3<S::Wide>) -> S::Wide {
        let fine = self.wide();
        match self.along {
            Some(Axis::X) => fine.x * other.x,
            Some(Axis::Y) => fine.y * other.y,
            Some(Axis::Z) => fine.z * other.z,
            None => fine.dot_compensated(other),
        }
    }

    /// The direction times a length.
    #[inline]
    pub(crate) fn times(&self, length: S) -> Vec3<S> {
        self.vector.map(|coordinate| length.times_unit(coordinate))
    }
}

impl Axis {
    /// The coordinates of a vector, this axis's first and the others in any order: two change places.
    #[inline]
    pub(crate) fn turned<T: Copy>(self, v: Vec3<T>) -> [T; 3] {
        match self {
            Self::X => [v.x, v.y, v.z],
            Self::Y => [v.y, v.x, v.z],
            Self::Z => [v.z, v.y, v.x],
        }
    }

    /// The other two coordinates of a vector, in cyclic order.
    #[inline]
    pub(crate) fn across<T: Copy>(self, v: Vec3<T>) -> [T; 2] {
        match self {
            Self::X => [v.y, v.z],
            Self::Y => [v.z, v.x],
            Self::Z => [v.x, v.y],
        }
    }
}
