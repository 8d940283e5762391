//! Integer arithmetic that fixed point is made of: rounded shifts, roots, quotients.

use super::select::{CORE, Core, long_product, shifted, unsigned_product};

/// `value / 2^shift`, rounded to nearest, halves upwards; `shift` may be negative. What leaves
/// the range of `i64` stays at its end.
#[inline]
pub(crate) const fn shift_right(value: i64, shift: i32) -> i64 {
    if shift <= 0 {
        let left = shift.unsigned_abs();
        if left < 64 && (value << left) >> left == value {
            return value << left;
        }
        return match value {
            0 => 0,
            1.. => i64::MAX,
            _ => i64::MIN,
        };
    }
    if shift > 63 {
        return 0;
    }
    // The bit below the last one that stays is 1 from one half on.
    let twice = shifted(value, (shift - 1).cast_unsigned());
    (twice >> 1) + (twice & 1)
}

/// As [`shift_right`], of a product of two numbers.
#[inline]
pub(crate) const fn shift_right_wide(value: i128, shift: u32) -> i64 {
    let half = 1i128 << (shift - 1);
    let shifted = value.saturating_add(half) >> shift;
    if shifted > i64::MAX as i128 {
        i64::MAX
    } else if shifted < i64::MIN as i128 {
        i64::MIN
    } else {
        shifted as i64
    }
}

/// `value / 2^shift`, rounded as by [`shift_right`] and held inside the range of `i32`; for shifts
/// by 1 to 31 bits.
#[inline]
pub(crate) const fn rounded_to_i32(value: i64, shift: u32) -> i32 {
    let high = (value >> 32) as i32;
    let unused = 32 - shift;
    if high << unused >> unused == high {
        let half = (value >> (shift - 1)) as i32 & 1;
        ((value >> shift) as i32).saturating_add(half)
    } else if high < 0 {
        i32::MIN
    } else {
        i32::MAX
    }
}

/// A number held inside the range of `i32`.
#[inline]
pub(crate) const fn narrow(value: i64) -> i32 {
    if value > i32::MAX as i64 {
        i32::MAX
    } else if value < i32::MIN as i64 {
        i32::MIN
    } else {
        value as i32
    }
}

/// The nearest whole number to `numerator / denominator`, halves upwards; for a denominator ≠ 0
/// whose double, and twice the numerator, are inside of the type's range.
#[inline]
pub(crate) const fn divide(numerator: i128, denominator: i128) -> i128 {
    let (n, d) =
        if denominator < 0 { (-numerator, -denominator) } else { (numerator, denominator) };
    let (n, d) = (2 * n + d, 2 * d);
    // Both fit 64 bits in most cases, and a quotient of these is several times as fast.
    let quotient = if n as i64 as i128 == n && d as i64 as i128 == d {
        match (n as i64).checked_div_euclid(d as i64) {
            Some(quotient) => Some(quotient as i128),
            None => None,
        }
    } else {
        n.checked_div_euclid(d)
    };
    match quotient {
        Some(quotient) => quotient,
        None => 0,
    }
}

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

/// The nearest whole number to the square root of `square · 2³²`.
///
/// A root of 32 bits, and 16 more by a step of Newton's.
#[inline(never)]
pub(crate) const fn long_root(square: u64) -> u64 {
    if square == 0 {
        return 0;
    }
    let zeros = leading_zeros(square) & !1;
    let normal = square << zeros;
    let short = sqrt(normal);
    let rest = normal.wrapping_sub(unsigned_product(short, short)).cast_signed();
    // rest · 2¹⁵ / short
    let step = ((rest >> 2) * (reciprocal(short) >> 1) as i64) >> 45;
    let mut root = (((short as i64) << 16) + step) >> (zeros / 2);
    let mut rest = ((square as i128) << 32) - long_product(root, root);
    while rest > root as i128 {
        rest -= 2 * root as i128 + 1;
        root += 1;
    }
    while rest <= -(root as i128) {
        rest += 2 * root as i128 - 1;
        root -= 1;
    }
    root.cast_unsigned()
}

