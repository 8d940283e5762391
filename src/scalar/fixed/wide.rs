//! 64-bit fixed point: the numbers that a fixed-point picture is set up with.

use crate::numeric::integer::{long_quotient, long_root, shift_right, shift_right_wide};
use crate::numeric::{long_product, sin_cos_of_quarters, steps, unsigned_product};
use crate::scalar::grid::nearest_units;
use crate::scalar::number::{Number, Real, sealed::Sealed};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A signed number with 32 bits before and 32 bits behind the binary point.
///
/// Every sum stays at the end of the range where it would leave it, products and quotients are
/// rounded to nearest and do so too, and a quotient by zero is an end of the range (or 0 for 0/0).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Wide(i64);

impl Wide {
    pub(in crate::scalar) const FRACTION_BITS: u32 = 32;

    /// The number of 2^−32 times `bits`.
    #[must_use]
    pub const fn from_bits(bits: i64) -> Self {
        Self(bits)
    }

    /// The number times 2^32.
    #[must_use]
    pub const fn to_bits(self) -> i64 {
        self.0
    }
}

impl Sealed for Wide {}

impl Number for Wide {
    const ZERO: Self = Self(0);
    const ONE: Self = Self(1 << Self::FRACTION_BITS);

    #[inline]
    fn from_int(integer: i32) -> Self {
        Self((integer as i64) << Self::FRACTION_BITS)
    }

    fn from_f64(number: f64) -> Self {
        Self(nearest_units(number, Self::FRACTION_BITS))
    }

    fn to_f64(self) -> f64 {
        self.0 as f64 / (1u64 << Self::FRACTION_BITS) as f64
    }

    // In set-up, which is seldom, one copy of what is long on small cores is enough.
    #[inline(never)]
    fn plus(self, other: Self) -> Self {
        Self(self.0.saturating_add(other.0))
    }

    #[inline(never)]
    fn minus(self, other: Self) -> Self {
        Self(self.0.saturating_sub(other.0))
    }

    #[inline]
    fn times(self, other: Self) -> Self {
        self * other
    }

    #[inline]
    fn negated(self) -> Self {
        Self(self.0.saturating_neg())
    }

    #[inline]
    fn abs(self) -> Self {
        Self(self.0.saturating_abs())
    }

    #[inline]
    fn is_finite(self) -> bool {
        true
    }

    #[inline]
    fn dot(x: [Self; 3], y: [Self; 3]) -> Self {
        Self::dot3(x, y)
    }
}

impl Add for Wide {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        self.plus(other)
    }
}

impl Sub for Wide {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self.minus(other)
    }
}

impl Mul for Wide {
    type Output = Self;
    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        Self(shift_right_wide(product(self, other), Self::FRACTION_BITS))
    }
}

impl Div for Wide {
    type Output = Self;
    #[inline(never)]
    fn div(self, other: Self) -> Self {
        if self.0 == 0 {
            return self;
        }
        let is_negative = (self.0 < 0) != (other.0 < 0);
        let (value, divisor) = (self.0.unsigned_abs(), other.0.unsigned_abs());
        // To the nearest, halves upwards: what is negative rounds down from just below a half.
        let half = divisor.saturating_sub(is_negative.into()) / 2;
        let numerator = (u128::from(value) << Self::FRACTION_BITS) + u128::from(half);
        let quotient = long_quotient(numerator, divisor);
        let size = i64::try_from(quotient).unwrap_or(i64::MAX);
        Self(match (is_negative, quotient) {
            (true, 0x8000_0000_0000_0000..) => i64::MIN,
            (true, _) => -size,
            (false, _) => size,
        })
    }
}

impl Neg for Wide {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.negated()
    }
}

#[inline]
fn product(a: Wide, b: Wide) -> i128 {
    long_product(a.0, b.0)
}

