//! What control points can be: numbers and vectors.

use super::error::EvaluateError;
use super::scalar::SplineScalar;
use crate::geom::Vec3;
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

    #[doc(hidden)]
    fn map<T, U>(array: Self::Array<T>, of: impl Fn(T) -> U) -> Self::Array<U>
    where
        T: Copy + Debug + PartialEq,
        U: Copy + Debug + PartialEq;
}

mod sealed {
    pub trait Sealed {}
}

impl<S: SplineScalar> sealed::Sealed for S {}
impl<S: SplineScalar> sealed::Sealed for Vec3<S> {}
impl<S: SplineScalar, const D: usize> sealed::Sealed for [S; D] {}

impl<S: SplineScalar> Point for S {
    type Scalar = S;
    type Array<T: Copy + Debug + PartialEq + 'static> = [T; 1];

    const ORIGIN: Self = S::ZERO;

    #[inline]
    fn coordinates(self) -> [S; 1] {
        [self]
    }

    #[inline]
    fn from_coordinates([x]: [S; 1]) -> Self {
        x
    }

    #[inline]
    fn map<T, U>(array: [T; 1], of: impl Fn(T) -> U) -> [U; 1]
    where
        T: Copy + Debug + PartialEq + 'static,
        U: Copy + Debug + PartialEq + 'static,
    {
        array.map(of)
    }
}

impl<S: SplineScalar> Point for Vec3<S> {
    type Scalar = S;
    type Array<T: Copy + Debug + PartialEq + 'static> = [T; 3];

    const ORIGIN: Self = Self::ZERO;

    #[inline]
    fn coordinates(self) -> [S; 3] {
        self.to_array()
    }

    #[inline]
    fn from_coordinates(coordinates: [S; 3]) -> Self {
        coordinates.into()
    }

    #[inline]
    fn map<T, U>(array: [T; 3], of: impl Fn(T) -> U) -> [U; 3]
    where
        T: Copy + Debug + PartialEq + 'static,
        U: Copy + Debug + PartialEq + 'static,
    {
        array.map(of)
    }
}

impl<S: SplineScalar, const D: usize> Point for [S; D] {
    type Scalar = S;
    type Array<T: Copy + Debug + PartialEq + 'static> = [T; D];

    const ORIGIN: Self = [S::ZERO; D];

    #[inline]
    fn coordinates(self) -> [S; D] {
        self
    }

    #[inline]
    fn from_coordinates(coordinates: [S; D]) -> Self {
        coordinates
    }

    #[inline]
    fn map<T, U>(array: [T; D], of: impl Fn(T) -> U) -> [U; D]
    where
        T: Copy + Debug + PartialEq + 'static,
        U: Copy + Debug + PartialEq + 'static,
    {
        array.map(of)
    }
}

/// The coordinates of a point inside of an evaluation.
pub(super) type Inner<P> = <P as Point>::Array<<<P as Point>::Scalar as SplineScalar>::Inner>;

/// A point inside of an evaluation.
#[inline]
pub(super) fn inner<P: Point>(point: P) -> Inner<P> {
    P::map(point.coordinates(), P::Scalar::inner)
}

/// A point after an evaluation.
#[inline]
pub(super) fn outer<P: Point>(point: Inner<P>) -> P {
    P::from_coordinates(P::map(point, P::Scalar::outer))
}

/// Every coordinate of one point changed with that of another one.
#[inline]
pub(super) fn combine<P: Point>(
    point: &mut Inner<P>,
    other: Inner<P>,
    with: impl Fn(
        <P::Scalar as SplineScalar>::Inner,
        <P::Scalar as SplineScalar>::Inner,
    ) -> <P::Scalar as SplineScalar>::Inner,
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
