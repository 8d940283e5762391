//! `tee`, the part that every measurement of this crate uses: a pipe with two flanges, a branch,
//! bores through both, and four bolt holes. Units are arbitrary.

#![allow(dead_code)] // every user takes what it needs

use scancsg::constant;
use scancsg::geom::{Vec3, vec3};
use scancsg::render::{CameraError, Orthographic, Perspective};
use scancsg::solid::{Cylinder, Difference, Painted, Rgb};

/// What there is of it, minus what is drilled out.
pub type Tee<S> = Difference<[Cylinder<S>; 4], [Cylinder<S>; 6]>;

/// The same in two colours: the outside and the drilled faces.
pub type PaintedTee<S> = Difference<Painted<[Cylinder<S>; 4]>, Painted<[Cylinder<S>; 6]>>;

macro_rules! tee {
    ($scalar:ident) => {
        /// The part with numbers of this type; it costs flash and no RAM.
        pub mod $scalar {
            use super::*;

            const BODY: [Cylinder<$scalar>; 4] = [
                constant!(Cylinder::<$scalar>::along_x(0.0, 0.0, 1.0, -2.0, 2.0)),
                constant!(Cylinder::<$scalar>::along_x(0.0, 0.0, 1.6, -2.0, -1.7)),
                constant!(Cylinder::<$scalar>::along_x(0.0, 0.0, 1.6, 1.7, 2.0)),
                constant!(Cylinder::<$scalar>::along_y(0.0, 0.0, 0.8, 0.0, 2.0)),
            ];
            const BORES: [Cylinder<$scalar>; 6] = [
                constant!(Cylinder::<$scalar>::along_x(0.0, 0.0, 0.7, -3.0, 3.0)),
                constant!(Cylinder::<$scalar>::along_y(0.0, 0.0, 0.5, 0.0, 3.0)),
                constant!(Cylinder::<$scalar>::along_x(1.3, 0.0, 0.15, -3.0, 3.0)),
                constant!(Cylinder::<$scalar>::along_x(-1.3, 0.0, 0.15, -3.0, 3.0)),
                constant!(Cylinder::<$scalar>::along_x(0.0, 1.3, 0.15, -3.0, 3.0)),
                constant!(Cylinder::<$scalar>::along_x(0.0, -1.3, 0.15, -3.0, 3.0)),
            ];

            /// The part.
            pub const TEE: Tee<$scalar> = Tee::new(BODY, BORES);

            /// The part, steel outside and brass where it was drilled.
            pub const PAINTED_TEE: PaintedTee<$scalar> =
                PaintedTee::new(Painted::new(BODY, STEEL), Painted::new(BORES, BRASS));

            /// The camera of every measurement: 4.4 units of frame height, from the upper right.
            pub fn orthographic() -> Result<Orthographic<$scalar>, CameraError> {
                Orthographic::look_along(VIEW, Vec3::ZERO, UP, 4.4)
            }

            /// The same direction from a distance of 10 units, with 5 units of frame height at the
            /// part's middle.
            pub fn perspective() -> Result<Perspective<$scalar>, CameraError> {
                // 2·atan(2.5/10).
                Perspective::look_at(VIEW * -10.0, Vec3::ZERO, UP, 0.489_957_3)
            }

            const VIEW: Vec3<$scalar> = vec3(-0.6 * 0.866_025_4, -0.5, -0.8 * 0.866_025_4);
            const UP: Vec3<$scalar> = vec3(0.0, 1.0, 0.0);

            /// Towards the light: from above, in front of the branch.
            pub const TO_LIGHT: Vec3<$scalar> = vec3(0.25, 0.85, 0.45);
        }
    };
}

const STEEL: Rgb = Rgb::new(150, 175, 200);
const BRASS: Rgb = Rgb::new(235, 175, 70);

tee!(f32);
tee!(f64);
