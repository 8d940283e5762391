//! The tools and the examples as a user runs them, in one program: most tests wait, and wait together.

#![allow(clippy::unwrap_used, clippy::panic)]

mod common;
mod examples;
mod gallery;
mod lidar;
mod oled;
#[cfg(unix)]
#[path = "../../scene/mod.rs"]
mod scene;
mod send;
mod view;