/// The nearest whole number to the square root.
///
/// A table's reciprocal root with 7 digits becomes one with 14 by a step of Newton's, and the root
/// one of 26 by another, in products of 32 bits. What is missing then is found by trying.
#[inline(never)]
pub(crate) const fn sqrt(square: u64) -> u32 {
    if square == 0 {
        return 0;
    }
    let zeros = leading_zeros(square) & !1;
    let (long, _) = root_of_26_digits(((square << zeros) >> 32) as u32);
    let mut root = long >> (zeros / 2);
    let mut rest = square.wrapping_sub(unsigned_product(root, root)).cast_signed();
    // The square of root + 1/2 is root² + root + 1/4.
    while rest > root as i64 && root < u32::MAX {
        rest -= 2 * root as i64 + 1;
        root += 1;
    }
    while rest <= -(root as i64) {
        rest += 2 * root as i64 - 1;
        root -= 1;
    }
    root
}

/// The square root of a number from 2⁶² on, to one unit.
#[inline]
pub(crate) const fn rough_root(square: u64) -> u32 {
    let (root, inverse) = root_of_26_digits((square >> 32) as u32);
    let rest = square.wrapping_sub(unsigned_product(root, root)).cast_signed();
    let step = ((rest >> 26) as i32 * inverse.cast_signed()) >> 22;
    root.saturating_add_signed(step)
}

/// The root of 1/4 ≤ a < 1, both in 32 digits, and its reciprocal in 15.
#[inline]
const fn root_of_26_digits(a: u32) -> (u32, u32) {
    let seed = SEEDS[(a >> 24) as usize] as u32 + 256;
    // y(3 − ay²)/2, in 15 digits.
    let three = (3 << 30) - (a >> 16) * ((seed * seed) >> 2);
    let inverse = (seed * (three >> 9)) >> 15;
    let short = ((a >> 16) * inverse) >> 15;
    // short + (a − short²)/2√a, in 32 digits.
    let rest = a.wrapping_sub(short * short).cast_signed();
    let long = (short << 16).saturating_add_signed(((rest >> 4) * inverse.cast_signed()) >> 12);
    (long, inverse)
}

