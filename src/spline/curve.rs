//! Curves whose control points can be changed.

use super::blend::Blend;
use super::domain::{Domain, Outside};
use super::knots::Knots;
use super::point::{Inner, Point, combine, inner, outer};
use super::{CurveError, EvaluateError};
use crate::geom::Vec3;
use crate::scalar::{Check, FixedI32, Fraction, Number};
use core::marker::PhantomData;

/// A B-spline curve of the order `K`, with room for `C` control points and `N` knots.
///
/// It is evaluated by de Boor's algorithm (C. de Boor, *On calculating with B-splines*, Journal of
/// Approximation Theory 6, 1972): control points are blended two by two. Each blend is measured
/// from the nearer of the two, so a curve with clamped ends passes through its first and last
/// control point exactly, and in `f32` a quadratic or cubic is within 1.5 units in the last place
/// of the largest coordinate of its control points. In fixed point, values are rounded once.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Curve<P: Point, const K: usize, const C: usize, const N: usize> {
    pub(super) knots: Knots<P::Scalar, K, N>,
    /// As many as the knots demand, and behind them origins.
    pub(super) points: [P; C],
}

/// What constructors need to know of a kind of points, for constants.
pub(super) struct Shape<P>(PhantomData<P>);

macro_rules! shape {
    ([$($generics:tt)*] $Scalar:ty, $Point:ty, $D:expr, $point:ident => $coordinates:expr, $zero:expr) => {
        impl<$($generics)*> Shape<$Point> {
            pub(super) const ORIGIN: $Point = $zero;

            pub(super) const fn coordinates($point: $Point) -> [$Scalar; $D] {
                $coordinates
            }

            /// Whether a point is finite, and whether it is within reach.
            const fn checked(point: $Point) -> Result<(), CurveError> {
                let coordinates = Self::coordinates(point);
                let mut rest: &[$Scalar] = &coordinates;
                while let [x, others @ ..] = rest {
                    if !Check::<$Scalar>::is_finite(*x) {
                        return Err(CurveError::NotFinite);
                    }
                    if !Check::<$Scalar>::is_control_coordinate(*x) {
                        return Err(CurveError::TooFar);
                    }
                    rest = others;
                }
                Ok(())
            }
        }

        impl<$($generics)* const K: usize, const C: usize, const N: usize> Curve<$Point, K, C, N> {
            /// A curve over these knots, with these control points: as many as there are knots,
            /// less the order.
            ///
            /// # Errors
            /// [`CurveError::PointCount`], [`CurveError::NotFinite`], [`CurveError::TooFar`], or
            /// [`CurveError::Empty`] if the domain has no length.
            pub const fn new(
                knots: Knots<$Scalar, K, N>,
                points: [$Point; C],
            ) -> Result<Self, CurveError> {
                if knots.points() != C {
                    return Err(CurveError::PointCount);
                }
                Self::checked(knots, points)
            }

            /// A curve over these knots, with these control points; there may be room for more.
            ///
            /// # Errors
            /// As [`new`](Self::new).
            pub const fn from_slice(
                knots: Knots<$Scalar, K, N>,
                points: &[$Point],
            ) -> Result<Self, CurveError> {
                if points.len() != knots.points() {
                    return Err(CurveError::PointCount);
                }
                Self::repeated(knots, points)
            }

            /// A closed curve over [periodic](Knots::periodic) knots, with a control point for
            /// each span: the last `K − 1` control points are the first ones again.
            ///
            /// # Errors
            /// As [`new`](Self::new); [`CurveError::PointCount`] unless there are as many control
            /// points as knots less `2K − 1`.
            pub const fn closed(
                knots: Knots<$Scalar, K, N>,
                points: &[$Point],
            ) -> Result<Self, CurveError> {
                if points.is_empty() || points.len() + K - 1 != knots.points() {
                    return Err(CurveError::PointCount);
                }
                Self::repeated(knots, points)
            }

            /// As many control points as the knots need, taken from a list over and over again.
            const fn repeated(
                knots: Knots<$Scalar, K, N>,
                points: &[$Point],
            ) -> Result<Self, CurveError> {
                let mut copy = [Shape::<$Point>::ORIGIN; C];
                let mut rest = points;
                let mut i = 0;
                while i < C && i < knots.points() {
                    if let [] = rest {
                        rest = points;
                    }
                    if let [point, others @ ..] = rest {
                        copy[i] = *point;
                        rest = others;
                    }
                    i += 1;
                }
                Self::checked(knots, copy)
            }

            const fn checked(
                knots: Knots<$Scalar, K, N>,
                points: [$Point; C],
            ) -> Result<Self, CurveError> {
                let count = knots.points();
                if count > C {
                    return Err(CurveError::PointCount);
                }
                let mut i = 0;
                while i < C && i < count {
                    if let Err(error) = Shape::<$Point>::checked(points[i]) {
                        return Err(error);
                    }
                    i += 1;
                }
                if count < K || knots.spans() == 0 {
                    return Err(CurveError::Empty);
                }
                Ok(Self { knots, points })
            }
        }
    };
}

macro_rules! shapes {
    ($($Scalar:ident),+) => {$(
        shape!([] $Scalar, $Scalar, 1, x => [x], 0.0);
        shape!([] $Scalar, Vec3<$Scalar>, 3, point => point.to_array(), Vec3::new(0.0, 0.0, 0.0));
        shape!([const D: usize,] $Scalar, [$Scalar; D], D, point => point, [0.0; D]);

        impl Check<$Scalar> {
            const fn is_control_coordinate(x: $Scalar) -> bool {
                Self::is_within_reach(x)
            }
        }
    )+};
}

