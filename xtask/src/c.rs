//! The library for programs in C: its tests, its programs on this computer and on boards, and its folder for
//! Arduino.

use crate::board::{Board, Number};
use crate::command::done;
use crate::paths::root;
use crate::{boot, elf, toolchain};
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The compiler for boards, from Debian's package `gcc-arm-none-eabi`.
pub const CROSS: &str = "arm-none-eabi-gcc";

/// The same for Arduino's sketches.
const CROSS_CPP: &str = "arm-none-eabi-g++";

/// Every warning is an error.
const STRICT: [&str; 5] = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic"];

/// Memory is watched, and what C leaves undefined.
const WATCHED: [&str; 3] =
    ["-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=undefined"];

/// The boards whose C programs are linked and booted.
const BOARDS: [(Board, Number); 2] =
    [(Board::Microbit, Number::I16f16), (Board::An386, Number::F32)];

/// A folder of Arduino's for a core, its target, and the number type that `ScancsgArduino.h` takes there.
const ARDUINO: [(&str, &str, Number); 3] = [
    ("cortex-m0plus", "thumbv6m-none-eabi", Number::I16f16),
    ("cortex-m3", "thumbv7m-none-eabi", Number::I16f16),
    ("cortex-m4/fpv4-sp-d16-hard", "thumbv7em-none-eabihf", Number::F32),
];

/// Checks all of it.
pub fn check() -> Result<(), String> {
    // The largest of everything, too.
    for features in [&[][..], &["--all-features", "--test", "border"]] {
        let mut command = Command::new("cargo");
        done(
            command.args(["test", "--package", "scancsg-capi"]).args(features).current_dir(root()),
        )?;
    }
    for number in Number::ALL {
        on_host(number)?;
    }
    for (board, number) in BOARDS {
        on_board(board, number)?;
    }
    arduino()
}

/// What a C compiler needs to know of a number type.
fn define(number: Number) -> &'static [&'static str] {
    match number {
        Number::F32 => &[],
        Number::I16f16 => &["-DSCANCSG_I16F16"],
    }
}

/// The same for cargo.
fn features(number: Number) -> &'static str {
    match number {
        Number::F32 => "",
        Number::I16f16 => "i16f16",
    }
}

fn source(path: &str) -> PathBuf {
    root().join("capi").join(path)
}

/// A command of a C compiler's.
fn compile(compiler: &str, number: Number) -> Command {
    let mut command = Command::new(compiler);
    command.args(STRICT).args(define(number)).arg("-I").arg(source("include"));
    command
}

fn output(command: &mut Command) -> Result<String, String> {
    let output = command.output().map_err(|error| format!("{command:?}: {error}"))?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    if output.status.success() {
        return Ok(text);
    }
    Err(format!("{command:?}: {text}{}", String::from_utf8_lossy(&output.stderr)))
}

/// The rows of both cameras, one after the other, as `tests/golden` has them.
fn golden(number: Number) -> Result<String, String> {
    let end = match number {
        Number::F32 => "",
        Number::I16f16 => "_i16f16",
    };
    let file = |camera: &str| {
        let path = root().join(format!("tests/golden/tee_160x120_{camera}{end}.txt"));
        fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))
    };
    Ok(file("orthographic")? + &file("perspective")?)
}

/// Compares rows with those of `tests/golden`.
fn compare(said: &str, number: Number) -> Result<(), String> {
    let want = golden(number)?;
    let rows = said.lines().zip(want.lines()).filter(|(got, want)| got == want).count();
    let count = want.lines().count();
    if rows == count && count > 0 {
        println!("{rows} rows are those of tests/golden");
        return Ok(());
    }
    Err(format!("only {rows} rows of {count} are those of tests/golden:\n{said}"))
}

/// Builds the C programs for this computer, and runs them.
fn on_host(number: Number) -> Result<(), String> {
    done(
        Command::new("cargo")
            .args(["build", "--quiet", "--package", "scancsg-capi"])
            .args(["--features", features(number)])
            .current_dir(root()),
    )?;
    let target =
        env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from);
    let library = target.join("debug/libscancsg_capi.a");
    let folder = root().join("target/c").join(number.name());
    fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let build = |name: &str, source: &Path, flags: &[&str]| {
        let program = folder.join(name);
        let mut command = compile("cc", number);
        command.args(flags).arg(source).arg(&library).arg("-o").arg(&program);
        done(command.args(["-lpthread", "-ldl", "-lm"])).map(|()| program)
    };
    compare(&output(&mut Command::new(build("tee", &source("examples/tee.c"), &[])?))?, number)?;
    // README's own program, so that it stays true.
    let readme = folder.join("readme.c");
    fs::write(&readme, readme_program()?).map_err(|error| error.to_string())?;
    let drawn = output(&mut Command::new(build("readme", &readme, &[])?))?;
    println!("{}", drawn.trim_end());
    if drawn.lines().count() != 32 || !drawn.contains("%%%") {
        return Err("README's program draws no plate".to_owned());
    }
    print!("{}", output(&mut Command::new(build("border", &source("tests/border.c"), &WATCHED)?))?);
    Ok(())
}

