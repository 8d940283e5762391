//! Square roots.

use super::quotients::{SEEDS, leading_zeros, reciprocal};
use crate::numeric::select::{long_product, unsigned_product};

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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::integer::{divide, long_quotient, normalized, quotient_by};
    use proptest::prelude::*;

    proptest! {
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
        fn roots_of_small_numbers_round(square in 0..1u64 << 20) {
            let root = i128::from(sqrt(square));
            let square = i128::from(square);
            prop_assert!(4 * square <= (2 * root + 1) * (2 * root + 1) || root == 0xffff_ffff);
            prop_assert!(root == 0 || 4 * square > (2 * root - 1) * (2 * root - 1));
        }
    }
}
