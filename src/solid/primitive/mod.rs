//! The primitives, one folder each: what it is, its constructors, and how each kind of rays sees it.

mod cylinder;
mod slab;
mod sphere;
mod torus;

pub use cylinder::{Cylinder, CylinderError, CylinderWall, WallHit};
pub use slab::{Slab, SlabError};
pub use sphere::{Sphere, SphereError};
pub use torus::{Torus, TorusError};
