//! What solids promise beyond where a line meets them: placement, pictures, mass, and sizes of any kind.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

#[macro_use]
extern crate testkit;

#[path = "../../examples/scene/mod.rs"]
mod scene;

mod absurd_numbers;
mod beside_the_origin;
mod inspect;
mod pipe;
mod placed_far;
mod scaled;
mod section;
