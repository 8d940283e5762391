//! Twice the precision of `f64`, in constants: for faces that are nearly parallel.
//!
//! As [`scalar`](crate::scalar)'s double words, whose traits have no `const` methods yet.

/// `high + low`, of which the second is at most half a unit in the last place of the first.
#[derive(Clone, Copy)]
pub(super) struct Double {
    pub(super) high: f64,
    low: f64,
}

impl Double {
    /// `a + b`, exactly: TwoSum.
    const fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let part = high - a;
        Self { high, low: (a - (high - part)) + (b - part) }
    }

    /// `a·b`, exactly: by Veltkamp's split.
    const fn product(a: f64, b: f64) -> Self {
        const fn split(x: f64) -> [f64; 2] {
            let scaled = 134_217_729.0 * x;
            let high = scaled - (scaled - x);
            [high, x - high]
        }
        let high = a * b;
        let ([a0, a1], [b0, b1]) = (split(a), split(b));
        Self { high, low: ((a0 * b0 - high) + a0 * b1 + a1 * b0) + a1 * b1 }
    }

    pub(super) const fn plus(self, other: Self) -> Self {
        let Self { high, low } = Self::sum(self.high, other.high);
        Self::sum(high, low + (self.low + other.low))
    }

    pub(super) const fn times(self, factor: f64) -> Self {
        let Self { high, low } = Self::product(self.high, factor);
        Self::sum(high, low + self.low * factor)
    }

    /// The quotient, rounded.
    pub(super) const fn over(self, divisor: Self) -> f64 {
        let quotient = self.high / divisor.high;
        let rest = self.plus(divisor.times(-quotient));
        quotient + rest.high / divisor.high
    }

    /// The vector product of two vectors.
    pub(super) const fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [Self; 3] {
        [
            Self::product(b, z).plus(Self::product(-c, y)),
            Self::product(c, x).plus(Self::product(-a, z)),
            Self::product(a, y).plus(Self::product(-b, x)),
        ]
    }
}
