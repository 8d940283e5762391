//! The arithmetic of splines: what number types do in ways of their own.

use crate::scalar::Scalar;
use core::fmt::Debug;

/// A number type that splines can be made of: every [`Scalar`].
///
/// Inside of an evaluation, numbers are of the type `Inner`: in floating point the type itself; in
/// fixed point 64 bits, of which 28 are guard bits. So a value is rounded once. Basis functions are
/// computed in twice the working precision: their errors are relative, and nothing waits for them.
pub trait Blend: Scalar {
    /// A number inside of an evaluation.
    #[doc(hidden)]
    type Inner: Copy + Debug + PartialEq + PartialOrd;
    /// The value of a basis function inside of an evaluation.
    #[doc(hidden)]
    type Weight: Copy;
    /// Where a parameter is between two knots.
    #[doc(hidden)]
    type Ratio: Copy;
    /// Where a span of a baked curve is, and how its polynomials are scaled.
    #[doc(hidden)]
    type Frame: Copy + Debug + PartialEq;
    /// A parameter as the polynomials of a baked curve take it.
    #[doc(hidden)]
    type Local: Copy;
    /// A coefficient of a baked curve.
    #[doc(hidden)]
    type Coefficient: Copy + Debug + PartialEq;
    /// What is added to a baked polynomial at the end.
    #[doc(hidden)]
    type Base: Copy + Debug + PartialEq;

    /// The largest coordinate of a control point.
    #[doc(hidden)]
    const LARGEST: Self;
    /// 0.
    #[doc(hidden)]
    const NOTHING: Self::Inner;
    /// The weight 1.
    #[doc(hidden)]
    const FULL: Self::Weight;
    /// The weight 0.
    #[doc(hidden)]
    const NONE: Self::Weight;
    /// A baked polynomial of this span may be evaluated outside of it.
    #[doc(hidden)]
    const EXTENDS: bool;

    #[doc(hidden)]
    fn inner(self) -> Self::Inner;

    /// The nearest number, held inside of the type's range.
    #[doc(hidden)]
    fn outer(inner: Self::Inner) -> Self;

    #[doc(hidden)]
    fn add(a: Self::Inner, b: Self::Inner) -> Self::Inner;

    #[doc(hidden)]
    fn subtract(a: Self::Inner, b: Self::Inner) -> Self::Inner;

    /// Where t is between `low` and `high`, which is larger.
    #[doc(hidden)]
    fn ratio(t: Self, low: Self, high: Self) -> Self::Ratio;

    /// `a + (b − a)·ratio`; exactly a or b where t was `low` or `high`.
    #[doc(hidden)]
    fn blend(a: Self::Inner, b: Self::Inner, ratio: Self::Ratio) -> Self::Inner;

    /// `weight·(t − low)/(high − low)`, for `low ≤ t ≤ high`; 0 for knots that coincide.
    #[doc(hidden)]
    fn rise(weight: Self::Weight, t: Self, low: Self, high: Self) -> Self::Weight;

    /// `weight·(high − t)/(high − low)`, for `low ≤ t ≤ high`; 0 for knots that coincide.
    #[doc(hidden)]
    fn fall(weight: Self::Weight, t: Self, low: Self, high: Self) -> Self::Weight;

    /// `weight·degree/(high − low)`, held inside of the type's range; 0 for knots that coincide.
    #[doc(hidden)]
    fn climb(weight: Self::Weight, degree: u16, low: Self, high: Self) -> Self::Weight;

    #[doc(hidden)]
    fn add_weights(a: Self::Weight, b: Self::Weight) -> Self::Weight;

    #[doc(hidden)]
    fn negate_weight(weight: Self::Weight) -> Self::Weight;

    /// The nearest number.
    #[doc(hidden)]
    fn from_weight(weight: Self::Weight) -> Self;

    /// `x·degree/(high − low)`; 0 for knots that coincide.
    #[doc(hidden)]
    fn slope(x: Self::Inner, degree: u16, low: Self, high: Self) -> Self::Inner;

    /// `x·(high − low)/(outer_high − outer_low)`: an interval inside of another one.
    #[doc(hidden)]
    fn share(x: Self::Inner, inside: [Self; 2], outside: [Self; 2]) -> Self::Inner;

    /// The parameter in `from..to` that differs from t by a multiple of `to − from`.
    #[doc(hidden)]
    fn wrap(t: Self, from: Self, to: Self) -> Self;

    /// `from + (to − from)·index/count`, for `index < count`.
    #[doc(hidden)]
    fn between(from: Self, to: Self, index: u32, count: u32) -> Self;

    /// The length of a vector.
    #[doc(hidden)]
    fn norm(coordinates: &[Self::Inner]) -> Self::Inner;

    /// `√(norm·factor/(8·tolerance))`, rounded upwards, at least 1.
    #[doc(hidden)]
    fn segments(norm: Self::Inner, factor: u16, tolerance: Self) -> u32;

    #[doc(hidden)]
    fn local(t: Self, start: Self, frame: &Self::Frame) -> Self::Local;

    /// `sum·local + coefficient`.
    #[doc(hidden)]
    fn horner(
        sum: Self::Coefficient,
        local: Self::Local,
        c: Self::Coefficient,
    ) -> Self::Coefficient;

    /// The value of a baked polynomial.
    #[doc(hidden)]
    fn baked(sum: Self::Coefficient, base: Self::Base, frame: &Self::Frame) -> Self;
}
