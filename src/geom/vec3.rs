//! Vectors and points of three coordinates.

use crate::scalar::Scalar;
use core::ops::{Add, Mul, Neg, Sub};

/// A vector or a point in space, in the units of the scene.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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

impl<S: Scalar> Vec3<S> {
    /// The origin, or the vector of no length.
    pub const ZERO: Self = Self::new(S::ZERO, S::ZERO, S::ZERO);

    /// Whether no coordinate is infinite or NaN.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }

    /// The scalar product in plain arithmetic: error up to 2 ulp of the largest term.
    #[must_use]
    #[inline]
    pub fn dot(self, other: Self) -> S {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// The scalar product in twice the working precision: accurate also where terms cancel.
    #[must_use]
    #[inline]
    pub fn dot_compensated(self, other: Self) -> S {
        S::dot3(self.to_array(), other.to_array())
    }

    /// The vector product; every coordinate is within 2 ulp, also for nearly parallel vectors.
    #[must_use]
    #[inline]
    pub fn cross(self, other: Self) -> Self {
        Self::new(
            S::product_difference(self.y, other.z, self.z, other.y),
            S::product_difference(self.z, other.x, self.x, other.z),
            S::product_difference(self.x, other.y, self.y, other.x),
        )
    }

    /// The square of the length.
    #[must_use]
    #[inline]
    pub fn length_squared(self) -> S {
        self.dot(self)
    }

    /// The largest absolute value of a coordinate.
    #[must_use]
    pub fn max_abs(self) -> S {
        self.x.abs().max(self.y.abs()).max(self.z.abs())
    }

    /// The vector of length 1 in this direction, or `None` for a vector that has none: zero, or
    /// with a coordinate that is infinite or NaN. Neither overflows nor loses small vectors.
    #[must_use]
    pub fn normalized(self) -> Option<Self> {
        let scaled = self.scaled_to_one();
        let length = scaled.length_squared().positive()?.sqrt();
        self.is_finite().then(|| scaled * (S::ONE / length))
    }

    /// The vector times a power of two, which is exact, so that its largest coordinate comes to
    /// lie between 1 and 2 or as near as the type's range allows.
    #[must_use]
    pub fn scaled_to_one(self) -> Self {
        self * self.max_abs().normalizing_power()
    }
}

/// What constructors check, for constants: traits have no `const` methods yet.
macro_rules! checks {
    ($($Float:ident),+) => {$(
        impl Vec3<$Float> {
            pub(crate) const fn has_finite_coordinates(self) -> bool {
                self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
            }

            pub(crate) const fn is_within_reach(self) -> bool {
                self.x.abs().max(self.y.abs()).max(self.z.abs()) <= <$Float>::REACH
            }
        }
    )+};
}

checks!(f32, f64);

impl<S: Scalar> Add for Vec3<S> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl<S: Scalar> Sub for Vec3<S> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl<S: Scalar> Mul<S> for Vec3<S> {
    type Output = Self;
    #[inline]
    fn mul(self, factor: S) -> Self {
        Self::new(self.x * factor, self.y * factor, self.z * factor)
    }
}

impl<S: Scalar> Neg for Vec3<S> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}
