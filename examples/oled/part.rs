//! What the display shows: a pulley, a groove between two flanges, with a bore and four holes.

use scancsg::geom::{Axis, Vec3, vec3};
use scancsg::scalar::{I16F16, Scalar};
use scancsg::solid::{AxisCylinder, Difference};

/// Cylinders along coordinate axes, known from the type.
pub type Pulley<S> = Difference<[AxisCylinder<S>; 3], [AxisCylinder<S>; 5]>;

/// The part by number type. Its constants cost flash and no RAM.
pub trait Part: Scalar {
    /// The part.
    const PULLEY: Pulley<Self>;
    /// Where it is seen from.
    const EYE: Vec3<Self>;
    /// The height of what is seen.
    const HEIGHT: Self;
    /// Towards the light.
    const TO_LIGHT: Vec3<Self>;
    /// The part of the light that comes from everywhere.
    const AMBIENT: Self;
}

macro_rules! part {
    ($($S:ident: $module:ident, |$hundredths:ident| $number:expr;)+) => {$(
        impl Part for $S {
            const PULLEY: Pulley<Self> = Pulley::new(
                [
                    $module::disc([0, 0], 75, [-40, 40]),
                    $module::disc([0, 0], 100, [-40, -22]),
                    $module::disc([0, 0], 100, [22, 40]),
                ],
                [
                    $module::disc([0, 0], 22, [-60, 60]),
                    $module::disc([48, 0], 13, [-60, 60]),
                    $module::disc([0, 48], 13, [-60, 60]),
                    $module::disc([-48, 0], 13, [-60, 60]),
                    $module::disc([0, -48], 13, [-60, 60]),
                ],
            );
            const EYE: Vec3<Self> = vec3($module::n(300), $module::n(160), $module::n(400));
            const HEIGHT: Self = $module::n(240);
            const TO_LIGHT: Vec3<Self> = vec3($module::n(-40), $module::n(80), $module::n(60));
            const AMBIENT: Self = $module::n(10);
        }

        mod $module {
            use super::*;

            pub const fn n($hundredths: i32) -> $S {
                $number
            }

            #[allow(clippy::panic)] // while compiling
            pub const fn disc(
                [x, y]: [i32; 2],
                radius: i32,
                [from, to]: [i32; 2],
            ) -> AxisCylinder<$S> {
                let (range, at) = (n(from)..n(to), [n(x), n(y)]);
                match AxisCylinder::<$S>::spanning(Axis::Z, range, at, n(radius)) {
                    Ok(disc) => disc,
                    Err(error) => panic!("{}", error.as_str()),
                }
            }
        }
    )+};
}

part! {
    f32: single, |hundredths| hundredths as f32 / 100.0;
    I16F16: fixed_point, |hundredths| I16F16::from_bits((hundredths << 16) / 100);
}
