//! Curves whose control points can be changed.

use super::blend::Blend;
use super::domain::{Domain, Outside};
use super::knots::Knots;
use super::point::{Inner, Point, combine, inner, outer};
use super::{CurveError, EvaluateError};
use crate::geom::Vec3;
use crate::scalar::Number;

/// A B-spline curve of the order `K`, with room for `C` control points and `N` knots.
///
/// It is evaluated by de Boor's algorithm (C. de Boor, *On calculating with B-splines*, Journal of
/// Approximation Theory 6, 1972): control points are blended two by two. In fixed point that has 28
/// guard bits. In floating point each blend starts at the nearer end of its knot interval; orders up
/// to 4 are within 5 units in the last place of the largest coordinate of the control points. A curve
/// with clamped ends passes through its first and last control point exactly.
#[derive(Debug, Clone, Copy)]
pub struct Curve<P: Point, const K: usize, const C: usize, const N: usize> {
    pub(super) knots: Knots<P::Scalar, K, N>,
    /// As many as the knots demand, and behind them origins.
    pub(super) points: [P; C],
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
            if x.abs() > P::Scalar::LARGEST {
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
        let t = self.domain().place(t, outside)?;
        if matches!(outside, Outside::Extrapolate) {
            return self.checked_derivative(0, t);
        }
        let span = self.knots.span_of_domain(t);
        let point = on_span::<P, K>(&self.knots.knots, &self.points, span, t);
        // A constructed curve has a span for every parameter.
        Ok(point.map_or(P::ORIGIN, outer))
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
        self.checked_derivative(order, self.domain().place(t, outside)?)
    }

    /// De Boor's triangle: `order` levels of differences, then blends.
    #[inline(never)]
    fn checked_derivative(&self, order: usize, t: P::Scalar) -> Result<P, EvaluateError> {
        let span = self.knots.span_of_domain(t);
        let segment = segment::<P, K>(&self.knots.knots, &self.points, span);
        let Some((points, low, high)) = segment.filter(|_| order < K) else {
            return Ok(P::ORIGIN);
        };
        let mut blended = points.map(inner);
        for level in 1..K {
            let degree = (K - level) as u16;
            let intervals = low.iter().skip(level).zip(high);
            let mut rest = blended.as_mut_slice();
            for (&low, &high) in intervals {
                let [a, others @ ..] = rest else { break };
                let Some(&b) = others.first() else { break };
                if level <= order {
                    combine::<P>(a, b, |a, b| P::Scalar::slope(a, b, degree, low, high));
                } else {
                    let ratio = P::Scalar::ratio(t, low, high);
                    combine::<P>(a, b, |a, b| P::Scalar::blend(a, b, ratio));
                }
                if !a.as_ref().iter().all(|x| P::Scalar::is_within(*x)) {
                    return Err(EvaluateError::Overflow);
                }
                rest = others;
            }
        }
        let Some(&point) = blended.first() else { return Ok(P::ORIGIN) };
        let mut coordinates = P::ORIGIN.coordinates();
        for (x, inner) in coordinates.as_mut().iter_mut().zip(point.as_ref()) {
            *x = P::Scalar::checked(*inner).ok_or(EvaluateError::Overflow)?;
        }
        Ok(P::from_coordinates(coordinates))
    }
}

impl<S: Blend, const K: usize, const C: usize, const N: usize> Curve<Vec3<S>, K, C, N> {
    /// The direction of the curve at a parameter, as a vector of length 1.
    ///
    /// # Errors
    /// As [`derivative`](Self::derivative); [`EvaluateError::Stationary`] where the first derivative
    /// is zero.
    pub fn tangent(&self, t: S, outside: Outside) -> Result<Vec3<S::Unit>, EvaluateError> {
        direction(self.derivative(1, t, outside)?)
    }
}

/// A velocity as a vector of length 1.
pub(super) fn direction<S: Blend>(velocity: Vec3<S>) -> Result<Vec3<S::Unit>, EvaluateError> {
    let direction = velocity.map(S::wide).normalized().ok_or(EvaluateError::Stationary)?;
    Ok(direction.map(S::unit))
}

/// The control points of a span, and the knots t_{j−k+1} … t_j and t_{j+1} … t_{j+k}.
#[inline]
#[allow(clippy::type_complexity)]
fn segment<'a, P: Point, const K: usize>(
    knots: &'a [P::Scalar],
    points: &'a [P],
    span: usize,
) -> Option<(&'a [P; K], &'a [P::Scalar; K], &'a [P::Scalar; K])> {
    let first = (span + 1).checked_sub(K)?;
    Some((
        points.get(first..)?.first_chunk()?,
        knots.get(first..)?.first_chunk()?,
        knots.get(span + 1..)?.first_chunk()?,
    ))
}

/// The highest order whose blends are few enough for quick ratios.
const QUICK: usize = 4;

/// De Boor's triangle on a span, for parameters on it.
#[inline]
pub(super) fn on_span<P: Point, const K: usize>(
    knots: &[P::Scalar],
    points: &[P],
    span: usize,
    t: P::Scalar,
) -> Option<Inner<P>> {
    let (points, low, high) = segment::<P, K>(knots, points, span)?;
    let mut blended = points.map(inner);
    for level in 1..K {
        // Loops over an index get unrolled, which chains of iterators don't.
        for i in 0..K - level {
            let (Some(&low), Some(&high)) = (low.get(i + level), high.get(i)) else { break };
            let Some(&b) = blended.get(i + 1) else { break };
            let Some(a) = blended.get_mut(i) else { break };
            let ratio = if K > QUICK { P::Scalar::fine_ratio } else { P::Scalar::ratio };
            let ratio = ratio(t, low, high);
            combine::<P>(a, b, |a, b| P::Scalar::blend(a, b, ratio));
        }
    }
    blended.first().copied()
}
