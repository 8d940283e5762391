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

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// Builds the library, and returns its file.
fn library() -> PathBuf {
    let cargo = env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo"));
    let mut build = Command::new(cargo);
    build.args(["build", "--package", "scancsg", "--lib", "--message-format", "json"]);
    let output = build.current_dir(ROOT).output().unwrap();
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{text}{}", String::from_utf8_lossy(&output.stderr));
    let mut files = text.split('"').filter(|part| part.ends_with(".rlib"));
    files.rfind(|file| file.contains("libscancsg")).unwrap().into()
}

/// What the compiler says, if it refuses the file.
fn refusal(file: &Path, library: &Path) -> Option<String> {
    let compiler = env::var_os("RUSTC").unwrap_or_else(|| OsString::from("rustc"));
    let object = env::temp_dir().join(format!("scancsg_{}.o", std::process::id()));
    let mut compile = Command::new(compiler);
    compile.args(["--edition", "2024", "--crate-type", "bin", "--emit", "obj", "-o"]).arg(&object);
    compile.args(["--extern", &format!("scancsg={}", library.display()), "-L"]);
    compile.arg(format!("dependency={}", library.with_file_name("deps").display()));
    let output = compile.arg(file).output().unwrap();
    let _ = fs::remove_file(object);
    (!output.status.success()).then(|| String::from_utf8_lossy(&output.stderr).into_owned())
}

#[test]
fn errors_point_the_right_way() {
    let library = library();
    let folder = Path::new(ROOT).join("tests/compile_errors");
    let mut count = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let file = entry.unwrap().path();
        let text = fs::read_to_string(&file).unwrap();
        let expected: Vec<&str> =
            text.lines().filter_map(|line| line.strip_prefix("//~ ")).collect();
        assert!(!expected.is_empty(), "{} expects nothing", file.display());
        let said =
            refusal(&file, &library).unwrap_or_else(|| panic!("{} compiles", file.display()));
        let first = said.split("\nerror").next().unwrap_or_default();
        for text in expected {
            assert!(first.contains(text), "{}: no \"{text}\" in\n{said}", file.display());
        }
        count += 1;
    }
    assert!(count >= 11, "{count} files");
}