impl Real for Wide {
    const PI: Self = Self(0x3_243f_6a89);
    const HALF: Self = Self(1 << (Self::FRACTION_BITS - 1));
    const EPSILON: Self = Self(1);
    const QUANTUM: Self = Self(1);

    #[inline]
    fn floor_to_i32(self) -> i32 {
        (self.0 >> Self::FRACTION_BITS) as i32
    }

    #[inline(never)]
    fn ratio(self, divisor: Self) -> i32 {
        // Sixteen digits of the divisor are off by 2^-15 at most, and a quotient of 32 bits is
        // several times as fast as one of 64.
        let (value, by) = (self.0.unsigned_abs(), divisor.0.unsigned_abs());
        let shift = 48u32.saturating_sub(by.leading_zeros());
        let (value, by) = (u32::try_from(value >> shift), (by >> shift) as u32);
        let size = value.unwrap_or(u32::MAX).checked_div(by).unwrap_or(0).min(i32::MAX as u32);
        if (self.0 < 0) == (divisor.0 < 0) { size as i32 } else { -(size as i32) }
    }

    /// From 2^−16 on: reciprocals of smaller numbers, times the coordinates of a scene, would
    /// leave the range. As angles, smaller ones count as none.
    #[inline]
    fn is_divisor(self) -> bool {
        self.0.unsigned_abs() >= 1 << (Self::FRACTION_BITS - 16)
    }

    #[inline(never)]
    fn sqrt(self) -> Self {
        Self(long_root(self.0.max(0).cast_unsigned()) as i64)
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = sin_cos(self.0);
        (Self(shift_right(sin, 30)), Self(shift_right(cos, 30)))
    }

    #[inline(never)]
    fn normalizing_power(self) -> Self {
        // 2^31 doesn't fit.
        let exponent = (self.0.unsigned_abs().leading_zeros() + 1).min(62);
        Self(1 << exponent)
    }

    #[inline]
    fn after_steps(self, step: Self, count: i32) -> Self {
        Self(self.0.wrapping_add(steps(step.0, count)))
    }

    #[inline(never)]
    fn holds_steps(self, step: Self, count: i32) -> bool {
        let (size, count) = (step.0.unsigned_abs(), count.unsigned_abs());
        let [high, low] = [(size >> 32) as u32, size as u32].map(|of| unsigned_product(of, count));
        let room = i64::MAX.unsigned_abs().checked_sub(self.0.unsigned_abs());
        // Both summands are below 2^63.
        high < 1 << 31 && room.is_some_and(|room| (high << 32) + low <= room)
    }

    #[inline(never)]
    fn product_difference(a: Self, b: Self, c: Self, d: Self) -> Self {
        Self(shift_right_wide(product(a, b).saturating_sub(product(c, d)), Self::FRACTION_BITS))
    }

    #[inline]
    fn around(self, half: Self) -> [Self; 2] {
        [Self(self.0.saturating_sub(half.0)), Self(self.0.saturating_add(half.0))]
    }

    #[inline(never)]
    fn cross([a, b, c]: [Self; 3], [x, y, z]: [Self; 3]) -> [Self; 3] {
        let difference = Self::product_difference;
        [difference(b, z, c, y), difference(c, x, a, z), difference(a, y, b, x)]
    }

    #[inline(never)]
    fn dot3(x: [Self; 3], y: [Self; 3]) -> Self {
        let [p0, p1, p2] = [0, 1, 2].map(|i| match (x.get(i), y.get(i)) {
            (Some(x), Some(y)) => product(*x, *y),
            _ => 0,
        });
        Self(shift_right_wide(p0.saturating_add(p1).saturating_add(p2), Self::FRACTION_BITS))
    }
}

