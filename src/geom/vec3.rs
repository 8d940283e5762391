//! Vectors and points of three coordinates.

use crate::scalar::{ConstOps, Number, Real, Scalar, per_scalar};
use core::ops::{Add, Mul, Neg, Sub};

/// A vector or a point in space, in the units of the scene.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Vec3<S> {
    /// First coordinate.
    pub x: S,
    /// Second coordinate.
    pub y: S,
    /// Third coordinate.
    pub z: S,
}

/// Shorthand for [`Vec3::new`].
#[must_use]
pub const fn vec3<S: Copy>(x: S, y: S, z: S) -> Vec3<S> {
    Vec3 { x, y, z }
}

impl<S: Copy> Vec3<S> {
    /// A vector from its coordinates.
    #[must_use]
    pub const fn new(x: S, y: S, z: S) -> Self {
        Self { x, y, z }
    }

    /// The coordinates in order.
    #[must_use]
    pub const fn to_array(self) -> [S; 3] {
        [self.x, self.y, self.z]
    }
}

impl<T: Number> Vec3<T> {
    /// The origin, or the vector of no length.
    pub const ZERO: Self = Self::new(T::ZERO, T::ZERO, T::ZERO);

    /// Whether no coordinate is infinite or NaN.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }

    /// The scalar product: in floating point in plain arithmetic, with an error up to 2 ulp of
    /// the largest term; in fixed point rounded once.
    #[must_use]
    #[inline]
    pub fn dot(self, other: Self) -> T {
        T::dot(self.to_array(), other.to_array())
    }

    /// The square of the length.
    #[must_use]
    #[inline]
    pub fn length_squared(self) -> T {
        self.dot(self)
    }

    /// The largest absolute value of a coordinate.
    #[must_use]
    pub fn max_abs(self) -> T {
        self.x.abs().max(self.y.abs()).max(self.z.abs())
    }

    /// The same operation on every coordinate.
    #[must_use]
    #[inline]
    pub fn map<U>(self, of: impl Fn(T) -> U) -> Vec3<U> {
        Vec3 { x: of(self.x), y: of(self.y), z: of(self.z) }
    }
}

impl<T: Real> Vec3<T> {
    /// The length. In fixed point, that of a vector with a coordinate from 2¹⁴ on is computed of 1024ths:
    /// its own squares would leave the range. That of one whose coordinates are below 1 is computed of 2¹⁴ times
    /// these: its own squares would have few digits, or none.
    pub(crate) fn length(self) -> T {
        let large = T::from_int(1 << 14);
        if T::QUANTUM > T::ZERO && self.max_abs() >= large {
            let factor = T::from_int(1024);
            return (self * (T::ONE / factor)).length_squared().sqrt() * factor;
        }
        if T::QUANTUM > T::ZERO && self.max_abs() < T::ONE {
            return (self * large).length_squared().sqrt() * (T::ONE / large);
        }
        self.length_squared().sqrt()
    }

    /// The vector after so many steps.
    #[inline]
    pub(crate) fn after_steps(self, step: Self, count: i32) -> Self {
        Self::new(
            self.x.after_steps(step.x, count),
            self.y.after_steps(step.y, count),
            self.z.after_steps(step.z, count),
        )
    }

    /// The scalar product in twice the working precision: accurate also where terms cancel.
    #[must_use]
    #[inline]
    pub fn dot_compensated(self, other: Self) -> T {
        T::dot3(self.to_array(), other.to_array())
    }

    /// The vector product; every coordinate is within 2 ulp, also for nearly parallel vectors.
    #[must_use]
    #[inline]
    pub fn cross(self, other: Self) -> Self {
        Self::from(T::cross(self.to_array(), other.to_array()))
    }

    /// The vector of length 1 in this direction, or `None` for a vector that has none: zero, or
    /// with a coordinate that is infinite or NaN. Neither overflows nor loses small vectors.
    #[must_use]
    pub fn normalized(self) -> Option<Self> {
        let scaled = self.scaled_to_one();
        let length = scaled.length_squared().positive()?.sqrt();
        self.is_finite().then(|| scaled * (T::ONE / length))
    }

    /// The vector times a power of two, which is exact, so that its largest coordinate comes to
    /// lie between 1 and 2 or as near as the type's range allows.
    #[must_use]
    pub fn scaled_to_one(self) -> Self {
        self * self.max_abs().normalizing_power()
    }
}

impl<S: Scalar> Vec3<S> {
    /// The same vector with more digits.
    pub(crate) fn wide(self) -> Vec3<S::Wide> {
        self.map(S::wide)
    }

    /// Whether no coordinate is larger than [`Scalar::MAX_COORDINATE`].
    pub(crate) fn is_within_range(self) -> bool {
        self.max_abs().is_within_range()
    }
}

per_scalar! { $S: impl[] Vec3<$S> {
    /// As [`is_finite`](Self::is_finite), for constants.
    pub(crate) const fn has_finite_coordinates(self) -> bool {
        let Self { x, y, z } = self;
        ConstOps::<$S>::is_finite(x) && ConstOps::<$S>::is_finite(y) && ConstOps::<$S>::is_finite(z)
    }

    /// As [`is_within_range`](Self::is_within_range), for constants.
    pub(crate) const fn is_within_reach(self) -> bool {
        let [x, y, z] = self.to_array();
        ConstOps::<$S>::is_within_reach(x)
            && ConstOps::<$S>::is_within_reach(y)
            && ConstOps::<$S>::is_within_reach(z)
    }
} }

impl<T> From<[T; 3]> for Vec3<T> {
    fn from([x, y, z]: [T; 3]) -> Self {
        Self { x, y, z }
    }
}

impl<T: Number> Add for Vec3<T> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.x.plus(other.x), self.y.plus(other.y), self.z.plus(other.z))
    }
}

impl<T: Number> Sub for Vec3<T> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x.minus(other.x), self.y.minus(other.y), self.z.minus(other.z))
    }
}

impl<T: Number> Mul<T> for Vec3<T> {
    type Output = Self;
    #[inline]
    fn mul(self, factor: T) -> Self {
        self.map(|coordinate| coordinate.times(factor))
    }
}

impl<T: Number> Neg for Vec3<T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.map(T::negated)
    }
}
