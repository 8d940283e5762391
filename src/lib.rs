//! Ray-cast CSG solids on a microcontroller, one scanline at a time.
#![no_std]

#[cfg(test)]
extern crate std;

mod error;
pub mod geom;
pub mod render;
pub mod scalar;
pub mod solid;
pub mod span;
pub mod stream;

pub(crate) use error::error_text;
