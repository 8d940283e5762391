//! Parts of `scancsg-scad --firmware` on a board: what they take there.

use crate::board::{Board, Number};
use crate::{boot, elf, toolchain};
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub struct Parts {
    /// What `scancsg-scad part.csg --firmware FILE.rs` wrote
    #[arg(required = true, value_name = "FILE.rs")]
    parts: Vec<PathBuf>,

    /// The board
    #[arg(long, default_value = "an386")]
    board: Board,

    /// The number type, as in the files
    #[arg(long, default_value = "f32")]
    number: Number,
}

/// Prints a line for each part: its name, flash, RAM (variables and stack), instructions until the first row, and
/// instructions of all rows, in a picture of 160 × 120.
pub fn measure(chosen: &Parts) -> Result<(), String> {
    let &Parts { ref parts, board, number } = chosen;
    let toolchain = toolchain::find(board.target())?;
    println!("# {}, {board}, {number}: part, flash, RAM, view, rows", toolchain.version);
    for path in parts {
        let wrong = |text: &str| format!("{}: {text}", path.display());
        let part = path.canonicalize().map_err(|error| wrong(&error.to_string()))?;
        let environment = [("SCANCSG_PART", part.as_path())];
        let elf = toolchain.build_with(board, number, "part", &[], &environment)?;
        let contents = elf::Contents::read(&elf)?;
        let said = boot::listen(board, &elf).map_err(|error| wrong(&error))?;
        let count = |name: &str| {
            let line = said.lines().find_map(|line| line.strip_prefix(name));
            line.and_then(|count| count.trim().parse::<u64>().ok())
                .ok_or_else(|| wrong(&format!("no {name} in: {said}")))
        };
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let ram = contents.ram + count("stack")?;
        println!("{name} {} {ram} {} {}", contents.flash, count("view")?, count("rows")?);
    }
    Ok(())
}
