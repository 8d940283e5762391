//! Points of curves in fixed point, by cumulative basis functions.
//!
//! The sum Cᵢ of the i-th basis function of a span and all behind it goes from 0 to 1, and a point is
//! `P₀ + Σ Cᵢ·(Pᵢ − Pᵢ₋₁)` (M.-J. Kim, M.-S. Kim, S. Shin, *A general construction scheme for unit
//! quaternion curves with simple high order derivatives*, SIGGRAPH 1995). De Boor's recurrence for the
//! sums has positive terms only: `Cᵢ + (Cᵢ₋₁ − Cᵢ)·ratio`. The ratios don't depend on the coordinates,
//! and the sum is rounded once.

use crate::numeric::unsigned_product;
use crate::scalar::integer::{leading_zeros, long_quotient};

/// Fraction bits of a ratio and of a cumulative basis function. Both are from 0 to 1.
const BITS: u32 = 44;

/// The fraction bits of the upper part of such a number; the lower part has 16 bits.
const UPPER: u32 = BITS - 16;

/// The upper and the lower part.
#[inline]
const fn parts(x: u64) -> [u32; 2] {
    [(x >> 16) as u32, x as u32 & 0xffff]
}

/// `a · b / 2¹⁶`, cut off, for b below 2¹⁶.
#[inline]
const fn upper_product(a: u32, b: u32) -> u32 {
    ((a >> 16).wrapping_mul(b)).wrapping_add(((a & 0xffff).wrapping_mul(b)) >> 16)
}

/// `a · b`, rounded.
#[inline(never)]
const fn product(a: u64, b: u64) -> u64 {
    let ([a, a_low], [b, b_low]) = (parts(a), parts(b));
    let lower = upper_product(a, b_low).wrapping_add(upper_product(b, a_low));
    let half = 1 << (UPPER - 17);
    (unsigned_product(a, b).wrapping_add(lower as u64).wrapping_add(half)) >> (2 * UPPER - BITS)
}

/// What parts of one width are divided by.
struct Divisor {
    width: u32,
    /// The width, shifted to 2³⁰ and more.
    normal: i32,
    shift: u32,
    /// 2⁴⁵ / `normal`, but for a unit: from 2¹⁴ to 2¹⁵.
    inverse: i32,
}

impl Divisor {
    /// Before there is a width: ratios are 0.
    const NONE: Self = Self { width: 0, normal: 0, shift: 0, inverse: 0 };

    /// Of a width from 1 to 2³¹ − 1.
    #[inline(never)]
    const fn new(width: u32) -> Self {
        let shift = leading_zeros(width as u64).wrapping_sub(33) & 31;
        let normal = (width << shift).cast_signed();
        // 48/17 − 32/17·x is 1/x but for 1/17 of it, for x from 1/2 to 1. Newton's step squares that.
        let x = normal >> 15;
        let seed = 46_261 - ((x * 30_841) >> 16);
        let missing = (1 << 30) - x * seed;
        let inverse = seed + (((missing >> 15) * seed) >> 15);
        let missing = (1 << 30) - x * inverse;
        let inverse = inverse + (((missing >> 12) * inverse + (1 << 17)) >> 18);
        Self { width, normal, shift, inverse }
    }

    /// `part / width`, for a part that is not larger than the width.
    ///
    /// Four digits of 12 bits, each from the upper bits of the rest. They have signs: a digit that is
    /// off leaves a rest of at most 0.7 of the width, and the next digit makes up for it.
    #[inline(never)]
    const fn ratio(&self, part: u32) -> u64 {
        let (mut rest, mut pairs) = ((part << self.shift).cast_signed(), [0i32; 2]);
        let mut i = 0;
        while i < 4 {
            let digit = ((rest >> 15).wrapping_mul(self.inverse).wrapping_add(1 << 17)) >> 18;
            rest = (rest << 12).wrapping_sub(digit.wrapping_mul(self.normal));
            pairs[i / 2] = (pairs[i / 2] << 12).wrapping_add(digit);
            i += 1;
        }
        let rounded = (pairs[1] + (1 << (47 - BITS))) >> (48 - BITS);
        ((pairs[0] as i64) << (BITS - 24)).wrapping_add(rounded as i64).cast_unsigned()
    }
}

