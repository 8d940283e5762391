//! Points of curves in fixed point, by cumulative basis functions.
//!
//! The sum Cᵢ of the i-th basis function of a span and all behind it goes from 0 to 1, and a point is
//! `P₀ + Σ Cᵢ·(Pᵢ − Pᵢ₋₁)` (M.-J. Kim, M.-S. Kim, S. Shin, *A general construction scheme for unit
//! quaternion curves with simple high order derivatives*, SIGGRAPH 1995). De Boor's recurrence for the
//! sums has positive terms only: `Cᵢ + (Cᵢ₋₁ − Cᵢ)·ratio`. The ratios don't depend on the coordinates,
//! and the sum is rounded once.

use crate::scalar::integer::{leading_zeros, long_quotient};
use crate::numeric::unsigned_product;

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
    /// Of a width below 2³¹.
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
pub(super) fn cumulative<const K: usize>(
    [low, high]: [&[i32; K]; 2],
    t: i32,
) -> [[u32; 2]; K] {
    let mut divisor = Divisor { width: 0, normal: 0, shift: 0, inverse: 0 };
    let mut sums = [0u64; K];
    if let Some(first) = sums.first_mut() {
        *first = 1 << BITS;
    }
    for level in (1..K).rev() {
        for i in (0..K - level).rev() {
            let (Some(&low), Some(&high)) = (low.get(i + level), high.get(i)) else { break };
            let ratio = ratio(&mut divisor, t.abs_diff(low), high.abs_diff(low));
            if let Some([before, own]) = sums.get_mut(i..i + 2) {
                *own = own.wrapping_add(product(before.wrapping_sub(*own), ratio));
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