/// 256(1/√a − 1) in the middle of each 256th from 1/4 on.
const SEEDS: [u8; 256] = {
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

/// The root of `square · 2⁴⁰`, cut off.
#[inline]
pub(crate) const fn root_with_40_digits(square: u64) -> u64 {
    let zeros = leading_zeros(square) & !1;
    let square = square << (zeros & 63);
    let mut root = sqrt(square);
    if unsigned_product(root, root) > square {
        root -= 1;
    }
    // 20 digits more: the rest over twice the root, less one where the square of that is too much.
    let rest = (square - unsigned_product(root, root)) << 20;
    let twice = 2 * root as u64;
    let step = match rest.checked_div(twice) {
        Some(step) => step,
        None => 0,
    };
    let is_too_much = (rest - step * twice) << 20 < step * step;
    (((root as u64) << 20) + step - is_too_much as u64) >> (zeros / 2)
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
        fn shifts_round(value in -1i64 << 40..1i64 << 40, shift in 0i32..50) {
            let exact = value as f64 / 2f64.powi(shift);
            prop_assert_eq!(shift_right(value, shift) as f64, (exact + 0.5).floor());
            if shift > 0 {
                let wide = shift_right_wide(i128::from(value), shift as u32);
                prop_assert_eq!(wide, shift_right(value, shift));
            }
        }

        #[test]
        fn quotients_round(n in -1i64 << 40..1i64 << 40, d in -1000i64..1000) {
            prop_assume!(d != 0);
            let got = divide(i128::from(n), i128::from(d));
            let (n, d) = (i128::from(n * d.signum()), i128::from(d.abs()));
            prop_assert!(2 * got * d - d <= 2 * n && 2 * n < 2 * got * d + d);
            prop_assert_eq!(divide(n << 60, d << 60), divide(n, d));
        }

        #[test]
        fn long_ones_are_the_library_s(high in 0..u32::MAX, low: u64, divisor in 0..1u64 << 63) {
            let wide = u128::from(high) << 64 | u128::from(low);
            for shift in [0, 20, 40, 60] {
                let (value, divisor) = (wide >> (shift / 2), divisor >> shift);
                // And next to multiples of the divisor, whose digits are the hardest to estimate.
                let multiple = (value >> 64) * u128::from(divisor);
                for value in [value, multiple, multiple.saturating_sub(1)] {
                    let want = value.checked_div(divisor.into()).unwrap_or(u128::MAX);
                    prop_assert_eq!(u128::from(long_quotient(value, divisor)), want.min(u64::MAX.into()));
                }
                let square = u128::from(low >> shift) << 32;
                let root = square.isqrt();
                let want = root + u128::from(square - root * root > root);
                prop_assert_eq!(u128::from(long_root(low >> shift)), want);
            }
        }

        #[test]
        fn more_digits_are_those_of_wide_integers(square: u64, drop in 0..64u32, part: i32, of: i32) {
            let square = square >> drop;
            let wide = (u128::from(square) << 40).isqrt();
            prop_assert_eq!(u128::from(root_with_40_digits(square)), wide);
            // A coordinate of a vector, and a length.
            let divisor = root_with_40_digits(square.max(1).max(u64::from(part.unsigned_abs()).pow(2)));
            let numerator = i64::from(part) * i64::from(of);
            let (mantissa, exponent) = normalized(divisor);
            prop_assert_eq!(
                i128::from(quotient_by(reciprocal(mantissa), exponent, divisor, numerator)),
                divide(i128::from(numerator) << 20, divisor.into())
            );
        }

        #[test]
        fn roots_round(any in 0..u64::MAX, shift in 0..64u32, root: u32, off in -2i64..=2) {
            // Any size; and next to where rounding turns over, which is at root² + root + 1/4.
            let edge = u64::from(root) * (u64::from(root) + 1);
            for square in [any >> shift, edge.saturating_add_signed(off)] {
                let (root, square) = (i128::from(sqrt(square)), i128::from(square));
                prop_assert!(4 * square <= (2 * root + 1) * (2 * root + 1) || root == 0xffff_ffff);
                prop_assert!(root == 0 || 4 * square > (2 * root - 1) * (2 * root - 1));
            }
        }

        #[test]
        fn rough_roots_are_off_by_a_unit(any in 1u64 << 62.., low: u32) {
            for square in [any, 1 << 62 | u64::from(low), u64::MAX - u64::from(low)] {
                prop_assert!(u64::from(rough_root(square)).abs_diff(square.isqrt()) <= 1);
            }
        }

        #[test]
        fn narrowed_shifts_saturate(value: i64, drop in 0..40u32, shift in 1..32u32) {
            let value = value >> drop;
            prop_assert_eq!(rounded_to_i32(value, shift), narrow(shift_right(value, shift as i32)));
        }

        #[test]
        fn roots_of_small_numbers_round(square in 0..1u64 << 20) {
            let root = i128::from(sqrt(square));
            let square = i128::from(square);
            prop_assert!(4 * square <= (2 * root + 1) * (2 * root + 1) || root == 0xffff_ffff);
            prop_assert!(root == 0 || 4 * square > (2 * root - 1) * (2 * root - 1));
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

    #[test]
    fn shifts_saturate() {
        assert_eq!(shift_right(3, -62), i64::MAX);
        assert_eq!(shift_right(-3, -62), i64::MIN);
        assert_eq!(shift_right(1, -62), 1 << 62);
        assert_eq!(shift_right(i64::MIN, 63), -1);
        assert_eq!(shift_right(i64::MIN, 64), 0);
        assert_eq!(shift_right_wide(i128::MAX, 32), i64::MAX);
        assert_eq!(shift_right_wide(i128::MIN, 32), i64::MIN);
        assert_eq!(narrow(i64::MAX), i32::MAX);
    }
}
