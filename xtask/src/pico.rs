//! A Raspberry Pi Pico in an emulator from the npm registry: its picture is the host's.

use crate::command::done;
use crate::paths::root;
use crate::toolchain;
use std::fs;
use std::process::Command;

const TARGET: &str = "thumbv6m-none-eabi";
/// The emulator.
const EMULATOR: &str = "rp2040js@1.4.1";

/// Builds `boards/rp2040`, boots it, receives its first frame, and compares that with the host's. Does the same
/// with the program that sends rows by DMA.
pub fn check() -> Result<(), String> {
    let package = root().join("boards/rp2040");
    let firmware = toolchain::find(TARGET)?.build_package(&package, TARGET, &["--locked"])?;
    let folder = root().join("target/pico");
    fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let path = |name: &str| folder.join(name);
    let read = |name: &str| {
        fs::read(path(name)).map_err(|error| format!("{}: {error}", path(name).display()))
    };
    done(Command::new("npm").current_dir(&folder).args([
        "install",
        "--silent",
        "--no-fund",
        "--no-audit",
        "--prefix",
        ".",
        EMULATOR,
    ]))?;
    let boot = |program: &str, out: &str, bytes: Option<usize>| {
        let mut command = Command::new("node");
        command
            .arg(root().join("boards/rp2040/boot.mjs"))
            .args([firmware.join(program), path(out)])
            .args(bytes.map(|bytes| bytes.to_string()))
            .env("NODE_MODULES_OF", path("node_modules"));
        done(&mut command)
    };
    boot("rp2040", "line.bin", None)?;
    let example = |name: &str| {
        let mut command = Command::new("cargo");
        let words = ["run", "--quiet", "--release", "--example", name, "--"];
        command.current_dir(root()).args(words);
        command
    };
    done(example("view").arg("--replay").arg(path("line.bin")).arg("--out").arg(path("pico.png")))?;
    done(example("stream").args(["--number", "i16f16", "--out"]).arg(path("host.png")))?;
    let host = read("host.png")?;
    if read("pico.png")? != host {
        return Err("the emulated Pico's picture is not the host's".to_owned());
    }
    let pixels = pixels(&host)?;
    boot("rtic", "rows.pgm", Some(HEADER.len() + pixels.len()))?;
    if read("rows.pgm")?.strip_prefix(HEADER) == Some(&pixels) {
        Ok(())
    } else {
        Err("the rows that the emulated Pico sends by DMA are not the host's".to_owned())
    }
}

/// What the file of grey values begins with.
const HEADER: &[u8] = b"P5 160 120 255\n";

/// The pixels of a PNG file.
fn pixels(file: &[u8]) -> Result<Vec<u8>, String> {
    let text = |error: png::DecodingError| error.to_string();
    let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().map_err(text)?;
    let mut pixels = vec![0; reader.output_buffer_size().unwrap_or(0)];
    let info = reader.next_frame(&mut pixels).map_err(text)?;
    pixels.truncate(info.buffer_size());
    Ok(pixels)
}