shapes!(f32, f64);
shape!([F: Fraction,] FixedI32<F>, FixedI32<F>, 1, x => [x], FixedI32::from_bits(0));
shape!([F: Fraction,] FixedI32<F>, Vec3<FixedI32<F>>, 3, point => point.to_array(), {
    let zero = FixedI32::from_bits(0);
    Vec3::new(zero, zero, zero)
});
shape!([F: Fraction, const D: usize,] FixedI32<F>, [FixedI32<F>; D], D, point => point, {
    [FixedI32::from_bits(0); D]
});

impl<F: Fraction> Check<FixedI32<F>> {
    const fn is_control_coordinate(_: FixedI32<F>) -> bool {
        true
    }
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
        let zero = P::Scalar::ZERO;
        self.knots.domain().unwrap_or(Domain { from: zero, to: zero })
    }

    /// The curve's point at a parameter.
    ///
    /// # Errors
    /// [`EvaluateError::NotFinite`]; [`EvaluateError::Outside`] if t is outside of the domain and
    /// the policy says so; [`EvaluateError::Overflow`] only outside of the domain.
    #[inline]
    pub fn value(&self, t: P::Scalar, outside: Outside) -> Result<P, EvaluateError> {
        let point = self.inner_derivative(0, t, outside)?;
        Ok(outer(point))
    }

    /// A derivative of the curve by its parameter; of order 0 it is the value, of order `K` or more
    /// zero. At a knot where it jumps it is that of the span behind, at the end of the domain that of
    /// the span in front.
    ///
    /// In fixed point a derivative beyond the range of the number type is the end of the range; it
    /// is accurate where the derivative's control points, that is differences of control points
    /// times the degree over differences of knots, are within 16 times the range.
    ///
    /// # Errors
    /// As [`value`](Self::value), and [`EvaluateError::Overflow`] for a derivative too large for a
    /// floating-point type.
    pub fn derivative(
        &self,
        order: usize,
        t: P::Scalar,
        outside: Outside,
    ) -> Result<P, EvaluateError> {
        Ok(outer(self.inner_derivative(order, t, outside)?))
    }

    #[inline]
    fn inner_derivative(
        &self,
        order: usize,
        t: P::Scalar,
        outside: Outside,
    ) -> Result<Inner<P>, EvaluateError> {
        let t = self.domain().place(t, outside)?;
        let point = de_boor(self, order, t);
        let is_finite = |x: &_| P::Scalar::outer(*x).is_finite();
        if (order > 0 || matches!(outside, Outside::Extrapolate))
            && !point.as_ref().iter().all(is_finite)
        {
            return Err(EvaluateError::Overflow);
        }
        Ok(point)
    }
}

impl<S: Blend, const K: usize, const C: usize, const N: usize> Curve<Vec3<S>, K, C, N> {
    /// The direction of the curve at a parameter, as a vector of length 1.
    ///
    /// # Errors
    /// As [`derivative`](Self::derivative); [`EvaluateError::Stationary`] where the first derivative
    /// is zero.
    pub fn tangent(&self, t: S, outside: Outside) -> Result<Vec3<S::Unit>, EvaluateError> {
        let velocity = self.derivative(1, t, outside)?;
        let Some(direction) = velocity.map(S::fine).normalized() else {
            return Err(EvaluateError::Stationary);
        };
        Ok(direction.map(S::unit))
    }
}

/// De Boor's triangle: `order` levels of differences, then blends.
#[inline]
fn de_boor<P: Point, const K: usize, const C: usize, const N: usize>(
    curve: &Curve<P, K, C, N>,
    order: usize,
    t: P::Scalar,
) -> Inner<P> {
    // A constructed curve has a span for every parameter.
    let span = curve.knots.span_of_domain(t);
    on_span::<P, K>(&curve.knots.knots, &curve.points, span, order, t)
        .unwrap_or_else(|| inner(P::ORIGIN))
}

/// As `de_boor`, with the polynomial of a given span.
#[inline]
pub(super) fn on_span<P: Point, const K: usize>(
    knots: &[P::Scalar],
    points: &[P],
    span: usize,
    order: usize,
    t: P::Scalar,
) -> Option<Inner<P>> {
    if order >= K {
        return Some(inner(P::ORIGIN));
    }
    let first = (span + 1).checked_sub(K)?;
    let points: &[P; K] = points.get(first..)?.first_chunk()?;
    // t_{j−k+1} … t_j and t_{j+1} … t_{j+k}.
    let low: &[P::Scalar; K] = knots.get(first..)?.first_chunk()?;
    let high: &[P::Scalar; K] = knots.get(span + 1..)?.first_chunk()?;

    let mut blended = points.map(inner);
    for level in 1..K {
        // Loops over an index get unrolled, which chains of iterators don't.
        for i in 0..K - level {
            let (Some(&low), Some(&high)) = (low.get(i + level), high.get(i)) else { break };
            let Some(&b) = blended.get(i + 1) else { break };
            let Some(a) = blended.get_mut(i) else { break };
            if level <= order {
                let degree = (K - level) as u16;
                combine::<P>(a, b, |a, b| {
                    P::Scalar::slope(P::Scalar::subtract(b, a), degree, low, high)
                });
            } else {
                let ratio = P::Scalar::ratio(t, low, high);
                combine::<P>(a, b, |a, b| P::Scalar::blend(a, b, ratio));
            }
        }
    }
    blended.first().copied()
}
