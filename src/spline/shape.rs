//! Constructors of curves, for constants: one set for each kind of points.

use super::CurveError;
use super::curve::Curve;
use super::knots::Knots;
use crate::geom::Vec3;
use crate::scalar::{ConstOps, FixedI32, Fraction};
use core::marker::PhantomData;

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
                    if !ConstOps::<$Scalar>::is_finite(*x) {
                        return Err(CurveError::NotFinite);
                    }
                    if !ConstOps::<$Scalar>::is_control_coordinate(*x) {
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

        impl ConstOps<$Scalar> {
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

impl<F: Fraction> ConstOps<FixedI32<F>> {
    const fn is_control_coordinate(_: FixedI32<F>) -> bool {
        true
    }
}
