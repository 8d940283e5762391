//! `tee`, the part that every measurement of this crate uses (and beside it [`pipe`] and [`plate`]): a
//! pipe with two flanges, a branch, bores through both, and four bolt holes. Units are arbitrary.

#![allow(dead_code)] // every user takes what it needs

pub mod fit;
pub mod housing;
pub mod pipe;
pub mod plate;
pub mod program;

use scancsg::constant;
use scancsg::geom::{Vec3, vec3};
use scancsg::render::{CameraError, Orthographic, Perspective};
use scancsg::scalar::{I16F16, Scalar};
use scancsg::solid::{Cylinder, Difference, Painted, Rgb};
use scancsg::spline::{Curve, EvaluateError, Knots, Outside};

/// What there is of it, minus what is drilled out.
pub type Tee<S> = Difference<[Cylinder<S>; 4], [Cylinder<S>; 6]>;

/// The same in two colours: the outside and the drilled faces.
pub type PaintedTee<S> = Difference<Painted<[Cylinder<S>; 4]>, Painted<[Cylinder<S>; 6]>>;

/// The time of a whole way around the part.
pub const LAP: f64 = 8.0;

/// What a user who chooses the number type by a type parameter asks for. The modules below have
/// the same by number type.
pub trait Scene: Scalar {
    /// What there is of the part.
    const BODY: [Cylinder<Self>; 4];
    /// The part.
    const TEE: Tee<Self>;
    /// The part in two colours.
    const PAINTED_TEE: PaintedTee<Self>;
    /// Towards the light.
    const TO_LIGHT: Vec3<Self>;

    /// The camera without perspective.
    fn orthographic() -> Result<Orthographic<Self>, CameraError>;

    /// The camera with perspective.
    fn perspective() -> Result<Perspective<Self>, CameraError>;

    /// Where the camera is on its way around the part, at a time from 0 to [`LAP`].
    fn eye(time: Self) -> Result<Vec3<Self>, EvaluateError>;

    /// The camera without perspective, from somewhere else.
    fn orthographic_from(eye: Vec3<Self>) -> Result<Orthographic<Self>, CameraError>;

    /// The camera with perspective, from somewhere else.
    fn perspective_from(eye: Vec3<Self>) -> Result<Perspective<Self>, CameraError>;

    /// The number nearest to this many hundredths.
    fn hundredths(count: i32) -> Self;
}

