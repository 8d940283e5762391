//! Sums and differences of products, from error-free products.

use super::error_free::two_sum;
use super::native::Native;

/// `a + b·c` with the product's rounding error added back: the result's only error is the
/// rounding of the sums.
#[inline]
pub(crate) fn add_product<S: Native>(a: S, b: S, c: S) -> S {
    let (product, product_error) = S::two_product(b, c);
    let (sum, sum_error) = two_sum(a, product);
    sum + (sum_error + product_error)
}

/// `a·b − c·d` from error-free products, good to 2 units in the last place.
///
/// Kahan's difference of products; the bound is that of Jeannerod, Louvet and Muller, *Further
/// analysis of Kahan's algorithm for the accurate computation of 2×2 determinants*, Mathematics
/// of Computation 82 (2013), section 4, with both products' errors kept.
#[inline]
pub(crate) fn product_difference<S: Native>(a: S, b: S, c: S, d: S) -> S {
    let (ab, ab_error) = S::two_product(a, b);
    let (cd, cd_error) = S::two_product(c, d);
    (ab - cd) + (ab_error - cd_error)
}

/// The sum of three products in twice the working precision: algorithm `Dot2` of Ogita, Rump and
/// Oishi, *Accurate sum and dot product*, SIAM Journal on Scientific Computing 26 (2005).
#[inline]
pub(crate) fn dot3<S: Native>(x: [S; 3], y: [S; 3]) -> S {
    let (sum, error) = long_dot3(x, y);
    sum + error
}

/// [`dot3`] before its last rounding: the sum, and what it has lost.
#[inline]
pub(super) fn long_dot3<S: Native>(x: [S; 3], y: [S; 3]) -> (S, S) {
    let (p0, e0) = S::two_product(x[0], y[0]);
    let (p1, e1) = S::two_product(x[1], y[1]);
    let (p2, e2) = S::two_product(x[2], y[2]);
    let (s, f1) = two_sum(p0, p1);
    let (s, f2) = two_sum(s, p2);
    (s, ((e0 + e1) + f1) + (e2 + f2))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
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
    }
}