/// The program of the package's README.
fn readme_program() -> Result<String, String> {
    let path = source("README.md");
    let text = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    let program = text.split_once("```c\n").and_then(|(_, rest)| rest.split_once("```"));
    program.map(|(program, _)| program.to_owned()).ok_or("the README has no program".to_owned())
}

/// Links the example for a board, looks what is in it, and boots it.
fn on_board(board: Board, number: Number) -> Result<(), String> {
    let toolchain = toolchain::find(board.target())?;
    let library = toolchain.build_library(board.target(), features(number))?;
    let elf = root().join("target/c").join(format!("{board}-{number}.elf"));
    link(board, number, &library, &elf)?;
    let contents = elf::Contents::read(&elf)?;
    println!("{board}, {number}: {} bytes of flash, {} of variables", contents.flash, contents.ram);
    // In `f32`, angles and directions that are no axis take some `f64`.
    let is_meant = |problem: &String| number == Number::F32 && problem.contains("f64");
    let problems: Vec<String> =
        contents.problems(number).filter(|problem| !is_meant(problem)).collect();
    if !problems.is_empty() {
        return Err(format!("{board}, {number}: {}", problems.join("; ")));
    }
    let said = boot::listen(board, &elf)?;
    said.lines().filter(|line| line.starts_with("stack")).for_each(|line| println!("{line}"));
    compare(&said, number)
}

fn link(board: Board, number: Number, library: &Path, elf: &Path) -> Result<(), String> {
    let (core, ram): (&[&str], _) = match board {
        Board::Microbit => (&["-mcpu=cortex-m0"], "0x4000"),
        Board::An386 => (&["-mcpu=cortex-m4", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"], "0x10000"),
        _ => return Err(format!("no C program is linked for {board}")),
    };
    let mut command = compile(CROSS, number);
    command
        .args(core)
        .args(["-Os", "-ffreestanding", "-nostdlib", "-Wl,--gc-sections,-z,noexecstack"])
        .arg(format!("-Wl,--defsym=_ram_size={ram}"))
        .arg("-L")
        .arg(root())
        .arg("-T")
        .arg(source("examples/board.ld"))
        .args([source("examples/tee.c"), source("examples/board.c")])
        .arg(library)
        .args(["-lgcc", "-o"])
        .arg(elf);
    done(&mut command)
}

/// Writes the library for Arduino to `target/arduino/Scancsg`.
pub fn arduino() -> Result<(), String> {
    let folder = root().join("target/arduino/Scancsg");
    copy_folder(&source("arduino"), &folder)?;
    copy(&source("include/scancsg.h"), &folder.join("src/scancsg.h"))?;
    for (place, target, number) in ARDUINO {
        let library = toolchain::find(target)?.build_library(target, features(number))?;
        copy(&library, &folder.join("src").join(place).join("libscancsg.a"))?;
        // Whoever has no compiler for C++ has one in Arduino.
        if toolchain::has_program(CROSS_CPP) {
            sketch(place, &folder)?;
        }
    }
    println!("{}", folder.display());
    Ok(())
}

/// Compiles the sketch as Arduino does, and links it with the folder's own library.
fn sketch(place: &str, folder: &Path) -> Result<(), String> {
    let (core, float) = place.split_once('/').unwrap_or((place, ""));
    let mut command = Command::new(CROSS_CPP);
    command.arg(format!("-mcpu={core}")).arg("-mthumb");
    if let Some((unit, abi)) = float.rsplit_once('-') {
        command.arg(format!("-mfpu={unit}")).arg(format!("-mfloat-abi={abi}"));
    }
    command
        .args(["-Os", "-std=gnu++11", "-Wall", "-Wextra", "-Werror", "-ffreestanding"])
        .args(["-fno-exceptions", "-fno-rtti", "-nostdlib", "-Wl,--gc-sections,-z,noexecstack"])
        .args(["-Wl,-e,reset,-Ttext=0x10000", "-include"])
        .arg(source("tests/Arduino.h"))
        .arg("-I")
        .arg(folder.join("src"))
        .args(["-x", "c++"])
        .arg(folder.join("examples/Tee/Tee.ino"))
        .args(["-x", "none", "-L"])
        .arg(folder.join("src").join(place))
        .args(["-lscancsg", "-lgcc", "-o"])
        .arg(root().join("target/arduino").join(format!("{core}.elf")));
    done(&mut command)
}

fn copy(from: &Path, to: &Path) -> Result<(), String> {
    let error = |error: std::io::Error| format!("{}: {error}", to.display());
    fs::create_dir_all(to.parent().unwrap_or(to)).map_err(error)?;
    fs::copy(from, to).map(drop).map_err(error)
}

fn copy_folder(from: &Path, to: &Path) -> Result<(), String> {
    let error = |error: std::io::Error| format!("{}: {error}", from.display());
    for entry in fs::read_dir(from).map_err(error)? {
        let entry = entry.map_err(error)?;
        let (path, to) = (entry.path(), to.join(entry.file_name()));
        if path.is_dir() { copy_folder(&path, &to) } else { copy(&path, &to) }?;
    }
    Ok(())
}
