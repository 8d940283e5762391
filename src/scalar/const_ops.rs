//! What constructors check and compute, for constants: traits have no `const` methods yet.

use super::number::Number;
use super::scalar::{Scalar, Stretch};
use crate::numeric::const_sqrt;
use core::marker::PhantomData;

/// The constant functions of a number type.
pub(crate) struct ConstOps<S>(PhantomData<S>);

impl<S: Number> ConstOps<S> {
    pub(crate) const ZERO: S = S::ZERO;
    pub(crate) const ONE: S = S::ONE;
}

macro_rules! floats {
    ($($Float:ident),+) => {$(
        impl ConstOps<$Float> {
            pub(crate) const fn is_finite(x: $Float) -> bool {
                x.is_finite()
            }

            pub(crate) const fn is_zero(x: $Float) -> bool {
                x == 0.0
            }

            pub(crate) const fn is_below(x: $Float, y: $Float) -> bool {
                x < y
            }

            pub(crate) const fn sum(x: $Float, y: $Float) -> $Float {
                x + y
            }

            pub(crate) const fn difference(x: $Float, y: $Float) -> $Float {
                x - y
            }

            pub(crate) const fn is_within_reach(x: $Float) -> bool {
                x.abs() <= <$Float>::MAX_COORDINATE
            }

            pub(crate) const fn is_radius(x: $Float) -> bool {
                <$Float>::MIN_RADIUS <= x && x <= <$Float>::MAX_COORDINATE
            }

            pub(crate) const fn inverse(radius: $Float) -> $Float {
                1.0 / radius
            }

            /// [`Number::to_f64`].
            pub(crate) const fn to_f64(x: $Float) -> f64 {
                x as f64
            }

            /// [`Number::from_f64`].
            pub(crate) const fn from_f64(x: f64) -> $Float {
                x as $Float
            }

            /// [`Scalar::normalized`].
            pub(crate) const fn normalized([x, y, z]: [$Float; 3]) -> Option<[$Float; 3]> {
                match normalized([x as f64, y as f64, z as f64]) {
                    Some([x, y, z]) => Some([x as $Float, y as $Float, z as $Float]),
                    None => None,
                }
            }

            /// [`Scalar::stretch`].
            pub(crate) const fn stretch(
                [a, b, c]: [$Float; 3],
                [x, y, z]: [$Float; 3],
            ) -> Option<Stretch<$Float>> {
                let (from, to) = ([a as f64, b as f64, c as f64], [x as f64, y as f64, z as f64]);
                match stretch(from, to, size_of::<$Float>()) {
                    Some(Stretch { direction: [x, y, z], low, high }) => Some(Stretch {
                        direction: [x as $Float, y as $Float, z as $Float],
                        low: low as $Float,
                        high: high as $Float,
                    }),
                    None => None,
                }
            }
        }
    )+};
}

floats!(f32, f64);

/// The vector of length 1 in the direction of a finite one, or `None` for zero.
pub(crate) const fn normalized([x, y, z]: [f64; 3]) -> Option<[f64; 3]> {
    let largest = x.abs().max(y.abs()).max(z.abs());
    if largest == 0.0 {
        return None;
    }
    // Scaled by the largest coordinate, no square can overflow or vanish.
    let (x, y, z) = (x / largest, y / largest, z / largest);
    let length = const_sqrt(x * x + y * y + z * z);
    Some([x / length, y / length, z / length])
}

/// The direction from one point to another, in a number type of so many bytes, and where along it
/// they lie.
pub(super) const fn stretch(from: [f64; 3], to: [f64; 3], size: usize) -> Option<Stretch<f64>> {
    let way = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
    let Some([x, y, z]) = normalized(way) else { return None };
    // Along the direction as it is rounded, which is what lines will be held against.
    let [x, y, z] = if size < size_of::<f64>() {
        [x as f32 as f64, y as f32 as f64, z as f32 as f64]
    } else {
        [x, y, z]
    };
    Some(Stretch {
        direction: [x, y, z],
        low: x * from[0] + y * from[1] + z * from[2],
        high: x * to[0] + y * to[1] + z * to[2],
    })
}
