//! Twice the working precision where a difference cancels: unevaluated sums of two numbers, and what
//! is made of error-free products.

use super::error_free::{quick_two_sum, two_sum};
use super::native::Native;

/// `high + low`, where `low` is at most half a unit in the last place of `high`.
///
/// Sums and products are those of Dekker (1971) in the notation of Joldes, Muller and Popescu,
/// *Tight and rigorous error bounds for basic building blocks of double-word arithmetic*, ACM
/// Transactions on Mathematical Software 44 (2017). Their relative errors are a few 2⁻⁴⁸ in `f32`
/// and a few 2⁻¹⁰⁶ in `f64`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Double<S> {
    pub(crate) high: S,
    pub(crate) low: S,
}

impl<S: Native> Double<S> {
    /// A number as it is.
    #[inline]
    pub(crate) fn from(high: S) -> Self {
        Self { high, low: S::CONSTANTS.zero }
    }

    /// `a + b`, exactly.
    #[inline]
    pub(crate) fn sum(a: S, b: S) -> Self {
        let (high, low) = two_sum(a, b);
        Self { high, low }
    }

    /// `a·b`, exactly.
    #[inline]
    pub(crate) fn product(a: S, b: S) -> Self {
        let (high, low) = S::two_product(a, b);
        Self { high, low }
    }

    /// `x − y·z`, rounded once from a scalar product in twice the working precision.
    #[inline]
    pub(crate) fn less_dot(x: S, y: [S; 3], z: [S; 3]) -> S {
        let (dot, lost) = long_dot3(y, z);
        let (high, error) = two_sum(x, -dot);
        high + (error - lost)
    }

    /// `self + other`; accurate also where the two nearly cancel (AccurateDWPlusDW).
    #[inline]
    pub(crate) fn plus(self, other: Self) -> Self {
        let (high, high_error) = two_sum(self.high, other.high);
        let (low, low_error) = two_sum(self.low, other.low);
        let (high, rest) = quick_two_sum(high, high_error + low);
        let (high, low) = quick_two_sum(high, rest + low_error);
        Self { high, low }
    }

    /// `self + other`, with an error of a few units of the last place of both operands' `low`:
    /// less than [`plus`](Self::plus) where they cancel, but enough for a sum of exact products.
    #[inline]
    pub(crate) fn plus_roughly(self, other: Self) -> Self {
        let (high, low) = two_sum(self.high, other.high);
        Self { high, low: low + (self.low + other.low) }
    }

    /// `self − other`, as [`plus_roughly`](Self::plus_roughly).
    #[inline]
    pub(crate) fn minus_roughly(self, other: Self) -> Self {
        self.plus_roughly(Self { high: -other.high, low: -other.low })
    }

    /// `x·y − z²`, rounded once from terms with errors of a few units of their last place.
    #[inline]
    pub(crate) fn product_less_square(x: Self, y: Self, z: Self) -> S {
        let (xy, xy_error) = S::two_product(x.high, y.high);
        let (zz, zz_error) = S::two_product(z.high, z.high);
        let cross = x.high * y.low + x.low * y.high;
        let twice = z.high * z.low;
        (xy - zz) + ((xy_error - zz_error) + (cross - (twice + twice)))
    }

    /// `self − other`.
    #[inline]
    pub(crate) fn minus(self, other: Self) -> Self {
        self.plus(Self { high: -other.high, low: -other.low })
    }

    /// `self · other` (DWTimesDW1).
    #[inline]
    pub(crate) fn times(self, other: Self) -> Self {
        let (high, error) = S::two_product(self.high, other.high);
        let cross = self.high * other.low + self.low * other.high;
        let (high, low) = quick_two_sum(high, error + cross);
        Self { high, low }
    }

    /// The nearest single number.
    #[inline]
    pub(crate) fn round(self) -> S {
        self.high + self.low
    }
}

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
fn long_dot3<S: Native>(x: [S; 3], y: [S; 3]) -> (S, S) {
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
