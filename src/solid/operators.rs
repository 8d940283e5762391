//! The operators `|`, `&` and `-`, of every solid with any other.

use super::{
    Boolean, ByLine, Cone, Cuboid, Cylinder, Difference, HalfSpace, Intersection, Many, Painted,
    Pipe, Placed, Polyhedron, Scaled, Slab, Sphere, Torus, Union,
};
use crate::scalar::Scalar;
use crate::span::Shape;
use core::ops::{BitAnd, BitOr, Sub};

macro_rules! operators {
    ($([$($generics:tt)*] $Solid:ty),+ $(,)?) => {$(
        impl<$($generics)*, Right> BitOr<Right> for $Solid {
            type Output = Union<Self, Right>;
            fn bitor(self, right: Right) -> Self::Output {
                Boolean::new(self, right)
            }
        }

        impl<$($generics)*, Right> BitAnd<Right> for $Solid {
            type Output = Intersection<Self, Right>;
            fn bitand(self, right: Right) -> Self::Output {
                Boolean::new(self, right)
            }
        }

        impl<$($generics)*, Right> Sub<Right> for $Solid {
            type Output = Difference<Self, Right>;
            fn sub(self, right: Right) -> Self::Output {
                Boolean::new(self, right)
            }
        }
    )+};
}

operators! {
    [S: Scalar] Cuboid<S>,
    [S: Scalar] Cone<S>,
    [S: Scalar] Cylinder<S>,
    [S: Scalar] HalfSpace<S>,
    [S: Scalar, const N: usize, F] Polyhedron<S, N, F>,
    [S: Scalar] Slab<S>,
    [S: Scalar] Sphere<S>,
    [S: Scalar] Torus<S>,
    [S: Scalar, const SEGMENTS: usize] Pipe<S, SEGMENTS>,
    [T, const N: usize] ByLine<T, N>,
    [T, const N: usize] Many<T, N>,
    [T] Painted<T>,
    [T: Shape] Placed<T>,
    [T: Shape] Scaled<T>,
    [O, L, R] Boolean<O, L, R>,
}
