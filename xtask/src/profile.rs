//! Where the instructions of a part go: every instruction that the emulator runs is counted at its
//! address.

use crate::board::{Board, Number};
use crate::toolchain;
use object::{Object, ObjectSymbol, SymbolKind};
use std::collections::BTreeMap;
use std::io::{BufRead, BufReader};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

#[derive(Debug, clap::Args)]
pub struct Profile {
    /// The board
    #[arg(long, default_value = "an386")]
    board: Board,

    /// The number type
    #[arg(long, default_value = "f32")]
    number: Number,

    /// The function of the example `bench` that is looked into
    #[arg(long, default_value = "orthographic_frame")]
    part: String,

    /// Run frames only, and of each picture one row of so many
    #[arg(long, value_name = "ROWS")]
    every: Option<u16>,

    /// Also write the count of every instruction's address, for a disassembler's listing
    #[arg(long, value_name = "FILE")]
    addresses: Option<PathBuf>,
}

/// A function in a firmware.
struct Function {
    name: String,
    place: Range<u64>,
}

fn functions(elf: &Path) -> Result<Vec<Function>, String> {
    let text = |error: &dyn std::fmt::Display| format!("{}: {error}", elf.display());
    let bytes = std::fs::read(elf).map_err(|error| text(&error))?;
    let file = object::File::parse(bytes.as_slice()).map_err(|error| text(&error))?;
    let mut functions: Vec<Function> = file
        .symbols()
        .filter(|symbol| symbol.kind() == SymbolKind::Text && symbol.size() > 0)
        .map(|symbol| {
            // The lowest bit tells Arm's instruction set.
            let start = symbol.address() & !1;
            let name = symbol.name().unwrap_or("?");
            let name = format!("{:#}", rustc_demangle::demangle(name));
            Function { name, place: start..start + symbol.size() }
        })
        .collect();
    functions.sort_by_key(|function| function.place.start);
    Ok(functions)
}

/// Every instruction on a line of its own: in newer emulators by another name.
fn single_step(program: &str) -> Result<&'static [&'static str], String> {
    let help = Command::new(program).arg("--help").output().map_err(|error| error.to_string())?;
    let knows_it = String::from_utf8_lossy(&help.stdout).contains("-singlestep");
    Ok(if knows_it { &["-singlestep"] } else { &["-accel", "tcg,one-insn-per-tb=on"] })
}

/// The address in a line of the emulator's trace: `Trace 0: 0x7f.. [00000000/0000123a/...] name`.
fn address(line: &[u8]) -> Option<u64> {
    let line = line.strip_prefix(b"Trace ")?;
    let start = line.iter().position(|byte| *byte == b'[')?;
    let address = line.get(start + 1..)?.split(|byte| *byte == b'/').nth(1)?;
    u64::from_str_radix(std::str::from_utf8(address).ok()?, 16).ok()
}

/// Runs the example `bench`, and counts what it does from the part's beginning until its caller
/// goes on.
fn count(
    board: Board,
    elf: &Path,
    part: &Function,
    caller: &Function,
) -> Result<BTreeMap<u64, u64>, String> {
    let (program, machine) = board.machine();
    let mut emulator = Command::new(program)
        .args(machine)
        .args(["-display", "none", "-monitor", "none", "-serial", "null"])
        .args(["-icount", "shift=7,align=off,sleep=off"])
        .args(single_step(program)?)
        .args(["-d", "exec,nochain", "-D", "/dev/stdout"])
        .args(["-semihosting-config", "enable=on,target=native", "-kernel"])
        .arg(elf)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .map_err(|error| format!("can't start {program}: {error}"))?;
    let mut counts = BTreeMap::new();
    let mut is_inside = false;
    if let Some(trace) = emulator.stdout.take() {
        let mut trace = BufReader::with_capacity(1 << 20, trace);
        let mut line = Vec::new();
        while trace.read_until(b'\n', &mut line).map_err(|error| error.to_string())? > 0 {
            if let Some(address) = address(&line) {
                is_inside &= !caller.place.contains(&address);
                is_inside |= address == part.place.start;
                if is_inside {
                    *counts.entry(address).or_insert(0) += 1;
                }
            }
            line.clear();
        }
    }
    emulator.wait().map_err(|error| error.to_string())?;
    Ok(counts)
}

/// Prints how often the instructions of each function ran, most first.
pub fn show(chosen: &Profile) -> Result<(), String> {
    let Profile { board, number, part, every, addresses } = chosen;
    let every = every.map(|every| every.to_string());
    let every = every.as_ref().map(|every| ("SCANCSG_EVERY", Path::new(every)));
    let every = every.as_slice();
    let elf = toolchain::find(board.target())?.build_with(*board, *number, "bench", &[], every)?;
    let functions = functions(&elf)?;
    let named = |name: &str| {
        let end = format!("::{name}");
        functions.iter().find(|function| function.name.ends_with(&end) || function.name == name)
    };
    let part = named(part).ok_or_else(|| format!("{} has no function `{part}`", elf.display()))?;
    let caller = ["__cortex_m_rt_main", "__risc_v_rt__main", "main"].into_iter().find_map(named);
    let caller = caller.ok_or("the firmware has no function `main`")?;
    eprintln!("{board}, {number}: counting what {} does; half a minute or more", part.name);
    let counts = count(*board, &elf, part, caller)?;
    let total: u64 = counts.values().sum();
    let mut of_function: Vec<(u64, &str)> = functions
        .iter()
        .map(|function| {
            (counts.range(function.place.clone()).map(|(_, count)| count).sum(), &*function.name)
        })
        .filter(|(count, _)| *count > 0)
        .collect();
    of_function.sort_unstable_by(|a, b| b.cmp(a));
    println!("{total:>11} instructions");
    for (count, name) in of_function {
        println!("{count:>11} {:>5.1} % {name}", 100.0 * count as f64 / total.max(1) as f64);
    }
    if let Some(path) = addresses {
        let text: String =
            counts.iter().map(|(address, count)| format!("{address:8x} {count}\n")).collect();
        std::fs::write(path, text).map_err(|error| format!("{}: {error}", path.display()))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    #[test]
    fn addresses_are_found_in_a_trace() {
        let line = b"Trace 0: 0x7f1c00000100 [00000000/0000c0de/00000110/ff020000] main\n";
        assert_eq!(super::address(line), Some(0xc0de));
        assert_eq!(super::address(b"stack 12\n"), None);
    }
}
