//! What doesn't compile says why, in the words of this crate.
//!
//! Every file in `tests/compile_errors/` must fail to compile. Its lines `//~ text` say what the compiler's
//! first error has to contain. Everything else in it may differ from compiler to compiler.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::env;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread;

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// The library's file, which this test was built with.
fn library() -> PathBuf {
    let cargo = env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo"));
    let mut build = Command::new(cargo);
    build.args(["test", "--no-run", "--test", "library", "--message-format", "json"]);
    let output = build.current_dir(Path::new(ROOT).join("..")).output().unwrap();
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{text}{}", String::from_utf8_lossy(&output.stderr));
    let mut files = text.split('"').filter(|part| part.ends_with(".rlib"));
    files.rfind(|file| file.contains("libscancsg")).unwrap().into()
}

/// What the compiler says, if it refuses the file.
fn refusal(file: &Path, library: &Path) -> Option<String> {
    let compiler = env::var_os("RUSTC").unwrap_or_else(|| OsString::from("rustc"));
    let name = file.file_stem().unwrap().display();
    let object = env::temp_dir().join(format!("scancsg_{}_{name}.o", std::process::id()));
    let mut compile = Command::new(compiler);
    compile.args(["--edition", "2024", "--crate-type", "bin", "--emit", "obj", "-o"]).arg(&object);
    compile.args(["--extern", &format!("scancsg={}", library.display())]);
    for folder in [library.with_file_name(""), library.with_file_name("deps")] {
        compile.args(["-L", &format!("dependency={}", folder.display())]);
    }
    let output = compile.arg(file).output().unwrap();
    let _ = fs::remove_file(object);
    (!output.status.success()).then(|| String::from_utf8_lossy(&output.stderr).into_owned())
}

/// Whether a file is refused with what it expects.
fn check(file: &Path, library: &Path) {
    let text = fs::read_to_string(file).unwrap();
    let expected: Vec<&str> = text.lines().filter_map(|line| line.strip_prefix("//~ ")).collect();
    assert!(!expected.is_empty(), "{} expects nothing", file.display());
    let said = refusal(file, library).unwrap_or_else(|| panic!("{} compiles", file.display()));
    let first = said.split("\nerror").next().unwrap_or_default();
    for text in expected {
        assert!(first.contains(text), "{}: no \"{text}\" in\n{said}", file.display());
    }
}

#[test]
fn errors_point_the_right_way() {
    let library = &library();
    let folder = fs::read_dir(Path::new(ROOT).join("compile_errors")).unwrap();
    let files: Vec<_> = folder.map(|entry| entry.unwrap().path()).collect();
    assert!(files.len() >= 11, "{} files", files.len());
    let cores = thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| {
        for part in files.chunks(files.len().div_ceil(cores)) {
            scope.spawn(move || part.iter().for_each(|file| check(file, library)));
        }
    });
}
