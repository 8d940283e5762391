//! The arithmetic of splines: what number types do in ways of their own.

pub(super) mod constant;
pub(super) mod fixed;
pub(super) mod float;
pub(super) mod order;

use crate::scalar::Scalar;
use core::fmt::Debug;

/// A number type that splines can be made of: every [`Scalar`].
///
/// Inside of an evaluation, numbers are of the type `Inner`: in floating point the type itself; in
/// fixed point 64 bits, of which 28 are guard bits. So a value is rounded once. Basis functions are
/// computed in twice the working precision: their errors are relative, and nothing waits for them.
pub trait SplineScalar: Scalar {
    /// A number inside of an evaluation.
    #[doc(hidden)]
    type Inner: Copy + Debug + PartialEq + PartialOrd + 'static;
    /// The value of a basis function inside of an evaluation.
    #[doc(hidden)]
    type Weight: Copy;
    /// Where a parameter is between two knots.
    #[doc(hidden)]
    type Ratio: Copy;
    /// How a parameter becomes the local one of a piece of a baked curve.
    #[doc(hidden)]
    type LocalMap: Copy + Debug + PartialEq;
    /// Something for every polynomial of a baked curve: in floating point a span has three of them.
    #[doc(hidden)]
    type Pieces<T: Copy + Debug + PartialEq, const SPANS: usize>: Copy + Debug + PartialEq;
    /// A coefficient of a baked curve, and the local parameter of a span.
    #[doc(hidden)]
    type Coefficient: Copy + Debug + PartialEq + 'static;
    /// An unsigned integer: how many numbers lie between two of the type's.
    #[doc(hidden)]
    type Key: Copy + Debug + Ord;
    /// What is done to the value of a baked polynomial at the end.
    #[doc(hidden)]
    type Base: Copy + Debug + PartialEq + 'static;

    /// The smallest and the largest coordinate of a control point.
    #[doc(hidden)]
    const RANGE: [Self; 2];
    /// 0.
    #[doc(hidden)]
    const NOTHING: Self::Inner;
    /// The weight 1.
    #[doc(hidden)]
    const FULL: Self::Weight;
    /// The weight 0.
    #[doc(hidden)]
    const NONE: Self::Weight;

    #[doc(hidden)]
    fn inner(self) -> Self::Inner;

    /// The nearest number, held inside of the type's range.
    #[doc(hidden)]
    fn outer(inner: Self::Inner) -> Self;

    /// Whether this and all like it can be blended without being held inside of a range.
    #[doc(hidden)]
    fn is_within(inner: Self::Inner) -> bool;

    /// As [`outer`](Self::outer), or `None` out of the type's range.
    #[doc(hidden)]
    fn checked(inner: Self::Inner) -> Option<Self>;

    #[doc(hidden)]
    fn add(a: Self::Inner, b: Self::Inner) -> Self::Inner;

    #[doc(hidden)]
    fn subtract(a: Self::Inner, b: Self::Inner) -> Self::Inner;

    /// Where t is between `low` and `high`, which is larger.
    #[doc(hidden)]
    fn ratio(t: Self, low: Self, high: Self) -> Self::Ratio;

    /// As [`ratio`](Self::ratio), for the many blends of a high order: in floating point with what
    /// rounding leaves of it.
    #[doc(hidden)]
    #[inline]
    fn fine_ratio(t: Self, low: Self, high: Self) -> Self::Ratio {
        Self::ratio(t, low, high)
    }

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

    /// `(b − a)·degree/(high − low)`; 0 for knots that coincide.
    #[doc(hidden)]
    fn slope(a: Self::Inner, b: Self::Inner, degree: u16, low: Self, high: Self) -> Self::Inner;

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

    /// How many numbers this is behind the one with the key `start`; before it, it is more than any
    /// number behind it is.
    #[doc(hidden)]
    fn after(self, start: Self::Key) -> Self::Key;

    #[doc(hidden)]
    fn from_key(key: Self::Key) -> Self;

    #[doc(hidden)]
    fn pieces<T: Copy + Debug + PartialEq, const SPANS: usize>(
        pieces: &Self::Pieces<T, SPANS>,
    ) -> &[T];

    /// Where a parameter is in a baked span: from −1 to 1, in fixed point from −1/2 to 1/2 of 2³².
    #[doc(hidden)]
    fn local(t: Self, map: &Self::LocalMap) -> Self::Coefficient;

    /// `sum·local + coefficient`.
    #[doc(hidden)]
    fn horner(
        sum: Self::Coefficient,
        local: Self::Coefficient,
        c: Self::Coefficient,
    ) -> Self::Coefficient;

    /// The same as the last step of a high order: in floating point rounded once.
    #[doc(hidden)]
    #[inline]
    fn last(
        sum: Self::Coefficient,
        local: Self::Coefficient,
        c: Self::Coefficient,
    ) -> Self::Coefficient {
        Self::horner(sum, local, c)
    }

    /// The value of a baked polynomial.
    #[doc(hidden)]
    fn baked(sum: Self::Coefficient, base: Self::Base, map: &Self::LocalMap) -> Self;

    /// A derivative of a baked polynomial at any parameter, from its coefficients and their
    /// powers, the highest first. `None` out of the type's range.
    #[doc(hidden)]
    fn extended(
        terms: impl Iterator<Item = (usize, Self::Coefficient)>,
        base: Self::Base,
        order: usize,
        t: Self,
        map: &Self::LocalMap,
    ) -> Option<Self>;
}

/// i(i−1)…(i−order+1): the factor of a power's derivative.
#[inline]
pub(super) fn falling(i: usize, order: usize) -> i64 {
    (0..order).fold(1, |product, j| product * (i as i64 - j as i64))
}
