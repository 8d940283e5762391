//! What all numbers of the crate can do, and what those that set up a picture can do besides.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

pub(super) mod sealed {
    use crate::numeric::{Loggable, Native};

    pub trait Sealed: Loggable {}
    impl<S: Native> Sealed for S {}
}

/// A number that vectors can be made of.
///
/// Sums and products are those of the type. Fixed-point numbers are rounded to nearest and stay
/// at the end of their range where they would leave it.
pub trait Number: sealed::Sealed + Copy + Debug + PartialOrd + 'static {
    /// 0.
    const ZERO: Self;
    /// 1.
    const ONE: Self;

    /// The nearest number to an integer, held inside the type's range.
    ///
    /// ```
    /// use scancsg::scalar::{I16F16, Number};
    ///
    /// assert_eq!(I16F16::from_int(-3), -3);
    /// assert_eq!(I16F16::from_int(40_000), I16F16::MAX);
    /// ```
    #[must_use]
    fn from_int(integer: i32) -> Self;

    /// The nearest number to one in double precision, held inside the type's range.
    #[must_use]
    fn from_f64(number: f64) -> Self;

    /// The number in double precision: exact for all but [`Wide`](super::Wide), which is rounded.
    #[must_use]
    fn to_f64(self) -> f64;

    /// `self + other`.
    #[must_use]
    fn plus(self, other: Self) -> Self;

    /// `self − other`.
    #[must_use]
    fn minus(self, other: Self) -> Self;

    /// `self · other`.
    #[must_use]
    fn times(self, other: Self) -> Self;

    /// `−self`.
    #[must_use]
    fn negated(self) -> Self;

    /// The absolute value.
    #[must_use]
    fn abs(self) -> Self;

    /// Whether the number is neither infinite nor NaN.
    fn is_finite(self) -> bool;

    /// `x·y` summed over three pairs. Fixed-point numbers are rounded once, floating-point
    /// numbers as often as they are added: error up to 2 ulp of the largest term.
    fn dot(x: [Self; 3], y: [Self; 3]) -> Self;

    /// The smaller of two numbers; `self` if either is NaN.
    #[must_use]
    #[inline]
    fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }

    /// The larger of two numbers; `self` if either is NaN.
    #[must_use]
    #[inline]
    fn max(self, other: Self) -> Self {
        if other > self { other } else { self }
    }
}

/// A number with all of arithmetic: what the cameras' rays and the set-up of views are made of.
///
/// For floating-point scenes it is the scene's own type; for fixed-point scenes it is
/// [`Wide`](super::Wide), because the step from one pixel to the next, and an angle, need more
/// digits than a length.
pub trait Real:
    Number
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// π, rounded.
    const PI: Self;
    /// 1/2.
    const HALF: Self;
    /// The distance from 1 to the next larger number.
    const EPSILON: Self;
    /// The distance from 0 to the next larger number, as far as it matters: 0 where rounding
    /// errors are relative.
    const QUANTUM: Self;

    /// The largest whole number ≤ `self`, held inside the range of `i32`; 0 for NaN.
    fn floor_to_i32(self) -> i32;

    /// `self / divisor` as a whole number, for a divisor other than 0 and quotients whose size is
    /// below 2¹⁶: off by less than 3. Larger ones have any size from there on.
    fn ratio(self, divisor: Self) -> i32;

    /// Whether a scene's lengths can be divided by the number: it is finite, and large enough
    /// for its square to have all its digits.
    fn is_divisor(self) -> bool;

    /// The square root, correctly rounded; NaN or 0 below zero.
    #[must_use]
    fn sqrt(self) -> Self;

    /// Sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);

    /// A power of two that brings a positive finite number to [1, 2), or as near as the type's
    /// range allows.
    #[must_use]
    fn normalizing_power(self) -> Self;

    /// `self + step·count`.
    ///
    /// In fixed point this is exact, also where the product alone would leave the type's range, as
    /// long as the sum does not.
    #[must_use]
    fn after_steps(self, step: Self, count: i32) -> Self;

    /// `[self − half, self + half]`.
    #[inline]
    #[must_use]
    fn around(self, half: Self) -> [Self; 2] {
        [self - half, self + half]
    }

    /// The vector product, with an error of at most 2 units in the last place of each coordinate.
    #[inline]
    #[must_use]
    fn cross([a, b, c]: [Self; 3], [x, y, z]: [Self; 3]) -> [Self; 3] {
        let difference = Self::product_difference;
        [difference(b, z, c, y), difference(c, x, a, z), difference(a, y, b, x)]
    }

    /// Whether [`after_steps`](Self::after_steps) stays within the type's range for all counts
    /// up to `count` in size.
    fn holds_steps(self, step: Self, count: i32) -> bool;

    /// `a·b − c·d` with an error of at most 2 units in the last place of the result, also where
    /// the two products nearly cancel.
    fn product_difference(a: Self, b: Self, c: Self, d: Self) -> Self;

    /// `x·y` summed over three pairs, as if computed in twice the working precision and then
    /// rounded.
    fn dot3(x: [Self; 3], y: [Self; 3]) -> Self;

    /// `self` if it is above zero: not for zero, and not for NaN.
    #[inline]
    fn positive(self) -> Option<Self> {
        (self > Self::ZERO).then_some(self)
    }
}
