//! Splines in floating point.

use super::Arithmetic;
use super::order::Ordered;
use crate::scalar::{Double, Float, Scalar};
use core::fmt::Debug;
use core::hint::select_unpredictable;
use core::ops::Neg;

/// Where a parameter is between two knots: measured from the nearer one.
///
/// So the error of `anchor + (b − a)·offset` is small against the difference of a and b, and both
/// ends are exact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nearer<S> {
    from_high: bool,
    /// From −1/2 to 1/2 for parameters between the knots.
    offset: S,
    /// What rounding has left of it, where that is known.
    rest: Option<S>,
}

/// The value of a basis function, in twice the working precision.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Weight<S>(Double<S>);

/// The local parameter of a baked piece is `t·scale + shift`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FloatMap<S> {
    /// A power of two, so that the product is exact.
    pub(in crate::spline) scale: S,
    pub(in crate::spline) shift: S,
}

impl<S: Float> Neg for Weight<S> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self(Double { high: -self.0.high, low: -self.0.low })
    }
}

/// `a/b`, with a relative error of a few units of the last place of `low`; 0 for a divisor of 0.
fn quotient<S: Float>(a: Double<S>, b: Double<S>) -> Double<S> {
    if b.high == S::ZERO {
        return Double::from(S::ZERO);
    }
    let high = a.high / b.high;
    if high.abs() > S::MAX_COORDINATE {
        return Double::from(high);
    }
    let back = Double::product(high, b.high);
    let rest = ((a.high - back.high) - back.low) + (a.low - high * b.low);
    Double::sum(high, rest / b.high)
}

impl<S: Float + Ordered> Arithmetic for S {
    type Inner = Self;
    type Weight = Weight<Self>;
    type Ratio = Nearer<Self>;
    type LocalMap = FloatMap<Self>;
    type Pieces<T: Copy + Debug + PartialEq, const SPANS: usize> = [[T; 3]; SPANS];
    type Coefficient = Self;
    type Base = ();

    const FULL: Weight<Self> = Weight(Double { high: S::ONE, low: S::ZERO });
    const NONE: Weight<Self> = Weight(Double { high: S::ZERO, low: S::ZERO });

    #[inline]
    fn inner(self) -> Self {
        self
    }

    #[inline]
    fn outer(inner: Self) -> Self {
        inner
    }

    #[inline]
    fn is_within(inner: Self) -> bool {
        inner.is_finite()
    }

    #[inline]
    fn checked(inner: Self) -> Option<Self> {
        inner.is_finite().then_some(inner)
    }

    #[inline]
    fn add(a: Self, b: Self) -> Self {
        a + b
    }

    #[inline]
    fn subtract(a: Self, b: Self) -> Self {
        a - b
    }

    #[inline]
    fn ratio(t: Self, low: Self, high: Self) -> Nearer<Self> {
        let (above, below) = (t - low, t - high);
        let from_high = -below < above;
        let near = select_unpredictable(from_high, below, above);
        Nearer { from_high, offset: near / (high - low), rest: None }
    }

    #[inline]
    fn fine_ratio(t: Self, low: Self, high: Self) -> Nearer<Self> {
        let from_high = high - t < t - low;
        let near = select_unpredictable(from_high, high, low);
        // So that no product's error is too small to be a number.
        let scale = (high - low).normalizing_power();
        let [part, width] = [Double::sum(t, -near), Double::sum(high, -low)]
            .map(|Double { high, low }| Double { high: high * scale, low: low * scale });
        let offset = quotient(part, width);
        Nearer { from_high, offset: offset.high, rest: Some(offset.low) }
    }

    #[inline]
    fn blend(a: Self, b: Self, ratio: Nearer<Self>) -> Self {
        let anchor = select_unpredictable(ratio.from_high, b, a);
        let product = (b - a) * ratio.offset;
        anchor + ratio.rest.map_or(product, |rest| product + (b - a) * rest)
    }

    #[inline(never)] // inlined, it makes five times the code
    fn split(Weight(weight): Weight<Self>, t: Self, [low, high]: [Self; 2]) -> [Weight<Self>; 2] {
        let width = Double::sum(high, -low);
        [Double::sum(t, -low), Double::sum(high, -t)]
            .map(|part| Weight(weight.times(quotient(part, width))))
    }

