//! The number type of a build.

use scancsg::geom::{Vec3, vec3};

/// A coordinate, a length, an angle in radians: `float`, or 65,536ths as `int32_t`.
#[cfg(not(feature = "i16f16"))]
pub type Number = f32;

/// A coordinate, a length, an angle in radians: `float`, or 65,536ths as `int32_t`.
#[cfg(feature = "i16f16")]
pub type Number = i32;

#[cfg(not(feature = "i16f16"))]
pub(crate) type Scalar = f32;
#[cfg(feature = "i16f16")]
pub(crate) type Scalar = scancsg::scalar::I16F16;

#[cfg(not(feature = "i16f16"))]
pub(crate) fn scalar(number: Number) -> Scalar {
    number
}

#[cfg(feature = "i16f16")]
pub(crate) fn scalar(number: Number) -> Scalar {
    Scalar::from_bits(number)
}

#[cfg(not(feature = "i16f16"))]
fn number(scalar: Scalar) -> Number {
    scalar
}

#[cfg(feature = "i16f16")]
fn number(scalar: Scalar) -> Number {
    scalar.to_bits()
}

pub(crate) fn vector([x, y, z]: [Number; 3]) -> Vec3<Scalar> {
    vec3(scalar(x), scalar(y), scalar(z))
}

pub(crate) fn numbers<const N: usize>(scalars: [Scalar; N]) -> [Number; N] {
    scalars.map(number)
}
