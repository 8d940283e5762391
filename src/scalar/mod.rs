//! The number types that everything else is generic over.
//!
//! [`Scalar`] is sealed: `f32` is what firmware with a floating-point unit (and most hosts) should
//! use, `f64` is there for reference runs on hosts. Both always compile side by side; a scene
//! chooses by the type of its numbers.
//!
//! Results have the same bits on every target. So nothing here calls a platform's maths library,
//! contracts a product and a sum, or leaves the order of operations open.

mod double;
mod float;
mod root;

pub(crate) use self::double::Double;
pub(crate) use self::float::two_sum;
pub(crate) use self::root::sqrt as const_sqrt;

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

/// A number type that scenes, cameras and rows can be made of.
pub trait Scalar:
    sealed::Sealed
    + Copy
    + Debug
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + 'static
{
    /// 0.
    const ZERO: Self;
    /// 1.
    const ONE: Self;
    /// Below every parameter of a crossing: −∞ where the type has it.
    const LOWEST: Self;
    /// Above every parameter of a crossing: +∞ where the type has it.
    const HIGHEST: Self;
    /// The largest coordinate and radius: 10¹⁵ for `f32`, 10⁶⁰ for `f64`. Up to there no square of a
    /// product overflows. Beyond, constructors return errors.
    const REACH: Self;
    /// The smallest radius: 10⁻¹² for `f32`, 10⁻⁶⁰ for `f64`. Down to there the rounding errors of
    /// squares can be represented. Below, constructors return errors.
    const FINEST: Self;
    /// π, rounded.
    const PI: Self;
    /// The distance from 1 to the next larger number.
    const EPSILON: Self;

    /// `halves / 2`, exactly; for pixel centres.
    fn from_halves(halves: i32) -> Self;

    /// The largest whole number ≤ `self`, held inside the range of `i32`; 0 for NaN.
    fn floor_to_i32(self) -> i32;

    /// `self` on the scale 0..=255, rounded to nearest; below 0 is 0, above 1 is 255, NaN is 0.
    fn to_level(self) -> u8;

    /// Whether the number is neither infinite nor NaN.
    fn is_finite(self) -> bool;

    /// Whether the number is finite and large enough to have all its digits: not zero, subnormal,
    /// infinite or NaN.
    fn is_normal(self) -> bool;

    /// The absolute value.
    #[must_use]
    fn abs(self) -> Self;

    /// The square root, correctly rounded; NaN below zero.
    #[must_use]
    fn sqrt(self) -> Self;

    /// Sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);

    /// A power of two that brings a positive finite number to [1, 2), or as near as the type's
    /// range allows.
    #[must_use]
    fn normalizing_power(self) -> Self;

    /// The product and its rounding error, exactly: `a·b = product + error`.
    fn two_product(a: Self, b: Self) -> (Self, Self);

    /// `a·b − c·d` with an error of at most 2 units in the last place of the result, also where
    /// the two products nearly cancel.
    fn product_difference(a: Self, b: Self, c: Self, d: Self) -> Self;

    /// `x·y` summed over three pairs, as if computed in twice the working precision and then
    /// rounded.
    fn dot3(x: [Self; 3], y: [Self; 3]) -> Self;

    /// `a + b·c` with the product's rounding error added back: the result's only error is the
    /// rounding of the sums.
    fn add_product(a: Self, b: Self, c: Self) -> Self;

    /// `self` if it is above zero: not for zero, and not for NaN.
    #[inline]
    fn positive(self) -> Option<Self> {
        (self > Self::ZERO).then_some(self)
    }

    /// The smaller of two numbers; `self` if either is NaN.
    #[must_use]
    fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }

    /// The larger of two numbers; `self` if either is NaN.
    #[must_use]
    fn max(self, other: Self) -> Self {
        if other > self { other } else { self }
    }
}
