//! Splines in fixed point: integers with guard bits, rounded once.

use super::Arithmetic;
use super::cumulative::{mean, weights};
use crate::scalar::integer::{divide, narrow, shift_right};
use crate::scalar::{ConstOps, FixedI32, Fraction};
use core::fmt::Debug;

/// Digits of an inner number beyond those of its type. With 32 of the type's own, four bits are
/// left for extrapolation and derivatives.
const GUARD: u32 = 28;

/// Digits of a ratio's fraction.
const RATIO: u32 = 62;

/// `whole + fraction/2⁶²`. Between the knots the whole part is 0, at the upper one 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mixed {
    whole: i64,
    fraction: i64,
}

impl Mixed {
    /// `numerator / denominator`, cut off, for |numerator| ≤ 2³² and 0 < denominator < 2³².
    #[inline(never)] // long divisions are slow and large anyway
    fn new(numerator: i64, denominator: i64) -> Self {
        let Some(whole) = numerator.checked_div_euclid(denominator) else {
            return Self { whole: 0, fraction: 0 };
        };
        let rest = (numerator - whole * denominator).unsigned_abs();
        // Two long divisions of 31 digits each.
        let divisor = denominator.unsigned_abs();
        let long = |rest: u64| {
            let digits = (rest << 31).checked_div(divisor).unwrap_or(0);
            (digits, (rest << 31) - digits * divisor)
        };
        let (high, rest) = long(rest);
        let (low, _) = long(rest);
        Self { whole, fraction: (high << 31 | low) as i64 }
    }

    /// `x·self`.
    #[inline]
    fn of(self, x: i64) -> i64 {
        let part = (i128::from(x) * i128::from(self.fraction)) >> RATIO;
        match self.whole {
            0 => part as i64,
            whole => x.saturating_mul(whole).saturating_add(part as i64),
        }
    }
}

/// The local parameter of a baked piece is `(t·2^shift − origin)/2³²`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FixedMap {
    /// Where the span starts.
    pub(in crate::spline) start: i32,
    /// The middle of the span, modulo 2³².
    pub(in crate::spline) origin: u32,
    pub(in crate::spline) shift: u8,
    /// Digits of the coefficients beyond those of the type.
    pub(in crate::spline) guard: u8,
}

impl FixedMap {
    /// Half of the span, times 2^shift.
    pub(in crate::spline) const fn half(self) -> u32 {
        self.origin.wrapping_sub(self.start.cast_unsigned().wrapping_shl(self.shift as u32))
    }
}

#[inline]
fn width<F: Fraction>(low: FixedI32<F>, high: FixedI32<F>) -> i64 {
    i64::from(high.to_bits()) - i64::from(low.to_bits())
}

/// A number of so many units, if there is one.
#[inline]
fn exactly<F: Fraction>(bits: i64) -> Option<FixedI32<F>> {
    i32::try_from(bits).ok().map(FixedI32::from_bits)
}

/// Held inside of a range whose ends have the same size.
fn held(x: i128) -> i64 {
    let most = i128::from(i64::MAX);
    x.clamp(-most, most) as i64
}

impl<F: Fraction> Arithmetic for FixedI32<F> {
    type Inner = i64;
    type Weight = i64;
    type Ratio = Mixed;
    type LocalMap = FixedMap;
    type Pieces<T: Copy + Debug + PartialEq, const SPANS: usize> = [[T; 1]; SPANS];
    type Coefficient = i32;
    /// The whole units of the value in the middle of the span.
    type Base = i32;

    const FULL: i64 = 1 << (GUARD + F::BITS);
    const NONE: i64 = 0;

    #[inline]
    fn inner(self) -> i64 {
        i64::from(self.to_bits()) << GUARD
    }

    #[inline]
    fn outer(inner: i64) -> Self {
        Self::from_bits(narrow(shift_right(inner, GUARD as i32)))
    }

    #[inline]
    fn is_within(inner: i64) -> bool {
        inner.unsigned_abs() < 1 << 61
    }

    #[inline]
    fn checked(inner: i64) -> Option<Self> {
        exactly(shift_right(inner, GUARD as i32))
    }

    #[inline]
    fn add(a: i64, b: i64) -> i64 {
        a.saturating_add(b)
    }

    #[inline]
    fn subtract(a: i64, b: i64) -> i64 {
        a.saturating_sub(b)
    }

    fn ratio(t: Self, low: Self, high: Self) -> Mixed {
        Mixed::new(width(low, t), width(low, high))
    }

    #[inline]
    fn blend(a: i64, b: i64, ratio: Mixed) -> i64 {
        a.saturating_add(ratio.of(b.saturating_sub(a)))
    }

