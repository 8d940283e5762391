//! From a file to a picture of the example `stream`: `--program` writes what `stream --scene` renders.

#[path = "../../examples/scene/mod.rs"]
mod scene_of_examples;
mod support;

use scancsg::geom::OrthographicRays;
use scancsg::program::Program;
use scancsg::render::{Gray8, Lambert, Orthographic, Picture, RowSource, Size};
use scancsg::scalar::I16F16;
use scancsg::solid::{Scan, Solid};
use scancsg_scad::program::Leaf;
use scancsg_scad::scene::Scene as Modelled;
use scene_of_examples::Scene;
use scene_of_examples::fit::Fit;
use std::error::Error;
use std::fs::{self, File};
use std::io::BufReader;
use std::path::{Path, PathBuf};
use std::process::Command;
use support::reference::folder;

const SIZE: [u16; 2] = [160, 120];

/// No pixel of a program is more levels off what the part itself looks like.
const LEVELS: u8 = 2;

/// The example, which is built here if it isn't there.
fn stream() -> Result<PathBuf, Box<dyn Error>> {
    let command = Path::new(env!("CARGO_BIN_EXE_scancsg-scad"));
    let mut build = Command::new(env!("CARGO"));
    build.args(["build", "--quiet", "--package", "examples", "--example", "stream"]);
    let folder = command.parent().ok_or("no folder")?;
    if folder.ends_with("release") {
        build.arg("--release");
    }
    assert!(build.current_dir(env!("CARGO_MANIFEST_DIR")).status()?.success());
    Ok(folder.join("examples/stream"))
}

/// The picture of a part with the camera and the light of the example.
fn picture<S, T>(part: &T, fit: &Fit<S>) -> Result<Vec<u8>, Box<dyn Error>>
where
    S: Scene,
    T: Solid<Scalar = S> + Scan<OrthographicRays<S>>,
{
    let [width, height] = SIZE;
    let camera: Orthographic<S> = fit.orthographic(None)?;
    let light = Lambert::new(Fit::<S>::to_light(), S::hundredths(15))?;
    let mut picture = Picture::new(part, &camera, Size::new(width, height)?, light, Gray8(0));
    let mut row = vec![Gray8(0); width.into()];
    let mut levels = Vec::new();
    for y in 0..height {
        picture.render(y, &mut row)?;
        levels.extend(row.iter().map(|pixel| pixel.0));
    }
    Ok(levels)
}

fn levels(path: &Path) -> Result<Vec<u8>, Box<dyn Error>> {
    let mut reader = png::Decoder::new(BufReader::new(File::open(path)?)).read_info()?;
    let mut pixels = vec![0; reader.output_buffer_size().ok_or("too large")?];
    reader.next_frame(&mut pixels)?;
    Ok(pixels)
}

fn check<S: Scene>(number: &str, stream: &Path) -> Result<(), Box<dyn Error>>
where
    Leaf<S>: Scan<OrthographicRays<S>, Scalar = S>,
{
    let scratch = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let mut count = 0;
    for entry in fs::read_dir(folder())? {
        let path = entry?.path();
        if path.extension().is_none_or(|extension| extension != "csg") {
            continue;
        }
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let file = scratch.join(format!("stream-{name}-{number}.scene"));
        let out = file.with_extension("png");
        let made = Command::new(env!("CARGO_BIN_EXE_scancsg-scad"))
            .arg(&path)
            .args(["--number", number, "--program"])
            .arg(&file)
            .output()?;
        assert!(made.status.success() && made.stderr.is_empty(), "{made:?}");
        let [width, height] = SIZE;
        let shown = Command::new(stream)
            .args(["--size", &format!("{width}x{height}"), "--scene"])
            .arg(&file)
            .arg("--out")
            .arg(&out)
            .output()?;
        assert!(shown.status.success(), "{name} in {number}: {shown:?}");
        let streamed = levels(&out)?;

        let program = Program::<Leaf<S>, 128, 8>::from_bytes(&fs::read(&file)?)?;
        let fit = Fit::of(&program.bounds()).ok_or("it has no end")?;
        assert!(streamed == picture(&program, &fit)?, "{name} in {number}: another picture");

        let part: Modelled = support::scene(&fs::read_to_string(&path)?)?;
        let fit = Fit { middle: fit.middle.map(S::to_f64), radius: fit.radius.to_f64() };
        let own = picture(&part, &fit)?;
        let off = streamed.iter().zip(&own).filter(|(a, b)| a.abs_diff(**b) > LEVELS).count();
        assert_eq!((off, streamed.len()), (0, own.len()), "{name} in {number}");
        assert!(own.iter().filter(|level| **level > 0).count() > 1_000, "{name} is too small");
        count += 1;
    }
    assert_eq!(count, 12);
    Ok(())
}

#[test]
fn what_is_written_is_rendered_by_the_example() -> Result<(), Box<dyn Error>> {
    let stream = stream()?;
    check::<f32>("f32", &stream)?;
    check::<I16F16>("i16f16", &stream)
}
