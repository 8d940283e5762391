//! Constructors of curves, and of baked ones, for constants: one set for each kind of points.

use super::Curve;
use crate::geom::Vec3;
use crate::scalar::{ConstOps, FixedI32, Fraction};
use crate::spline::baked::{Baked, search};
use crate::spline::error::CurveError;
use crate::spline::knots::Knots;
use crate::spline::point::Point;
use crate::spline::scalar::constant::repeated;
use crate::spline::scalar::order::Ordered;

macro_rules! constructors {
    ([$($generics:tt)*] $Scalar:ty, $Point:ty, $D:expr, $PIECES:literal, |$point:ident| $coordinates:expr) => {
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
                let [lowest, highest] = <$Scalar as Ordered>::RANGE;
                let points = repeated(points, 0, count, <$Point as Point>::ORIGIN);
                let rows = Self::rows(&points);
                let mut rest = rows.as_flattened();
                while let [x, others @ ..] = rest {
                    if !ConstOps::<$Scalar>::is_finite(*x) {
                        return Err(CurveError::NotFinite);
                    }
                    if ConstOps::<$Scalar>::is_below(*x, lowest)
                        || ConstOps::<$Scalar>::is_below(highest, *x)
                    {
                        return Err(CurveError::TooFar);
                    }
                    rest = others;
                }
                if count < K || knots.spans() == 0 {
                    return Err(CurveError::Empty);
                }
                Ok(Self { knots, points })
            }

            /// The coordinates of all points.
            const fn rows(points: &[$Point; C]) -> [[$Scalar; $D]; C] {
                let mut rows = [[ConstOps::<$Scalar>::ZERO; $D]; C];
                let mut i = 0;
                while i < C {
                    let $point = points[i];
                    rows[i] = $coordinates;
                    i += 1;
                }
                rows
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
                let places = match self.knots.places::<$PIECES, SPANS>() {
                    Ok(places) => places,
                    Err(error) => return Err(error),
                };
                let places = places.as_flattened();
                let (mut knots, mut points) = ([0.0; N], [[0.0; $D]; C]);
                let mut i = 0;
                while i < N {
                    knots[i] = ConstOps::<$Scalar>::units(self.knots.knots[i]);
                    i += 1;
                }
                let rows = Self::rows(&self.points);
                let mut i = 0;
                while i < C * $D {
                    let x = rows.as_flattened()[i];
                    points.as_flattened_mut()[i] = ConstOps::<$Scalar>::units(x);
                    i += 1;
                }
                let first = ConstOps::<$Scalar>::piece(&knots, &points, places[0]);
                let Some(first) = first else { return Err(CurveError::TooFar) };
                let mut pieces = [[first; $PIECES]; SPANS];
                let mut i = 1;
                while i < places.len() {
                    let piece = ConstOps::<$Scalar>::piece(&knots, &points, places[i]);
                    let Some(piece) = piece else { return Err(CurveError::TooFar) };
                    pieces.as_flattened_mut()[i] = piece;
                    i += 1;
                }
                let from = ConstOps::<$Scalar>::first_key(places[0].1[0]);
                let end = ConstOps::<$Scalar>::last_key(places[places.len() - 1].1[1]);
                let outside = end.wrapping_add(1);
                let mut nodes = [[[0; 2]; $PIECES]; SPANS];
                let mut node = 1;
                while node < 1 << search::levels(places.len()) {
                    if let Some(i) = search::element(node, places.len()) {
                        let key = ConstOps::<$Scalar>::first_key(places[i].1[0]);
                        nodes.as_flattened_mut().as_flattened_mut()[node] = key.wrapping_sub(outside);
                    }
                    node += 1;
                }
                Ok(Baked { nodes, outside, from, end, pieces })
            }
        }
    };
}

macro_rules! kinds {
    ($([$($generics:tt)*] $Scalar:ty, $PIECES:literal;)+) => {$(
        constructors!([$($generics)*] $Scalar, $Scalar, 1, $PIECES, |x| [x]);
        constructors!([$($generics)*] $Scalar, Vec3<$Scalar>, 3, $PIECES, |point| point.to_array());
        constructors!([$($generics)* const D: usize,] $Scalar, [$Scalar; D], D, $PIECES, |point| point);
    )+};
}

kinds! {
    [] f32, 3;
    [] f64, 3;
    [F: Fraction,] FixedI32<F>, 1;
}
