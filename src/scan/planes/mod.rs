//! Planes in pictures: a slab, the caps of a cylinder, the faces of a polyhedron.

mod crossings;
mod kept;
mod orthographic;
mod perspective;
mod pool;

pub use crossings::{Crossed, End};
pub use kept::FaceView;
pub(crate) use orthographic::{EdgeOn, Ends, faces};
pub use orthographic::{OrthographicFace, OrthographicRow, OrthographicView};
pub use perspective::{PerspectiveRow, PerspectiveView};
pub use pool::{FaceRows, PoolRow};
