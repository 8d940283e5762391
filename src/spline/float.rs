//! Splines in floating point.

use super::blend::Blend;
use crate::scalar::{Number, Real, Scalar};

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
}

/// The local parameter of a baked span is `((t − start) − half)·scale`.
#[doc(hidden)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FloatFrame<S> {
    pub(super) half: S,
    /// A power of two, so that the product is exact.
    pub(super) scale: S,
}

macro_rules! floats {
    ($($Float:ident $fmod:path),+) => {$(
        impl Blend for $Float {
            type Inner = Self;
            type Ratio = Nearer<Self>;
            type Frame = FloatFrame<Self>;
            type Local = Self;
            type Coefficient = Self;
            type Base = ();

            const LARGEST: Self = Self::REACH;
            const NOTHING: Self = 0.0;
            const EXTENDS: bool = true;

            #[inline]
            fn inner(self) -> Self {
                self
            }

            #[inline]
            fn outer(inner: Self) -> Self {
                inner
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
                Nearer { from_high, offset: if from_high { below } else { above } / (high - low) }
            }

            #[inline]
            fn blend(a: Self, b: Self, ratio: Nearer<Self>) -> Self {
                let anchor = if ratio.from_high { b } else { a };
                anchor + (b - a) * ratio.offset
            }

            #[inline]
            fn rise(x: Self, t: Self, low: Self, high: Self) -> Self {
                if low < high { x * ((t - low) / (high - low)) } else { 0.0 }
            }

            #[inline]
            fn fall(x: Self, t: Self, low: Self, high: Self) -> Self {
                if low < high { x * ((high - t) / (high - low)) } else { 0.0 }
            }

            #[inline]
            fn slope(x: Self, degree: u16, low: Self, high: Self) -> Self {
                // The product first: it is exact for the small whole numbers that most terms are.
                if low < high { x * Self::from(degree) / (high - low) } else { 0.0 }
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
            fn local(t: Self, start: Self, frame: &Self::Frame) -> Self {
                ((t - start) - frame.half) * frame.scale
            }

            #[inline]
            fn horner(sum: Self, local: Self, c: Self) -> Self {
                sum * local + c
            }

            #[inline]
            fn baked(sum: Self, (): (), _: &Self::Frame) -> Self {
                sum
            }
        }
    )+};
}

floats!(f32 libm::fmodf, f64 libm::fmod);

const _: () = assert!(<f32 as Scalar>::REACH < 1e18);
