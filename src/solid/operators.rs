//! The operators `|`, `&` and `-`, of every solid with any other.

use super::{
    AxisCylinder, Boolean, ByLine, Capsule, Cone, Cuboid, Cylinder, HalfSpace, Many, Painted, Pipe,
    Placed, Polyhedron, RoundedCuboid, Scaled, Slab, Sphere, Torus,
};
use crate::scalar::Scalar;
use crate::span::Shape;

macro_rules! operators {
    ($([$($generics:tt)*] $Solid:ty),+ $(,)?) => {$(
        $crate::solid::operators! { BitOr, bitor, Union, [$($generics)*] $Solid }
        $crate::solid::operators! { BitAnd, bitand, Intersection, [$($generics)*] $Solid }
        $crate::solid::operators! { Sub, sub, Difference, [$($generics)*] $Solid }
    )+};
    ($Operator:ident, $operator:ident, $Output:ident, [$($generics:tt)*] $Solid:ty) => {
        impl<$($generics)*, Right> core::ops::$Operator<Right> for $Solid
        where
            $Solid: $crate::span::Shape,
            Right: $crate::span::Shape<Scalar = <$Solid as $crate::span::Shape>::Scalar>,
        {
            type Output = $crate::solid::$Output<Self, Right>;
            fn $operator(self, right: Right) -> Self::Output {
                $crate::solid::Boolean::new(self, right)
            }
        }
    };
}
pub(crate) use operators;

operators! {
    [S: Scalar] Cuboid<S>,
    [S: Scalar] Cone<S>,
    [S: Scalar] AxisCylinder<S>,
    [S: Scalar] Cylinder<S>,
    [S: Scalar] HalfSpace<S>,
    [S: Scalar, const N: usize, F] Polyhedron<S, N, F>,
    [S: Scalar] Slab<S>,
    [S: Scalar] Sphere<S>,
    [S: Scalar] Torus<S>,
    [S: Scalar] Capsule<S>,
    [S: Scalar] RoundedCuboid<S>,
    [S: Scalar, const SEGMENTS: usize] Pipe<S, SEGMENTS>,
    [T, const N: usize] ByLine<T, N>,
    [T, const N: usize] Many<T, N>,
    [T] Painted<T>,
    [T: Shape] Placed<T>,
    [T: Shape] Scaled<T>,
    [O, L, R] Boolean<O, L, R>,
}
