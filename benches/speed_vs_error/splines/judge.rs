//! Curves against exact fractions.

use super::exact::{self, Ratio};
use super::kind::Kind;
use super::methods::Ready;
use super::sets::Case;

/// What was found out about a method on some curves.
#[derive(Debug, Clone, Default)]
pub struct Accuracy {
    /// Of a point's worst coordinate: in units of the largest coordinate of the control points.
    pub errors: Vec<f64>,
    /// Curves that the number type can hold.
    pub asked: usize,
    pub not_taken: usize,
    /// Points that are NaN, infinite, or errors.
    pub not_answered: usize,
}

impl Accuracy {
    pub fn judge(&mut self, kind: Kind, case: &Case, truth: &Truth, ready: Option<&Ready>) {
        self.asked += 1;
        let Some(ready) = ready else {
            self.not_taken += 1;
            return;
        };
        let unit = (kind.unit_of)(case.size());
        for (got, want) in (ready.values)().into_iter().zip(&truth.0) {
            match got.filter(|point| point.iter().all(|x| x.is_finite())) {
                None => self.not_answered += 1,
                Some(point) => {
                    let off = |(x, want): (&f64, &Ratio)| (&Ratio::of(*x) - want).abs().to_f64();
                    let worst = point.iter().zip(want).map(off).fold(0.0, f64::max);
                    self.errors.push(worst / unit);
                }
            }
        }
    }
}

/// The exact points of a curve.
pub struct Truth(Vec<[Ratio; 3]>);

impl Truth {
    pub fn of(case: &Case) -> Self {
        let ratios =
            |numbers: &[f64]| -> Vec<Ratio> { numbers.iter().map(|&x| Ratio::of(x)).collect() };
        let knots = ratios(&case.knots);
        let points = case.points.map(|point| point.map(Ratio::of));
        let value = |t: &f64| {
            let t = Ratio::of(*t);
            let span = exact::span_of_domain(&knots, case.order, &t);
            let first = span.unwrap_or_default() + 1 - case.order;
            let mut sums = [(); 3].map(|()| Ratio::zero());
            for (i, point) in points.iter().enumerate().skip(first).take(case.order) {
                let (weight, _) = exact::basis(&knots, span, case.order, i, &t, 0);
                for (sum, x) in sums.iter_mut().zip(point) {
                    *sum = &*sum + &(&weight * x);
                }
            }
            sums
        };
        Self(case.parameters.iter().map(value).collect())
    }
}
