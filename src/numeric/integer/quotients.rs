//! Quotients and reciprocals.

use crate::numeric::select::{CORE, Core, unsigned_product};

/// `numerator / divisor`, cut off; the end of the range where it is larger, and for a divisor of 0.
/// For numerators below 2¹²⁷ and divisors up to 2⁶³.
///
/// Two digits of 32 bits (Knuth, 4.3.1 D), each estimated by the reciprocal of the divisor's first word.
#[inline(never)]
pub(crate) const fn long_quotient(numerator: u128, divisor: u64) -> u64 {
    if (numerator >> 64) as u64 >= divisor {
        return u64::MAX;
    }
    let zeros = leading_zeros(divisor);
    let (numerator, divisor) = (numerator << zeros, divisor << zeros);
    let (high, low) = ((divisor >> 32) as u32, divisor as u32);
    let inverse = reciprocal(high);
    let (mut rest, mut quotient) = ((numerator >> 64) as u64, 0);
    let mut word = 2;
    while word > 0 {
        word -= 1;
        let next = (numerator >> (32 * word)) as u32;
        let estimate = unsigned_product((rest >> 32) as u32, inverse) >> 31;
        let mut digit = if estimate > u32::MAX as u64 { u32::MAX } else { estimate as u32 };
        // What was cut off makes the estimate some units too small or too large.
        let of_high = (unsigned_product(digit, high) as i128) << 32;
        let mut left = ((rest as i128) << 32 | next as i128) - of_high;
        left -= unsigned_product(digit, low) as i128;
        while left < 0 {
            left += divisor as i128;
            digit -= 1;
        }
        while left >= divisor as i128 {
            left -= divisor as i128;
            digit += 1;
        }
        quotient = quotient << 32 | digit as u64;
        rest = left as u64;
    }
    quotient
}

/// `numerator · 2²⁰ / divisor`, rounded to nearest, halves upwards, for quotients of 32 bits and divisors
/// below 2⁵⁶; `inverse` is the reciprocal of the [`normalized`] divisor.
#[inline]
pub(crate) const fn quotient_by(inverse: u32, exponent: i32, divisor: u64, numerator: i64) -> i64 {
    let (mantissa, own) = normalized(numerator.unsigned_abs());
    let roughly = unsigned_product(mantissa, inverse);
    let mut quotient = match roughly.checked_shr((43 + exponent - own).cast_unsigned()) {
        Some(quotient) => quotient,
        None => 0,
    };
    // Off by a few units at most, so of the rest 64 bits tell all.
    let exact = numerator.unsigned_abs() << 20;
    let mut rest = exact.wrapping_sub(quotient.wrapping_mul(divisor)).cast_signed();
    while rest < 0 {
        rest += divisor as i64;
        quotient -= 1;
    }
    while rest >= divisor as i64 {
        rest -= divisor as i64;
        quotient += 1;
    }
    let twice = 2 * rest as u64;
    if numerator < 0 {
        -((quotient + (twice > divisor) as u64) as i64)
    } else {
        (quotient + (twice >= divisor) as u64) as i64
    }
}

/// The zeros in front of the first one.
#[inline]
pub(crate) const fn leading_zeros(value: u64) -> u32 {
    // A call for each word, where it's a call: so of one word only.
    match (value >> 32) as u32 {
        0 => 32 + (value as u32).leading_zeros(),
        high => high.leading_zeros(),
    }
}

/// A positive number as `mantissa · 2^exponent` with 2³¹ ≤ `mantissa` < 2³², cut off; 0 for 0.
#[inline]
pub(crate) const fn normalized(value: u64) -> (u32, i32) {
    if value == 0 {
        return (0, 0);
    }
    let zeros = leading_zeros(value);
    (((value << zeros) >> 32) as u32, 32 - zeros as i32)
}

/// `2^63 / mantissa` for 2³¹ ≤ `mantissa` < 2³²: between 2³¹ and 2³².
#[inline]
pub(crate) const fn reciprocal(mantissa: u32) -> u32 {
    match CORE {
        _ if mantissa == 0 => u32::MAX,
        Core::Narrow => reciprocal_by_steps(mantissa),
        Core::Word => reciprocal_by_halves(mantissa),
        // 2^63 − 1, so that the reciprocal of 2³¹ fits.
        Core::Long => (((1u64 << 63) - 1) / mantissa as u64) as u32,
    }
}

