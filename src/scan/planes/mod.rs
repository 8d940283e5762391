//! Two parallel planes in pictures: a slab, or the caps of a cylinder.

mod orthographic;
mod perspective;

pub(crate) use orthographic::{EdgeOn, Ends, faces};
pub use orthographic::{OrthographicRow, OrthographicView};
pub use perspective::{PerspectiveRow, PerspectiveView};
