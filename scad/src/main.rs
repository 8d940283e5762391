//! `scancsg-scad`: OpenSCAD's parts as pictures and in numbers.

mod cli;
mod console;
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
