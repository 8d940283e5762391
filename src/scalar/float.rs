//! [`Scalar`] for `f32` and `f64`.

use super::error_free::{
    dot3, product_difference, quick_square_less, quick_square_less_f32, square_less_f32,
    square_less_f64, two_product, two_product_f32, two_sum,
};
use super::formula::{Formula, Roots};
#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
use super::hardware::sqrt as sqrt_f32;
use super::number::sealed::Sealed;
use super::rebase::{Rebased, rebased};
use super::{Number, Real, Scalar};
#[cfg(not(all(target_arch = "arm", target_abi = "eabihf")))]
use libm::sqrtf as sqrt_f32;

/// A binary floating-point number.
pub trait Float: Real + Scalar<Unit = Self, Wide = Self, Scale = Self> {
    /// The product and its rounding error, exactly: `a·b = product + error`.
    fn two_product(a: Self, b: Self) -> (Self, Self);

    /// `a + b·c` with the product's rounding error added back: the result's only error is the
    /// rounding of the sums.
    fn add_product(a: Self, b: Self, c: Self) -> Self;

    /// `x² − y` with one rounding, unless that is subnormal: the product is fused with the
    /// difference. In `f64` it comes from a sum with twice the precision.
    fn square_less(x: Self, y: Self) -> Self;

    /// [`square_less`](Self::square_less), or `None`, rarely, where that takes longer: then whoever
    /// asks may turn to a function for rare cases, and keeps nothing for afterwards.
    fn quick_square_less(x: Self, y: Self) -> Option<Self>;
}

/// `x·y`, added up from the first coordinate on.
#[inline]
fn sum_of_products<S: Float, const N: usize>(x: [S; N], y: [S; N]) -> S {
    x.into_iter().zip(y).fold(S::ZERO, |sum, (x, y)| sum + x * y)
}

