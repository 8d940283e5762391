//! Solids made of solids: boolean operations, and unions of many of one kind.

mod boolean;
mod group;
mod many;

pub use boolean::{Boolean, Difference, Intersection, Union};
pub use many::{Many, ManyError};
