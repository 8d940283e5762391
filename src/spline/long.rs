//! Double words in constants: what is baked has more digits than any number type.

/// `high + low`, where `low` is at most half a unit in the last place of `high`.
///
/// The algorithms are those of `scalar::Double`, which is no `const fn`: a trait's methods can't
/// be.
#[derive(Clone, Copy)]
pub(super) struct Long {
    high: f64,
    low: f64,
}

impl Long {
    pub(super) const ZERO: Self = Self { high: 0.0, low: 0.0 };

    pub(super) const fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }

    /// `a + b`, exactly (Knuth).
    pub(super) const fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let b_rounded = high - a;
        let a_rounded = high - b_rounded;
        Self { high, low: (a - a_rounded) + (b - b_rounded) }
    }

    /// `a·b`, exactly (Dekker 1971).
    const fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        let ([a, a_low], [b, b_low]) = (split(a), split(b));
        Self { high, low: a_low * b_low - (((high - a * b) - a_low * b) - a * b_low) }
    }

    pub(super) const fn plus(self, other: Self) -> Self {
        let (high, low) = (Self::sum(self.high, other.high), Self::sum(self.low, other.low));
        let sum = Self::sum(high.high, high.low + low.high);
        Self::sum(sum.high, sum.low + low.low)
    }

    pub(super) const fn minus(self, other: Self) -> Self {
        self.plus(Self { high: -other.high, low: -other.low })
    }

    pub(super) const fn times(self, other: Self) -> Self {
        let product = Self::product(self.high, other.high);
        let cross = self.high * other.low + self.low * other.high;
        Self::sum(product.high, product.low + cross)
    }

    pub(super) const fn over(self, other: Self) -> Self {
        let high = self.high / other.high;
        let rest = self.minus(other.times(Self::from(high)));
        Self::sum(high, rest.high / other.high)
    }

    /// Times a power of two.
    pub(super) const fn scaled(self, power: f64) -> Self {
        Self { high: self.high * power, low: self.low * power }
    }

    pub(super) const fn round(self) -> f64 {
        self.high
    }

    /// The nearest whole number; for numbers below 2⁶³.
    pub(super) const fn whole(self) -> i64 {
        let whole = self.high as i64;
        let rest = (self.high - whole as f64) + self.low;
        let floor = rest as i64 - (rest < 0.0) as i64;
        whole.saturating_add(floor).saturating_add((rest - floor as f64 >= 0.5) as i64)
    }
}

/// Two halves of a number, products of which are exact (Veltkamp).
const fn split(x: f64) -> [f64; 2] {
    let shifted = x * 134_217_729.0;
    let high = shifted - (shifted - x);
    [high, x - high]
}

/// A power of two that brings a positive number to [1/2, 1), or as near as the range allows.
pub(super) const fn power(x: f64) -> f64 {
    let field = (x.to_bits() >> 52) & 0x7ff;
    // 2^(1022 − field); of subnormal numbers the largest power, which is not enough.
    let power = if field < 2045 { 2045 - field } else { 1 };
    f64::from_bits(if power > 2046 { 2046 << 52 } else { power << 52 })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_beyond_those_of_a_double() {
        let third = Long::from(1.0).over(Long::from(3.0));
        let rest = Long::from(1.0).minus(third.times(Long::from(3.0)));
        assert!(rest.high.abs() < 1e-31, "{}", rest.high);
        let tiny = 1e-20;
        let sum = Long::sum(1.0, tiny).plus(Long::sum(tiny, -1.0));
        assert_eq!(sum.high, 2.0 * tiny);
        let large = Long::sum((1u64 << 62) as f64, 0.75);
        assert_eq!(large.whole(), (1 << 62) + 1);
    }

    #[test]
    fn whole_numbers_are_nearest() {
        let cases =
            [(0.5, 1), (-0.5, 0), (-0.6, -1), (2.4, 2), (-2.4, -2), (1e15, 1_000_000_000_000_000)];
        for (x, whole) in cases {
            assert_eq!(Long::from(x).whole(), whole, "{x}");
        }
    }

    #[test]
    fn powers_normalize() {
        for x in [1.0, 1.5, 0.75, 3e37, 1.2e-38, 1e-20, 1e-300] {
            assert!((0.5..1.0).contains(&(x * power(x))), "{x}");
        }
        assert!((1e-320 * power(1e-320)).is_finite());
        assert!((f64::MAX * power(f64::MAX)) < 4.0);
    }
}
