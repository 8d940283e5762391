//! The command line.

use crate::console::{say, working};
use crate::host::image;
use crate::{port, report};
use clap::Parser;
use scancsg_scad::map::Map;
use scancsg_scad::picture::{Angles, BACKGROUND, View, render, write_png};
use scancsg_scad::program::{Bytes, MOST_SPANS, NumberType, deviation, firmware, program};
use scancsg_scad::scene::Scene;
use scancsg_scad::{Error, ErrorKind, Lowered, Model, lower, parse, read, rust};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Reads a part of OpenSCAD's and shows, measures or checks it.
///
/// Without an option, it says only whether the part is modelled.
#[derive(Debug, Parser)]
#[command(
    version,
    max_term_width = 80,
    after_help = "\
Exit codes: 0 it worked; 1 a file can't be read or written; 2 wrong options;
3 the file has an error, or the part doesn't fit; 4 something isn't modelled
(--skip goes on without it).

Modelled: cube, sphere, cylinder, convex polyhedron, circle, square, polygon,
text, group, union, difference, intersection, multmatrix, resize, color, render,
linear_extrude without twist, rotate_extrude, offset, hull, minkowski of unions
of convex solids."
)]
pub struct Options {
    /// The part: a .csg file, or a .scad file where `openscad` is installed.
    part: PathBuf,
    /// Writes a picture: a PNG file.
    #[arg(long, short, value_name = "PNG")]
    out: Option<PathBuf>,
    /// The picture's width and height in pixels.
    #[arg(long, value_name = "WxH", default_value = "640x480", value_parser = size)]
    size: [u16; 2],
    /// From where: turns about x, y and z in degrees, as in OpenSCAD. 0,0,0 is from above, 90,0,0 from the front.
    #[arg(long, value_name = "X,Y,Z", default_value = "55,0,25", value_parser = angles, allow_hyphen_values = true)]
    camera: Angles,
    /// Writes a constant of Rust: the part in typed solids, in `f32`.
    #[arg(long, value_name = "RS")]
    rust: Option<PathBuf>,
    /// Writes the part as a program: bytes that a device reads.
    #[arg(long, value_name = "SCENE")]
    program: Option<PathBuf>,
    /// Writes Rust for firmware: room for the program, its bytes, and a camera.
    #[arg(long, value_name = "RS")]
    firmware: Option<PathBuf>,
    /// The number type of the program: f32, or i16f16 for processors without floating point.
    #[arg(long, value_name = "TYPE", default_value_t, value_parser = number)]
    number: NumberType,
    /// The most faces of a polyhedron of the program. One with more is an
    /// intersection of several. The example `device` takes 8.
    #[arg(long, value_name = "N", default_value_t = 12, value_parser = clap::value_parser!(u8).range(4..=12))]
    faces: u8,
    /// Makes the part so many times as large.
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, value_parser = factor)]
    scale: f64,
    /// Sends the part to a device, in the device's number type, and receives
    /// the picture that answers it. --out saves that one.
    #[arg(long, value_name = "DEVICE")]
    port: Option<String>,
    /// Bits per second of the line to the device.
    #[arg(long, value_name = "BAUD", default_value_t = 115_200, requires = "port")]
    baud: u32,
    /// Goes on without what isn't modelled, and says what that is.
    #[arg(long)]
    skip: bool,
    /// Says what the part is made of and what it measures.
    #[arg(long)]
    report: bool,
    /// How many pixels a side the measuring has: twice as many, a third of the error.
    #[arg(long, value_name = "N", default_value_t = 400, value_parser = clap::value_parser!(u16).range(10..=4000))]
    pixels: u16,
}

fn size(text: &str) -> Result<[u16; 2], String> {
    let parts: Option<Vec<u16>> =
        text.split('x').map(|part| part.parse().ok().filter(|n| *n > 0)).collect();
    parts.and_then(|parts| parts.try_into().ok()).ok_or_else(|| "a size is written 640x480".into())
}

fn angles(text: &str) -> Result<Angles, String> {
    let parts: Option<Vec<f64>> = text.split(',').map(|part| part.trim().parse().ok()).collect();
    let parts: Option<[f64; 3]> = parts.and_then(|parts| parts.try_into().ok());
    parts.map(Angles).ok_or_else(|| "three angles are written 55,0,25".into())
}

