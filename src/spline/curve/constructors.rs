//! Constructors of curves, and of baked ones, for constants: one set for each kind of points.

use super::Curve;
use crate::geom::Vec3;
use crate::scalar::{ConstOps, FixedI32, Fraction, per_scalar};
use crate::spline::baked::{Baked, search};
use crate::spline::error::CurveError;
use crate::spline::knots::Knots;
use crate::spline::point::Point;
use crate::spline::scalar::constant::repeated;
use crate::spline::scalar::order::Ordered;

macro_rules! constructors {
    ([$($generics:tt)*] $Scalar:ty, $Point:ty, $D:expr, |$point:ident| $coordinates:expr) => {
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
                Self::repeating(knots, &points, C)
            }

            /// A curve over these knots, with these control points; there may be room for more.
            ///
            /// # Errors
            /// As [`new`](Self::new).
            pub const fn from_slice(
                knots: Knots<$Scalar, K, N>,
                points: &[$Point],
            ) -> Result<Self, CurveError> {
                Self::repeating(knots, points, points.len())
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
                Self::repeating(knots, points, points.len() + K - 1)
            }

            /// A curve with so many control points, which are these over and over again.
            const fn repeating(
                knots: Knots<$Scalar, K, N>,
                points: &[$Point],
                count: usize,
            ) -> Result<Self, CurveError> {
                if points.is_empty() || count != knots.points() || count > C {
                    return Err(CurveError::PointCount);
                }
                let points = repeated(points, 0, count, <$Point as Point>::ORIGIN);
                let curve = Self { knots, points };
                match curve.flat().check(count) {
                    Ok(()) => Ok(curve),
                    Err(error) => Err(error),
                }
            }

            /// The same curve of arrays.
            const fn flat(&self) -> Curve<[$Scalar; $D], K, C, N> {
                let mut points = [[ConstOps::<$Scalar>::ZERO; $D]; C];
                let mut i = 0;
                while i < C {
                    let $point = self.points[i];
                    points[i] = $coordinates;
                    i += 1;
                }
                Curve { knots: self.knots, points }
            }

            /// The curve's polynomials, for a constant: they don't follow when a control point is
            /// moved.
            ///
            /// With twice as many `SPANS` as the curve has, each is divided into two polynomials,
            /// and so on: rounding errors become smaller, and in fixed point there is room for control
            /// points that are farther apart.
            ///
            /// # Errors
            /// [`CurveError::SpanCount`] unless `SPANS` is the number of the curve's spans, or a
            /// multiple of it;
            /// [`CurveError::TooFar`] in fixed point, if a span goes so far that fewer than four
            /// guard bits are left. In `I16F16`, control points of a cubic within 25 units of some
            /// place always are near enough. That is for those that alternate, over spans of a power of
            /// two; most have room for some hundreds, and over halves of a span also those for 200.
            pub const fn bake<const SPANS: usize>(
                &self,
            ) -> Result<Baked<$Point, K, SPANS>, CurveError> {
                match self.flat().baked() {
                    Ok(Baked { nodes, outside, from, end, pieces }) => {
                        Ok(Baked { nodes, outside, from, end, pieces })
                    }
                    Err(error) => Err(error),
                }
            }
        }
    };
}

constructors!([] f32, f32, 1, |x| [x]);
constructors!([] f64, f64, 1, |x| [x]);
constructors!([F: Fraction,] FixedI32<F>, FixedI32<F>, 1, |x| [x]);
constructors!([] f32, Vec3<f32>, 3, |point| point.to_array());
constructors!([] f64, Vec3<f64>, 3, |point| point.to_array());
constructors!([F: Fraction,] FixedI32<F>, Vec3<FixedI32<F>>, 3, |point| point.to_array());
constructors!([const D: usize,] f32, [f32; D], D, |point| point);
constructors!([const D: usize,] f64, [f64; D], D, |point| point);
constructors!([F: Fraction, const D: usize,] FixedI32<F>, [FixedI32<F>; D], D, |point| point);

per_scalar! { $S: impl[const D: usize, const K: usize, const C: usize, const N: usize] Curve<[$S; D], K, C, N> {
    /// Whether this is a curve, with so many control points.
    const fn check(&self, count: usize) -> Result<(), CurveError> {
        let [lowest, highest] = <$S as Ordered>::RANGE;
        let mut rest = self.points.as_flattened();
        while let [x, others @ ..] = rest {
            if !ConstOps::<$S>::is_finite(*x) {
                return Err(CurveError::NotFinite);
            }
            if ConstOps::<$S>::is_below(*x, lowest) || ConstOps::<$S>::is_below(highest, *x) {
                return Err(CurveError::TooFar);
            }
            rest = others;
        }
        if count < K || self.knots.spans() == 0 { Err(CurveError::Empty) } else { Ok(()) }
    }

    const fn baked<const SPANS: usize>(&self) -> Result<Baked<[$S; D], K, SPANS>, CurveError> {
        let places = match self.knots.places::<SPANS>() {
            Ok(places) => places,
            Err(error) => return Err(error),
        };
        let (mut knots, mut points) = ([0.0; N], [[0.0; D]; C]);
        let mut i = 0;
        while i < N {
            knots[i] = ConstOps::<$S>::units(self.knots.knots[i]);
            i += 1;
        }
        let mut i = 0;
        while i < C * D {
            points.as_flattened_mut()[i] = ConstOps::<$S>::units(self.points.as_flattened()[i]);
            i += 1;
        }
        let first = ConstOps::<$S>::piece(&knots, &points, places[0][0]);
        let Some(first) = first else { return Err(CurveError::TooFar) };
        let mut pieces = [[first; _]; SPANS];
        let mut nodes = [[[0; 2]; _]; SPANS];
        let places = places.as_flattened();
        let mut i = 1;
        while i < places.len() {
            let piece = ConstOps::<$S>::piece(&knots, &points, places[i]);
            let Some(piece) = piece else { return Err(CurveError::TooFar) };
            pieces.as_flattened_mut()[i] = piece;
            i += 1;
        }
        let from = ConstOps::<$S>::first_key(places[0].1[0]);
        let end = ConstOps::<$S>::last_key(places[places.len() - 1].1[1]);
        let outside = end.wrapping_add(1);
        let mut node = 1;
        while node < 1 << search::levels(places.len()) {
            if let Some(i) = search::element(node, places.len()) {
                let key = ConstOps::<$S>::first_key(places[i].1[0]);
                nodes.as_flattened_mut().as_flattened_mut()[node] = key.wrapping_sub(outside);
            }
            node += 1;
        }
        Ok(Baked { nodes, outside, from, end, pieces })
    }
} }
