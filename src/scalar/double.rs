//! Unevaluated sums of two numbers: twice the working precision where a difference cancels.

use super::error_free::{long_dot3, two_sum};
use super::float::Float;

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

impl<S: Float> Double<S> {
    /// A number as it is.
    #[inline]
    pub(crate) fn from(high: S) -> Self {
        Self { high, low: S::ZERO }
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

/// The sum of two numbers, the first of which is the larger, and its rounding error.
#[inline]
fn quick_two_sum<S: Float>(large: S, small: S) -> (S, S) {
    let sum = large + small;
    (sum, small - (sum - large))
}
