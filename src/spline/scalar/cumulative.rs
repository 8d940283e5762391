//! Points of curves in fixed point, by cumulative basis functions.
//!
//! The sum Cᵢ of the i-th basis function of a span and all behind it goes from 0 to 1, and a point is
//! `P₀ + Σ Cᵢ·(Pᵢ − Pᵢ₋₁)` (M.-J. Kim, M.-S. Kim, S. Shin, *A general construction scheme for unit
//! quaternion curves with simple high order derivatives*, SIGGRAPH 1995). De Boor's recurrence for the
//! sums has positive terms only: `Cᵢ + (Cᵢ₋₁ − Cᵢ)·ratio`. The ratios don't depend on the coordinates.
//! The point's sum is taken as `Σ (Cᵢ − Cᵢ₊₁)·Pᵢ`. It is exact, and rounded once.

use crate::numeric::{product, short_product, unsigned_product, upper_product};
use crate::scalar::integer::{leading_zeros, long_quotient};

/// Fraction bits of a ratio and of a cumulative basis function. Both are from 0 to 1.
const BITS: u32 = 44;

/// How far such a number is shifted in 64 bits. The lower word has 16 of its digits.
const SHIFT: u32 = 16;

/// The fraction bits of the upper word.
const UPPER: u32 = BITS + SHIFT - 32;

/// The upper and the lower word.
#[inline]
const fn words(x: u64) -> [u32; 2] {
    [(x >> 32) as u32, x as u32]
}

/// `a · b`, rounded to 44 fraction bits.
#[inline]
const fn part_of(a: u64, b: u64) -> u64 {
    let ([a, a_low], [b, b_low]) = (words(a), words(b));
    let half = 1 << (2 * UPPER - BITS - 1);
    let lower = upper_product(a, b_low >> SHIFT).wrapping_add(upper_product(b, a_low >> SHIFT));
    let product = unsigned_product(a, b).wrapping_add(lower.wrapping_add(half) as u64);
    (product >> (2 * UPPER - BITS)) << SHIFT
}

/// What parts of one width are divided by.
struct Divisor {
    width: u32,
    /// How far the width is shifted to be 2³⁰ and more.
    shift: u32,
    /// 2⁴⁵ / the shifted width, but for a unit: from 2¹⁴ to 2¹⁵.
    inverse: i32,
}

impl Divisor {
    /// Before there is a width: ratios are 0.
    const NONE: Self = Self { width: 0, shift: 0, inverse: 0 };

    /// Shift and inverse of a width from 1 to 2³¹ − 1.
    #[inline(never)]
    const fn shift_and_inverse(width: u32) -> (u32, i32) {
        let shift = leading_zeros(width as u64).wrapping_sub(33) & 31;
        // 48/17 − 32/17·x is 1/x but for 1/17 of it, for x from 1/2 to 1. Newton's step squares that.
        let x = (width << shift).cast_signed() >> 15;
        let seed = 46_261 - ((x * 30_841) >> 16);
        let missing = (1 << 30) - x * seed;
        let inverse = seed + (((missing >> 15) * seed) >> 15);
        let missing = (1 << 30) - x * inverse;
        (shift, inverse + (((missing >> 12) * inverse + (1 << 17)) >> 18))
    }

    /// `part / width`, for a part that is not larger than the width.
    #[inline]
    const fn ratio(&self, part: u32) -> u64 {
        let shift = self.shift & 31;
        digits((part << shift).cast_signed(), (self.width << shift).cast_signed(), self.inverse)
    }
}

/// The ratio of a part and a width that are shifted.
///
/// Four digits of 12 bits, each from the upper bits of the rest. They have signs: a digit that is off
/// leaves a rest of at most 0.7 of the width, and the next digit makes up for it.
#[inline(never)]
const fn digits(mut rest: i32, width: i32, inverse: i32) -> u64 {
    let (mut pairs, mut i) = ([0i32; 2], 0);
    while i < 4 {
        let digit = ((rest >> 15).wrapping_mul(inverse).wrapping_add(1 << 17)) >> 18;
        rest = (rest << 12).wrapping_sub(digit.wrapping_mul(width));
        pairs[i / 2] = (pairs[i / 2] << 12).wrapping_add(digit);
        i += 1;
    }
    let rounded = (pairs[1] + (1 << (47 - BITS))) >> (48 - BITS);
    let upper = (pairs[0] << (UPPER - 24)).wrapping_add(rounded >> SHIFT);
    (upper.cast_unsigned() as u64) << 32 | (rounded << SHIFT).cast_unsigned() as u64
}