fn number(text: &str) -> Result<NumberType, String> {
    let found = NumberType::ALL.into_iter().find(|number| number.name() == text);
    found.ok_or_else(|| "a number type is f32 or i16f16".into())
}

fn factor(text: &str) -> Result<f64, String> {
    let factor = text.parse().ok().filter(|factor| (1e-9..=1e9).contains(factor));
    factor.ok_or_else(|| "a factor is from 1e-9 to 1e9".into())
}

/// What the command does. An error comes with the exit code.
pub fn run(options: &Options) -> Result<(), (u8, Error)> {
    act(options).map_err(|error| {
        let code = match error.kind {
            ErrorKind::File(_) => 1,
            ErrorKind::NotModelled(_) => 4,
            _ => 3,
        };
        (code, error)
    })
}

fn act(options: &Options) -> Result<(), Error> {
    let began = Instant::now();
    let text = working("reading", || read(&options.part))?;
    let Lowered { mut tree, skipped } =
        working("modelling", || lower(&parse(&text)?, options.skip))?;
    for error in &skipped {
        eprintln!("left out: {error}");
    }
    if options.scale != 1.0 {
        tree.place(&Map::scaling(options.scale));
    }
    let counts = tree.counts();
    let model = Model::of(tree)?;
    let scene = Scene::of(&model)?;
    let modelled = began.elapsed();
    if let Some(device) = &options.port {
        let make = |number| made(&model, number, options);
        let frame = port::picture(device, options.baud, make)?;
        let [width, height] = [frame.header.width, frame.header.height];
        say!("{width} x {height} pixels from {device} in {:.1?}", began.elapsed());
        if let Some(path) = &options.out {
            save(path, &image::png(&frame).map_err(Error::file)?)?;
        }
    } else if let Some(path) = &options.out {
        let view = View::of_all(&scene, options.camera, options.size)?;
        let pixels = working("rendering", || render(&scene, &view, options.size, BACKGROUND))?;
        write_png(path, options.size, &pixels)?;
        say!("{} in {:.0?}", path.display(), began.elapsed());
    }
    if let Some(path) = &options.rust {
        save(path, rust(&model, "PART")?.as_bytes())?;
    }
    let is_wanted = options.report || options.program.is_some() || options.firmware.is_some();
    let made = is_wanted.then(|| made(&model, options.number, options));
    if let (Some(path), Some(made)) = (&options.program, &made) {
        save(path, &made.clone()?.bytes)?;
    }
    if let (Some(path), Some(made)) = (&options.firmware, &made) {
        let (made, corners) = (made.clone()?, scene.corners());
        let spans = corners.map(|corners| working("tracing", || made.spans(corners)));
        let spans = spans.transpose()?.flatten().unwrap_or(MOST_SPANS);
        let view = View::of_all(&scene, options.camera, options.size)?;
        save(path, firmware(&made, &view, spans).as_bytes())?;
    }
    let is_written = [&options.out, &options.rust, &options.program, &options.firmware]
        .iter()
        .any(|path| path.is_some())
        || options.port.is_some();
    if options.report {
        report::part(counts, &model, &scene, options.pixels, modelled);
        match made.transpose() {
            Ok(made) => {
                made.map_or(Ok(()), |made| report::program(&made, &scene, options.camera))?
            }
            Err(error) => say!("program    none in {}: {error}", options.number),
        }
    } else if !is_written {
        say!("modelled: {} solids, {} operators", counts.solids, counts.operators);
    }
    Ok(())
}

/// The part as a program. Says so if the number type hasn't the digits for it.
fn made(model: &Model, number: NumberType, options: &Options) -> Result<Bytes, Error> {
    let faces = options.faces.into();
    let made = working("writing", || program(model, number, faces))?;
    match working("comparing", || deviation(model, number, faces, options.camera)) {
        Ok(deviation) => {
            if let Some(warning) = deviation.warning() {
                eprintln!("warning: {warning}");
            }
        }
        Err(error) => eprintln!("warning: the program isn't compared with the part: {error}"),
    }
    Ok(made)
}

fn save(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    fs::write(path, bytes).map_err(|error| Error::file(format!("{}: {error}", path.display())))
}
