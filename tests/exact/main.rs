//! Where lines meet solids, against exact arithmetic, in every number type.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]
#![allow(clippy::result_large_err)] // Err is no error here

mod cone;
mod cylinder;
mod cylinder_reference;
mod fixed;
mod planes;
mod scaled;
mod torus;
