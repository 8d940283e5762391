//! What control points can be: numbers and vectors.

use super::error::EvaluateError;
use super::scalar::{Arithmetic, SplineScalar};
use crate::geom::Vec3;
use crate::scalar::Number;
use core::fmt::Debug;

/// A control point, and a point of a curve: a number, a [`Vec3`], or an array of coordinates.
pub trait Point: Copy + Debug + PartialEq + sealed::Sealed {
    /// The type of the coordinates and of the curve's parameter.
    type Scalar: SplineScalar;
    /// Something for each coordinate.
    #[doc(hidden)]
    type Array<T: Copy + Debug + PartialEq + 'static>: Copy
        + Debug
        + PartialEq
        + AsRef<[T]>
        + AsMut<[T]>
        + 'static;

    /// The point with all coordinates 0.
    const ORIGIN: Self;

    #[doc(hidden)]
    fn coordinates(self) -> Self::Array<Self::Scalar>;

    #[doc(hidden)]
    fn from_coordinates(coordinates: Self::Array<Self::Scalar>) -> Self;

    /// The same for each coordinate.
    #[doc(hidden)]
    fn filled<T: Copy + Debug + PartialEq>(with: T) -> Self::Array<T>;
}

mod sealed {
    pub trait Sealed {}
}

macro_rules! points {
    ($([$($generics:tt)*] $Point:ty, $D:expr, $origin:expr, $coordinates:expr, $point:expr;)+) => {$(
        impl<S: SplineScalar, $($generics)*> sealed::Sealed for $Point {}

        impl<S: SplineScalar, $($generics)*> Point for $Point {
            type Scalar = S;
            type Array<T: Copy + Debug + PartialEq + 'static> = [T; $D];

            const ORIGIN: Self = $origin;

            #[inline]
            fn coordinates(self) -> [S; $D] {
                $coordinates(self)
            }

            #[inline]
            fn from_coordinates(coordinates: [S; $D]) -> Self {
                $point(coordinates)
            }

            #[inline]
            fn filled<T: Copy + Debug + PartialEq + 'static>(with: T) -> [T; $D] {
                [with; $D]
            }
        }
    )+};
}

points! {
    [] S, 1, S::ZERO, |x| [x], |[x]: [S; 1]| x;
    [] Vec3<S>, 3, Self::ZERO, Vec3::to_array, Vec3::from;
    [const D: usize] [S; D], D, [S::ZERO; D], |array| array, |array| array;
}

/// The coordinates of a point inside of an evaluation.
pub(super) type Inner<P> = <P as Point>::Array<<<P as Point>::Scalar as Arithmetic>::Inner>;

/// A point inside of an evaluation.
#[inline]
pub(super) fn inner<P: Point>(point: P) -> Inner<P> {
    let mut inner = P::filled(P::Scalar::ZERO.inner());
    for (inner, x) in inner.as_mut().iter_mut().zip(point.coordinates().as_ref()) {
        *inner = x.inner();
    }
    inner
}

/// A point after an evaluation.
#[inline]
pub(super) fn outer<P: Point>(point: Inner<P>) -> P {
    let mut outer = P::ORIGIN.coordinates();
    for (outer, x) in outer.as_mut().iter_mut().zip(point.as_ref()) {
        *outer = P::Scalar::outer(*x);
    }
    P::from_coordinates(outer)
}

/// Every coordinate of one point changed with that of another one.
#[inline]
pub(super) fn combine<P: Point>(
    point: &mut Inner<P>,
    other: Inner<P>,
    with: impl Fn(
        <P::Scalar as Arithmetic>::Inner,
        <P::Scalar as Arithmetic>::Inner,
    ) -> <P::Scalar as Arithmetic>::Inner,
) {
    for (x, other) in point.as_mut().iter_mut().zip(other.as_ref()) {
        *x = with(*x, *other);
    }
}

/// A velocity as a vector of length 1.
pub(super) fn direction<S: SplineScalar>(
    velocity: Vec3<S>,
) -> Result<Vec3<S::Unit>, EvaluateError> {
    let direction = velocity.map(S::wide).normalized().ok_or(EvaluateError::Stationary)?;
    Ok(direction.map(S::unit))
}
