//! The firmware of boards that people own, each with the HAL of its chip: that all of it builds, and what it
//! takes of flash and RAM.

use crate::elf::Contents;
use crate::paths::root;
use crate::toolchain;
use std::fs;
use std::path::Path;

/// Folders of `boards/`, and their targets. The step `pico` boots the first.
const BOARDS: [(&str, &str); 5] = [
    ("rp2040", "thumbv6m-none-eabi"),
    ("rp2350", "thumbv8m.main-none-eabihf"),
    ("stm32f4", "thumbv7em-none-eabihf"),
    ("nrf52840", "thumbv7em-none-eabihf"),
    ("esp32c3", "riscv32imc-unknown-none-elf"),
];

/// Builds all of it, and says how large it is.
pub fn check() -> Result<(), String> {
    println!("| board | program | flash | RAM |\n|---|---|---|---|");
    BOARDS.iter().try_for_each(|(board, target)| build(board, target))
}

/// Builds the programs of a board.
fn build(board: &str, target: &str) -> Result<(), String> {
    let package = root().join("boards").join(board);
    let built = toolchain::find(target)?.build_package(&package, target, &["--locked"])?;
    for program in programs(&package, board)? {
        let Contents { flash, ram, .. } = Contents::read(&built.join(&program))?;
        println!("| {board} | {program} | {flash} | {ram} |");
    }
    Ok(())
}

/// The names of a package's programs: its own, and those in `src/bin`.
fn programs(package: &Path, name: &str) -> Result<Vec<String>, String> {
    let mut programs = vec![name.to_owned()];
    let folder = package.join("src/bin");
    if folder.is_dir() {
        let text = |error: std::io::Error| format!("{}: {error}", folder.display());
        for entry in fs::read_dir(&folder).map_err(text)? {
            let path = entry.map_err(text)?.path();
            programs.extend(path.file_stem().map(|stem| stem.to_string_lossy().into_owned()));
        }
    }
    programs.sort_unstable();
    Ok(programs)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What has to be written besides a part, to see it on a display: lines of code outside of `mod part`.
    #[test]
    fn a_display_takes_25_lines() -> Result<(), String> {
        let source = fs::read_to_string(root().join("boards/stm32f4/src/bin/panel.rs"));
        let source = source.map_err(|error| error.to_string())?;
        let (before, rest) = source.split_once("mod part {\n").ok_or("no part")?;
        let (_, after) = rest.split_once("\n}\n").ok_or("the part has no end")?;
        let is_code = |line: &&str| !line.trim().is_empty() && !line.trim().starts_with("//");
        let count = before.lines().chain(after.lines()).filter(is_code).count();
        assert!((10..=25).contains(&count), "{count} lines");
        Ok(())
    }
}
