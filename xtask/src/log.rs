//! The `defmt` log of a firmware.

use crate::board::{Board, Number};
use crate::boot;
use crate::toolchain;

/// The feature that a firmware logs with.
pub const FEATURE: &str = "defmt";

/// With its log the firmware must send the same picture, and say what it does.
pub fn check(board: Board, number: Number) -> Result<(), String> {
    let elf = toolchain::find(board.target())?.build(board, number, "stream", &[FEATURE])?;
    let outcome = boot::stream(board, number, &elf)?;
    let mut problems = outcome.problems;
    let stack = outcome.stack.unwrap_or_default();
    let expected = [
        (" 160x120 pixels in ", number.name()),
        (": 120 rows, ", " repairs"),
        (&format!(" stack: {stack} of "), " bytes"),
    ];
    for (start, end) in expected {
        let is_it = |line: &str| {
            let line = line.to_ascii_lowercase();
            line.starts_with("info") && line.contains(start) && line.ends_with(end)
        };
        if !outcome.said.lines().any(is_it) {
            problems.push(format!("the log has no line of \"{start}…{end}\""));
        }
    }
    if problems.is_empty() {
        println!("{board}, {number}: the picture is the host's, and the log is\n{}", outcome.said);
        Ok(())
    } else {
        Err(format!("{board}, {number}: {}\n{}", problems.join("\n       "), outcome.said))
    }
}
