//! Solids that are made of several primitives: capsules, rounded boxes, rings of holes.

mod capsule;
mod ring;
mod rounded;

pub use capsule::Capsule;
pub use rounded::RoundedCuboid;
