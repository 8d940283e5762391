//! Firmware that sends bytes and ends: they are the host's, and it is small.

use crate::board::{Board, Number};
use crate::boot::Machine;
use crate::oled::part::Part;
use crate::toolchain::{Level, Toolchain};
use crate::{elf, lidar, oled};
use scancsg::scalar::I16F16;
use std::io::Read;
use std::time::Duration;

/// An example, and how it is built.
struct Firmware {
    example: &'static str,
    level: Level,
    /// The flash that it may take on the smallest board, in fixed point.
    most_flash: u64,
    /// What it sends.
    on_host: fn(Number) -> Option<Vec<u8>>,
}

const ALL: [Firmware; 2] = [
    Firmware {
        example: "lidar",
        level: Level::Three,
        most_flash: 32 * 1024,
        on_host: |number| {
            let mut bytes = Vec::new();
            let sent = match number {
                Number::F32 => lidar::sent::<f32>(&mut bytes),
                Number::I16f16 => lidar::sent::<I16F16>(&mut bytes),
            };
            sent.is_ok().then_some(bytes)
        },
    },
    Firmware {
        example: "oled",
        level: Level::S,
        most_flash: 20 * 1024,
        on_host: |number| {
            let mut bytes = Vec::new();
            let shown = match number {
                Number::F32 => oled::show::<f32, _>(&f32::CRANKSHAFT, &mut bytes),
                Number::I16f16 => oled::show::<I16F16, _>(&I16F16::CRANKSHAFT, &mut bytes),
            };
            shown.is_ok().then_some(bytes)
        },
    },
];

/// The flash of each, by the words of a table's row.
pub type Flash = Vec<(String, u64)>;

/// Builds and boots all on a board, in the number type that suits it; the flash that they take, and what
/// is wrong with them.
pub fn check(
    toolchain: &Toolchain,
    board: Board,
    number: Number,
) -> Result<(Flash, Vec<String>), String> {
    let (mut flash, mut problems) = (Vec::new(), Vec::new());
    if number != board.number() {
        return Ok((flash, problems));
    }
    for Firmware { example, level, most_flash, on_host } in ALL {
        let elf = toolchain.build_at(level, board, number, example, &[])?;
        let contents = elf::Contents::read(&elf)?;
        let mut problem = |text: String| problems.push(format!("{example}: {text}"));
        contents.problems(number).for_each(&mut problem);
        if board == Board::Microbit && contents.flash > most_flash {
            problem(format!("it takes {} bytes of flash, of {most_flash}", contents.flash));
        }
        let (machine, mut line) = Machine::start(board, &elf)?;
        let text = |error: std::io::Error| format!("{board}, {example}: {error}");
        line.set_read_timeout(Some(Duration::from_secs(60))).map_err(text)?;
        let mut bytes = Vec::new();
        line.read_to_end(&mut bytes).map_err(text)?;
        let (said, is_good) = machine.finish(Duration::from_secs(60));
        if !is_good {
            problem(format!("the firmware was not content: {}", said.trim()));
        }
        if on_host(number).as_ref() != Some(&bytes) {
            problem("what it sends differs from the host's".into());
        }
        flash.push((
            format!("flash of `{example}` at `opt-level = {level}`, bytes"),
            contents.flash,
        ));
    }
    Ok((flash, problems))
}
