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
fn arm() -> Result<Arm, &'static str> {
    let rod = |x, radius, low, high| {
        Cylinder::along(Axis::Z, [n(x), n(0)], n(radius), n(low), n(high))
            .map_err(|error| error.as_str())
    };
    let bar = |from, to| {
        Cuboid::between(vec3(n(from), n(-20), n(-15)), vec3(n(to), n(20), n(15)))
            .map_err(|error| error.as_str())
    };
    let ball = Sphere::around(Vec3::ZERO, n(30)).map_err(|error| error.as_str())?;
    let built = || {
        let mut arm = Arm::new(Part::Cuboid(bar(0, 150).ok()?));
        arm.push(Part::Cylinder(rod(75, 12, -50, 50).ok()?)).ok()?;
        arm.subtract(1).ok()?;
        arm.push(Part::Sphere(ball)).ok()?;
        let lower = arm.push(Part::Cuboid(bar(0, 120).ok()?)).ok()?;
        arm.push(Part::Sphere(ball)).ok()?;
        arm.push(Part::Cylinder(rod(140, 30, -30, 30).ok()?)).ok()?;
        arm.push(Part::Cylinder(rod(140, 20, -10, 50).ok()?)).ok()?;
        arm.subtract(1).ok()?;
        arm.add_pose(Pose::IDENTITY).ok()?;
        arm.add_pose(Pose::IDENTITY).ok()?;
        for part in 0..arm.part_count() {
            arm.place(part, Some(if part < lower { UPPER } else { LOWER })).ok()?;
        }
        Some(arm)
    };
    built().ok_or("the arm has more parts than there is room for")
}

/// Turns both joints: the shoulder once in all frames, the elbow to and fro.
fn turn(arm: &mut Arm, frame: i32) -> Result<(), &'static str> {
    let turn = |angle| Pose::<Number>::rotation_z(angle).map_err(|error| error.as_str());
    let shoulder = turn(angle(frame, FRAMES))?;
    let (sway, _) = angle(frame, FRAMES).wide().sin_cos();
    let bend = Number::from_wide(sway * Number::from_f64(FRAC_PI_2).wide());
    // The elbow bends in its own frame, then is carried to the upper link's end, then turns with it.
    let carried = || {
        let elbow = Pose::translation(vec3(n(150), n(0), n(0))).ok()?;
        turn(bend).ok()?.then(&elbow).ok()?.then(&shoulder).ok()
    };
    let elbow = carried().ok_or("the elbow is too far away")?;
    arm.set_pose(UPPER, shoulder).map_err(|error| error.as_str())?;
    arm.set_pose(LOWER, elbow).map_err(|error| error.as_str())
}

/// What the lidar measures: a ring of rays in the arm's plane, from beside the arm.
fn scan(arm: &Arm, mut measured: impl FnMut(Option<Number>)) -> Result<(), &'static str> {
    let mut list = SpanList::<Number, 32>::new();
    for index in 0..RAYS {
        let (sin, cos) = angle(index, RAYS).wide().sin_cos();
        let way = vec3(Number::from_wide(cos), Number::from_wide(sin), n(0));
        let ray = Ray::new(vec3(n(230), n(230), n(0)), way).map_err(|error| error.as_str())?;
        let hit = arm.hit(&ray, &mut list).map_err(|error| error.as_str())?;
        measured(hit.map(|hit| hit.t));
    }
    Ok(())
}

/// Turns the arm through all frames, and hands over what each of them looks like.
fn run(mut show: impl FnMut(&Arm, i32) -> Result<(), &'static str>) -> Result<(), &'static str> {
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
        say(error);
    }
    loop {
        board::finish(result.is_ok());
    }
}

#[cfg(not(target_os = "none"))]
fn main() -> Result<(), &'static str> {
    use scancsg::render::{Gray8, Lambert, Orthographic, Picture, Size};
    run(|arm, frame| {
        let above = vec3(n(0), n(0), n(-100));
        let camera = Orthographic::look_along(above, Vec3::ZERO, vec3(n(0), n(100), n(0)), n(680))
            .map_err(|error| error.as_str())?;
        let light = Lambert::new(vec3(n(-30), n(40), n(100)), n(20));
        let light = light.map_err(|error| error.as_str())?;
        let size = Size::new(60, 60).map_err(|error| error.as_str())?;
        let mut picture = Picture::new(arm, &camera, size, light, Gray8(0));
        println!("frame {frame}:");
        // A character is twice as high as it is wide.
        for y in (0..size.height()).step_by(2) {
            let mut row = [Gray8(0); 60];
            let rendered = picture.scanline(y).and_then(|mut line| line.render(&mut row));
            rendered.map_err(|error| error.as_str())?;
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
