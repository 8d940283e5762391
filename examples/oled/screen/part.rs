//! What the display shows: a crankshaft of ten cylinders.

use scancsg::geom::{Axis, Vec3, vec3};
use scancsg::scalar::{I16F16, Scalar};
use scancsg::solid::AxisCylinder;

/// Cylinders along coordinate axes, known from the type.
pub type Crankshaft<S> = [AxisCylinder<S>; 10];

/// The part by number type. Its constants cost flash and no RAM.
pub trait Part: Scalar {
    /// The part.
    const CRANKSHAFT: Crankshaft<Self>;
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
            const CRANKSHAFT: Crankshaft<Self> = [
                // Journals,
                $module::rod([0, 0], 22, [-210, -110]),
                $module::rod([0, 0], 22, [-30, 30]),
                $module::rod([0, 0], 22, [110, 170]),
                // pins,
                $module::rod([42, 0], 18, [-92, -48]),
                $module::rod([-42, 0], 18, [48, 92]),
                // webs,
                $module::rod([15, 0], 60, [-110, -92]),
                $module::rod([15, 0], 60, [-48, -30]),
                $module::rod([-15, 0], 60, [30, 48]),
                $module::rod([-15, 0], 60, [92, 110]),
                // and a flywheel.
                $module::rod([0, 0], 95, [170, 195]),
            ];
            const EYE: Vec3<Self> = vec3($module::n(-300), $module::n(160), $module::n(400));
            const HEIGHT: Self = $module::n(260);
            const TO_LIGHT: Vec3<Self> = vec3($module::n(-60), $module::n(80), $module::n(30));
            const AMBIENT: Self = $module::n(10);
        }

        mod $module {
            use super::*;

            pub const fn n($hundredths: i32) -> $S {
                $number
            }

            #[allow(clippy::panic)] // while compiling
            pub const fn rod(
                [y, z]: [i32; 2],
                radius: i32,
                [from, to]: [i32; 2],
            ) -> AxisCylinder<$S> {
                let (range, at) = (n(from)..n(to), [n(y), n(z)]);
                match AxisCylinder::<$S>::spanning(Axis::X, range, at, n(radius)) {
                    Ok(rod) => rod,
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
