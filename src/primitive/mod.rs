//! The primitives, one folder each: what it is, its constructors, and how each kind of rays sees it.

mod cone;
mod cuboid;
mod cylinder;
mod half_space;
mod polyhedron;
mod slab;
mod sphere;
mod torus;

pub use cone::{Cone, ConeError};
pub use cuboid::{Cuboid, CuboidError};
pub use cylinder::{AxisCylinder, Cylinder, CylinderError, CylinderWall, WallHit};
pub use half_space::HalfSpaceError;
pub use polyhedron::{Polyhedron, PolyhedronError, Pooled};
pub use slab::{Slab, SlabError};
pub use sphere::{Sphere, SphereError};
pub use torus::{Torus, TorusError};
