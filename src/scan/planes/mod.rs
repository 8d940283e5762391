//! Planes in pictures: a slab, the caps of a cylinder, the faces of a polyhedron.

mod crossings;
mod orthographic;
mod perspective;

pub use crossings::Crossings;
pub(crate) use orthographic::{EdgeOn, Ends, faces};
pub use orthographic::{OrthographicFace, OrthographicRow, OrthographicView};
pub use perspective::{PerspectiveRow, PerspectiveView};
