//! What the host's tools share: serial ports, sending parts, receiving frames, showing and saving them.

#![allow(dead_code)] // every tool takes what it needs

pub mod film;
pub mod image;
pub mod meter;
pub mod picture;
pub mod port;
pub mod receive;
pub mod screen;
pub mod send;
pub mod wire;
