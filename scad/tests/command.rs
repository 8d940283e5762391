//! The command: its exit codes, its files, and its help.

mod support;

use scancsg::program::Program;
use scancsg::scalar::I16F16;
use scancsg_scad::program::Leaf;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use support::reference::folder;

fn run(arguments: &[&str]) -> Result<Output, std::io::Error> {
    Command::new(env!("CARGO_BIN_EXE_scancsg-scad")).args(arguments).output()
}

fn scratch(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

fn part(name: &str, text: &str) -> Result<String, std::io::Error> {
    let path = scratch(name);
    fs::write(&path, text)?;
    Ok(path.to_string_lossy().into_owned())
}

#[test]
fn exit_codes_say_what_is_wrong() -> Result<(), Box<dyn Error>> {
    let good = part("good.csg", "cube(size = [3, 2, 1]);")?;
    let far = part("far.csg", "cube(size = [90000, 2, 1]);")?;
    let wrong = part("wrong.csg", "cube(size = [3, 2, 1]")?;
    let surface = part("surface.csg", "cube(size = [3, 2, 1]);\nsurface(file = \"a.png\");")?;
    let out = scratch("codes.scene").to_string_lossy().into_owned();
    let cases: [(&[&str], i32, &str); 9] = [
        (&[&good], 0, "1 solids"),
        (&[&good, "--program", &out], 0, ""),
        (&["there-is-none.csg"], 1, "there-is-none.csg"),
        (&[&good, "--program", "there/is/no/folder.scene"], 1, "folder.scene"),
        (&[&good, "--port", "there-is-no-such-port"], 1, "there-is-no-such-port"),
        (&[&good, "--number", "f16"], 2, "f32 or i16f16"),
        (&[&wrong], 3, ""),
        (&[&far, "--program", &out, "--number", "i16f16"], 3, "--scale 0.02"),
        (&[&surface], 4, "line 2"),
    ];
    for (arguments, code, text) in cases {
        let output = run(arguments)?;
        let said = String::from_utf8_lossy(if code == 0 { &output.stdout } else { &output.stderr });
        assert_eq!(output.status.code(), Some(code), "{arguments:?}: {said}");
        assert!(said.contains(text), "{arguments:?}: {said}");
    }
    assert!(
        run(&[&far, "--program", &out, "--number", "i16f16", "--scale", "0.02"])?.status.success()
    );
    Ok(())
}

#[test]
fn files_are_what_a_device_reads() -> Result<(), Box<dyn Error>> {
    let hinge = folder().join("hinge.csg").to_string_lossy().into_owned();
    let [scene, rust] = ["hinge.scene", "hinge.rs"].map(scratch);
    let [scene_name, rust_name] = [&scene, &rust].map(|path| path.to_string_lossy().into_owned());
    let arguments = ["--program", &scene_name, "--firmware", &rust_name, "--number", "i16f16"];
    let output = run(&[&[hinge.as_str()], &arguments[..]].concat())?;
    assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
    let bytes = fs::read(scene)?;
    assert_eq!(Program::<Leaf<I16F16>, 29>::from_bytes(&bytes)?.part_count(), 29);
    let rust = fs::read_to_string(rust)?;
    assert!(rust.contains("pub type Part = Program<Leaf<I16F16>, 29, 0, 32>;"), "{rust}");
    assert!(rust.contains(&format!("pub static BYTES: [u8; {}]", bytes.len())), "{rust}");
    Ok(())
}

/// What the number type hasn't the digits for is said, with the line. What should help does.
#[test]
fn a_program_that_is_not_its_part_is_warned_of() -> Result<(), Box<dyn Error>> {
    let sheared = "cube(size = [0.1, 0.1, 0.01]);
        multmatrix([[0.01,0.003,0,0],[0,0.01,0.002,0],[0,0,0.01,0],[0,0,0,1]]) {
            minkowski() {
                cube(size = [10, 8, 4]);
                cylinder($fn = 48, h = 1, r1 = 2, r2 = 0);
            }
        }";
    let large = "intersection() {
            cube(size = [10, 10, 10], center = true);
            multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,-1e9],[0,0,0,1]]) { sphere(r = 1e9); }
        }";
    let [sheared, large] = [part("sheared.csg", sheared)?, part("large.csg", large)?];
    let out = scratch("warned.scene").to_string_lossy().into_owned();
    let warning = |options: &[&str]| -> Result<String, std::io::Error> {
        let output = run(&[options, &["--program", &out]].concat())?;
        assert!(output.status.success(), "{output:?}");
        Ok(String::from_utf8_lossy(&output.stderr).into_owned())
    };
    assert_eq!(warning(&[&sheared])?, "");
    let said = warning(&[&sheared, "--number", "i16f16"])?;
    assert!(said.starts_with("warning: line 3: in i16f16, "), "{said}");
    let scale = said.split("--scale ").nth(1).and_then(|rest| rest.split(' ').next());
    let scale = scale.ok_or("nothing helps")?;
    assert_eq!(warning(&[&sheared, "--number", "i16f16", "--scale", scale])?, "");

    let said = warning(&[&large])?;
    assert!(said.starts_with("warning: line 3: in f32, "), "{said}");
    Ok(())
}

#[test]
fn the_help_fits_a_terminal() -> Result<(), Box<dyn Error>> {
    let help = String::from_utf8(run(&["--help"])?.stdout)?;
    for option in ["--program", "--firmware", "--port", "--report", "--scale", "Exit codes"] {
        assert!(help.contains(option), "{option}");
    }
    let wide: Vec<&str> = help.lines().filter(|line| line.chars().count() > 80).collect();
    assert!(wide.is_empty(), "{wide:?}");
    Ok(())
}
