//! Splines in floating point.

use super::blend::{Blend, falling};
use crate::scalar::{Double, Float, FloatFrame, Number, Real, Scalar};
use core::fmt::Debug;
use core::hint::select_unpredictable;

/// Where a parameter is between two knots: measured from the nearer one.
///
/// So the error of `anchor + (b − a)·offset` is small against the difference of a and b, and both
/// ends are exact.
#[doc(hidden)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nearer<S> {
    from_high: bool,
    /// From −1/2 to 1/2 for parameters between the knots.
    offset: S,
    /// What rounding has left of it, where that is known.
    rest: Option<S>,
}

/// The value of a basis function, in twice the working precision.
#[doc(hidden)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Weight<S>(Double<S>);

impl<S: Float> Weight<S> {
    /// `self·part/whole`; 0 for a whole of 0.
    #[inline(never)] // inlined, it makes five times the code
    fn share(self, part: Double<S>, whole: Double<S>) -> Self {
        Self(self.0.times(quotient(part, whole)))
    }

    /// `self·degree/width`, with a size up to `most`; 0 for a width of 0.
    #[inline(never)]
    fn climb(self, degree: S, width: Double<S>, most: S) -> Self {
        let within = |x: S| Self(Double::from(x.min(most).max(-most)));
        // A product's error may overflow before the product does.
        if self.0.high.abs() > most * S::EPSILON {
            let is_empty = width.high == S::ZERO;
            return within(if is_empty { S::ZERO } else { self.0.high / width.high * degree });
        }
        let product = self.0.times(Double::from(degree));
        let Double { high, low } = quotient(product, width);
        // Outside of the range in which the product of quotient and divisor has an exact error.
        if high.abs() > S::MAX_COORDINATE { within(high) } else { Self(Double { high, low }) }
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

macro_rules! orders {
    ($($order:ident $Float:ident $Whole:ident),+) => {$(
        /// A whole number in the order of the floats, −0 below 0. It is its own inverse.
        #[inline]
        pub(super) const fn $order(x: $Float) -> $Whole {
            let bits = x.to_bits().cast_signed();
            bits ^ ((bits >> ($Whole::BITS - 1)).cast_unsigned() >> 1).cast_signed()
        }
    )+};
}

orders!(order_f32 f32 i32, order_f64 f64 i64);

macro_rules! floats {
    ($($Float:ident $fmod:path, $Key:ident $Whole:ident $order:ident),+) => {$(
        impl Blend for $Float {
            type Inner = Self;
            type Weight = Weight<Self>;
            type Ratio = Nearer<Self>;
            type Frame = FloatFrame<Self>;
            type Pieces<T: Copy + Debug + PartialEq, const SPANS: usize> = [[T; 3]; SPANS];
            type Coefficient = Self;
            type Key = $Key;
            type Base = ();

            const LARGEST: Self = Self::MAX_COORDINATE;
            const NOTHING: Self = 0.0;
            const FULL: Weight<Self> = Weight(Double { high: 1.0, low: 0.0 });
            const NONE: Weight<Self> = Weight(Double { high: 0.0, low: 0.0 });

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
                let offset = quotient(Double::sum(t, -near), Double::sum(high, -low));
                Nearer { from_high, offset: offset.high, rest: Some(offset.low) }
            }

            #[inline]
            fn blend(a: Self, b: Self, ratio: Nearer<Self>) -> Self {
                let anchor = select_unpredictable(ratio.from_high, b, a);
                let product = (b - a) * ratio.offset;
                anchor + ratio.rest.map_or(product, |rest| product + (b - a) * rest)
            }

            fn rise(weight: Weight<Self>, t: Self, low: Self, high: Self) -> Weight<Self> {
                weight.share(Double::sum(t, -low), Double::sum(high, -low))
            }

            fn fall(weight: Weight<Self>, t: Self, low: Self, high: Self) -> Weight<Self> {
                weight.share(Double::sum(high, -t), Double::sum(high, -low))
            }

            fn climb(weight: Weight<Self>, degree: u16, low: Self, high: Self) -> Weight<Self> {
                weight.climb(Self::from(degree), Double::sum(high, -low), Self::MAX / 4.0)
            }

            fn add_weights(a: Weight<Self>, b: Weight<Self>) -> Weight<Self> {
                Weight(a.0.plus(b.0))
            }

            #[inline]
            fn negate_weight(weight: Weight<Self>) -> Weight<Self> {
                Weight(Double { high: -weight.0.high, low: -weight.0.low })
            }

            #[inline]
            fn from_weight(weight: Weight<Self>) -> Self {
                weight.0.round()
            }

            #[inline]
            fn slope(a: Self, b: Self, degree: u16, low: Self, high: Self) -> Self {
                // The product first: it is exact for the small whole numbers that most terms are.
                if low < high { (b - a) * Self::from(degree) / (high - low) } else { 0.0 }
            }

            #[inline]
            fn share(x: Self, [low, high]: [Self; 2], outside: [Self; 2]) -> Self {
                x * ((high - low) / (outside[1] - outside[0]))
            }

            fn wrap(t: Self, from: Self, to: Self) -> Self {
                let period = to - from;
                // The remainder is exact and has the sign of t − from.
                let rest = $fmod(t - from, period);
                let wrapped = from + if rest < 0.0 { rest + period } else { rest };
                Number::max(Number::min(wrapped, to), from)
            }

            #[inline]
            fn between(from: Self, to: Self, index: u32, count: u32) -> Self {
                let t = from + (to - from) * (index as Self / count as Self);
                Number::min(t, to)
            }

            fn norm(coordinates: &[Self]) -> Self {
                // Squares of coordinates of up to REACH don't overflow in `f32` only just.
                let largest = coordinates.iter().fold(0.0, |most, x| Number::max(Number::abs(*x), most));
                let scale = largest.normalizing_power();
                let sum = coordinates.iter().fold(0.0, |sum, x| {
                    let x = x * scale;
                    sum + x * x
                });
                Real::sqrt(sum) / scale
            }

            fn segments(norm: Self, factor: u16, tolerance: Self) -> u32 {
                let exact = Real::sqrt(norm / tolerance * (Self::from(factor) / 8.0));
                // Large quotients stay at the largest whole number.
                let whole = exact as u32;
                let more = u32::from(exact > whole as Self);
                whole.saturating_add(more).max(1)
            }

            #[inline]
            fn after(self, start: $Key) -> $Key {
                $order(self).cast_unsigned().wrapping_sub(start)
            }

            #[inline]
            fn from_key(key: $Key) -> Self {
                Self::from_bits($order(Self::from_bits(key)).cast_unsigned())
            }

            #[inline]
            fn pieces<T: Copy + Debug + PartialEq, const SPANS: usize>(
                pieces: &Self::Pieces<T, SPANS>,
            ) -> &[T] {
                pieces.as_flattened()
            }

            #[inline]
            fn before(t: Self, end: Self) -> Self {
                Number::min(t, end.next_down())
            }

            #[inline]
            fn local(t: Self, frame: &Self::Frame) -> Self {
                t * frame.scale + frame.shift
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
            fn baked(sum: Self, (): (), _: &Self::Frame) -> Self {
                sum
            }

            fn extended(
                terms: impl Iterator<Item = (usize, Self)>,
                (): (),
                order: usize,
                t: Self,
                frame: &Self::Frame,
            ) -> Option<Self> {
                let local = Self::local(t, frame);
                let sum = terms.fold(0.0, |sum, (power, c)| {
                    sum * local + c * falling(power, order) as Self
                });
                Self::checked((0..order).fold(sum, |sum, _| sum * frame.scale))
            }
        }
    )+};
}

floats!(
    f32 libm::fmodf, u32 i32 order_f32,
    f64 libm::fmod, u64 i64 order_f64
);

const _: () = assert!(<f32 as Scalar>::MAX_COORDINATE < 1e18);