macro_rules! float {
    ($Float:ident, $Bits:ident, $reach:literal, $finest:literal, $two_product:path, $square_less:path, $quick_square_less:path, $sqrt:path, $sin_cos:path) => {
        impl Sealed for $Float {}

        impl Number for $Float {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;

            #[inline]
            fn plus(self, other: Self) -> Self {
                self + other
            }

            #[inline]
            fn minus(self, other: Self) -> Self {
                self - other
            }

            #[inline]
            fn times(self, other: Self) -> Self {
                self * other
            }

            #[inline]
            fn negated(self) -> Self {
                -self
            }

            #[inline]
            fn abs(self) -> Self {
                $Float::abs(self)
            }

            #[inline]
            fn is_finite(self) -> bool {
                $Float::is_finite(self)
            }

            #[inline]
            fn dot(x: [Self; 3], y: [Self; 3]) -> Self {
                x[0] * y[0] + x[1] * y[1] + x[2] * y[2]
            }
        }

        impl Real for $Float {
            const PI: Self = core::$Float::consts::PI;
            const HALF: Self = 0.5;
            const EPSILON: Self = $Float::EPSILON;
            const QUANTUM: Self = 0.0;

            #[inline]
            fn from_int(whole: i32) -> Self {
                whole as $Float
            }

            #[inline]
            fn floor_to_i32(self) -> i32 {
                let whole = self as i32;
                if (whole as $Float) > self { whole.saturating_sub(1) } else { whole }
            }

            #[inline]
            fn ratio(self, divisor: Self) -> i32 {
                (self / divisor) as i32
            }

            #[inline]
            fn is_divisor(self) -> bool {
                (self * self).is_normal()
            }

            #[inline]
            fn sqrt(self) -> Self {
                $sqrt(self)
            }

            fn sin_cos(self) -> (Self, Self) {
                $sin_cos(self)
            }

            #[inline]
            fn normalizing_power(self) -> Self {
                const MANTISSA: u32 = $Float::MANTISSA_DIGITS - 1;
                const BIAS: $Bits = ($Float::MAX_EXP - 1) as $Bits;
                let exponent = (self.to_bits() & !(1 << ($Bits::BITS - 1))) >> MANTISSA;
                // 2^(bias − exponent); the largest numbers get the smallest normal power.
                let field = (2 * BIAS).saturating_sub(exponent).max(1);
                $Float::from_bits(field << MANTISSA)
            }

            #[inline]
            fn after_steps(self, step: Self, count: i32) -> Self {
                self + step * count as $Float
            }

            #[inline]
            fn holds_steps(self, _: Self, _: i32) -> bool {
                true
            }

            #[inline]
            fn product_difference(a: Self, b: Self, c: Self, d: Self) -> Self {
                product_difference(a, b, c, d)
            }

            #[inline]
            fn dot3(x: [Self; 3], y: [Self; 3]) -> Self {
                dot3(x, y)
            }
        }

        impl Float for $Float {
            #[inline]
            fn two_product(a: Self, b: Self) -> (Self, Self) {
                $two_product(a, b)
            }

            #[inline]
            fn add_product(a: Self, b: Self, c: Self) -> Self {
                let (product, product_error) = Self::two_product(b, c);
                let (sum, sum_error) = two_sum(a, product);
                sum + (sum_error + product_error)
            }

            #[inline]
            fn square_less(x: Self, y: Self) -> Self {
                $square_less(x, y)
            }

            #[inline]
            fn quick_square_less(x: Self, y: Self) -> Option<Self> {
                $quick_square_less(x, y)
            }
        }

        impl Scalar for $Float {
            type Unit = Self;
            type Wide = Self;
            type Scale = Self;

            const LOWEST: Self = $Float::NEG_INFINITY;
            const HIGHEST: Self = $Float::INFINITY;
            const MAX_COORDINATE: Self = $reach;
            const MIN_RADIUS: Self = $finest;
            const SHORTEST: Self = 0.0;
            const LONGEST: Self = $Float::MAX;
            const ROUNDING: Self = 0.0;
            const NO_SCALE: Self = 0.0;

            #[inline]
            fn uncertainty(size: Self) -> Self {
                // Twice the four units that all sums and products together may be off.
                size * (8.0 * $Float::EPSILON)
            }

            #[inline]
            fn wide(self) -> Self {
                self
            }

            #[inline]
            fn from_wide(fine: Self) -> Self {
                fine
            }

            #[inline]
            fn unit(fine: Self) -> Self {
                fine
            }

            #[inline]
            fn wide_unit(unit: Self) -> Self {
                unit
            }

            #[inline]
            fn times_unit(self, unit: Self) -> Self {
                self * unit
            }

            #[inline]
            fn dot_unit(vector: [Self; 3], direction: [Self; 3]) -> Self {
                dot3(vector, direction)
            }

            #[inline]
            fn scale(fine: Self) -> Self {
                fine
            }

            #[inline]
            fn scaled(self, factor: Self) -> Self {
                self * factor
            }

            #[inline]
            fn stretched(self, factor: Self) -> Self {
                self * factor
            }

            #[inline]
            fn quotients([one, other]: [Self; 2], denominator: Self) -> [Self; 2] {
                [one / denominator, other / denominator]
            }

            #[inline]
            fn leg(hypotenuse: Self, leg: Self) -> Option<Self> {
                (hypotenuse * hypotenuse - leg * leg).positive().map(Real::sqrt)
            }

            #[inline]
            fn moment(q: [Self; 2], m: [Self; 2]) -> Self {
                q[0] * m[1] - q[1] * m[0]
            }

            #[inline]
            fn chord<const K: usize, const N: usize>(
                radius: Self,
                k: [Self::Wide; K],
                q: [Self; N],
                m: [Self; N],
            ) -> Option<Roots<Self>> {
                let a = sum_of_products(m, m);
                if !a.is_normal() {
                    return None;
                }
                let discriminant = radius * radius * a - sum_of_products(k, k);
                let Some(discriminant) = discriminant.positive() else {
                    return Some(Roots::Outside);
                };
                let inverse = 1.0 / a;
                let middle = -sum_of_products(q, m) * inverse;
                let half = Real::sqrt(discriminant) * inverse;
                Some(Roots::Between(middle - half, middle + half))
            }

            #[inline]
            fn length(vector: [Self; 3]) -> Self {
                Real::sqrt(Self::dot(vector, vector))
            }

            #[inline]
            fn with_length(vector: [Self; 3], length: Self) -> [Self; 3] {
                // A point that is moved onto a surface is as near as this square is exact.
                let square = dot3(vector, vector);
                let factor = if square > 0.0 { length / Real::sqrt(square) } else { 0.0 };
                vector.map(|coordinate| coordinate * factor)
            }

            fn next_below(self) -> Self {
                self.next_down()
            }

            #[inline]
            fn to_level(self) -> u8 {
                let level = self * 255.0 + 0.5;
                // Arm converts to the range of `i32` by itself, and x86 to none.
                if cfg!(target_arch = "arm") {
                    (level as i32).clamp(0, 255) as u8
                } else {
                    level as u8
                }
            }

            #[inline(always)]
            fn compute<A: Formula<Self>>(formula: A) -> A::Output {
                formula.float()
            }

            #[inline(always)]
            fn rebased(origin: [Self; 3], direction: [Self; 3]) -> Rebased<Self> {
                rebased(origin, direction)
            }
        }
    };
}

float!(
    f32,
    u32,
    1e15,
    1e-12,
    two_product_f32,
    square_less_f32,
    quick_square_less_f32,
    sqrt_f32,
    libm::sincosf
);
float!(
    f64,
    u64,
    1e60,
    1e-60,
    two_product,
    square_less_f64,
    quick_square_less,
    libm::sqrt,
    libm::sincos
);

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn powers_normalize(x in proptest::num::f32::POSITIVE | proptest::num::f32::SUBNORMAL) {
            prop_assume!(x > 0.0);
            let scaled = x * x.normalizing_power();
            let limit = if x < f32::MAX / 2.0 { 2.0 } else { 4.0 };
            prop_assert!(scaled < limit, "{x} became {scaled}");
            prop_assert!(scaled >= 1.0 || x < f32::MIN_POSITIVE, "{x} became {scaled}");
        }
    }

    #[test]
    fn levels_clamp_and_round() {
        let cases = [(-1.0, 0), (0.0, 0), (0.5, 128), (1.0, 255), (9.0, 255), (f32::NAN, 0)];
        for (value, level) in cases {
            assert_eq!(value.to_level(), level, "{value}");
        }
    }
}
