//! A robot's arm of two links that turns every frame, while a ring of single rays, a lidar, meets it.
//!
//! The arm is a [`Program`]: its parts stand in two frames, one for each link. To turn a joint is to set
//! a pose. As firmware it says through the console what the lidar measures; a host shows pictures
//! besides.

#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../board/mod.rs"]
mod board;

use core::f64::consts::{FRAC_PI_2, TAU};
use scancsg::Error;
use scancsg::geom::{Axis, Pose, Ray, Vec3, vec3};
use scancsg::program::Program;
use scancsg::scalar::{Number as _, Real, Scalar};
use scancsg::solid::{Cuboid, Cylinder, Sphere};
use scancsg::span::SpanList;

#[cfg(any(number = "f32", all(target_abi = "eabihf", not(number = "i16f16"))))]
type Number = f32;
#[cfg(not(any(number = "f32", all(target_abi = "eabihf", not(number = "i16f16")))))]
type Number = scancsg::scalar::I16F16;

scancsg::leaves! {
    /// What the arm is made of.
    pub enum Part<S> {
        Cylinder(Cylinder<S>),
        Cuboid(Cuboid<S>),
        Sphere(Sphere<S>),
    }
}

type Arm = Program<Part<Number>, 8, 2>;

/// The lidar's rays in a turn, and the frames of a turn of the arm.
const RAYS: i32 = 24;
const FRAMES: i32 = 12;
/// The number of a link's frame.
const UPPER: usize = 0;
const LOWER: usize = 1;

fn n(hundredths: i32) -> Number {
    Number::from_ratio(hundredths, 100)
}

/// An angle of so many parts of a whole turn.
fn angle(part: i32, of: i32) -> Number {
    Number::from_f64(TAU * f64::from(part) / f64::from(of))
}

/// The arm, stretched out along x: a drilled bar for each link, balls for its joints, and a cup at its end.
fn arm() -> Result<Arm, Error> {
    let rod = |x, radius, low, high| {
        Cylinder::along(Axis::Z, [n(x), n(0)], n(radius), n(low), n(high)).map(Part::Cylinder)
    };
    let bar = |from, to| {
        Cuboid::between(vec3(n(from), n(-20), n(-15)), vec3(n(to), n(20), n(15))).map(Part::Cuboid)
    };
    let ball = Part::Sphere(Sphere::around(Vec3::ZERO, n(30))?);
    let mut arm = Arm::new(bar(0, 150)?);
    arm.push(rod(75, 12, -50, 50)?)?;
    arm.subtract(1)?;
    arm.push(ball)?;
    let lower = arm.push(bar(0, 120)?)?;
    arm.push(ball)?;
    arm.push(rod(140, 30, -30, 30)?)?;
    arm.push(rod(140, 20, -10, 50)?)?;
    arm.subtract(1)?;
    arm.add_pose(Pose::IDENTITY)?;
    arm.add_pose(Pose::IDENTITY)?;
    for part in 0..arm.part_count() {
        arm.place(part, Some(if part < lower { UPPER } else { LOWER }))?;
    }
    Ok(arm)
}

/// Turns both joints: the shoulder once in all frames, the elbow to and fro.
fn turn(arm: &mut Arm, frame: i32) -> Result<(), Error> {
    let shoulder = Pose::<Number>::rotation_z(angle(frame, FRAMES))?;
    let (sway, _) = angle(frame, FRAMES).wide().sin_cos();
    let bend = Number::from_wide(sway * Number::from_f64(FRAC_PI_2).wide());
    // The elbow bends in its own frame, then is carried to the upper link's end, then turns with it.
    let carried = Pose::translation(vec3(n(150), n(0), n(0)))?;
    let elbow = Pose::rotation_z(bend)?.then(&carried)?.then(&shoulder)?;
    arm.set_pose(UPPER, shoulder)?;
    Ok(arm.set_pose(LOWER, elbow)?)
}

/// What the lidar measures: a ring of rays in the arm's plane, from beside the arm.
fn scan(arm: &Arm, mut measured: impl FnMut(Option<Number>)) -> Result<(), Error> {
    let mut list = SpanList::<Number, 32>::new();
    for index in 0..RAYS {
        let (sin, cos) = angle(index, RAYS).wide().sin_cos();
        let way = vec3(Number::from_wide(cos), Number::from_wide(sin), n(0));
        let ray = Ray::new(vec3(n(230), n(230), n(0)), way)?;
        let hit = arm.hit(&ray, &mut list)?;
        measured(hit.map(|hit| hit.t));
    }
    Ok(())
}

/// Turns the arm through all frames, and hands over what each of them looks like.
fn run(mut show: impl FnMut(&Arm, i32) -> Result<(), Error>) -> Result<(), Error> {
    let mut arm = arm()?;
    for frame in 0..FRAMES {
        turn(&mut arm, frame)?;
        show(&arm, frame)?;
    }
    Ok(())
}

#[cfg(target_os = "none")]
#[board::entry]
fn main() -> ! {
    use board::{say, say_number};
    let result = run(|arm, frame| {
        say("frame ");
        say_number(frame as u32);
        say(":");
        // In hundredths.
        scan(arm, |range| {
            say(" ");
            match range {
                Some(range) => say_number((range.to_f64() * 100.0) as u32),
                None => say("-"),
            }
        })?;
        say("\n");
        Ok(())
    });
    if let Err(error) = result {
        say(error.as_str());
    }
    loop {
        board::finish(result.is_ok());
    }
}

#[cfg(not(target_os = "none"))]
fn main() -> Result<(), Error> {
    use scancsg::render::{Gray8, Lambert, Orthographic, Picture, Size};
    run(|arm, frame| {
        let above = vec3(n(0), n(0), n(-100));
        let up = vec3(n(0), n(100), n(0));
        let camera = Orthographic::look_along(above, Vec3::ZERO, up, n(680))?;
        let light = Lambert::new(vec3(n(-30), n(40), n(100)), n(20))?;
        let size = Size::new(60, 60)?;
        let mut picture = Picture::new(arm, &camera, size, light, Gray8(0));
        println!("frame {frame}:");
        // A character is twice as high as it is wide.
        for y in (0..size.height()).step_by(2) {
            let mut row = [Gray8(0); 60];
            picture.scanline(y)?.render(&mut row)?;
            let dot = |pixel: &Gray8| char::from(b" .:-=+*#%@"[usize::from(pixel.0) / 26]);
            println!("{}", row.iter().map(dot).collect::<String>());
        }
        let mut ranges = Vec::new();
        scan(arm, |range| {
            ranges.push(range.map_or("-".to_owned(), |range| format!("{:.2}", range.to_f64())));
        })?;
        println!("{}", ranges.join(" "));
        Ok(())
    })
}