    #[inline]
    fn summed<A: Copy + AsRef<[Self]> + AsMut<[Self]>, const K: usize>(
        points: impl Fn() -> [A; K],
        knots: [&[Self; K]; 2],
        t: Self,
    ) -> Option<A> {
        let [low, high] = knots.map(|knots| knots.map(Self::to_bits));
        let (points, weights) = (points(), weights([&low, &high], t.to_bits()));
        let mut point = *points.first()?;
        for (i, x) in point.as_mut().iter_mut().enumerate() {
            let of = |point: &A| point.as_ref().get(i).map_or(0, |x| x.to_bits());
            *x = Self::from_bits(mean(points.iter().map(of).zip(weights)));
        }
        Some(point)
    }

    fn split(x: i64, t: Self, [low, high]: [Self; 2]) -> [i64; 2] {
        [width(low, t), width(t, high)].map(|part| Mixed::new(part, width(low, high)).of(x))
    }

    fn climb(x: i64, degree: u16, [low, high]: [Self; 2]) -> i64 {
        Self::slope(0, x, degree, low, high)
    }

    #[inline]
    fn add_weights(a: i64, b: i64) -> i64 {
        a.saturating_add(b)
    }

    #[inline]
    fn from_weight(weight: i64) -> Self {
        Self::outer(weight)
    }

    #[inline(never)]
    fn slope(a: i64, b: i64, degree: u16, low: Self, high: Self) -> i64 {
        let width = width(low, high);
        if width == 0 {
            return 0;
        }
        let rise = (i128::from(b) - i128::from(a)) * i128::from(degree);
        held(divide(rise << F::BITS, i128::from(width)))
    }

    fn share(x: i64, part: i64, whole: i64) -> i64 {
        let product = i128::from(x) * i128::from(part);
        held(product.checked_div(whole.into()).unwrap_or(0))
    }

    fn project(vector: &[i64], along: &[i64], length: i64) -> i64 {
        let products = vector.iter().zip(along).map(|(&x, &y)| i128::from(x) * i128::from(y));
        held(products.fold(0, i128::saturating_add).checked_div(length.into()).unwrap_or(0))
    }

    fn wrap(t: Self, from: Self, to: Self) -> Self {
        let rest = width(from, t).checked_rem_euclid(width(from, to)).unwrap_or(0);
        Self::from_bits(narrow(i64::from(from.to_bits()) + rest))
    }

    fn between(from: Self, to: Self, index: u32, count: u32) -> Self {
        ConstOps::<Self>::divided([from, to], index as usize, count as usize)
    }

    fn norm(coordinates: &[i64]) -> i64 {
        let sum = coordinates.iter().fold(0u128, |sum, x| {
            let x = u128::from(x.unsigned_abs());
            sum.saturating_add(x * x)
        });
        i64::try_from(sum.isqrt()).unwrap_or(i64::MAX)
    }

    #[inline]
    fn pieces<T: Copy + Debug + PartialEq, const SPANS: usize>(
        pieces: &Self::Pieces<T, SPANS>,
    ) -> &[T] {
        pieces.as_flattened()
    }

    #[inline]
    fn local(t: Self, map: &FixedMap) -> i32 {
        let scaled = t.to_bits().cast_unsigned().wrapping_shl(map.shift.into());
        scaled.wrapping_sub(map.origin).cast_signed()
    }

    #[inline]
    fn horner(sum: i32, local: i32, c: i32) -> i32 {
        // The upper word of the product, cut off: half a unit is in the coefficient.
        c.wrapping_add(((i64::from(sum) * i64::from(local)) >> 32) as i32)
    }

    #[inline]
    fn baked(sum: i32, base: i32, map: &FixedMap) -> Self {
        // Half a unit is in the sum.
        Self::from_bits(base.saturating_add(sum >> (map.guard & 31)))
    }

    fn extended(
        terms: impl Iterator<Item = (usize, i32)>,
        base: i32,
        order: usize,
        t: Self,
        map: &FixedMap,
    ) -> Option<Self> {
        let shift = u32::from(map.shift);
        let offset = i128::from(width(Self::from_bits(map.start), t)) << shift;
        let local = offset - i128::from(map.half());
        let sum = terms.fold(0, |sum: i128, (power, c)| {
            // What is held in here is far beyond the range at the end.
            let product = sum.saturating_mul(local) >> 32;
            // i(i−1)…(i−order+1): the factor of a power's derivative.
            let falling = (0..order).fold(1, |falling, j| falling * (power - j) as i128);
            let sum = product.saturating_add(falling.saturating_mul(c.into()));
            sum.clamp(-1 << 61, 1 << 61)
        });
        // 2^(shift − 32) is the scale of t, in units of the type.
        let digits = order as i32 * (32 - F::BITS as i32 - shift as i32) + i32::from(map.guard);
        let sum = sum as i64;
        if order > 0 {
            return exactly(shift_right(sum, digits));
        }
        // Half a unit is in the sum.
        exactly(i64::from(base) + (sum >> (map.guard & 31)))
    }
}
