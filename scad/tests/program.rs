//! Parts as programs: what a device reads is the part.

mod support;

use scancsg::geom::OrthographicRays;
use scancsg::inspect::MassProperties;
use scancsg::program::{Coded, Program};
use scancsg::scalar::{I16F16, Number as _, Scalar};
use scancsg::solid::{Bounds, Scan, Solid};
use scancsg::span::SpanList;
use scancsg_scad::map::Map;
use scancsg_scad::picture::{Angles, BACKGROUND, Rgb8, View, render};
use scancsg_scad::program::{FACES, Leaf, NumberType, program};
use scancsg_scad::scene::Scene;
use scancsg_scad::{ErrorKind, Model, lower, parse};
use std::error::Error;
use std::path::PathBuf;
use std::{env, fs};
use support::SIZE;
use support::reference::folder;

const PARTS: usize = 128;
const POSES: usize = 8;
type Read<S> = Program<Leaf<S>, PARTS, POSES>;

/// In parts of all pixels: those whose colour is another one by more than a level or two.
const PIXELS: f64 = 0.000_2;
/// In parts of the volume.
const VOLUME: f64 = 0.000_1;

/// The `.csg` files of a folder: the crate's own parts, or those of `SCAD_PARTS`.
fn parts() -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let from = env::var_os("SCAD_PARTS").map_or_else(folder, PathBuf::from);
    let mut parts = fs::read_dir(from)?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<Result<Vec<_>, _>>()?;
    parts.retain(|path| path.extension().is_some_and(|extension| extension == "csg"));
    parts.sort();
    Ok(parts)
}

fn model(text: &str) -> Result<Model, scancsg_scad::Error> {
    Model::of(lower(&parse(text)?, false)?.tree)
}

fn volume<T: Solid>(part: &T, [low, high]: [[f64; 3]; 2]) -> Result<f64, Box<dyn Error>> {
    let [low, high] = [low, high].map(|corner| corner.map(T::Scalar::from_f64).into());
    let mut list = SpanList::<T::Scalar, 512>::new();
    let mass = MassProperties::of(part, Bounds::Box { low, high }, 40, &mut list)?;
    Ok(mass.volume.to_f64())
}

/// The share of pixels that look another way.
fn off(one: &[Rgb8], other: &[Rgb8]) -> f64 {
    let is_off = |(a, b): (&Rgb8, &Rgb8)| a.0.iter().zip(b.0).any(|(a, b)| a.abs_diff(b) > 2);
    one.iter().zip(other).filter(|pair| is_off(*pair)).count() as f64 / one.len() as f64
}

fn check<S: Scalar>(path: &PathBuf, number: NumberType) -> Result<(), Box<dyn Error>>
where
    Leaf<S>: Scan<OrthographicRays<S>, Scalar = S> + Coded + Solid,
    Read<S>: Sync,
{
    let model = model(&fs::read_to_string(path)?)?;
    let made = program(&model, number, FACES)?;
    let read = Read::<S>::from_bytes(&made.bytes)?;
    assert_eq!((read.part_count(), read.operand_count()), (made.parts, 1));

    let scene = Scene::of(&model)?;
    let view = View::of_all(&scene, Angles::default(), SIZE)?;
    let want = render(&scene, &view, SIZE, BACKGROUND)?;
    let got = render(&read, &view, SIZE, BACKGROUND)?;
    let pixels = off(&got, &want);
    let corners = scene.corners().ok_or("empty")?.map(|corner| corner.to_array());
    let [want, got] = [volume(&scene, corners)?, volume(&read, corners)?];
    let name = path.display();
    println!("{name}: {pixels:.5} of the pixels, {want} {got}");
    if env::var_os("SCAD_PARTS").is_some() {
        return Ok(());
    }
    assert!(pixels <= PIXELS, "{name} in {number}: {pixels} of the pixels");
    assert!((got - want).abs() <= VOLUME * want, "{name} in {number}: {got}, not {want}");
    Ok(())
}

