//! Firmware on all boards: its picture, what it takes, and what it counts.

use crate::board::{Board, Number};
use crate::{boot, counts, elf, host, report, sent, toolchain};
use std::path::PathBuf;

#[derive(Debug, Default, clap::Args)]
pub struct Boards {
    /// Only this board; may be given several times
    #[arg(long)]
    board: Vec<Board>,

    /// Only this number type
    #[arg(long)]
    number: Option<Number>,

    /// Save the picture of the last board as a PNG file
    #[arg(long, value_name = "FILE.png")]
    png: Option<PathBuf>,

    /// Write the expected instruction counts, and docs/measured/boards.md, anew
    #[arg(long)]
    overwrite: bool,
}

/// The flash that rendering may take on the smallest board, in fixed point.
const MOST_FLASH: u64 = 24 * 1024;

/// The RAM that rendering and sending may take: variables and stack. 1 KiB of it is what rows are predicted
/// with.
const MOST_RAM: u64 = 4096 + 1024;

/// Builds, boots and measures, and compares with what is expected.
pub fn measure(chosen: &Boards) -> Result<(), String> {
    let boards: Vec<Board> =
        if chosen.board.is_empty() { Board::ALL.to_vec() } else { chosen.board.clone() };
    let mut rows = Vec::new();
    let mut problems = Vec::new();
    for board in boards {
        let toolchain = toolchain::find(board.target())?;
        for number in Number::ALL {
            if chosen.number.is_some_and(|only| only != number) {
                continue;
            }
            eprintln!("{board}, {number}: building with {}", toolchain.version);
            let elf = toolchain.build(board, number, "stream", &[])?;
            let contents = elf::Contents::read(&elf)?;
            problems
                .extend(contents.problems(number).map(|text| format!("{board}, {number}: {text}")));
            let outcome = boot::stream(board, number, &elf)?;
            problems
                .extend(outcome.problems.iter().map(|text| format!("{board}, {number}: {text}")));
            let ram = outcome.stack.map(|stack| contents.ram + u64::from(stack));
            if ram.is_none_or(|ram| ram > MOST_RAM) {
                let text = ram.map_or("an unknown number of".to_owned(), |ram| ram.to_string());
                problems.push(format!(
                    "{board}, {number}: it takes {text} bytes of RAM, of {MOST_RAM} that it may"
                ));
            }
            if let Some(path) = &chosen.png {
                host::film::Film::new(path).push(&outcome.frame)?;
            }
            let least = toolchain.build(board, number, "render_only", &[])?;
            let least = elf::Contents::read(&least)?;
            problems.extend(
                least
                    .problems(number)
                    .map(|text| format!("{board}, {number}, render_only: {text}")),
            );
            let render_flash = least.flash;
            if board == Board::Microbit && number == Number::I16f16 && render_flash > MOST_FLASH {
                let text = format!("rendering takes {render_flash} bytes of flash");
                problems.push(format!("{board}, {number}: {text}, of {MOST_FLASH} that it may"));
            }
            let (sent, wrong) = sent::check(&toolchain, board, number)?;
            problems.extend(wrong.iter().map(|text| format!("{board}, {number}, {text}")));
            let counts = counts::measure(&toolchain, board, number)?;
            problems.extend(counts.problem().map(|text| format!("{board}, {number}: {text}")));
            let changes = counts.compare(chosen.overwrite)?;
            changes.iter().for_each(|change| eprintln!("  {}", change.text));
            problems.extend(
                changes
                    .into_iter()
                    .filter(|change| change.is_worse)
                    .map(|change| format!("{board}, {number}: {}", change.text)),
            );
            rows.push(report::Row { board, number, contents, render_flash, sent, outcome, counts });
        }
    }
    let table = report::table(&rows);
    println!("{table}");
    let is_complete = chosen.board.is_empty() && chosen.number.is_none();
    if is_complete && chosen.overwrite {
        report::write(&rows)?;
    }
    if problems.is_empty() { Ok(()) } else { Err(problems.join("\n       ")) }
}
