//! Error-free transformations: sums and products with their rounding errors.
//!
//! The error of a product can be represented exactly, so that every target may compute it in the way
//! that it is fastest at, and all get the same bits.

use core::ops::{Add, Mul, Sub};

/// A binary floating-point number that can be split into two halves of its precision.
pub trait Split: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
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

/// The sum of two numbers and its rounding error, exactly: `a + b = sum + error`.
///
/// Knuth, *The Art of Computer Programming* vol. 2, section 4.2.2, theorem B. Exact for all
/// finite inputs whose sum does not overflow.
#[inline]
pub(crate) fn two_sum<S: Split>(a: S, b: S) -> (S, S) {
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
pub(super) fn two_product<S: Split>(a: S, b: S) -> (S, S) {
    let product = a * b;
    let (a_high, a_low) = a.split();
    let (b_high, b_low) = b.split();
    let error = a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low);
    (product, error)
}

/// As [`two_product`], with an error that is rounded once where it has digits below the smallest
/// subnormal number: as the other two ways round it.
#[allow(dead_code)] // on targets with something faster
pub(super) fn two_product_soft(a: f32, b: f32) -> (f32, f32) {
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
pub(super) fn two_product_wide(a: f32, b: f32) -> (f32, f32) {
    let exact = f64::from(a) * f64::from(b);
    let product = exact as f32;
    (product, (exact - f64::from(product)) as f32)
}

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
    }
}
