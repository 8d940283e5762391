//! The crate's main job from end to end: a part is rendered one scanline at a time, each scanline
//! goes through a serial line as a packet, and the other end puts the picture together.
//!
//! The library's `serve` renders, sends and repairs, on a microcontroller as on a host. For bare metal,
//! `firmware.rs` is around it; on a host, `loopback.rs` gives it a pseudo-terminal to send into and
//! plays the other end as well.

#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(not(target_os = "none"))]
mod args;
#[cfg(target_os = "none")]
#[path = "../board/mod.rs"]
mod board;
#[cfg(not(target_os = "none"))]
mod coding;
#[cfg(not(target_os = "none"))]
mod file;
#[cfg(target_os = "none")]
mod firmware;
#[cfg(not(target_os = "none"))]
mod frames;
#[cfg(not(target_os = "none"))]
mod gallery;
#[cfg(not(target_os = "none"))]
#[path = "../host/mod.rs"]
mod host;
#[cfg(not(target_os = "none"))]
mod line;
#[cfg(not(target_os = "none"))]
mod loopback;
#[path = "../scene/mod.rs"]
mod scene;
#[cfg(not(target_os = "none"))]
mod setting;
#[cfg(not(target_os = "none"))]
mod shading;

#[cfg(not(target_os = "none"))]
fn main() -> std::process::ExitCode {
    loopback::run()
}
