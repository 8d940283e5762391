//! Constructors of baked curves, for constants: one for each kind of points.

use super::Baked;
use super::float::{DOUBLE, SINGLE};
use super::layout::{Kind, Layout};
use super::search;
use crate::geom::Vec3;
use crate::scalar::{ConstOps, FixedI32, Fraction};
use crate::spline::curve::Curve;
use crate::spline::error::CurveError;

macro_rules! bake {
    ([$($generics:tt)*] $Scalar:ty, $Point:ty, $PIECES:literal, $kind:expr) => {
        impl<$($generics)* const K: usize, const C: usize, const N: usize> Curve<$Point, K, C, N> {
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
                let knots = &$kind.numbers(&ConstOps::<$Scalar>::keys(&self.knots.knots));
                let domain = [K - 1, self.knots.points()];
                let spans = self.knots.spans();
                let layout = match Layout::<$PIECES, SPANS>::new($kind, knots, domain, spans) {
                    Ok(layout) => layout,
                    Err(error) => return Err(error),
                };
                let points = &$kind.rows(&Self::keys(&self.points));
                let mut pieces = match ConstOps::<$Scalar>::piece(knots, points, layout.place(0)) {
                    Ok(piece) => [[piece; $PIECES]; SPANS],
                    Err(error) => return Err(error),
                };
                let mut i = 1;
                while i < SPANS * $PIECES {
                    match ConstOps::<$Scalar>::piece(knots, points, layout.place(i)) {
                        Ok(piece) => pieces.as_flattened_mut()[i] = piece,
                        Err(error) => return Err(error),
                    }
                    i += 1;
                }
                let mut nodes = [[[0; 2]; $PIECES]; SPANS];
                let mut node = 1;
                while node < 1 << search::levels(SPANS * $PIECES) {
                    nodes.as_flattened_mut().as_flattened_mut()[node] = layout.node(node) as _;
                    node += 1;
                }
                let (from, end) = (layout.start(0) as _, layout.end() as _);
                let outside = layout.end().wrapping_add(1) as _;
                Ok(Baked { nodes, outside, from, end, pieces })
            }
        }
    };
}

macro_rules! kinds {
    ($([$($generics:tt)*] $Scalar:ty, $PIECES:literal, $kind:expr;)+) => {$(
        bake!([$($generics)*] $Scalar, $Scalar, $PIECES, $kind);
        bake!([$($generics)*] $Scalar, Vec3<$Scalar>, $PIECES, $kind);
        bake!([$($generics)* const D: usize,] $Scalar, [$Scalar; D], $PIECES, $kind);
    )+};
}

kinds! {
    [] f32, 3, Kind::Float(SINGLE);
    [] f64, 3, Kind::Float(DOUBLE);
    [F: Fraction,] FixedI32<F>, 1, Kind::Fixed;
}