macro_rules! tee {
    ($module:ident, $scalar:ty, $from_ratio:path) => {
        /// The part with numbers of this type; it costs flash and no RAM.
        pub mod $module {
            use super::*;

            /// The number type.
            pub type Scalar = $scalar;

            pub(super) const BODY: [Cylinder<Scalar>; 4] = [
                constant!(Cylinder::<Scalar>::along_x(n(0), n(0), n(100), n(-200), n(200))),
                constant!(Cylinder::<Scalar>::along_x(n(0), n(0), n(160), n(-200), n(-170))),
                constant!(Cylinder::<Scalar>::along_x(n(0), n(0), n(160), n(170), n(200))),
                constant!(Cylinder::<Scalar>::along_y(n(0), n(0), n(80), n(0), n(200))),
            ];
            const BORES: [Cylinder<Scalar>; 6] = [
                constant!(Cylinder::<Scalar>::along_x(n(0), n(0), n(70), n(-300), n(300))),
                constant!(Cylinder::<Scalar>::along_y(n(0), n(0), n(50), n(0), n(300))),
                constant!(Cylinder::<Scalar>::along_x(n(130), n(0), n(15), n(-300), n(300))),
                constant!(Cylinder::<Scalar>::along_x(n(-130), n(0), n(15), n(-300), n(300))),
                constant!(Cylinder::<Scalar>::along_x(n(0), n(130), n(15), n(-300), n(300))),
                constant!(Cylinder::<Scalar>::along_x(n(0), n(-130), n(15), n(-300), n(300))),
            ];

            /// The number nearest to this many hundredths.
            pub(super) const fn n(hundredths: i32) -> Scalar {
                $from_ratio(hundredths, 100)
            }

            /// The number nearest to this many hundred millionths.
            const fn fine(parts: i32) -> Scalar {
                $from_ratio(parts, 100_000_000)
            }

            /// The part.
            pub const TEE: Tee<Scalar> = Tee::new(BODY, BORES);

            /// The part, steel outside and brass where it was drilled.
            pub const PAINTED_TEE: PaintedTee<Scalar> =
                PaintedTee::new(Painted::new(BODY, STEEL), Painted::new(BORES, BRASS));

            /// The camera of every measurement: 4.4 units of frame height, from the upper right.
            pub fn orthographic() -> Result<Orthographic<Scalar>, CameraError> {
                Orthographic::look_along(VIEW, Vec3::ZERO, UP, FRAME_HEIGHT)
            }

            /// The same direction from a distance of 10 units, with 5 units of frame height at the
            /// part's middle.
            pub fn perspective() -> Result<Perspective<Scalar>, CameraError> {
                Perspective::look_at(VIEW * n(-1000), Vec3::ZERO, UP, FIELD_OF_VIEW)
            }

            const VIEW: Vec3<Scalar> = vec3(fine(-51_961_524), n(-50), fine(-69_282_032));
            pub(super) const FRAME_HEIGHT: Scalar = n(440);
            // 2·atan(2.5/10).
            pub(super) const FIELD_OF_VIEW: Scalar = fine(48_995_730);

            /// A way around the part, and over it: a closed curve, a cubic B-spline.
            pub(super) const ORBIT: Curve<Vec3<Scalar>, 4, 11, 15> =
                constant!(Curve::<Vec3<Scalar>, 4, 11, 15>::closed(LAPS, &ORBIT_POINTS));
            const LAPS: Knots<Scalar, 4, 15> = constant!(Knots::<Scalar, 4, 15>::periodic(&[
                n(0),
                n(100),
                n(200),
                n(300),
                n(400),
                n(500),
                n(600),
                n(700),
                n(800),
            ]));
            const ORBIT_POINTS: [Vec3<Scalar>; 8] = [
                vec3(n(660), n(640), n(880)),
                vec3(n(-160), n(900), n(1090)),
                vec3(n(-880), n(500), n(660)),
                vec3(n(-1090), n(100), n(-160)),
                vec3(n(-660), n(-300), n(-880)),
                vec3(n(160), n(0), n(-1090)),
                vec3(n(880), n(200), n(-660)),
                vec3(n(1090), n(400), n(160)),
            ];

            pub(super) const UP: Vec3<Scalar> = vec3(n(0), n(100), n(0));

            /// Towards the light: from above, in front of the branch.
            pub const TO_LIGHT: Vec3<Scalar> = vec3(n(25), n(85), n(45));
        }

        impl Scene for $scalar {
            const BODY: [Cylinder<Self>; 4] = $module::BODY;
            const TEE: Tee<Self> = $module::TEE;
            const PAINTED_TEE: PaintedTee<Self> = $module::PAINTED_TEE;
            const TO_LIGHT: Vec3<Self> = $module::TO_LIGHT;

            fn orthographic() -> Result<Orthographic<Self>, CameraError> {
                $module::orthographic()
            }

            fn perspective() -> Result<Perspective<Self>, CameraError> {
                $module::perspective()
            }

            fn eye(time: Self) -> Result<Vec3<Self>, EvaluateError> {
                $module::ORBIT.value(time, Outside::Wrap)
            }

            fn orthographic_from(eye: Vec3<Self>) -> Result<Orthographic<Self>, CameraError> {
                Orthographic::look_at(eye, Vec3::ZERO, $module::UP, $module::FRAME_HEIGHT)
            }

            fn perspective_from(eye: Vec3<Self>) -> Result<Perspective<Self>, CameraError> {
                Perspective::look_at(eye, Vec3::ZERO, $module::UP, $module::FIELD_OF_VIEW)
            }

            fn hundredths(count: i32) -> Self {
                $from_ratio(count, 100)
            }
        }
    };
}

const STEEL: Rgb = Rgb::new(150, 175, 200);
const BRASS: Rgb = Rgb::new(235, 175, 70);

const fn single(numerator: i32, denominator: i32) -> f32 {
    double(numerator, denominator) as f32
}

const fn double(numerator: i32, denominator: i32) -> f64 {
    numerator as f64 / denominator as f64
}

const fn fixed_point(numerator: i32, denominator: i32) -> I16F16 {
    let (numerator, denominator) = ((numerator as i64) << 17, denominator as i64);
    I16F16::from_bits((numerator + denominator).div_euclid(2 * denominator) as i32)
}

tee!(f32, f32, single);
tee!(f64, f64, double);
tee!(i16f16, I16F16, fixed_point);
