//! What the device knows of parts, and how large they may be: change it to what your board has room for. A kind
//! that isn't named isn't linked.

use scancsg::program::Program;
use scancsg::solid::{Cone, Cuboid, Cylinder, Sphere};
#[cfg(not(board = "microbit"))]
use scancsg::solid::{Polyhedron, Scaled};

#[cfg(not(board = "microbit"))]
mod size {
    pub const PARTS: usize = 32;
    pub const POSES: usize = 16;
    pub const BYTES: usize = 2048;
}
/// For 16 KiB of RAM.
#[cfg(board = "microbit")]
mod size {
    pub const PARTS: usize = 16;
    pub const POSES: usize = 4;
    pub const BYTES: usize = 640;
}

#[cfg(not(board = "microbit"))]
scancsg::leaves! {
    /// The kinds of parts.
    pub enum Leaf<S> {
        Cylinder(Cylinder<S>),
        Cuboid(Cuboid<S>),
        Sphere(Sphere<S>),
        Cone(Cone<S>),
        Polyhedron(Polyhedron<S, 8>),
        ScaledCylinder(Scaled<Cylinder<S>>),
        ScaledSphere(Scaled<Sphere<S>>),
        ScaledCone(Scaled<Cone<S>>),
    }
}
#[cfg(board = "microbit")]
scancsg::leaves! {
    /// The kinds of parts.
    pub enum Leaf<S> {
        Cylinder(Cylinder<S>),
        Cuboid(Cuboid<S>),
        Sphere(Sphere<S>),
        Cone(Cone<S>),
    }
}

/// Room for the bytes of a program.
pub const BYTES: usize = size::BYTES;

/// A part.
pub type Part<S> = Program<Leaf<S>, { size::PARTS }, { size::POSES }>;
