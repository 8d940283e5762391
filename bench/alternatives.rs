//! The same picture by other means: `tee` as a signed distance field that is sphere-traced, and how many
//! triangles a mesh of it would have.
//!
//! `cargo bench --package bench --bench alternatives`

#![allow(clippy::unwrap_used)]

#[path = "../examples/scene/mod.rs"]
mod scene;
#[path = "timing.rs"]
#[allow(dead_code)] // of what tables of several methods need
mod timing;

use scancsg::geom::{RayRow, Rays, Vec3, vec3};
use scancsg::render::{Camera, Gray8, Lambert, Picture, Size};
use scene::Scene;
use std::cell::Cell;
use timing::{Pass, Rounds};

const WIDTH: u16 = 160;
const HEIGHT: u16 = 120;
const PIXELS: usize = WIDTH as usize * HEIGHT as usize;

/// A cylinder of `tee`: its axis, two coordinates of the axis, the radius, and its ends along the axis.
type Tube = (usize, [f32; 2], f32, [f32; 2]);

const BODY: [Tube; 4] = [
    (0, [0.0, 0.0], 1.0, [-2.0, 2.0]),
    (0, [0.0, 0.0], 1.6, [-2.0, -1.7]),
    (0, [0.0, 0.0], 1.6, [1.7, 2.0]),
    (1, [0.0, 0.0], 0.8, [0.0, 2.0]),
];
const BORES: [Tube; 6] = [
    (0, [0.0, 0.0], 0.7, [-3.0, 3.0]),
    (1, [0.0, 0.0], 0.5, [0.0, 3.0]),
    (0, [1.3, 0.0], 0.15, [-3.0, 3.0]),
    (0, [-1.3, 0.0], 0.15, [-3.0, 3.0]),
    (0, [0.0, 1.3], 0.15, [-3.0, 3.0]),
    (0, [0.0, -1.3], 0.15, [-3.0, 3.0]),
];

/// The distance of a point from a cylinder: that of a rectangle in the plane of radius and axis.
/// (J. C. Hart, Sphere tracing, The Visual Computer 12, 1996.)
fn tube(&(axis, [u0, v0], radius, [low, high]): &Tube, point: [f32; 3]) -> f32 {
    let along = point[axis];
    let (u, v) =
        if axis == 0 { (point[1] - u0, point[2] - v0) } else { (point[0] - u0, point[2] - v0) };
    let beside = (u * u + v * v).sqrt() - radius;
    let beyond = (low - along).max(along - high);
    let outside = (beside.max(0.0), beyond.max(0.0));
    beside.max(beyond).min(0.0) + (outside.0 * outside.0 + outside.1 * outside.1).sqrt()
}

/// The distance from the part: a bound where solids are cut, as usual.
fn distance(point: [f32; 3]) -> f32 {
    let nearest = |tubes: &[Tube]| tubes.iter().map(|t| tube(t, point)).fold(f32::MAX, f32::min);
    nearest(&BODY).max(-nearest(&BORES))
}

/// A sphere-traced picture: the level of each pixel, and how often the distance was asked.
struct Traced {
    pixels: Vec<Gray8>,
    questions: usize,
}

/// Steps end within `near` of the surface. More steps than 256 see nothing.
fn sphere_traced(near: f32) -> Traced {
    let rays = <f32 as Scene>::orthographic().unwrap().rays(Size::new(WIDTH, HEIGHT).unwrap());
    let light = f32::TO_LIGHT.normalized().unwrap();
    let questions = Cell::new(0);
    let ask = |point: Vec3<f32>| {
        questions.set(questions.get() + 1);
        distance([point.x, point.y, point.z])
    };
    let mut pixels = Vec::with_capacity(PIXELS);
    for y in 0..i32::from(HEIGHT) {
        let row = rays.row(2 * y + 1 - i32::from(HEIGHT));
        for x in 0..i32::from(WIDTH) {
            let line = row.line(2 * x + 1 - i32::from(WIDTH));
            // The part is inside of a ball of radius 2.8.
            let (mut t, mut level) = (-2.8, 0.0);
            for _ in 0..256 {
                let point = line.at(t);
                let step = ask(point);
                if step < near {
                    let slope = |d: Vec3<f32>| ask(point + d) - ask(point - d);
                    let h = 1e-3;
                    let normal = vec3(
                        slope(vec3(h, 0.0, 0.0)),
                        slope(vec3(0.0, h, 0.0)),
                        slope(vec3(0.0, 0.0, h)),
                    );
                    let cosine = normal.normalized().map_or(0.0, |normal| normal.dot(light));
                    level = 0.15 + 0.85 * cosine.max(0.0);
                    break;
                }
                t += step;
                if t > 2.8 {
                    break;
                }
            }
            pixels.push(Gray8((level * 255.0 + 0.5) as u8));
        }
    }
    Traced { pixels, questions: questions.get() }
}

fn cast() -> Vec<Gray8> {
    let camera = <f32 as Scene>::orthographic().unwrap();
    let light = Lambert::new(f32::TO_LIGHT, 0.15).unwrap();
    let size = Size::new(WIDTH, HEIGHT).unwrap();
    let part = <f32 as Scene>::TEE;
    let mut picture = Picture::new(&part, &camera, size, light, Gray8(0));
    let mut pixels = vec![Gray8(0); PIXELS];
    for (y, row) in (0..).zip(pixels.chunks_exact_mut(WIDTH.into())) {
        picture.scanline(y).unwrap().render(row).unwrap();
    }
    pixels
}

/// Triangles of the part's cylinders, without what booleans add where they cut each other: two for each
/// facet of a wall, and as many less two for each end.
fn triangles(facets: usize) -> usize {
    (BODY.len() + BORES.len()) * (2 * facets + 2 * (facets - 2))
}

fn main() {
    const NEAR: [f32; 3] = [1e-2, 1e-3, 1e-4];
    let casting: Pass = Box::new(|| drop(std::hint::black_box(cast())));
    let tracing = NEAR.map(|near| -> Pass {
        Box::new(move || drop(std::hint::black_box(sphere_traced(near).pixels)))
    });
    let passes = [casting].into_iter().chain(tracing).map(|pass| (pass, PIXELS)).collect();
    let times = Rounds::of(passes, 5);
    let exact = cast();
    println!("| `tee`, 160x120, f32 | ns a pixel | times | distances a pixel | wrong pixels |");
    println!("|---|---:|---:|---:|---:|");
    println!("| cast by spans | {:.1} | 1 | – | – |", times.nanoseconds(0));
    for (pass, near) in (1..).zip(NEAR) {
        let Traced { pixels, questions } = sphere_traced(near);
        let wrong = exact.iter().zip(&pixels).filter(|(a, b)| a.0.abs_diff(b.0) > 8).count();
        println!(
            "| sphere-traced to {near:e} | {:.1} | {:.0} | {:.1} | {:.2} % |",
            times.nanoseconds(pass),
            times.ratio(pass, 0),
            questions as f64 / PIXELS as f64,
            100.0 * wrong as f64 / PIXELS as f64,
        );
    }
    println!("\n| chord error of a flange, in pixels | facets of a circle | triangles, at least |");
    println!("|---|---:|---:|");
    for error in [1.0, 0.5, 0.25_f64] {
        // The flange has a radius of 1.6, and 120 pixels show 4.4 units.
        let pixels = 1.6 * 120.0 / 4.4;
        let facets = (std::f64::consts::PI / (1.0 - error / pixels).acos()).ceil() as usize;
        println!("| {error} | {facets} | {} |", triangles(facets));
    }
}
