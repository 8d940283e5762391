//! Single rays: all spans, or the first hit.

mod hit;
mod ray_cast;
mod rebased;

pub(crate) use hit::seen_at;
pub use hit::{Hit, Seen, first_seen};
pub use ray_cast::RayCast;