#[test]
fn programs_in_f32_are_the_parts() -> Result<(), Box<dyn Error>> {
    parts()?.iter().try_for_each(|path| check::<f32>(path, NumberType::F32))
}

#[test]
fn programs_in_fixed_point_are_the_parts() -> Result<(), Box<dyn Error>> {
    parts()?.iter().try_for_each(|path| check::<I16F16>(path, NumberType::I16F16))
}

#[test]
fn what_has_no_room_is_an_error_that_says_what_helps() -> Result<(), Box<dyn Error>> {
    let far = "cube(size = [20000, 1, 1]);";
    let Err(error) = program(&model(far)?, NumberType::I16F16, FACES) else {
        return Err("it fits".into());
    };
    assert!(
        matches!(&error.kind, ErrorKind::Limit(text) if text.contains("--scale 0.2")),
        "{error}"
    );
    assert_eq!(error.line, 1);
    let mut smaller = lower(&parse(far)?, false)?.tree;
    smaller.place(&Map::scaling(0.2));
    assert!(program(&Model::of(smaller)?, NumberType::I16F16, FACES).is_ok());
    assert!(program(&model(far)?, NumberType::F32, FACES).is_ok());

    let thin = "cylinder(h = 5, r1 = 1e-7, r2 = 1e-7);";
    let Err(error) = program(&model(thin)?, NumberType::I16F16, FACES) else {
        return Err("it fits".into());
    };
    assert!(error.to_string().contains("too small"), "{error}");

    // 3,000 boxes have more than 65,535 bytes.
    let many: String =
        (0..3_000).map(|i| format!("multmatrix([[1,0,0,{i}],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) {{ cube(size = [0.5, 1, 1]); }}\n")).collect();
    let Err(error) = program(&model(&many)?, NumberType::F32, FACES) else {
        return Err("it fits".into());
    };
    assert!(error.to_string().contains("more than 65535 bytes"), "{error}");
    assert!(
        program(&model("difference() { cube(size = [1, 1, 0]); }")?, NumberType::F32, FACES)
            .is_err()
    );
    Ok(())
}

/// What is turned alike stands in one pose, and a polyhedron of many faces is several parts.
#[test]
fn poses_and_parts_are_few() -> Result<(), Box<dyn Error>> {
    let turned = "multmatrix([[0.8,-0.6,0,0],[0.6,0.8,0,0],[0,0,1,0],[0,0,0,1]])";
    let text = format!(
        "{turned} {{ cube(size = [1, 1, 1]); }} {turned} {{ cube(size = [3, 1, 1]); }} cube(size = [1, 2, 3]);"
    );
    let made = program(&model(&text)?, NumberType::F32, FACES)?;
    assert_eq!((made.parts, made.poses), (3, 1));
    // 30 sides and two ends: three of twelve faces at most.
    let corners: Vec<String> = (0..30)
        .map(|i| (f64::from(i) * std::f64::consts::TAU / 30.0).sin_cos())
        .map(|(sin, cos)| format!("[{cos}, {sin}]"))
        .collect();
    let text =
        format!("linear_extrude(height = 2) {{ polygon(points = [{}]); }}", corners.join(", "));
    let made = program(&model(&text)?, NumberType::F32, FACES)?;
    assert_eq!((made.parts, made.faces), (3, 11));
    let few = program(&model(&text)?, NumberType::F32, 8)?;
    assert_eq!((few.parts, few.faces), (4, 8));
    let read = Read::<f32>::from_bytes(&made.bytes)?;
    let exact = 15.0 * (std::f64::consts::TAU / 30.0).sin() * 2.0;
    let got = volume(&read, [[-1.0, -1.0, 0.0], [1.0, 1.0, 2.0]])?;
    assert!((got - exact).abs() < 0.003 * exact, "{got}, not {exact}");
    Ok(())
}
