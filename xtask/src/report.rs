//! The table of the boards.

use crate::board::{Board, Number};
use crate::boot::Outcome;
use crate::counts::Counts;
use crate::elf::Contents;
use crate::paths::root;
use std::fmt::Write as _;
use std::fs;

pub struct Row {
    pub board: Board,
    pub number: Number,
    pub contents: Contents,
    /// Flash of a firmware that renders and does nothing else.
    pub render_flash: u64,
    pub outcome: Outcome,
    pub counts: Counts,
}

impl Row {
    fn columns(&self) -> [String; 8] {
        let Self { board, number, contents, outcome, counts, .. } = self;
        let stack = outcome.stack.map_or("?".to_owned(), |stack| stack.to_string());
        let per_pixel = counts
            .of("orthographic: frame, a pixel")
            .map_or("?".to_owned(), |count| count.to_string());
        [
            board.to_string(),
            board.core().to_owned(),
            number.to_string(),
            contents.flash.to_string(),
            format!("{} + {stack}", contents.ram),
            per_pixel,
            outcome.traffic.bytes.to_string(),
            if outcome.is_same_as_host { "yes" } else { "NO" }.to_owned(),
        ]
    }
}

/// So short that a terminal of 80 columns holds them.
const HEADINGS: [&str; 8] =
    ["board", "core", "number", "flash", "RAM", "instr/px", "bytes", "same"];

/// The table, aligned for a terminal and for Markdown alike.
pub fn table(rows: &[Row]) -> String {
    let cells: Vec<[String; 8]> = rows.iter().map(Row::columns).collect();
    let widths: Vec<usize> = HEADINGS
        .iter()
        .enumerate()
        .map(|(i, heading)| {
            cells
                .iter()
                .filter_map(|row| row.get(i))
                .map(String::len)
                .fold(heading.len(), usize::max)
        })
        .collect();
    let line = |cells: &[String]| {
        let padded: Vec<String> =
            cells.iter().zip(&widths).map(|(cell, width)| format!("{cell:width$}")).collect();
        format!("| {} |\n", padded.join(" | "))
    };
    let mut text = line(&HEADINGS.map(str::to_owned));
    let rule: Vec<String> = widths.iter().map(|width| "-".repeat(*width)).collect();
    let _ = writeln!(text, "|-{}-|", rule.join("-|-"));
    cells.iter().for_each(|row| text.push_str(&line(row)));
    text
}

/// `docs/boards.md`: the table, and the counts of all parts.
pub fn write(rows: &[Row]) -> Result<(), String> {
    let version = rows.first().map_or(String::new(), |row| row.counts.version().to_owned());
    let mut text = format!(
        "# Boards\n\n\
         Made by `cargo xtask boards --overwrite`: the example `stream` as firmware, booted in QEMU, \
         its picture (`tee`, 160x120, Gray8, orthographic) received through the emulated serial \
         port and compared with the host's, row by row. Sizes in bytes; instructions are counted by \
         the emulator and are those of {version}, `opt-level = 3`, fat LTO. Flash is the whole \
         firmware: start-up, driver, scene, renderer, packets, repair. RAM is variables and the \
         stack at its deepest, instr/px the instructions of a whole frame by its pixels, bytes what \
         a frame takes on the line, and same whether every row is the host's.\n\n{}\n",
        table(rows)
    );
    text.push_str(
        "## Instructions of the parts\n\n\
         Of a ready ray (the mean of 100 ordinary rays) and of splines a call, its arguments, its \
         return and its result are counted, and not the loop around it; of the other parts the loop, \
         too. A naive row asks every primitive about the line of every pixel. A plate of 64 holes \
         doesn't fit the RAM of the micro:bit.\n\n\
         | part |",
    );
    rows.iter().for_each(|row| {
        let _ = write!(text, " {} {} |", row.board.core(), row.number);
    });
    text.push_str("\n|---|");
    rows.iter().for_each(|_| text.push_str("---:|"));
    text.push('\n');
    text.push_str("| flash of a firmware that only renders, bytes |");
    rows.iter().for_each(|row| {
        let _ = write!(text, " {} |", row.render_flash);
    });
    text.push('\n');
    // What doesn't fit the smallest board is missing there.
    let names = rows.iter().map(|row| &row.counts.entries).max_by_key(|entries| entries.len());
    for (name, _) in names.into_iter().flatten() {
        let _ = write!(text, "| {name} |");
        rows.iter().for_each(|row| {
            let count = row.counts.of(name).map_or("-".to_owned(), |count| count.to_string());
            let _ = write!(text, " {count} |");
        });
        text.push('\n');
        if let Some(scene) = name.strip_suffix(NAIVE) {
            let _ = write!(text, "| {scene}, naive by middle row |");
            rows.iter().for_each(|row| {
                let _ = write!(text, " {} |", naive_ratio(&row.counts, scene));
            });
            text.push('\n');
        }
    }
    save("docs/boards.md", &text)?;
    let readme = fs::read_to_string(root().join("README.md")).map_err(|error| error.to_string())?;
    save("README.md", &with_table(&readme, &table(rows))?)
}

/// The naive caster's part of a scene.
const NAIVE: &str = ": naive middle row";

/// How many times as many instructions the naive caster takes for a row.
fn naive_ratio(counts: &Counts, scene: &str) -> String {
    let count = |part: &str| counts.of(&format!("{scene}{part}"));
    match (count(NAIVE), count(": middle row")) {
        (Some(naive), Some(row)) => format!("{:.1}", naive as f64 / row as f64),
        _ => "-".to_owned(),
    }
}

fn save(name: &str, text: &str) -> Result<(), String> {
    fs::write(root().join(name), text).map_err(|error| format!("{name}: {error}"))
}

/// The text with the table between its two marks.
fn with_table(text: &str, table: &str) -> Result<String, String> {
    const MARKS: [&str; 2] = ["<!-- boards -->\n", "<!-- end of boards -->\n"];
    let [start, end] = MARKS.map(|mark| text.split_once(mark));
    match (start, end) {
        (Some((before, _)), Some((_, after))) => {
            let [start, end] = MARKS;
            Ok(format!("{before}{start}{table}{end}{after}"))
        }
        _ => Err("README.md has no marks around the table of the boards".into()),
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_table_is_replaced_between_its_marks() {
        let old = "a\n<!-- boards -->\n| old |\n<!-- end of boards -->\nb\n";
        let new = "a\n<!-- boards -->\n| new |\n<!-- end of boards -->\nb\n";
        assert_eq!(super::with_table(old, "| new |\n").as_deref(), Ok(new));
        assert!(super::with_table("no marks", "").is_err());
    }
}