/// Where the parameter is between two knots.
#[inline]
fn ratio(divisor: &mut Divisor, part: u32, width: u32) -> u64 {
    // So wide are knots at opposite ends of the range only.
    if width >> 31 != 0 {
        return long_quotient(u128::from(part) << BITS, width.into()) << SHIFT;
    }
    // Knots are at equal distances often.
    if width != divisor.width {
        let (shift, inverse) = Divisor::shift_and_inverse(width);
        *divisor = Divisor { width, shift, inverse };
    }
    divisor.ratio(part)
}

/// The cumulative basis functions of a span, given the K knots from its beginning backwards, in
/// ascending order, and those from its end on; for a parameter on the span.
#[inline]
fn cumulative<const K: usize>([low, high]: [&[i32; K]; 2], t: i32) -> [u64; K] {
    let mut divisor = Divisor::NONE;
    let mut sums = [0u64; K];
    if let Some(first) = sums.first_mut() {
        *first = 1 << (BITS + SHIFT);
    }
    for level in (1..K).rev() {
        for i in (0..K - level).rev() {
            let (Some(&low), Some(&high)) = (low.get(i + level), high.get(i)) else { break };
            let [part, width] = [t, high].map(|x| x.wrapping_sub(low).cast_unsigned());
            let ratio = ratio(&mut divisor, part, width);
            if let Some([before, own]) = sums.get_mut(i..i + 2) {
                let way = before.wrapping_sub(*own);
                let is_one = level == K - 1;
                *own = own.wrapping_add(if is_one { ratio } else { part_of(way, ratio) });
            }
        }
    }
    sums
}

/// What the coordinates of a span's control points are multiplied with: an upper part, and a lower one
/// of 16 bits.
#[inline]
pub(super) fn weights<const K: usize>(knots: [&[i32; K]; 2], t: i32) -> [(i32, u16); K] {
    let sums = cumulative(knots, t);
    core::array::from_fn(|i| {
        let at = |i| sums.get(i).copied().unwrap_or(0);
        let weight = at(i).wrapping_sub(at(i + 1));
        let [upper, lower] = words(weight);
        (upper.cast_signed(), (lower >> SHIFT) as u16)
    })
}

/// The mean of coordinates with such weights.
#[inline]
pub(super) fn mean(coordinates: impl Iterator<Item = (i32, (i32, u16))>) -> i32 {
    let (mut upper, mut lower) = (1 << (UPPER - 1), 0i64);
    for (x, weight) in coordinates {
        upper = product(x, weight.0).wrapping_add(upper);
        lower = short_product(x, weight.1).wrapping_add(lower);
    }
    (upper.wrapping_add(lower >> SHIFT) >> UPPER) as i32
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
        let got = i128::from(got >> SHIFT);
        (got * i128::from(width) - exact) as f64 / f64::from(width)
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
                let error = (part_of(a << SHIFT, b << SHIFT) >> SHIFT) as f64 - exact;
                prop_assert!(error.abs() < 0.51, "{a} · {b}: {error}");
            }
            prop_assert_eq!(part_of(1 << (BITS + SHIFT), b << SHIFT), b << SHIFT);
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

    proptest! {
        /// No product is cut off before the sum is rounded.
        #[test]
        fn means_are_exact_sums(any: [i32; 4], small: [i8; 4], ends: [i32; 2], from in 0..=1u32 << 30) {
            let [low, high] = [ends[0].min(ends[1]) >> 1, (ends[0].max(ends[1]) >> 1) + 1];
            let part = (u64::from(high.abs_diff(low)) * u64::from(from)) >> 30;
            let weights = weights([&[low; 4], &[high; 4]], low + part as i32);
            let exact = |(upper, lower): (i32, u16)| i128::from(upper) << SHIFT | i128::from(lower);
            prop_assert_eq!(weights.iter().map(|weight| exact(*weight)).sum::<i128>(), 1 << BITS);
            for points in [any, small.map(i32::from), any.map(|x| if x < 0 { i32::MIN } else { i32::MAX })] {
                let terms = points.iter().zip(weights);
                let sum: i128 = terms.map(|(x, weight)| i128::from(*x) * exact(weight)).sum();
                let rounded = (sum + (1 << (BITS - 1))) >> BITS;
                prop_assert_eq!(i128::from(mean(points.into_iter().zip(weights))), rounded);
            }
        }
    }
}
