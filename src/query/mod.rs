//! What a solid says of itself, and what single rays ask it: all spans, or the first hit.

mod describe;
mod hit;
mod ray_cast;
mod rebased;

pub use describe::{Rgb, Solid};
pub(crate) use hit::seen_at;
pub use hit::{Hit, Seen, first_seen};
pub use ray_cast::RayCast;
