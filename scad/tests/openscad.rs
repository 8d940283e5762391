//! Parts against an installed OpenSCAD: minutes, so only when asked for.
//!
//! ```sh
//! cargo test -p scancsg-scad --test openscad -- --ignored --nocapture
//! ```
//!
//! `SCAD_PARTS` names another folder of `.csg` files. `SCAD_RECORD=1` writes the references anew.

mod support;

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;
use std::{env, fs, thread};
use support::mesh::Mesh;
use support::reference::{Reference, folder};
use support::{Difference, compare, of_mesh, scene};

/// How many facets what is meant to be round gets: for a comparison, whose time grows with the square, and for the
/// references that are kept. A circle of 64 facets lacks 0.16 % of its area, one of 96 lacks 0.07 %.
const FACETS: u32 = 64;
const RECORDED: u32 = 96;

#[test]
#[ignore = "needs `openscad`, and minutes"]
fn parts_are_what_openscad_makes_of_them_now() -> Result<(), Box<dyn Error>> {
    let from = env::var_os("SCAD_PARTS").map_or_else(folder, PathBuf::from);
    let records = env::var_os("SCAD_RECORD").is_some();
    let mut parts: Vec<PathBuf> = fs::read_dir(from)?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<Result<_, _>>()?;
    parts.retain(|path| path.extension().is_some_and(|extension| extension == "csg"));
    parts.sort();
    let facets = if records { RECORDED } else { FACETS };
    // One OpenSCAD for each core, and each takes the next part.
    let (next, done) = (Mutex::new(parts.iter()), Mutex::new(Vec::new()));
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                while let Some(path) = next.lock().ok().and_then(|mut next| next.next()) {
                    let compared = compared(path, facets).map_err(|error| error.to_string());
                    if let Ok(mut done) = done.lock() {
                        done.push((path, compared));
                    }
                }
            });
        }
    });
    let mut done = done.into_inner().map_err(|error| error.to_string())?;
    done.sort_by_key(|(path, _)| *path);
    assert_eq!(done.len(), parts.len());
    let (mut table, mut failed) = (String::new(), Vec::new());
    for (path, compared) in done {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let (reference, off) = compared.map_err(|error| format!("{name}: {error}"))?;
        println!(
            "{name:24} {:12.3} {:+.3} % {:.3} %",
            reference.volume,
            off.volume * 100.0,
            off.pixels * 100.0
        );
        if off.volume.abs() >= 0.003 || off.pixels >= 0.001 {
            failed.push(name.clone());
        }
        table += &(reference.line(&name) + "\n");
        if records {
            reference.write_silhouette(&name)?;
        }
    }
    if records {
        fs::write(folder().join("volumes.txt"), table)?;
    }
    assert!(!parts.is_empty(), "no part was compared");
    assert!(failed.is_empty(), "{failed:?}");
    Ok(())
}

/// What OpenSCAD makes of a part, and how far the importer is off that.
fn compared(path: &Path, facets: u32) -> Result<(Reference, Difference), Box<dyn Error>> {
    let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let text = fs::read_to_string(path)?;
    let reference = of_mesh(&openscad(&name, &text, facets)?);
    let off = compare(&scene(&text)?, &reference, 400)?;
    Ok((reference, off))
}

/// The mesh that OpenSCAD makes of a part with more facets. What is there from a run before is taken.
fn openscad(name: &str, text: &str, facets: u32) -> Result<Mesh, Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let [csg, stl] = ["csg", "stl"].map(|extension| folder.join(format!("{name}.{extension}")));
    let text: String = text.lines().map(|line| raised(line, facets) + "\n").collect();
    let is_known = fs::read_to_string(&csg).is_ok_and(|known| known == text) && stl.exists();
    if !is_known {
        let _ = fs::remove_file(&stl);
        fs::write(&csg, text)?;
        let output = Command::new("openscad").arg("-o").arg(&stl).arg(&csg).output()?;
        if !output.status.success() {
            return Err(String::from_utf8_lossy(&output.stderr).into());
        }
    }
    Ok(Mesh::of_stl(&fs::read_to_string(&stl)?).ok_or("no mesh")?)
}

/// A line with more facets, unless few are meant.
fn raised(line: &str, facets: u32) -> String {
    let Some((before, rest)) = line.split_once("$fn = ") else { return line.into() };
    let (number, after) = rest.split_once([',', ')']).unwrap_or((rest, ""));
    let end = rest.len() - after.len() - number.len();
    let sign = rest.get(number.len()..number.len() + end).unwrap_or_default();
    match number.trim().parse::<f64>() {
        Ok(given) if !(1.0..=8.0).contains(&given) && given < f64::from(facets) => {
            format!("{before}$fn = {facets}{sign}{after}")
        }
        _ => line.into(),
    }
}
