//! `scancsg-scad`: OpenSCAD's parts as pictures and in numbers.

mod cli;
mod console;
#[path = "../../examples/host/mod.rs"]
mod host;
#[cfg(test)]
#[path = "../../examples/stream/line.rs"]
#[allow(dead_code)] // tests take what they need
mod line;
mod port;
mod report;

use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    match cli::run(&cli::Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err((code, error)) => {
            eprintln!("scancsg-scad: {error}");
            ExitCode::from(code)
        }
    }
}
