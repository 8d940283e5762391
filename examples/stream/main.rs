//! The crate's main job from end to end: a part is rendered one scanline at a time, each scanline
//! goes through a serial line as a packet, and the other end puts the picture together.
//!
//! `device.rs` is the part that firmware runs too; everything else here is the host around it.

#[cfg(target_os = "none")]
compile_error!(
    "the example `stream` runs on hosts only so far; `device.rs` is what firmware needs"
);

#[cfg(not(target_os = "none"))]
mod args;
mod device;
#[cfg(not(target_os = "none"))]
#[path = "../host/mod.rs"]
mod host;
#[cfg(not(target_os = "none"))]
mod loopback;
#[path = "../scene/mod.rs"]
mod scene;

#[cfg(not(target_os = "none"))]
fn main() -> std::process::ExitCode {
    loopback::run()
}