/// Where the parameter is between two knots.
#[inline]
fn ratio(divisor: &mut Divisor, part: u32, width: u32) -> u64 {
    // So wide are knots at opposite ends of the range only.
    if width >> 31 != 0 {
        return long_quotient(u128::from(part) << BITS, width.into());
    }
    // Knots are at equal distances often.
    if width != divisor.width {
        *divisor = Divisor::new(width);
    }
    divisor.ratio(part)
}

/// The cumulative basis functions of a span as their parts, given the K knots from its beginning
/// backwards, in ascending order, and those from its end on.
#[inline]
pub(super) fn cumulative<const K: usize>([low, high]: [&[i32; K]; 2], t: i32) -> [[u32; 2]; K] {
    let mut divisor = Divisor::NONE;
    let mut sums = [0u64; K];
    if let Some(first) = sums.first_mut() {
        *first = 1 << BITS;
    }
    for level in (1..K).rev() {
        for i in (0..K - level).rev() {
            let (Some(&low), Some(&high)) = (low.get(i + level), high.get(i)) else { break };
            let ratio = ratio(&mut divisor, t.abs_diff(low), high.abs_diff(low));
            if let Some([before, own]) = sums.get_mut(i..i + 2) {
                let way = before.wrapping_sub(*own);
                let is_one = level == K - 1;
                *own = own.wrapping_add(if is_one { ratio } else { product(way, ratio) });
            }
        }
    }
    sums.map(parts)
}

/// The mean of coordinates with cumulative weights.
#[inline]
pub(super) fn mean(first: i32, others: impl Iterator<Item = (i32, [u32; 2])>) -> i32 {
    let (mut sum, mut before) = (1u64 << (UPPER - 1), first);
    for (own, [upper, lower]) in others {
        let way = own.abs_diff(before);
        let part = unsigned_product(way, upper).wrapping_add(upper_product(way, lower).into());
        sum = if own < before { sum.wrapping_sub(part) } else { sum.wrapping_add(part) };
        before = own;
    }
    first.wrapping_add((sum.cast_signed() >> UPPER) as i32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// How far a ratio is from the exact one, times the width: in units of its last place.
    fn error(part: u32, width: u32) -> f64 {
        let mut divisor = Divisor::NONE;
        let got = ratio(&mut divisor, part, width);
        let exact = i128::from(part) << BITS;
        (i128::from(got) * i128::from(width) - exact) as f64 / f64::from(width)
    }

    proptest! {
        #[test]
        fn ratios_are_nearly_the_nearest(any: u32, other: u32, shift in 0..32u32) {
            let wide = any | 1 << 31;
            for width in [any, any >> shift, wide, wide >> shift, u32::MAX >> shift, 1 << shift] {
                let width = width.max(1);
                // All ratios; and some next to 0, to a half and to 1.
                let scaled = ((u64::from(other) * u64::from(width)) >> 32) as u32;
                let near = other % width.min(64);
                for part in [scaled, near, width - near, width / 2 + near / 2] {
                    let limit = if width >> 31 == 0 { 0.54 } else { 1.0 };
                    let error = error(part, width);
                    prop_assert!(error.abs() < limit, "{} / {}: {}", part, width, error);
                }
            }
        }

        #[test]
        fn products_round(a in 0..=1u64 << BITS, b in 0..=1u64 << BITS, shift in 0..BITS) {
            for (a, b) in [(a, b), (a >> shift, b), (1 << BITS, b), (a, 1 << BITS)] {
                let exact = (u128::from(a) * u128::from(b)) as f64 / 2f64.powi(BITS as i32);
                let error = product(a, b) as f64 - exact;
                prop_assert!(error.abs() < 0.51, "{a} · {b}: {error}");
            }
            prop_assert_eq!(product(1 << BITS, b), b);
        }
    }

    /// All that a divisor's reciprocal depends on.
    #[test]
    fn every_reciprocal_has_quick_ratios() {
        for upper in 1u32 << 15..1 << 16 {
            for width in [upper << 15, upper << 15 | 0x7fff] {
                for part in [1, width / 3, width - width / 5, width - 1] {
                    let error = error(part, width);
                    assert!(error.abs() < 0.54, "{part} / {width}: {error}");
                }
                assert_eq!([error(0, width), error(width, width)], [0.0; 2]);
            }
        }
    }

    /// Where a ratio can be represented, it is.
    #[test]
    fn halves_are_exact() {
        for shift in 0..30 {
            for width in [2u32 << shift, 6 << shift.min(28), 0x7fff_fffe, u32::MAX - 1] {
                assert_eq!(error(width / 2, width), 0.0);
            }
        }
    }
}
