//! [`Scalar`] for `f32` and `f64`, and their error-free transformations.

#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
use super::hardware::sqrt as sqrt_f32;
use super::number::sealed::Sealed;
use super::rebase::{Rebased, rebased};
use super::{Chord, Number, Real, Scalar};
#[cfg(not(all(target_arch = "arm", target_abi = "eabihf")))]
use libm::sqrtf as sqrt_f32;

/// A binary floating-point number.
pub trait Float: Real + Scalar<Unit = Self, Fine = Self, Factor = Self> {
    /// The product and its rounding error, exactly: `a·b = product + error`.
    fn two_product(a: Self, b: Self) -> (Self, Self);

    /// `a + b·c` with the product's rounding error added back: the result's only error is the
    /// rounding of the sums.
    fn add_product(a: Self, b: Self, c: Self) -> Self;

    /// `x² + y² − z`, as `x·x + (y·y − z)` with two roundings: each product is fused with its sum,
    /// unless that is subnormal. In `f64` the roundings come from sums with twice the precision.
    fn squares_less(xy: [Self; 2], z: Self) -> Self;
}

/// The sum of two numbers and its rounding error, exactly: `a + b = sum + error`.
///
/// Knuth, *The Art of Computer Programming* vol. 2, section 4.2.2, theorem B. Exact for all
/// finite inputs whose sum does not overflow.
#[inline]
pub(crate) fn two_sum<S: Float>(a: S, b: S) -> (S, S) {
    let sum = a + b;
    let b_rounded = sum - a;
    let a_rounded = sum - b_rounded;
    (sum, (a - a_rounded) + (b - b_rounded))
}

/// The product of two numbers and its rounding error, exactly: `a·b = product + error`.
///
/// Dekker, *A floating-point technique for extending the available precision*, Numerische
/// Mathematik 18 (1971). It uses products and sums only, so it needs no FMA unit. Exact unless an
/// intermediate leaves the type's range.
#[inline]
fn two_product<S: Split>(a: S, b: S) -> (S, S) {
    let product = a * b;
    let (a_high, a_low) = a.split();
    let (b_high, b_low) = b.split();
    let error = a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low);
    (product, error)
}

/// As [`two_product`], with an error that is rounded once where it has digits below the smallest
/// subnormal number: as the other two ways round it.
#[allow(dead_code)] // on targets with something faster
fn two_product_soft(a: f32, b: f32) -> (f32, f32) {
    /// 2^60 and 2^−120.
    const LARGE: f32 = (1u64 << 60) as f32;
    const SMALL: f32 = 1.0 / (LARGE * LARGE);
    let (product, error) = two_product(a, b);
    if product.abs() >= 1e-30 {
        return (product, error);
    }
    if product.abs() < f32::MIN_POSITIVE {
        // The error is less than half of the smallest number.
        return (product, 0.0);
    }
    (product, two_product(a * LARGE, b * LARGE).1 * SMALL)
}

/// The product of two numbers and its rounding error, by a product of twice the width.
///
/// Where `f64` is as fast as `f32` this is faster than [`two_product`]; the bits are the same.
#[inline]
#[allow(dead_code)] // on targets without it
fn two_product_wide(a: f32, b: f32) -> (f32, f32) {
    let exact = f64::from(a) * f64::from(b);
    let product = exact as f32;
    (product, (exact - f64::from(product)) as f32)
}

#[inline]
fn squares_less_f64([x, y]: [f64; 2], z: f64) -> f64 {
    f64::add_product(f64::add_product(-z, y, y), x, x)
}

#[cfg(not(all(target_arch = "arm", target_abi = "eabihf", not(target_has_atomic = "64"))))]
use super::fused::squares_less as squares_less_f32;
#[cfg(all(target_arch = "arm", target_abi = "eabihf", not(target_has_atomic = "64")))]
use super::hardware::squares_less as squares_less_f32;

#[cfg(all(target_arch = "arm", target_abi = "eabihf", not(target_has_atomic = "64")))]
use super::hardware::two_product as two_product_f32;
#[cfg(not(any(
    target_pointer_width = "64",
    all(target_arch = "arm", target_abi = "eabihf", not(target_has_atomic = "64"))
)))]
use two_product_soft as two_product_f32;
#[cfg(target_pointer_width = "64")]
use two_product_wide as two_product_f32;

/// `a·b − c·d` from error-free products, good to 2 units in the last place.
///
/// Kahan's difference of products; the bound is that of Jeannerod, Louvet and Muller, *Further
/// analysis of Kahan's algorithm for the accurate computation of 2×2 determinants*, Mathematics
/// of Computation 82 (2013), section 4, with both products' errors kept.
#[inline]
fn product_difference<S: Float>(a: S, b: S, c: S, d: S) -> S {
    let (ab, ab_error) = S::two_product(a, b);
    let (cd, cd_error) = S::two_product(c, d);
    (ab - cd) + (ab_error - cd_error)
}

/// The sum of three products in twice the working precision: algorithm `Dot2` of Ogita, Rump and
/// Oishi, *Accurate sum and dot product*, SIAM Journal on Scientific Computing 26 (2005).
#[inline]
fn dot3<S: Float>(x: [S; 3], y: [S; 3]) -> S {
    let (p0, e0) = S::two_product(x[0], y[0]);
    let (p1, e1) = S::two_product(x[1], y[1]);
    let (p2, e2) = S::two_product(x[2], y[2]);
    let (s, f1) = two_sum(p0, p1);
    let (s, f2) = two_sum(s, p2);
    s + (((e0 + e1) + f1) + (e2 + f2))
}

