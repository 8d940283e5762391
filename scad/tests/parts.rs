//! The crate's own parts against what OpenSCAD made of them, as recorded.

mod support;

use std::error::Error;
use std::fs;
use support::reference::{Reference, folder};
use support::{compare, scene};

/// In parts of the volume, and of the pixels.
const VOLUME: f64 = 0.003;
const PIXELS: f64 = 0.001;

#[test]
fn parts_are_what_openscad_makes_of_them() -> Result<(), Box<dyn Error>> {
    let mut count = 0;
    for entry in fs::read_dir(folder())? {
        let path = entry?.path();
        if path.extension().is_none_or(|extension| extension != "csg") {
            continue;
        }
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let reference = Reference::read(&name).ok_or(format!("no reference of {name}"))?;
        let off = compare(&scene(&fs::read_to_string(&path)?)?, &reference, 130)?;
        assert!(off.volume.abs() < VOLUME && off.pixels < PIXELS, "{name}: {off:?}");
        count += 1;
    }
    assert_eq!(count, 12);
    Ok(())
}

/// A test that can fail: another part's reference is told apart.
#[test]
fn another_part_is_told_apart() -> Result<(), Box<dyn Error>> {
    let text = fs::read_to_string(folder().join("clip.csg"))?;
    let reference = Reference::read("clip").ok_or("no reference")?;
    // A bore of 6 becomes one of 6.1.
    let off =
        compare(&scene(&text.replace("r1 = 6, r2 = 6", "r1 = 6.1, r2 = 6.1"))?, &reference, 130)?;
    assert!(off.volume.abs() > VOLUME && off.pixels > PIXELS, "{off:?}");
    Ok(())
}
