//! Ray-cast CSG solids on a microcontroller, one scanline at a time.
#![no_std]

pub mod render;
pub mod stream;
