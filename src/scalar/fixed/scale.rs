//! Factors of any size for fixed-point numbers.

use super::wide::Wide;
use crate::numeric::integer::{normalized, reciprocal, shift_right};
use crate::numeric::product;

/// `mantissa · 2^−shift`: a number ≥ 0 with 31 significant bits, whatever its size.
///
/// A reciprocal or a stretch may be far from 1, where a fixed number of digits behind the point
/// would be too few. A product costs one multiplication of 32 by 32 bits and a shift.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Scale {
    mantissa: u32,
    shift: i32,
}

impl Scale {
    /// 0.
    pub(super) const NONE: Self = Self { mantissa: 0, shift: 0 };

    /// The factor of a number ≥ 0; of one below, 0.
    pub(super) fn new(number: Wide) -> Self {
        let bits = u64::try_from(number.to_bits()).unwrap_or(0);
        let (mantissa, exponent) = normalized(bits);
        // One bit less than it could have, so that products fit 63 bits.
        Self { mantissa: mantissa >> 1, shift: Wide::FRACTION_BITS as i32 - exponent - 1 }
    }

    /// 1/`number` for a number > 0, rounded down.
    pub(in crate::scalar) const fn inverse(number: Wide) -> Self {
        let bits = if number.to_bits() > 0 { number.to_bits().cast_unsigned() } else { 0 };
        let (mantissa, exponent) = normalized(bits);
        let shift = 62 + exponent - Wide::FRACTION_BITS as i32;
        Self { mantissa: reciprocal(mantissa) >> 1, shift }
    }

    /// `bits · self · 2^exponent`, rounded; what leaves the range stays at its end.
    #[inline]
    pub(super) fn times(self, bits: i32, exponent: i32) -> i64 {
        // The mantissa has 31 bits.
        let product = product(bits, self.mantissa.cast_signed());
        shift_right(product, self.shift - exponent)
    }

    /// As [`times`](Self::times), of a number of 64 bits, of which the first 32 count.
    #[inline]
    pub(super) fn times_wide(self, bits: i64, exponent: i32) -> i64 {
        let spare = bits.unsigned_abs().leading_zeros() as i32;
        let drop = (33 - spare).max(0);
        self.times(
            shift_right(bits, drop).clamp(i32::MIN.into(), i32::MAX.into()) as i32,
            exponent + drop,
        )
    }
}
