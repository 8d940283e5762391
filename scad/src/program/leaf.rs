//! The solids that a program is made of.

use super::kind::Kind;
use scancsg::scalar::Scalar;
use scancsg::solid::{Cone, Cuboid, Cylinder, Polyhedron, Scaled, Sphere, Torus};

/// The most faces that a polyhedron of a program may have. One with more is an intersection of several.
pub const FACES: usize = 12;

scancsg::leaves! {
    /// All that the parts of a program may be, for whoever reads one on a host. Firmware names what it needs.
    pub enum Leaf<S> {
        Cylinder(Cylinder<S>),
        Cuboid(Cuboid<S>),
        Sphere(Sphere<S>),
        Cone(Cone<S>),
        Torus(Torus<S>),
        Polyhedron(Polyhedron<S, FACES>),
        ScaledCylinder(Scaled<Cylinder<S>>),
        ScaledSphere(Scaled<Sphere<S>>),
        ScaledCone(Scaled<Cone<S>>),
        ScaledTorus(Scaled<Torus<S>>),
    }
}

impl<S: Scalar> Leaf<S> {
    /// What it is.
    pub(super) fn kind_of(&self) -> Kind {
        match self {
            Self::Cylinder(_) => Kind::Cylinder,
            Self::Cuboid(_) => Kind::Cuboid,
            Self::Sphere(_) => Kind::Sphere,
            Self::Cone(_) => Kind::Cone,
            Self::Torus(_) => Kind::Torus,
            Self::Polyhedron(_) => Kind::Polyhedron,
            Self::ScaledCylinder(_) => Kind::ScaledCylinder,
            Self::ScaledSphere(_) => Kind::ScaledSphere,
            Self::ScaledCone(_) => Kind::ScaledCone,
            Self::ScaledTorus(_) => Kind::ScaledTorus,
        }
    }
}
