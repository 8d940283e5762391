//! Constructors of curves, for constants: one set for each kind of points.

use super::Curve;
use crate::geom::Vec3;
use crate::scalar::{ConstOps, FixedI32, Fraction};
use crate::spline::error::CurveError;
use crate::spline::knots::Knots;
use crate::spline::scalar::constant::{NOT_FINITE, repeated};

/// Whether so many points, whose coordinates have these keys, are control points.
const fn check<const D: usize>(
    points: &[[i64; D]],
    count: usize,
    [lowest, highest]: [i64; 2],
) -> Result<(), CurveError> {
    if count > points.len() {
        return Err(CurveError::PointCount);
    }
    let mut i = 0;
    while i < count * D {
        let key = points[i / D][i % D];
        if key == NOT_FINITE {
            return Err(CurveError::NotFinite);
        }
        if key < lowest || highest < key {
            return Err(CurveError::TooFar);
        }
        i += 1;
    }
    Ok(())
}

macro_rules! constructors {
    ([$($generics:tt)*] $Scalar:ty, $Point:ty, $D:expr, $zero:expr, |$point:ident| $coordinates:expr) => {
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
                Self::checked(knots, repeated(points, points.len(), $zero))
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
                Self::checked(knots, repeated(points, knots.points(), $zero))
            }

            const fn checked(
                knots: Knots<$Scalar, K, N>,
                points: [$Point; C],
            ) -> Result<Self, CurveError> {
                let count = knots.points();
                let keys = Self::keys(&points);
                if let Err(error) = check(&keys, count, ConstOps::<$Scalar>::REACH) {
                    return Err(error);
                }
                if count < K || knots.spans() == 0 {
                    return Err(CurveError::Empty);
                }
                Ok(Self { knots, points })
            }

            /// The keys of all coordinates.
            pub(in crate::spline) const fn keys(points: &[$Point; C]) -> [[i64; $D]; C] {
                let mut keys = [[0; $D]; C];
                let mut i = 0;
                while i < C {
                    let $point = points[i];
                    keys[i] = ConstOps::<$Scalar>::keys(&$coordinates);
                    i += 1;
                }
                keys
            }
        }
    };
}

macro_rules! kinds {
    ($([$($generics:tt)*] $Scalar:ty, $zero:expr;)+) => {$(
        constructors!([$($generics)*] $Scalar, $Scalar, 1, $zero, |x| [x]);
        constructors!(
            [$($generics)*] $Scalar, Vec3<$Scalar>, 3, Vec3::new($zero, $zero, $zero),
            |point| point.to_array()
        );
        constructors!([$($generics)* const D: usize,] $Scalar, [$Scalar; D], D, [$zero; D], |point| point);
    )+};
}

kinds! {
    [] f32, 0.0;
    [] f64, 0.0;
    [F: Fraction,] FixedI32<F>, FixedI32::from_bits(0);
}
