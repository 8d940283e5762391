//! Solids: primitives, boolean combinations, and what they answer to lines.
//!
//! A solid is a typed expression. What it does not mention is not linked.
//!
//! ```
//! use scancsg::geom::{Ray, vec3};
//! use scancsg::solid::{Cylinder, RayCast};
//! use scancsg::span::SpanList;
//!
//! let shaft = Cylinder::<f32>::along_x(0.0, 0.0, 1.0, -2.0, 2.0)?;
//! let bore = Cylinder::<f32>::along_x(0.0, 0.0, 0.5, -3.0, 3.0)?;
//! let pipe = shaft - bore;
//!
//! let ray = Ray::new(vec3(0.0, 5.0, 0.0), vec3(0.0, -1.0, 0.0))?;
//! let mut spans = SpanList::<_, 4>::new();
//! let walls = pipe.trace(&ray, &mut spans);
//! assert_eq!(walls.len(), 2);
//! assert_eq!((walls[0].enter.t, walls[0].exit.t), (4.0, 4.5));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | to | use |
//! |---|---|
//! | make a part | [`Cuboid`], [`Cylinder`], [`Cone`], [`Sphere`], [`Torus`], [`Polyhedron`], [`Pipe`] |
//! | cut a part | [`HalfSpace`], [`Slab`], `section` of the module `inspect` |
//! | combine parts | `a \| b`, `a & b`, `a - b`; arrays and [`Many`] for unions of one kind |
//! | colour, move or turn a part | [`Painted`], [`Placed`] |
//! | scale, mirror or shear a part | [`Scaled`] |
//! | go on from where a ray met it | [`Hit::leave`] |
//! | ask where a single ray meets it | [`RayCast`] |
//! | add a solid of your own | implement [`Shape`] and [`Solid`], wrap it in [`ByLine`] |
//! | wrap solids in a type of your own | [`Wrap`] |
//!
//! Constructors come in pairs: a `const` one for each number type, and one that a type parameter can call.
//!
//! | solid | in constants, `T::<f32>::…` | for any number type, `T::<S>::…` |
//! |---|---|---|
//! | [`Cuboid`] | `new`, `spanning` | `between`, `of_size`, `around` |
//! | [`Cylinder`] | `spanning`, `along_x`, `along_y`, `along_z`, `between`, `on`, `ring_along` | `along`, `from_to`, `on_axis`, `ring` |
//! | [`AxisCylinder`] | `spanning` | `along` |
//! | [`Cone`] | `spanning`, `along_x`, `along_y`, `along_z`, `between`, `on` | `along`, `from_to`, `on_axis` |
//! | [`Capsule`] | `new` | `Cylinder::capsule` |
//! | [`RoundedCuboid`] | `new` | `Cuboid::rounded` |
//! | [`Sphere`] | `new` | `around` |
//! | [`Torus`] | `along_x`, `along_y`, `along_z`, `new` | `along`, `around` |
//! | [`Slab`] | `along_x`, `along_y`, `along_z`, `new` | `across`, `facing` |
//! | [`HalfSpace`] | `new` | `facing`, `below`, `above` |
//! | [`Polyhedron`] | `new`, `prism`, `frustum` | `bounded_by`, `extruded`, `with_corners` |

mod combine;
mod compound;
mod operators;
mod pipe;
mod wrap;

pub use crate::primitive::{
    AxisCylinder, Cone, ConeError, Cuboid, CuboidError, Cylinder, CylinderError, CylinderWall,
    HalfSpaceError, Polyhedron, PolyhedronError, Pooled, Slab, SlabError, Sphere, SphereError,
    Torus, TorusError, WallHit,
};
pub use crate::quadric::HalfSpace;
pub use crate::query::{Hit, RayCast, Rgb, Seen, Solid, first_seen};
pub use crate::scan::Scan;
pub use crate::scan::bounds::Bounds;
pub use crate::span::Shape;
pub use combine::{Boolean, Difference, Intersection, Many, ManyError, Union};
pub use compound::{Capsule, RoundedCuboid};
pub(crate) use operators::operators;
pub use pipe::{Pipe, PipeError};
pub use wrap::{ByLine, Painted, Placed, Scaled, Wrap};