    #[inline(never)]
    fn climb(Weight(weight): Weight<Self>, degree: u16, [low, high]: [Self; 2]) -> Weight<Self> {
        let (most, degree) =
            (S::CONSTANTS.largest * S::from_ratio(1, 4), Self::from_int(degree.into()));
        let within = |x: S| Weight(Double::from(x.min(most).max(-most)));
        let width = Double::sum(high, -low);
        // A product's error may overflow before the product does.
        if weight.high.abs() > most * S::EPSILON {
            let is_empty = width.high == S::ZERO;
            return within(if is_empty { S::ZERO } else { weight.high / width.high * degree });
        }
        let quotient = quotient(weight.times(Double::from(degree)), width);
        // Outside of the range in which the product of quotient and divisor has an exact error.
        let is_large = quotient.high.abs() > S::MAX_COORDINATE;
        if is_large { within(quotient.high) } else { Weight(quotient) }
    }

    fn add_weights(a: Weight<Self>, b: Weight<Self>) -> Weight<Self> {
        Weight(a.0.plus(b.0))
    }

    #[inline]
    fn from_weight(weight: Weight<Self>) -> Self {
        weight.0.round()
    }

    #[inline]
    fn slope(a: Self, b: Self, degree: u16, low: Self, high: Self) -> Self {
        // The product first: it is exact for the small integers that most terms are.
        if low < high { (b - a) * Self::from_int(degree.into()) / (high - low) } else { S::ZERO }
    }

    #[inline]
    fn share(x: Self, part: Self, whole: Self) -> Self {
        if whole > S::ZERO { x * (part / whole) } else { S::ZERO }
    }

    fn project(vector: &[Self], along: &[Self], length: Self) -> Self {
        if length <= S::ZERO {
            return S::ZERO;
        }
        // The quotient first: products of lengths may be too small to be numbers.
        vector.iter().zip(along).fold(S::ZERO, |sum, (x, along)| sum + *x * (*along / length))
    }

    fn wrap(t: Self, from: Self, to: Self) -> Self {
        let period = to - from;
        // The remainder is exact and has the sign of t − from.
        let rest = (t - from).remainder(period);
        let wrapped = from + if rest < S::ZERO { rest + period } else { rest };
        wrapped.min(to).max(from)
    }

    #[inline]
    fn between(from: Self, to: Self, index: u32, count: u32) -> Self {
        let [index, count] = [index, count].map(|x| Self::from_int(x.cast_signed()));
        let t = from + (to - from) * (index / count);
        t.min(to)
    }

    fn norm(coordinates: &[Self]) -> Self {
        // Squares of coordinates of up to MAX_COORDINATE don't overflow in `f32` only just.
        let largest = coordinates.iter().fold(S::ZERO, |most, x| x.abs().max(most));
        let scale = largest.normalizing_power();
        let sum = coordinates.iter().fold(S::ZERO, |sum, x| {
            let x = *x * scale;
            sum + x * x
        });
        sum.sqrt() / scale
    }

    #[inline]
    fn pieces<T: Copy + Debug + PartialEq, const SPANS: usize>(
        pieces: &Self::Pieces<T, SPANS>,
    ) -> &[T] {
        pieces.as_flattened()
    }

    #[inline]
    fn local(t: Self, map: &Self::LocalMap) -> Self {
        t * map.scale + map.shift
    }

    #[inline]
    fn horner(sum: Self, local: Self, c: Self) -> Self {
        sum * local + c
    }

    #[inline]
    fn last(sum: Self, local: Self, c: Self) -> Self {
        Float::add_product(c, sum, local)
    }

    #[inline]
    fn baked(sum: Self, (): (), _: &Self::LocalMap) -> Self {
        sum
    }

    fn extended(
        terms: impl Iterator<Item = (usize, Self)>,
        (): (),
        order: usize,
        t: Self,
        map: &Self::LocalMap,
    ) -> Option<Self> {
        let local = Self::local(t, map);
        let sum = terms.fold(S::ZERO, |sum, (power, c)| {
            let factors = (0..order).map(|j| Self::from_int((power - j) as i32));
            sum * local + c * factors.fold(S::ONE, |falling, factor| falling * factor)
        });
        Self::checked((0..order).fold(sum, |sum, _| sum * map.scale))
    }
}

const _: () = assert!(<f32 as Scalar>::MAX_COORDINATE < 1e18);
