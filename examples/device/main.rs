//! A device that draws what it is sent: it waits for a part, as a program in bytes, renders it, sends the picture,
//! and waits for the next one. `view --send` is the other end.
//!
//! Firmware; on a host it only says so, so that all examples build there too.

#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../board/mod.rs"]
mod board;
#[cfg(target_os = "none")]
mod firmware;
#[cfg(target_os = "none")]
mod part;
#[cfg(target_os = "none")]
#[path = "../scene/mod.rs"]
mod scene;

#[cfg(not(target_os = "none"))]
fn main() {
    println!(
        "`device` is for boards: build it for one of their targets, and send parts by `view --send`"
    );
}
