//! `templates/firmware`, instantiated with its own defaults: it builds, its test is content on the host, and
//! the emulated board sends the rows that the test knows.

use crate::board::Board;
use crate::boot::Machine;
use crate::command::done;
use crate::host::receive::{Room, Session, timing};
use crate::paths::root;
use crate::toolchain;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

const NAME: &str = "my-part";
/// The board that the template's defaults are about.
const BOARD: Board = Board::An386;

/// Instantiates it, tests it on the host, builds it, boots it, and compares its rows with the test's.
pub fn check() -> Result<(), String> {
    let folder = root().join("target/template").join(NAME);
    instantiate(&root().join("templates/firmware"), &folder)?;
    // Versions that the examples have: nothing is compiled twice.
    let lock = root().join("boards/nrf52840/Cargo.lock");
    fs::copy(lock, folder.join("Cargo.lock")).map_err(|error| error.to_string())?;
    let target = root().join("target/template/host");
    let mut test = Command::new("cargo");
    done(test.current_dir(&folder).arg("host-test").env("CARGO_TARGET_DIR", &target))?;
    let toolchain = toolchain::find(BOARD.target())?;
    let elf = toolchain.build_package(&folder, BOARD.target(), &[])?.join(NAME);
    let rows =
        fs::read_to_string(folder.join("src/rows.txt")).map_err(|error| error.to_string())?;
    if sent_rows(&elf)? == rows {
        println!("the emulated board sent {} rows, all as on the host", rows.lines().count());
        Ok(())
    } else {
        Err("the rows of the template's firmware are not those of its test".to_owned())
    }
}

/// The rows of a frame that a firmware sends, in the form of the template's test.
fn sent_rows(elf: &Path) -> Result<String, String> {
    let (_machine, line) = Machine::start(BOARD, elf)?;
    let mut room = Room::new();
    let mut session: Session<'_> = Session::new(Box::new(line), &mut room, timing(None));
    let frame = session.frame(Duration::from_secs(60), |_| {}).ok_or("no frame came")?;
    if let Some(problem) = frame.problem() {
        return Err(problem);
    }
    let rows = frame.pixels.chunks(frame.header.row_bytes()).enumerate();
    Ok(rows.map(|(y, row)| format!("{y:03} {:08x}\n", hash(row))).collect())
}

/// FNV-1a of 32 bits, as in the template.
fn hash(row: &[u8]) -> u32 {
    row.iter().fold(0x811C_9DC5, |hash, byte| (hash ^ u32::from(*byte)).wrapping_mul(0x0100_0193))
}

/// Does what `cargo generate` does: copies the files, with a value in the place of each placeholder.
fn instantiate(from: &Path, to: &Path) -> Result<(), String> {
    let text = |path: &Path| {
        fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))
    };
    let mut values = defaults(&text(&from.join("cargo-generate.toml"))?);
    // This crate is the one that is tested.
    values.retain(|(name, _)| name != "scancsg");
    values.push(("scancsg".to_owned(), format!("path = {:?}", root())));
    values.push(("project-name".to_owned(), NAME.to_owned()));
    for file in files(from)? {
        let Ok(place) = file.strip_prefix(from) else { continue };
        if place == Path::new("cargo-generate.toml") {
            continue;
        }
        let written = replaced(&text(&file)?, &values)
            .map_err(|problem| format!("{}: {problem}", file.display()))?;
        let path = to.join(place);
        let made = path.parent().map_or(Ok(()), fs::create_dir_all);
        made.and_then(|()| fs::write(&path, written))
            .map_err(|error| format!("{}: {error}", path.display()))?;
    }
    Ok(())
}

/// The defaults of `cargo-generate.toml`.
fn defaults(text: &str) -> Vec<(String, String)> {
    let placeholders = text.split("[placeholders.").skip(1);
    let default = |part: &str| {
        let name = part.split(']').next()?;
        let line = part.lines().find_map(|line| line.strip_prefix("default = "))?;
        Some((name.to_owned(), line.trim_matches(['"', '\'']).to_owned()))
    };
    placeholders.filter_map(default).collect()
}

/// A file's text with the values.
fn replaced(text: &str, values: &[(String, String)]) -> Result<String, String> {
    let text = values.iter().fold(text.to_owned(), |text, (name, value)| {
        text.replace(&format!("{{{{{name}}}}}"), value)
    });
    match text.split_once("{{") {
        Some((_, rest)) => Err(format!("no value for {:?}", rest.split("}}").next())),
        None => Ok(text),
    }
}

/// All files of a folder and of the folders in it.
fn files(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let text = |error: std::io::Error| format!("{}: {error}", folder.display());
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).map_err(text)? {
        let path = entry.map_err(text)?.path();
        if path.is_dir() {
            files.extend(self::files(&path)?);
        } else {
            files.push(path);
        }
    }
    Ok(files)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_placeholder_has_a_default() -> Result<(), String> {
        let folder = root().join("templates/firmware");
        let list = fs::read_to_string(folder.join("cargo-generate.toml"));
        let list = list.map_err(|error| error.to_string())?;
        let mut values = defaults(&list);
        assert_eq!(values.len(), list.matches("[placeholders.").count());
        values.push(("project-name".to_owned(), NAME.to_owned()));
        for file in files(&folder)? {
            let text = fs::read_to_string(&file).map_err(|error| error.to_string())?;
            replaced(&text, &values)?;
        }
        Ok(())
    }

    #[test]
    fn a_placeholder_without_a_value_is_an_error() {
        assert!(replaced("{{chip}}", &[]).is_err());
        let values = [("chip".to_owned(), "nRF52840_xxAA".to_owned())];
        assert_eq!(replaced("{{chip}}", &values).as_deref(), Ok("nRF52840_xxAA"));
    }
}
