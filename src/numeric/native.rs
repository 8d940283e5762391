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
    Split + Div<Output = Self> + Neg<Output = Self> + PartialOrd + Debug + Loggable + 'static
{
    /// Numbers that generic code can't write.
    const CONSTANTS: Constants<Self>;

    /// The product and its rounding error, exactly: `a·b = product + error`.
    fn two_product(a: Self, b: Self) -> (Self, Self);

    /// The nearest number.
    fn from_i32(integer: i32) -> Self;

    /// The nearest number.
    fn from_f64(number: f64) -> Self;

    /// The same number.
    fn to_f64(self) -> f64;

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

    /// The next smaller number.
    fn predecessor(self) -> Self;

    /// A power of two that brings a positive finite number to [1, 2); the largest ones get the
    /// smallest normal power.
    fn inverse_power(self) -> Self;
}

/// Numbers of one type.
#[derive(Debug)]
pub struct Constants<S> {
    /// Of the mantissa.
    pub(crate) bits: u32,
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
    ($Float:ident, $Bits:ident, $lengths:expr, $two_product:path, $sqrt:path, $sin_cos:path) => {
        impl Native for $Float {
            const CONSTANTS: Constants<Self> = Constants {
                bits: $Float::MANTISSA_DIGITS,
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
            fn from_f64(number: f64) -> Self {
                number as $Float
            }

            #[inline]
            fn to_f64(self) -> f64 {
                self.into()
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
                self.is_normal()
            }

            #[inline]
            fn root(self) -> Self {
                $sqrt(self)
            }

            fn sine_and_cosine(self) -> (Self, Self) {
                $sin_cos(self)
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

native!(f32, u32, [1e-12, 1e15], two_product_f32, sqrt_f32, libm::sincosf);
native!(f64, u64, [1e-60, 1e60], two_product, libm::sqrt, libm::sincos);
