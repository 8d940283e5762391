//! The arithmetic of splines: what number types do in ways of their own.

pub(super) mod constant;
mod cumulative;
pub(super) mod fixed;
pub(super) mod float;
pub(super) mod order;

use crate::scalar::Scalar;
use core::fmt::Debug;
use core::ops::Neg;
use order::Ordered;

/// A number type that splines can be made of: every [`Scalar`].
pub trait SplineScalar: Scalar + Arithmetic {}

impl<S: Arithmetic> SplineScalar for S {}

/// The arithmetic of splines.
///
/// Inside of an evaluation, numbers are of the type `Inner`: in floating point the type itself; in
/// fixed point 64 bits, of which 28 are guard bits. So a value is rounded once. Basis functions are
/// computed in twice the working precision: their errors are relative, and nothing waits for them.
pub trait Arithmetic: Scalar + Ordered {
    /// A number inside of an evaluation.
    type Inner: Copy + Debug + PartialEq + PartialOrd + 'static;
    /// The value of a basis function inside of an evaluation.
    type Weight: Copy + Neg<Output = Self::Weight>;
    /// Where a parameter is between two knots.
    type Ratio: Copy;
    /// How a parameter becomes the local one of a piece of a baked curve.
    type LocalMap: Copy + Debug + PartialEq;
    /// Something for every polynomial of a baked curve: in floating point a span has three of them.
    type Pieces<T: Copy + Debug + PartialEq, const SPANS: usize>: Copy + Debug + PartialEq;
    /// A coefficient of a baked curve, and the local parameter of a span.
    type Coefficient: Copy + Debug + PartialEq + 'static;
    /// What is done to the value of a baked polynomial at the end.
    type Base: Copy + Debug + PartialEq + 'static;

    /// The weight 1.
    const FULL: Self::Weight;
    /// The weight 0.
    const NONE: Self::Weight;

    fn inner(self) -> Self::Inner;

    /// The nearest number, held inside of the type's range.
    fn outer(inner: Self::Inner) -> Self;

    /// Whether this and all like it can be blended without being held inside of a range.
    fn is_within(inner: Self::Inner) -> bool;

    /// As [`outer`](Self::outer), or `None` out of the type's range.
    fn checked(inner: Self::Inner) -> Option<Self>;

    fn add(a: Self::Inner, b: Self::Inner) -> Self::Inner;

    fn subtract(a: Self::Inner, b: Self::Inner) -> Self::Inner;

    /// Where t is between `low` and `high`, which is larger.
    fn ratio(t: Self, low: Self, high: Self) -> Self::Ratio;

    /// As [`ratio`](Self::ratio), for the many blends of a high order: in floating point with what
    /// rounding leaves of it.
    #[inline]
    fn fine_ratio(t: Self, low: Self, high: Self) -> Self::Ratio {
        Self::ratio(t, low, high)
    }

    /// `a + (b − a)·ratio`; exactly a or b where t was `low` or `high`.
    fn blend(a: Self::Inner, b: Self::Inner, ratio: Self::Ratio) -> Self::Inner;

    /// The point at a parameter, of a span whose K control points have these coordinates, given the K
    /// knots from its beginning backwards, in ascending order, and those from its end on. `None` where
    /// blends are the way to it.
    #[inline]
    fn summed<A: Copy + AsRef<[Self]> + AsMut<[Self]>, const K: usize>(
        _points: impl Fn() -> [A; K],
        _knots: [&[Self; K]; 2],
        _t: Self,
    ) -> Option<A> {
        None
    }

    /// `weight·(t − low)/(high − low)` and `weight·(high − t)/(high − low)`, for `low ≤ t ≤ high`; 0 for
    /// knots that coincide.
    fn split(weight: Self::Weight, t: Self, interval: [Self; 2]) -> [Self::Weight; 2];

    /// `weight·degree/(high − low)`, held inside of the type's range; 0 for knots that coincide.
    fn climb(weight: Self::Weight, degree: u16, interval: [Self; 2]) -> Self::Weight;

    fn add_weights(a: Self::Weight, b: Self::Weight) -> Self::Weight;

    /// The nearest number.
    fn from_weight(weight: Self::Weight) -> Self;

    /// `(b − a)·degree/(high − low)`; 0 for knots that coincide.
    fn slope(a: Self::Inner, b: Self::Inner, degree: u16, low: Self, high: Self) -> Self::Inner;

    /// `x·part/whole`, for 0 ≤ part ≤ whole; 0 for a whole of 0.
    fn share(x: Self::Inner, part: Self::Inner, whole: Self::Inner) -> Self::Inner;

    /// How far a vector reaches along another one of this length; 0 for a length of 0.
    fn project(vector: &[Self::Inner], along: &[Self::Inner], length: Self::Inner) -> Self::Inner;

    /// The parameter in `from..to` that differs from t by a multiple of `to − from`.
    fn wrap(t: Self, from: Self, to: Self) -> Self;

    /// `from + (to − from)·index/count`, for `index < count`.
    fn between(from: Self, to: Self, index: u32, count: u32) -> Self;

    /// The length of a vector.
    fn norm(coordinates: &[Self::Inner]) -> Self::Inner;

    fn pieces<T: Copy + Debug + PartialEq, const SPANS: usize>(
        pieces: &Self::Pieces<T, SPANS>,
    ) -> &[T];

    /// Where a parameter is in a baked span: from −1 to 1, in fixed point from −1/2 to 1/2 of 2³².
    fn local(t: Self, map: &Self::LocalMap) -> Self::Coefficient;

    /// `sum·local + coefficient`.
    fn horner(
        sum: Self::Coefficient,
        local: Self::Coefficient,
        c: Self::Coefficient,
    ) -> Self::Coefficient;

    /// The same as the last step of a high order: in floating point rounded once.
    #[inline]
    fn last(
        sum: Self::Coefficient,
        local: Self::Coefficient,
        c: Self::Coefficient,
    ) -> Self::Coefficient {
        Self::horner(sum, local, c)
    }

    /// The value of a baked polynomial.
    fn baked(sum: Self::Coefficient, base: Self::Base, map: &Self::LocalMap) -> Self;

    /// A derivative of a baked polynomial at any parameter, from its coefficients and their
    /// powers, the highest first. `None` out of the type's range.
    fn extended(
        terms: impl Iterator<Item = (usize, Self::Coefficient)>,
        base: Self::Base,
        order: usize,
        t: Self,
        map: &Self::LocalMap,
    ) -> Option<Self>;
}
