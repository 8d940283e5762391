//! Where in a picture a bounded solid can be seen: silhouettes.
//!
//! What rounding can move is bounded and added. A silhouette may be too large, never too small.

mod ball;
mod frustum;
mod outline;
mod quadratic;
mod strip;

pub(crate) use ball::PerspectiveBall;
pub(crate) use frustum::Strip;
pub(crate) use outline::Around;
pub use outline::{Anywhere, Bounds, Outline, Rectangle, Silhouette};
pub(crate) use quadratic::{constant, extent};
pub(crate) use strip::{Rows, Steps};
