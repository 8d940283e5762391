//! `plate`: a round plate with bolt holes on a square grid, to see how pictures cost with many
//! primitives.
//!
//! Whatever their number N, the holes have a quarter of the grid's pitch as their radius and a
//! grid of the same size, so the same area is drilled out, and a picture shows about as much of the
//! plate: with 1, 4, 16 and 64 holes, `tee`'s camera sees it in 37.1, 37.6, 38.5 and 40.1 % of 160×120
//! pixels. Only the number of primitives grows.

use super::Scene;
use scancsg::constant;
use scancsg::scalar::I16F16;
use scancsg::solid::{Cylinder, Difference};

/// What there is of it, minus `N` holes.
pub type Plate<S, const N: usize> = Difference<Cylinder<S>, [Cylinder<S>; N]>;

/// The plate in a number type, with a square number of holes.
pub trait PlateScene<const N: usize>: Scene {
    /// The plate.
    const PLATE: Plate<Self, N>;
}

macro_rules! plate {
    ($module:ident, $Scalar:ty) => {
        mod $module {
            use super::super::$module::n;
            use super::*;

            /// As wide as the frame is high, and thin.
            pub(super) const DISC: Cylinder<$Scalar> =
                constant!(Cylinder::<$Scalar>::along_z(n(0), n(0), n(220), n(-5), n(5)));

            /// The holes, on a square with sides of 3.2.
            pub(super) const fn holes<const N: usize>() -> [Cylinder<$Scalar>; N] {
                const { assert!(N.isqrt().pow(2) == N, "holes are on a square grid") };
                let side = N.isqrt() as i32;
                let mut holes = [hole([0, 0], side); N];
                let mut index = 0;
                while index < N {
                    holes[index] = hole([index as i32 % side, index as i32 / side], side);
                    index += 1;
                }
                holes
            }

            /// A hole in a column and a row of the grid.
            #[allow(clippy::panic)] // while compiling
            const fn hole([column, row]: [i32; 2], side: i32) -> Cylinder<$Scalar> {
                let half_pitch = 160 / side;
                let (x, y) =
                    ((2 * column + 1 - side) * half_pitch, (2 * row + 1 - side) * half_pitch);
                match Cylinder::<$Scalar>::along_z(n(x), n(y), n(half_pitch / 2), n(-10), n(10)) {
                    Ok(hole) => hole,
                    Err(error) => panic!("{}", error.as_str()),
                }
            }
        }

        impl<const N: usize> PlateScene<N> for $Scalar {
            const PLATE: Plate<Self, N> = Plate::<Self, N>::new($module::DISC, $module::holes());
        }
    };
}

plate!(f32, f32);
plate!(f64, f64);
plate!(i16f16, I16F16);