/// The same for cores that divide 32 bits in hardware: two digits of 16 bits (Knuth, 4.3.1 D).
const fn reciprocal_by_halves(mantissa: u32) -> u32 {
    let (high, low) = (mantissa >> 16, mantissa & 0xffff);
    let (mut rest, mut quotient, mut digits) = ((1u32 << 31) - 1, 0u32, 0);
    while digits < 2 {
        let mut digit = match rest.checked_div(high) {
            Some(digit) => digit,
            None => 0, // for no mantissa that there is
        };
        let mut left = rest - digit * high;
        while left < 0x1_0000 && (digit > 0xffff || digit * low > (left << 16 | 0xffff)) {
            digit -= 1;
            left += high;
        }
        rest = (rest << 16 | 0xffff).wrapping_sub(digit.wrapping_mul(mantissa));
        quotient = quotient << 16 | digit;
        digits += 1;
    }
    quotient
}

/// The same for cores that divide in software.
///
/// The table's reciprocal root, squared, has 7 digits; a step of third order makes 18 of them, and one
/// of Newton's all but the last: for no mantissa the quotient is off by more than one then.
const fn reciprocal_by_steps(mantissa: u32) -> u32 {
    // With a = mantissa / 2³²: 2¹⁶/a, and by how much a times that is short of one, in 32 digits.
    let root = SEEDS[(mantissa >> 24) as usize] as u32 + 256;
    let seed = root * root;
    let product =
        (mantissa >> 16).wrapping_mul(seed).wrapping_add(((mantissa >> 2 & 0x3fff) * seed) >> 14);
    let short = product.wrapping_neg().cast_signed();
    let short = short + (((short >> 11) * (short >> 11)) >> 10);
    // 2³⁰/a
    let half = (seed << 14).saturating_add_signed(((short >> 13) * seed.cast_signed()) >> 5);
    let rest = (1u64 << 62).wrapping_sub(unsigned_product(mantissa, half)).cast_signed();
    let step = (((rest >> 28) as i32) * (half >> 16).cast_signed()) >> 17;

    let mut quotient = half.saturating_mul(2).saturating_add_signed(step);
    let whole = (1u64 << 63) - 1;
    let mut rest = whole.wrapping_sub(unsigned_product(mantissa, quotient)).cast_signed();
    while rest < 0 {
        rest += mantissa as i64;
        quotient -= 1;
    }
    while rest >= mantissa as i64 {
        rest -= mantissa as i64;
        quotient += 1;
    }
    quotient
}

/// 256(1/√a − 1) in the middle of each 256th from 1/4 on.
pub(super) const SEEDS: [u8; 256] = {
    let mut seeds = [0; 256];
    let mut index = 64;
    while index < 256 {
        // ⌊√(2²⁵/(2i + 1))⌉, which is 256 to 512.
        let twice = ((1u32 << 27) / (2 * index as u32 + 1)).isqrt();
        seeds[index] = (twice.div_ceil(2) - 256) as u8;
        index += 1;
    }
    seeds
};

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn zeros_are_counted(any: u64, shift in 0..64u32) {
            prop_assert_eq!(leading_zeros(any >> shift), (any >> shift).leading_zeros());
        }

        #[test]
        fn reciprocals_are_cut_off(mantissa in 1u32 << 31..) {
            for mantissa in [mantissa, 1 << 31, (1 << 31) + (mantissa & 15), u32::MAX] {
                let want = ((1u64 << 63) - 1) / u64::from(mantissa);
                prop_assert_eq!(u64::from(reciprocal(mantissa)), want);
                prop_assert_eq!(u64::from(reciprocal_by_halves(mantissa)), want);
                prop_assert_eq!(u64::from(reciprocal_by_steps(mantissa)), want);
            }
        }

        #[test]
        fn reciprocals_are_good_to_the_last_bit(value in 1..u64::MAX) {
            let (mantissa, exponent) = normalized(value);
            let power = 2f64.powi(exponent);
            let relative = f64::from(mantissa) * power / value as f64 - 1.0;
            prop_assert!((-5e-10..=1e-15).contains(&relative), "{relative}");
            let product = f64::from(mantissa) * f64::from(reciprocal(mantissa)) / 2f64.powi(63);
            prop_assert!((1.0 - 5e-10..=1.0).contains(&product), "{product}");
        }
    }
}
