//! The host's receiver: shows and saves the frames that a device sends through a serial port.
//!
//! A tool for hosts; as firmware it only says so, so that all examples build there too.

#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(not(target_os = "none"))]
mod args;
#[cfg(target_os = "none")]
#[path = "../board/mod.rs"]
mod board;
#[cfg(not(target_os = "none"))]
#[path = "../host/mod.rs"]
mod host;
#[cfg(not(target_os = "none"))]
mod ports;
#[cfg(not(target_os = "none"))]
mod replay;
#[cfg(not(target_os = "none"))]
mod save;
#[cfg(not(target_os = "none"))]
mod serve;
#[cfg(not(target_os = "none"))]
mod tap;
#[cfg(not(target_os = "none"))]
mod view;

#[cfg(not(target_os = "none"))]
fn main() -> std::process::ExitCode {
    view::run()
}

#[cfg(target_os = "none")]
#[board::entry]
fn main() -> ! {
    loop {
        board::say("`view` is for hosts\n");
        board::finish(false);
    }
}
