//! The splines whose points are counted, and those points as one number, by which `cargo xtask boards`
//! compares a board with the host: cores with a floating-point unit have instructions of their own for
//! them, which must give the same bits.

#![allow(dead_code)] // every user takes what it needs

use crate::scene::Scene;
use core::hint::black_box;
use scancsg::constant;
use scancsg::geom::{Vec3, vec3};
use scancsg::scalar::I16F16;
use scancsg::spline::{Baked, Curve, Knots, SplineScalar};

/// Cubic curves in space, with eight control points.
pub type Editable<S> = Curve<Vec3<S>, 4, 8, 12>;
pub type InFlash<S> = Baked<Vec3<S>, 4, 5>;

pub trait Splines: SplineScalar + Scene {
    const KNOTS: Knots<Self, 4, 12>;
    const EDITABLE: Editable<Self>;
    const BAKED: InFlash<Self>;

    fn bits(self) -> u32;
}

macro_rules! splines {
    ($($Number:ident: $module:ident, |$count:ident| $quarters:expr, $bits:expr;)+) => {$(
        impl Splines for $Number {
            const KNOTS: Knots<Self, 4, 12> = $module::KNOTS;
            const EDITABLE: Editable<Self> = $module::EDITABLE;
            const BAKED: InFlash<Self> = constant!($module::EDITABLE.bake());

            fn bits(self) -> u32 {
                $bits(self)
            }
        }

        mod $module {
            use super::*;

            pub const KNOTS: Knots<$Number, 4, 12> =
                constant!(Knots::<$Number, 4, 12>::clamped_uniform(8, quarters(0), quarters(20)));
            pub const EDITABLE: Editable<$Number> = constant!(Editable::<$Number>::new(
                KNOTS,
                [
                    point([0, 0, 0]),
                    point([4, 8, -4]),
                    point([12, 4, 2]),
                    point([16, -8, 4]),
                    point([8, -12, 8]),
                    point([0, -4, 12]),
                    point([-4, 4, 8]),
                    point([2, 8, 4]),
                ]
            ));

            const fn point([x, y, z]: [i32; 3]) -> Vec3<$Number> {
                vec3(quarters(x), quarters(y), quarters(z))
            }

            const fn quarters($count: i32) -> $Number {
                $quarters
            }
        }
    )+};
}

splines! {
    f32: single, |count| count as f32 / 4.0, f32::to_bits;
    I16F16: fixed_point, |count| I16F16::from_bits(count << 14), |x: I16F16| x.to_bits().cast_unsigned();
}

/// All bits of the points at 96 parameters: quarters, among which are all knots and what is outside of
/// the domain, and others. No single difference is lost in it.
pub fn digest<S: Splines>(points: impl Fn(S) -> [Vec3<S>; 2]) -> u32 {
    let quarters = (-4..28).map(|i| S::hundredths(25 * i));
    let others = (0..64).map(|i| S::hundredths(8 * i + 3));
    let points = quarters.chain(others).flat_map(|t| points(black_box(t)));
    points
        .flat_map(|point| [point.x, point.y, point.z])
        // Fowler, Noll and Vo's hash, of words.
        .fold(0x811c_9dc5, |digest, x| (digest ^ x.bits()).wrapping_mul(0x0100_0193))
}
