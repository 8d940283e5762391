//! Where a line meets a wall or a plane, exactly: numbers with one square root, on integers.

use dashu_int::IBig;
use std::cmp::Ordering;

pub fn square(x: &IBig) -> IBig {
    x * x
}

/// The parameter (p + s·√q)/d with d > 0, q ≥ 0 and s = −1, 0 or 1.
#[derive(Debug, Clone)]
pub struct Surd {
    pub p: IBig,
    pub s: i64,
    pub q: IBig,
    pub d: IBig,
}

impl Surd {
    /// p/d, for any d but zero.
    pub fn ratio(p: IBig, d: IBig) -> Self {
        let (p, d) = if d < IBig::ZERO { (-p, -d) } else { (p, d) };
        Self { p, s: 0, q: IBig::ZERO, d }
    }

    /// A floating-point number below 2²⁰, cut off below 2⁻⁹⁰.
    pub fn float(x: f64) -> Self {
        Self::ratio(IBig::from((x * 2f64.powi(90)) as i128), IBig::ONE << 90)
    }

    /// Against p/d with d > 0: (P + s√q)/D ⋛ p/d ⇔ s·√q·d ⋛ p·D − P·d, and squares keep the order
    /// of absolute values.
    pub fn compare(&self, p: &IBig, d: &IBig) -> Ordering {
        let right = p * &self.d - &self.p * d;
        let left_squared = IBig::from(self.s) * &self.q * square(d);
        let right_squared = if right < IBig::ZERO { -square(&right) } else { square(&right) };
        left_squared.cmp(&right_squared)
    }

    /// Against a parameter without a root.
    pub fn order(&self, ratio: &Self) -> Ordering {
        assert_eq!(ratio.s, 0);
        self.compare(&ratio.p, &ratio.d)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_ordered_among_fractions() {
        let root = |s: i64| Surd { p: 3.into(), s, q: 2.into(), d: 2.into() };
        // (3 − √2)/2 = 0.7928…, (3 + √2)/2 = 2.2071…
        let order = |s: i64, x: f64| root(s).order(&Surd::float(x));
        assert_eq!([order(-1, 0.792), order(-1, 0.793)], [Ordering::Greater, Ordering::Less]);
        assert_eq!([order(1, 2.207), order(1, 2.208)], [Ordering::Greater, Ordering::Less]);
        assert_eq!(root(0).order(&Surd::ratio((-3).into(), (-2).into())), Ordering::Equal);
    }
}