/// `x·y`, added up from the first coordinate on.
#[inline]
fn sum_of_products<S: Float, const N: usize>(x: [S; N], y: [S; N]) -> S {
    x.into_iter().zip(y).fold(S::ZERO, |sum, (x, y)| sum + x * y)
}

/// A binary floating-point number that can be split into two halves of its precision.
trait Split: Float {
    /// High and low half: `self = high + low` exactly, and products of halves are exact.
    fn split(self) -> (Self, Self);
}

impl Split for f32 {
    #[inline]
    fn split(self) -> (Self, Self) {
        // Twelve bits of the 24 each: products of these fit, and cutting them off is exact.
        let high = Self::from_bits(self.to_bits() & !0xfff);
        (high, self - high)
    }
}

impl Split for f64 {
    #[inline]
    fn split(self) -> (Self, Self) {
        // 53 bits are odd: Veltkamp's split into 26 and 26 hides one in the low half's sign.
        let shifted = self * 134_217_729.0;
        let high = shifted - (shifted - self);
        (high, self - high)
    }
}

macro_rules! float {
    ($Float:ident, $Bits:ident, $reach:literal, $finest:literal, $two_product:path, $squares_less:path, $sqrt:path, $sin_cos:path, $floor:path) => {
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
                $floor(self) as i32
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
            fn squares_less(xy: [Self; 2], z: Self) -> Self {
                $squares_less(xy, z)
            }
        }

        impl Scalar for $Float {
            type Unit = Self;
            type Fine = Self;
            type Factor = Self;

            const LOWEST: Self = $Float::NEG_INFINITY;
            const HIGHEST: Self = $Float::INFINITY;
            const REACH: Self = $reach;
            const FINEST: Self = $finest;
            const SHORTEST: Self = 0.0;
            const LONGEST: Self = $Float::MAX;
            const BLUR: Self = 0.0;

            #[inline]
            fn fine(self) -> Self {
                self
            }

            #[inline]
            fn from_fine(fine: Self) -> Self {
                fine
            }

            #[inline]
            fn unit(fine: Self) -> Self {
                fine
            }

            #[inline]
            fn fine_unit(unit: Self) -> Self {
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
            fn factor(fine: Self) -> Self {
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
            fn chord<const K: usize, const N: usize>(
                radius: Self,
                k: [Self; K],
                q: [Self; N],
                m: [Self; N],
            ) -> Chord<Self> {
                let a = sum_of_products(m, m);
                if !a.is_normal() {
                    return Chord::Along;
                }
                let discriminant = radius * radius * a - sum_of_products(k, k);
                let Some(discriminant) = discriminant.positive() else { return Chord::Beside };
                let inverse = 1.0 / a;
                let middle = -sum_of_products(q, m) * inverse;
                let half = Real::sqrt(discriminant) * inverse;
                Chord::Between(middle - half, middle + half)
            }

            #[inline]
            fn length(vector: [Self; 3]) -> Self {
                Real::sqrt(Self::dot(vector, vector))
            }

            #[inline]
            fn with_length(vector: [Self; 3], length: Self) -> [Self; 3] {
                let factor = length / Self::length(vector);
                vector.map(|coordinate| coordinate * factor)
            }

            fn next_below(self) -> Self {
                self.next_down()
            }

            #[inline]
            fn to_level(self) -> u8 {
                (self * 255.0 + 0.5) as u8
            }

            #[inline]
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
    squares_less_f32,
    sqrt_f32,
    libm::sincosf,
    libm::floorf
);
float!(f64, u64, 1e60, 1e-60, two_product, squares_less_f64, libm::sqrt, libm::sincos, libm::floor);

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn products_are_error_free(a in -1e6f32..1e6, b in -1e6f32..1e6) {
            let (product, error) = two_product(a, b);
            prop_assert_eq!(product, a * b);
            // The exact product of two f32 fits an f64.
            prop_assert_eq!(f64::from(product) + f64::from(error), f64::from(a) * f64::from(b));
        }

        #[test]
        fn all_products_have_the_same_bits(
            x in 1f32..2.0, y in -2f32..-1.0, x_exponent in -126..60, y_exponent in -126..60,
        ) {
            // Also where the error, or all of the product, is subnormal or vanishes.
            let (a, b) = (x * 2f32.powi(x_exponent), y * 2f32.powi(y_exponent));
            let bits = |(product, error): (f32, f32)| (product.to_bits(), error + 0.0);
            let wide = bits(two_product_wide(a, b));
            prop_assert_eq!(bits(two_product_soft(a, b)), wide);
            prop_assert_eq!(bits((a * b, a.mul_add(b, -(a * b)))), wide);
        }

        #[test]
        fn sums_are_error_free(a in -1e6f32..1e6, b in -1e-3f32..1e-3) {
            let (sum, error) = two_sum(a, b);
            prop_assert_eq!(sum, a + b);
            prop_assert_eq!(f64::from(sum) + f64::from(error), f64::from(a) + f64::from(b));
        }

        #[test]
        fn a_difference_of_products_survives_cancellation(
            a in 1f32..2.0, b in 1f32..2.0, ulps in -3i32..=3,
        ) {
            // c·d is a·b moved by a few ulps: the naive difference has no correct digit left.
            let c = f32::from_bits(a.to_bits().wrapping_add_signed(ulps));
            let d = f32::from_bits(b.to_bits().wrapping_add_signed(1));
            let exact = f64::from(a) * f64::from(b) - f64::from(c) * f64::from(d);
            let got = f64::from(product_difference(a, b, c, d));
            prop_assert!((got - exact).abs() <= 1.2e-7 * exact.abs(), "{got} against {exact}");
        }

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
