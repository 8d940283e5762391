//! `housing`: a bearing housing of a box, ten cylinders and four spheres; and beside it a box and a cylinder
//! of the same height and width, for what each of them costs alone.

use super::Scene;
use scancsg::constant;
use scancsg::geom::vec3;
use scancsg::scalar::I16F16;
use scancsg::solid::{Cuboid, Cylinder, Difference, Sphere, Union};

/// Base and ring, minus bores, bolt holes and their sinks.
pub type Housing<S> =
    Difference<Union<Cuboid<S>, [Cylinder<S>; 3]>, Union<[Cylinder<S>; 7], [Sphere<S>; 4]>>;

/// The housing in a number type.
pub trait HousingScene: Scene {
    /// The housing.
    const HOUSING: Housing<Self>;
    /// A box alone.
    const BOX: Cuboid<Self>;
    /// A cylinder alone.
    const ROD: Cylinder<Self>;
}

macro_rules! housing {
    ($module:ident, $Scalar:ty) => {
        mod $module {
            use super::super::$module::n;
            use super::*;

            const BASE: Cuboid<$Scalar> = constant!(Cuboid::<$Scalar>::new(
                vec3(n(-210), n(-150), n(-80)),
                vec3(n(210), n(-110), n(80))
            ));
            const RING: [Cylinder<$Scalar>; 3] = [
                constant!(Cylinder::<$Scalar>::along_z(n(0), n(10), n(130), n(-70), n(70))),
                constant!(Cylinder::<$Scalar>::along_z(n(0), n(10), n(145), n(-15), n(15))),
                constant!(Cylinder::<$Scalar>::along_y(n(0), n(0), n(35), n(100), n(175))),
            ];
            const BORES: [Cylinder<$Scalar>; 7] = [
                constant!(Cylinder::<$Scalar>::along_z(n(0), n(10), n(75), n(-100), n(100))),
                constant!(Cylinder::<$Scalar>::along_z(n(0), n(10), n(95), n(-45), n(100))),
                constant!(Cylinder::<$Scalar>::along_y(n(0), n(0), n(12), n(50), n(200))),
                bolt(165, 45),
                bolt(165, -45),
                bolt(-165, 45),
                bolt(-165, -45),
            ];
            const SINKS: [Sphere<$Scalar>; 4] =
                [sink(165, 45), sink(165, -45), sink(-165, 45), sink(-165, -45)];

            #[allow(clippy::panic)] // while compiling
            const fn bolt(x: i32, z: i32) -> Cylinder<$Scalar> {
                match Cylinder::<$Scalar>::along_y(n(x), n(z), n(15), n(-200), n(-50)) {
                    Ok(hole) => hole,
                    Err(error) => panic!("{}", error.as_str()),
                }
            }

            #[allow(clippy::panic)] // while compiling
            const fn sink(x: i32, z: i32) -> Sphere<$Scalar> {
                match Sphere::<$Scalar>::new(vec3(n(x), n(-102), n(z)), n(28)) {
                    Ok(sink) => sink,
                    Err(error) => panic!("{}", error.as_str()),
                }
            }

            pub(super) const HOUSING: Housing<$Scalar> =
                Housing::<$Scalar>::new(Union::new(BASE, RING), Union::new(BORES, SINKS));
            pub(super) const BOX: Cuboid<$Scalar> = constant!(Cuboid::<$Scalar>::new(
                vec3(n(-120), n(-120), n(-120)),
                vec3(n(120), n(120), n(120))
            ));
            pub(super) const ROD: Cylinder<$Scalar> =
                constant!(Cylinder::<$Scalar>::along_y(n(0), n(0), n(150), n(-130), n(130)));
        }

        impl HousingScene for $Scalar {
            const HOUSING: Housing<Self> = $module::HOUSING;
            const BOX: Cuboid<Self> = $module::BOX;
            const ROD: Cylinder<Self> = $module::ROD;
        }
    };
}

housing!(f32, f32);
housing!(f64, f64);
housing!(i16f16, I16F16);
