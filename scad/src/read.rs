//! Files: `.csg` as they are, `.scad` through OpenSCAD.

use crate::error::Error;
use std::ffi::OsStr;
use std::path::Path;
use std::process::Command;
use std::{env, fs, process};

/// The text of a `.csg` file; of a `.scad` file, what an installed `openscad` makes of it.
///
/// # Errors
/// An [`Error`] that names the file, or what OpenSCAD says.
pub fn read(path: &Path) -> Result<String, Error> {
    let failed = |path: &Path, error: &dyn std::fmt::Display| {
        Error::file(format!("{}: {error}", path.display()))
    };
    if path.extension() != Some(OsStr::new("scad")) {
        return fs::read_to_string(path).map_err(|error| failed(path, &error));
    }
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let made = env::temp_dir().join(format!("scancsg-scad-{}-{stem}.csg", process::id()));
    let run = Command::new("openscad").arg("-o").arg(&made).arg(path).output();
    let output = run.map_err(|error| Error::file(format!("`openscad` can't be run: {error}")))?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        return Err(Error::file(format!("`openscad` says of {}: {}", path.display(), said.trim())));
    }
    let text = fs::read_to_string(&made).map_err(|error| failed(&made, &error));
    let _ = fs::remove_file(&made);
    text
}
