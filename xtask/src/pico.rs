//! A Raspberry Pi Pico in an emulator from the npm registry: its picture is the host's.

use crate::command::done;
use crate::paths::root;
use crate::toolchain;
use std::fs;
use std::process::Command;

const TARGET: &str = "thumbv6m-none-eabi";
/// The emulator.
const EMULATOR: &str = "rp2040js@1.4.1";

/// Builds `boards/rp2040`, boots it, receives its first frame, and compares that with the host's.
pub fn check() -> Result<(), String> {
    let firmware = toolchain::find(TARGET)?.build_package("rp2040", TARGET)?;
    let folder = root().join("target/pico");
    fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let path = |name: &str| folder.join(name);
    done(Command::new("npm").current_dir(&folder).args([
        "install",
        "--silent",
        "--no-fund",
        "--no-audit",
        "--prefix",
        ".",
        EMULATOR,
    ]))?;
    done(
        Command::new("node")
            .arg(root().join("boards/rp2040/boot.mjs"))
            .args([&firmware, &path("line.bin")])
            .env("NODE_MODULES_OF", path("node_modules")),
    )?;
    let example = |name: &str| {
        let mut command = Command::new("cargo");
        let words = ["run", "--quiet", "--release", "--example", name, "--"];
        command.current_dir(root()).args(words);
        command
    };
    done(example("view").arg("--replay").arg(path("line.bin")).arg("--out").arg(path("pico.png")))?;
    done(example("stream").args(["--number", "i16f16", "--out"]).arg(path("host.png")))?;
    let picture = |name: &str| {
        fs::read(path(name)).map_err(|error| format!("{}: {error}", path(name).display()))
    };
    if picture("pico.png")? == picture("host.png")? {
        Ok(())
    } else {
        Err("the emulated Pico's picture is not the host's".to_owned())
    }
}