/// Sine and cosine, as multiples of 2^−62, of an angle in multiples of 2^−32.
fn sin_cos(angle: i64) -> (i64, i64) {
    /// 2/π as a multiple of 2^−64.
    const QUARTERS: i128 = 0xa2f9_836e_4e44_152a;
    sin_cos_of_quarters((i128::from(angle) * QUARTERS) >> 34)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::prelude::rust_2024::*;

    fn value(fine: Wide) -> f64 {
        fine.0 as f64 / 2f64.powi(32)
    }

    fn wide(value: f64) -> Wide {
        Wide((value * 2f64.powi(32)) as i64)
    }

    const UNIT: f64 = 1.0 / 4_294_967_296.0;

    proptest! {
        #[test]
        fn arithmetic_is_rounded_once(x in -30f64..30.0, y in -30f64..30.0) {
            let (a, b) = (wide(x), wide(y));
            let (x, y) = (value(a), value(b));
            prop_assert!((value(a * b) - x * y).abs() <= 0.51 * UNIT);
            if y.abs() > 0.1 {
                prop_assert!((value(a / b) - x / y).abs() <= 0.51 * UNIT);
            }
            let root = value(Real::sqrt(a));
            prop_assert!((root - x.max(0.0).sqrt()).abs() <= 0.51 * UNIT);
            let difference = value(Wide::product_difference(a, b, b, Wide::ONE));
            prop_assert!((difference - (x * y - y)).abs() <= 0.51 * UNIT);
        }

        #[test]
        fn angles(x in -3e4f64..3e4) {
            let a = wide(x);
            let (sin, cos) = a.sin_cos();
            prop_assert!((value(sin) - value(a).sin()).abs() <= 0.6 * UNIT);
            prop_assert!((value(cos) - value(a).cos()).abs() <= 0.6 * UNIT);
        }

        #[test]
        fn powers_normalize(bits in 1i64..) {
            let scaled = Wide(bits) * Wide(bits).normalizing_power();
            if bits >= 4 {
                prop_assert!((Wide::ONE..Wide::from_int(2)).contains(&scaled), "{scaled:?}");
            }
        }

        #[test]
        fn steps_may_overflow_on_the_way(at in -1i64 << 60..1i64 << 60, count in 1i32..1000) {
            let step = Wide(i64::MAX / 10);
            let start = Wide(at.wrapping_sub(step.0.wrapping_mul(i64::from(count))));
            prop_assert_eq!(start.after_steps(step, count), Wide(at));
        }

        #[test]
        fn steps_are_held_up_to_the_last_unit(step: i64, shift in 0..63u32, count: i32, off in -1i128..=1) {
            let step = step >> shift;
            let way = i128::from(step).abs() * i128::from(count.unsigned_abs());
            let room = i128::from(i64::MAX) - way + off;
            for at in [room, -room, room.clamp(i64::MIN.into(), i64::MAX.into())] {
                if let Ok(at) = i64::try_from(at) {
                    let most = i128::from(at.unsigned_abs()) + way;
                    let fits = most <= i128::from(i64::MAX);
                    prop_assert_eq!(Wide(at).holds_steps(Wide(step), count), fits, "{}, {}", at, step);
                }
            }
        }
    }

    #[test]
    fn the_ends_of_the_range() {
        let (low, high) = (Wide(i64::MIN), Wide(i64::MAX));
        assert_eq!(high + Wide(1), high);
        assert_eq!(low - Wide(1), low);
        assert_eq!(-low, high);
        assert_eq!(low * low, high);
        assert_eq!(low * high, low);
        assert_eq!(Wide::ONE / Wide::ZERO, high);
        assert_eq!(-Wide::ONE / Wide::ZERO, low);
        assert_eq!(Wide::ZERO / Wide::ZERO, Wide::ZERO);
        assert_eq!(low / Wide(-1), high);
        assert_eq!(Wide::dot3([low; 3], [low; 3]), high);
        assert_eq!(Wide::dot3([low; 3], [high; 3]), low);
        assert_eq!(Real::sqrt(low), Wide::ZERO);
        assert!(high.holds_steps(Wide::ZERO, 5) && !high.holds_steps(Wide(1), 1));
        assert!(!low.holds_steps(low, i32::MIN));
    }
}
