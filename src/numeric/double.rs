//! Twice the working precision where a difference cancels: unevaluated sums of two numbers.

use super::error_free::two_sum;
use super::native::Native;
use super::products::long_dot3;

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

    /// The nearest single number.
    #[inline]
    pub(crate) fn round(self) -> S {
        self.high + self.low
    }
}

/// What generic code and constants both need, under two names: a trait's methods can't be `const`.
macro_rules! operations {
    ($([$($constant:tt)?] [$($generics:tt)*] $S:ty: $plus:ident $minus:ident $times:ident, $sum:path, $product:path;)+) => {$(
        impl<$($generics)*> Double<$S> {
            /// `self + other`; accurate also where the two nearly cancel (AccurateDWPlusDW).
            #[inline]
            pub(crate) $($constant)? fn $plus(self, other: Self) -> Self {
                let (high, high_error) = $sum(self.high, other.high);
                let (low, low_error) = $sum(self.low, other.low);
                // The first one is the larger, from here on.
                let first = high + (high_error + low);
                let rest = (high_error + low) - (first - high);
                let high = first + (rest + low_error);
                Self { high, low: (rest + low_error) - (high - first) }
            }

            /// `self − other`.
            #[inline]
            pub(crate) $($constant)? fn $minus(self, other: Self) -> Self {
                self.$plus(Self { high: -other.high, low: -other.low })
            }

            /// `self · other` (DWTimesDW1).
            #[inline]
            pub(crate) $($constant)? fn $times(self, other: Self) -> Self {
                let (product, error) = $product(self.high, other.high);
                let rest = error + (self.high * other.low + self.low * other.high);
                let high = product + rest;
                Self { high, low: rest - (high - product) }
            }
        }
    )+};
}

operations! {
    [] [S: Native] S: plus minus times, two_sum, S::two_product;
    [const] [] f64: add sub mul, exact_sum, exact_product;
}

/// For constants.
impl Double<f64> {
    /// A number as it is.
    pub(crate) const fn exactly(high: f64) -> Self {
        Self { high, low: 0.0 }
    }

    /// `a + b`, exactly.
    pub(crate) const fn of_sum(a: f64, b: f64) -> Self {
        let (high, low) = exact_sum(a, b);
        Self { high, low }
    }

    /// `self / other`.
    pub(crate) const fn div(self, other: Self) -> Self {
        let high = self.high / other.high;
        let rest = self.sub(other.mul(Self::exactly(high)));
        Self::of_sum(high, rest.high / other.high)
    }

    /// Times a power of two.
    pub(crate) const fn scaled(self, power: f64) -> Self {
        Self { high: self.high * power, low: self.low * power }
    }

    /// The nearest integer, halves upwards; for numbers below 2⁶³.
    pub(crate) const fn nearest(self) -> i64 {
        let integer = self.high as i64;
        let rest = (self.high - integer as f64) + self.low;
        let floor = rest as i64 - (rest < 0.0) as i64;
        integer.saturating_add(floor).saturating_add((rest - floor as f64 >= 0.5) as i64)
    }
}

/// As [`two_sum`].
const fn exact_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_rounded = sum - a;
    let a_rounded = sum - b_rounded;
    (sum, (a - a_rounded) + (b - b_rounded))
}

/// As [`Native::two_product`].
const fn exact_product(a: f64, b: f64) -> (f64, f64) {
    const fn split(x: f64) -> [f64; 2] {
        let shifted = x * 134_217_729.0;
        let high = shifted - (shifted - x);
        [high, x - high]
    }
    let product = a * b;
    let ([a, a_low], [b, b_low]) = (split(a), split(b));
    (product, a_low * b_low - (((product - a * b) - a_low * b) - a * b_low))
}

#[cfg(test)]
mod tests {
    use super::*;

    type Words = Double<f64>;

    #[test]
    fn digits_beyond_those_of_a_double() {
        let [one, three] = [1.0, 3.0].map(Words::from);
        let third = one.div(three);
        let rest = one.sub(third.mul(three));
        assert!(rest.high.abs() < 1e-31, "{}", rest.high);
        let tiny = 1e-20;
        let sum = Words::of_sum(1.0, tiny).add(Words::of_sum(tiny, -1.0));
        assert_eq!(sum.high, 2.0 * tiny);
        let large = Words::of_sum((1u64 << 62) as f64, 0.75);
        assert_eq!(large.nearest(), (1 << 62) + 1);
    }

    #[test]
    fn integers_are_nearest() {
        let cases =
            [(0.5, 1), (-0.5, 0), (-0.6, -1), (2.4, 2), (-2.4, -2), (1e15, 1_000_000_000_000_000)];
        for (x, integer) in cases {
            assert_eq!(Words::from(x).nearest(), integer, "{x}");
        }
    }
}
