//! Curves whose control points can be changed.

mod constructors;
pub(super) mod flatten;
mod insert;
mod triangle;

use super::domain::{Domain, Outside};
use super::error::{CurveError, EvaluateError};
use super::knots::Knots;
use super::point::{Point, direction};
use super::scalar::SplineScalar;
use super::scalar::order::Ordered;
use crate::geom::Vec3;
use crate::scalar::Number;

/// A B-spline curve of the order `K`, with room for `C` control points and `N` knots.
///
/// It is evaluated by de Boor's algorithm (C. de Boor, *On calculating with B-splines*, Journal of
/// Approximation Theory 6, 1972): control points are blended two by two, each pair from the nearer end of
/// its knot interval. In fixed point the same blends make cumulative basis functions, and these the point.
/// In floating point, orders up to 6 are within 5 units in the last place of the largest coordinate of
/// the control points; in fixed point they are within 0.51 units. A curve with clamped ends passes through
/// its first and last control point exactly.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Curve<P: Point, const K: usize, const C: usize, const N: usize> {
    pub(in crate::spline) knots: Knots<P::Scalar, K, N>,
    /// As many as the knots demand, and behind them origins.
    pub(in crate::spline) points: [P; C],
}

impl<P: Point, const K: usize, const C: usize, const N: usize> Curve<P, K, C, N> {
    /// The knots.
    #[must_use]
    pub const fn knots(&self) -> &Knots<P::Scalar, K, N> {
        &self.knots
    }

    /// The control points.
    #[must_use]
    #[inline]
    pub fn points(&self) -> &[P] {
        self.points.get(..self.knots.points()).unwrap_or(&self.points)
    }

    /// Moves a control point. The curve changes on at most `K` spans of knots, from t_index to
    /// t_{index+k}.
    ///
    /// # Errors
    /// [`CurveError::PointCount`] for an index that doesn't exist, [`CurveError::NotFinite`],
    /// [`CurveError::TooFar`]; the curve is as before then.
    pub fn set_point(&mut self, index: usize, point: P) -> Result<(), CurveError> {
        for x in point.coordinates().as_ref() {
            if !x.is_finite() {
                return Err(CurveError::NotFinite);
            }
            let [lowest, highest] = P::Scalar::RANGE;
            if *x < lowest || highest < *x {
                return Err(CurveError::TooFar);
            }
        }
        let count = self.knots.points();
        let place = self.points.get_mut(index).filter(|_| index < count);
        *place.ok_or(CurveError::PointCount)? = point;
        Ok(())
    }

    /// The parameters of the curve.
    #[must_use]
    #[inline]
    pub fn domain(&self) -> Domain<P::Scalar> {
        // Constructors take only knots that have one.
        let at = |i: usize| self.knots.knots.get(i).copied().unwrap_or(P::Scalar::ZERO);
        Domain { from: at(K - 1), to: at(self.knots.points()) }
    }

    /// The curve's point at a parameter.
    ///
    /// # Errors
    /// [`EvaluateError::NotFinite`]; [`EvaluateError::Outside`] if t is outside of the domain and
    /// the policy says so; [`EvaluateError::Overflow`] only outside of the domain.
    #[inline]
    pub fn value(&self, t: P::Scalar, outside: Outside) -> Result<P, EvaluateError> {
        let domain = self.domain();
        let t = domain.place(t, outside)?;
        if matches!(outside, Outside::Extrapolate) {
            return self.derivative_at(0, t);
        }
        let span = self.knots.span_of_domain(t, domain.to);
        let point = triangle::point::<P, K>(&self.knots.knots, &self.points, span, t);
        // A constructed curve has a span for every parameter.
        Ok(point.unwrap_or(P::ORIGIN))
    }

    /// A derivative of the curve by its parameter; of order 0 it is the value, of order `K` or more
    /// zero. At a knot where it jumps it is that of the span behind, at the end of the domain that of
    /// the span in front.
    ///
    /// In floating point it is within 3 units in the last place of the sum of its terms' sizes. In
    /// fixed point orders 1 and 2 are within 0.51 units, and a third one with 2⁻²⁶/w² more, for knots
    /// that are w apart.
    ///
    /// # Errors
    /// As [`value`](Self::value), and [`EvaluateError::Overflow`] for a derivative too large for its
    /// type; in fixed point also where a control point of it or of a derivative before it is four
    /// times too large.
    pub fn derivative(
        &self,
        order: usize,
        t: P::Scalar,
        outside: Outside,
    ) -> Result<P, EvaluateError> {
        self.derivative_at(order, self.domain().place(t, outside)?)
    }

    fn derivative_at(&self, order: usize, t: P::Scalar) -> Result<P, EvaluateError> {
        let span = self.knots.span_of_domain(t, self.domain().to);
        triangle::derivative::<P, K>(&self.knots.knots, &self.points, span, order, t)
    }
}

impl<S: SplineScalar, const K: usize, const C: usize, const N: usize> Curve<Vec3<S>, K, C, N> {
    /// The direction of the curve at a parameter, as a vector of length 1.
    ///
    /// # Errors
    /// As [`derivative`](Self::derivative); [`EvaluateError::Stationary`] where the first derivative
    /// is zero.
    pub fn tangent(&self, t: S, outside: Outside) -> Result<Vec3<S::Unit>, EvaluateError> {
        direction(self.derivative(1, t, outside)?)
    }
}
