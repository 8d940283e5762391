//! Quadratics with integer coefficients: on which side of a root a fraction lies is known exactly,
//! which makes correctly rounded roots out of approximate ones.

use crate::scalar::integer;
use core::ops::{Add, Mul, Neg, Sub};
use ethnum::I256;

/// A signed integer wide enough for its use.
pub(super) trait Integer:
    Copy
    + Ord
    + From<i128>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
{
    /// The absolute value as `mantissa · 2^exponent`, with the highest bit of the mantissa set
    /// unless it is 0, and the rest cut off.
    fn magnitude(self) -> Magnitude;
}

impl Integer for i128 {
    #[inline]
    fn magnitude(self) -> Magnitude {
        Magnitude::of(self.unsigned_abs())
    }
}

impl Integer for I256 {
    fn magnitude(self) -> Magnitude {
        let bits = self.unsigned_abs();
        let surplus = 128u32.saturating_sub(bits.leading_zeros());
        let Magnitude { mantissa, exponent } = Magnitude::of((bits >> surplus).as_u128());
        Magnitude { mantissa, exponent: exponent + surplus as i32 }
    }
}

/// `mantissa · 2^exponent`: about a number above zero, or 0.
#[derive(Clone, Copy)]
pub(super) struct Magnitude {
    mantissa: u64,
    exponent: i32,
}

impl Magnitude {
    #[inline]
    fn of(bits: u128) -> Self {
        let spare = bits.leading_zeros();
        let mantissa = (bits.checked_shl(spare).unwrap_or(0) >> 64) as u64;
        Self { mantissa, exponent: 64 - spare as i32 }
    }

    /// The square root, with 31 correct bits.
    fn sqrt(self) -> Self {
        let odd = self.exponent & 1;
        let root = (self.mantissa >> odd).isqrt();
        Self { mantissa: root << 32, exponent: (self.exponent + odd) / 2 - 32 }.aligned()
    }

    /// The same with the mantissa's highest bit set.
    fn aligned(self) -> Self {
        let spare = self.mantissa.leading_zeros();
        let mantissa = self.mantissa.checked_shl(spare).unwrap_or(0);
        Self { mantissa, exponent: self.exponent - spare as i32 }
    }

    fn plus(self, other: Self) -> Self {
        let (large, small) =
            if self.exponent >= other.exponent && self.mantissa > 0 || other.mantissa == 0 {
                (self, other)
            } else {
                (other, self)
            };
        let apart = (large.exponent - small.exponent).unsigned_abs() + 1;
        let small = small.mantissa.checked_shr(apart).unwrap_or(0);
        Self { mantissa: (large.mantissa >> 1) + small, exponent: large.exponent + 1 }.aligned()
    }

    /// `self / other` in units of 2^−`digits`, cut off and at most 2^52, with a relative error of less
    /// than 2^−29.
    fn over(self, other: Self, digits: i32) -> i64 {
        let quotient = self.mantissa.checked_div(other.mantissa >> 32).unwrap_or(u64::MAX);
        let exponent = self.exponent - other.exponent - 32 + digits;
        let most = 1 << 52;
        let quotient = if exponent <= 0 {
            quotient.checked_shr(exponent.unsigned_abs()).unwrap_or(0)
        } else if exponent.unsigned_abs() < quotient.leading_zeros() {
            quotient << exponent
        } else {
            most
        };
        quotient.min(most).cast_signed()
    }
}

/// `a t² + 2 b t + c`, for t in parameters of the line: not in units of the grid.
pub(super) struct Quadratic<W> {
    pub(super) a: W,
    pub(super) b: W,
    pub(super) c: W,
    /// `b² − a·c`.
    pub(super) discriminant: W,
}

/// Which root: the one where the line enters, or the one where it exits.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Root {
    Enter,
    Exit,
}

/// Binary digits that approximate roots have beyond those of the grid.
pub(super) const GUARD: u32 = 16;

impl<W: Integer> Quadratic<W> {
    /// The sign of the value at a fraction, and that of its derivative: each times a positive factor.
    fn at(&self, numerator: i128, denominator: i128) -> [W; 2] {
        let (n, d) = (W::from(numerator), W::from(denominator));
        let ascent = self.a * n + self.b * d;
        [n * (ascent + self.b * d) + self.c * d * d, ascent]
    }

    /// Whether the quadratic's root is above the fraction, or at it.
    pub(super) fn is_at_or_above(&self, root: Root, numerator: i128, denominator: i128) -> bool {
        let ([value, ascent], zero) = (self.at(numerator, denominator), W::from(0));
        match root {
            Root::Enter => value >= zero && ascent <= zero,
            Root::Exit => value <= zero || ascent <= zero,
        }
    }

    /// Whether the quadratic's root is below the fraction, or at it.
    pub(super) fn is_at_or_below(&self, root: Root, numerator: i128, denominator: i128) -> bool {
        let ([value, ascent], zero) = (self.at(numerator, denominator), W::from(0));
        match root {
            Root::Enter => value <= zero || ascent >= zero,
            Root::Exit => value >= zero && ascent >= zero,
        }
    }

    /// Whether the value at a fraction is below zero: the line is inside there.
    pub(super) fn is_inside(&self, numerator: i128, denominator: i128) -> bool {
        let [value, _] = self.at(numerator, denominator);
        value < W::from(0)
    }

