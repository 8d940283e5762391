//! What scenes are made of, and the programs that they are.

use crate::capacity::{PARTS, POSES};
use crate::number::Scalar;
use scancsg::program;

macro_rules! part {
    ($($more:tt)*) => {
        scancsg::leaves! {
            /// What scenes are made of.
            pub(crate) enum Part<S> {
                Cylinder(scancsg::solid::Cylinder<S>),
                Cuboid(scancsg::solid::Cuboid<S>),
                Sphere(scancsg::solid::Sphere<S>),
                Cone(scancsg::solid::Cone<S>),
                HalfSpace(scancsg::solid::HalfSpace<S>),
                $($more)*
            }
        }
    };
}
#[cfg(not(feature = "torus"))]
part!();
#[cfg(feature = "torus")]
part!(Torus(scancsg::solid::Torus<S>));

pub(crate) type Program = program::Program<Part<Scalar>, PARTS, POSES>;
