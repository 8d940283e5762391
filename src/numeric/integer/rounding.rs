//! Shifts, quotients and narrower types, rounded.

use crate::numeric::select::shifted;

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

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
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
        fn narrowed_shifts_saturate(value: i64, drop in 0..40u32, shift in 1..32u32) {
            let value = value >> drop;
            prop_assert_eq!(rounded_to_i32(value, shift), narrow(shift_right(value, shift as i32)));
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