    /// Both roots on the grid of `fraction` bits, each rounded to nearest, halves upwards.
    #[inline(never)] // in several places, and long
    pub(super) fn roots(&self, fraction: u32) -> [i32; 2] {
        // As in floating point: s/a and c/s with s = |b| + √D, where nothing cancels.
        let zero = W::from(0);
        let digits = (fraction + GUARD) as i32;
        let s = self.b.magnitude().plus(self.discriminant.magnitude().sqrt());
        let far = s.over(self.a.magnitude(), digits);
        let near = self.c.magnitude().over(s, digits);
        let near = if self.c < zero { -near } else { near };
        let [enter, exit] = if self.b == zero {
            [-far, far]
        } else if self.b > zero {
            [-far, -near]
        } else {
            [near, far]
        };

        [self.nearest(Root::Enter, enter, fraction), self.nearest(Root::Exit, exit, fraction)]
    }

    /// The roots, if there are two: different numbers also where both round to the same, unless
    /// that is an end of the grid.
    pub(super) fn chord(&self, fraction: u32) -> Option<[i32; 2]> {
        if self.discriminant <= W::from(0) {
            return None;
        }
        let [enter, exit] = self.roots(fraction);
        if enter < exit || exit == i32::MIN || enter == i32::MAX {
            return Some([enter, exit]);
        }
        // The span is shorter than the grid's step: it grows on the side that is nearer.
        let is_nearer_above = self.is_at_or_above(Root::Exit, enter.into(), 1 << fraction);
        Some(if is_nearer_above { [enter, enter + 1] } else { [enter - 1, enter] })
    }

    /// The number of the grid nearest to a root that is known with [`GUARD`] more digits and a
    /// relative error of 2^−29; held inside the grid's range.
    fn nearest(&self, root: Root, roughly: i64, fraction: u32) -> i32 {
        const LIMIT: i64 = 1 << 31;
        let raised = roughly + (1 << (GUARD - 1));
        let error = (roughly.abs() >> 29) + 2;
        let beyond = raised & ((1 << GUARD) - 1);
        let mut t = (raised >> GUARD).clamp(-LIMIT, LIMIT);
        if beyond < error || beyond > (1 << GUARD) - 1 - error {
            // Too near to the middle between two numbers: only the quadratic itself can tell.
            let is_at_or_above_half =
                |t: i64| self.is_at_or_above(root, (2 * t + 1).into(), 2 << fraction);
            while t < LIMIT && is_at_or_above_half(t) {
                t += 1;
            }
            while t > -LIMIT && !is_at_or_above_half(t - 1) {
                t -= 1;
            }
        }
        integer::narrow(t)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::prelude::rust_2024::*;

    /// The nearest number of the grid by bisection of the sign, which needs no root at all.
    fn bisected(quadratic: &Quadratic<i128>, root: Root, fraction: u32) -> i32 {
        let (mut low, mut high) = (-1i128 << 31, (1i128 << 31) - 1);
        while low < high {
            let middle = (low + high) >> 1;
            if quadratic.is_at_or_above(root, 2 * middle + 1, 2 << fraction) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        low as i32
    }

    fn check(q: [i64; 2], m: [i64; 2], radius: i64) -> Result<(), TestCaseError> {
        let wide = |x: [i64; 2], y: [i64; 2]| {
            i128::from(x[0]) * i128::from(y[0]) + i128::from(x[1]) * i128::from(y[1])
        };
        let square = i128::from(radius) * i128::from(radius);
        let k = wide(q, [m[1], -m[0]]);
        let (a, b, c) = (wide(m, m), wide(q, m), wide(q, q) - square);
        let discriminant = square * a - k * k;
        if a == 0 || discriminant <= 0 {
            return Ok(());
        }
        let quadratic = Quadratic { a, b, c, discriminant };
        let exact = [Root::Enter, Root::Exit].map(|root| bisected(&quadratic, root, 16));
        let got = quadratic.chord(16).unwrap_or_default();
        prop_assert_eq!(quadratic.roots(16), exact);
        if exact[0] < exact[1] || exact[1] == i32::MIN || exact[0] == i32::MAX {
            prop_assert_eq!(got, exact);
        } else {
            prop_assert_eq!(got[0] + 1, got[1]);
            prop_assert!(got[0] == exact[0] || got[1] == exact[1]);
        }
        Ok(())
    }

    proptest! {
        #[test]
        fn roots_of_any_size(
            q in [-1i64 << 29..1i64 << 29, -1i64 << 29..1i64 << 29],
            m in [-1i64 << 30..1i64 << 30, -1i64 << 30..1i64 << 30],
            radius in 1i64..1 << 28,
            drop_q in 0u32..28, drop_m in 0u32..29, drop_r in 0u32..27,
        ) {
            let q = q.map(|x| x >> drop_q);
            let m = m.map(|x| x >> drop_m);
            check(q, m, (radius >> drop_r).max(1))?;
        }

        #[test]
        fn roots_of_small_numbers(
            q in [-20i64..20, -20i64..20], m in [-6i64..6, -6i64..6], radius in 1i64..20,
            far in 0u32..20,
        ) {
            check(q.map(|x| x << far), m, radius << far)?;
        }
    }
}
