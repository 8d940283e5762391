//! The floating-point numbers that a processor or a compiler's library computes with.

use super::error_free::{Split, two_product};
use super::select::{sqrt_f32, two_product_f32};
use core::fmt::Debug;
use core::ops::{Div, Neg};

/// A number may be logged only where its type says how.
#[cfg(feature = "defmt")]
pub trait Loggable: defmt::Format {}
#[cfg(feature = "defmt")]
impl<T: defmt::Format> Loggable for T {}

/// Every number may be logged, as nothing can log.
#[cfg(not(feature = "defmt"))]
pub trait Loggable {}
#[cfg(not(feature = "defmt"))]
impl<T> Loggable for T {}

/// `f32` or `f64`.
pub trait Native:
    Split
    + Div<Output = Self>
    + Neg<Output = Self>
    + PartialOrd
    + Into<f64>
    + Debug
    + Loggable
    + 'static
{
    /// Numbers that generic code can't write.
    const CONSTANTS: Constants<Self>;

    /// The product and its rounding error, exactly: `a·b = product + error`.
    fn two_product(a: Self, b: Self) -> (Self, Self);

    /// The nearest number.
    fn from_i32(integer: i32) -> Self;

    /// The nearest number.
    fn from_double(number: f64) -> Self;

    /// The number without its fraction, held inside the range; 0 for NaN.
    fn to_i32(self) -> i32;

    /// The number without its fraction, held inside the range; 0 for NaN.
    fn to_u8(self) -> u8;

    /// The absolute value.
    fn magnitude(self) -> Self;

    /// Whether the number is finite, and large enough to have all its digits.
    fn has_all_digits(self) -> bool;

    /// The square root, correctly rounded; NaN below zero.
    fn root(self) -> Self;

    /// Sine and cosine of an angle in radians.
    fn sine_and_cosine(self) -> (Self, Self);

    /// The remainder of a division, exactly; it has the sign of `self`.
    fn remainder(self, divisor: Self) -> Self;

    /// The next smaller number.
    fn predecessor(self) -> Self;

    /// A power of two that brings a positive finite number to [1, 2); the largest ones get the
    /// smallest normal power.
    fn inverse_power(self) -> Self;
}

/// Numbers of one type.
#[derive(Debug)]
pub struct Constants<S> {
    pub(crate) zero: S,
    pub(crate) half: S,
    pub(crate) one: S,
    pub(crate) pi: S,
    /// The distance from 1 to the next larger number.
    pub(crate) epsilon: S,
    pub(crate) largest: S,
    pub(crate) infinity: S,
    pub(crate) minus_infinity: S,
    /// Lengths from the first to the second have squares that can be added up, multiplied with
    /// numbers of the size of 1, and divided by each other: nothing overflows or vanishes.
    pub(crate) lengths: [S; 2],
}

macro_rules! native {
    ($Float:ident, $Bits:ident, $lengths:expr, $two_product:path, $sqrt:path, $sin_cos:path, $fmod:path) => {
        impl Native for $Float {
            const CONSTANTS: Constants<Self> = Constants {
                zero: 0.0,
                half: 0.5,
                one: 1.0,
                pi: core::$Float::consts::PI,
                epsilon: $Float::EPSILON,
                largest: $Float::MAX,
                infinity: $Float::INFINITY,
                minus_infinity: $Float::NEG_INFINITY,
                lengths: $lengths,
            };

            #[inline]
            fn two_product(a: Self, b: Self) -> (Self, Self) {
                $two_product(a, b)
            }

            #[inline]
            fn from_i32(integer: i32) -> Self {
                integer as $Float
            }

            #[inline]
            fn from_double(number: f64) -> Self {
                number as $Float
            }

            #[inline]
            fn to_i32(self) -> i32 {
                self as i32
            }

            #[inline]
            fn to_u8(self) -> u8 {
                self as u8
            }

            #[inline]
            fn magnitude(self) -> Self {
                self.abs()
            }

            #[inline]
            fn has_all_digits(self) -> bool {
                // In comparisons of integers, which compilers keep: half as long as `is_normal`.
                const INFINITE: $Bits = $Float::INFINITY.to_bits();
                (self.to_bits() & INFINITE).wrapping_sub(1) < INFINITE - 1
            }

            #[inline]
            fn root(self) -> Self {
                $sqrt(self)
            }

            fn sine_and_cosine(self) -> (Self, Self) {
                $sin_cos(self)
            }

            fn remainder(self, divisor: Self) -> Self {
                $fmod(self, divisor)
            }

            fn predecessor(self) -> Self {
                self.next_down()
            }

            #[inline]
            fn inverse_power(self) -> Self {
                const MANTISSA: u32 = $Float::MANTISSA_DIGITS - 1;
                const BIAS: $Bits = ($Float::MAX_EXP - 1) as $Bits;
                let exponent = self.abs().to_bits() >> MANTISSA;
                $Float::from_bits((2 * BIAS).saturating_sub(exponent).max(1) << MANTISSA)
            }
        }
    };
}

native!(f32, u32, [1e-12, 1e15], two_product_f32, sqrt_f32, libm::sincosf, libm::fmodf);
native!(f64, u64, [1e-60, 1e60], two_product, libm::sqrt, libm::sincos, libm::fmod);

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn normal_numbers_have_all_digits(bits: u64, exponent in prop_oneof![Just(0), Just(0x7ff), Just(1)]) {
            for bits in [bits, bits & !(0x7ff << 52) | exponent << 52] {
                let (double, single) = (f64::from_bits(bits), f32::from_bits((bits >> 32) as u32));
                prop_assert_eq!(double.has_all_digits(), double.is_normal());
                prop_assert_eq!(single.has_all_digits(), single.is_normal());
            }
        }
    }

    #[test]
    fn the_ends_of_the_range() {
        for x in [
            0.0,
            f32::MIN_POSITIVE,
            f32::MIN_POSITIVE.next_down(),
            f32::MAX,
            f32::INFINITY,
            f32::NAN,
        ] {
            assert_eq!(x.has_all_digits(), x.is_normal());
            assert_eq!((-x).has_all_digits(), x.is_normal());
        }
    }
}
