//! Renders cylinders to a small display of two colours, in 128 × 64 dots and without a frame buffer.
//!
//! As firmware it sends the bytes of an SSD1306's bus through the board's serial port. A host prints the dots.

#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../board/mod.rs"]
mod board;
mod screen;

use screen::part::{Crankshaft, Part};

#[cfg(any(number = "f32", all(target_abi = "eabihf", not(number = "i16f16"))))]
type Number = f32;
#[cfg(not(any(number = "f32", all(target_abi = "eabihf", not(number = "i16f16")))))]
type Number = scancsg::scalar::I16F16;

static CRANKSHAFT: Crankshaft<Number> = Number::CRANKSHAFT;

#[cfg(target_os = "none")]
#[board::entry]
fn main() -> ! {
    let is_shown = screen::show(&CRANKSHAFT, board::uart()).is_ok();
    loop {
        board::finish(is_shown);
    }
}

#[cfg(not(target_os = "none"))]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut bus = Vec::new();
    screen::show(&CRANKSHAFT, &mut bus).map_err(|error| format!("{error:?}"))?;
    print!("{}", screen::ssd1306::dots(&bus));
    Ok(())
}
