//! Pictures of ten solids of each kind, that cover about as many pixels: what a kind of solid costs.
//!
//! ```sh
//! cargo bench --package bench --bench ten              # nanoseconds a pixel, of each kind
//! cargo bench --package bench --bench ten -- box 3     # three pictures of boxes, for callgrind
//! ```
//!
//! Instructions a pixel are those of three pictures less those of one, divided by two and by 19,200:
//! `valgrind --tool=callgrind` in front of the built program, with the same arguments.

#[path = "timing.rs"]
#[allow(dead_code)] // other benches compare
mod timing;

use scancsg::geom::{AffineMap, Axis, OrthographicRays, Vec3, vec3};
use scancsg::render::{Gray8, Lambert, Orthographic, Picture, Size};
use scancsg::scalar::{I16F16, Scalar};
use scancsg::solid::{Cone, Cuboid, Cylinder, Polyhedron, Scaled, Scan, Solid, Sphere, Torus};
use std::error::Error;
use std::hint::black_box;
use timing::{Pass, Rounds};

const COUNT: usize = 10;
const SIZE: [u16; 2] = [160, 120];
const KINDS: [&str; 6] = ["cylinder", "box", "cone", "polyhedron", "ellipsoid", "torus"];

type Made<T> = Result<T, Box<dyn Error>>;

/// Renders as many pictures as the argument says, and counts the pixels that see a solid.
type Scene = Box<dyn Fn(u32) -> usize>;

/// So many hundredths.
fn n<S: Scalar>(hundredths: i32) -> S {
    S::from_ratio(hundredths, 100)
}

/// Where the solids are: on a bent row through the picture, some before others.
fn place<S: Scalar>(index: usize) -> Vec3<S> {
    let i = index as i32;
    vec3(n(44 * i - 198), n((i * i * 37 + 60 * i) % 240 - 120), n((i * 71) % 160 - 80))
}

fn ten<S: Scalar, T: Copy>(make: impl Fn(Vec3<S>) -> Made<T>) -> Made<[T; COUNT]> {
    let mut all = [make(place(0))?; COUNT];
    for (index, solid) in all.iter_mut().enumerate() {
        *solid = make(place(index))?;
    }
    Ok(all)
}

/// Ten solids of one kind, in sizes that cover about as many pixels.
fn pictures<S: Scalar>(kind: &str) -> Made<Scene> {
    let half = n::<S>(match kind {
        "cylinder" => 50,
        "cone" => 62,
        _ => 44,
    });
    let ends = |middle: S| [middle.minus(half), middle.plus(half)];
    let around = move |c: Vec3<S>| [c - vec3(half, half, half), c + vec3(half, half, half)];
    match kind {
        "cylinder" => of(ten(|c: Vec3<S>| {
            let [low, high] = ends(c.y);
            Ok(Cylinder::along(Axis::Y, [c.x, c.z], half, low, high)?)
        })?),
        "box" => of(ten(move |c| {
            let [low, high] = around(c);
            Ok(Cuboid::between(low, high)?)
        })?),
        "cone" => of(ten(|c: Vec3<S>| {
            let [low, high] = ends(c.y);
            Ok(Cone::along(Axis::Y, [c.x, c.z], [half, n(25)], low, high)?)
        })?),
        "polyhedron" => of(ten(move |c| {
            let [low, high] = around(c);
            let corner = |i: usize| {
                let pick = |bit, low, high| if i & bit == 0 { low } else { high };
                // Narrower on top.
                let narrow = if i & 2 == 0 { S::ZERO } else { n(10) };
                let x = pick(1, low.x.plus(narrow), high.x.minus(narrow));
                vec3(x, pick(2, low.y, high.y), pick(4, low.z, high.z))
            };
            Ok(Polyhedron::<S, 6>::with_corners(std::array::from_fn(corner))?)
        })?),
        "ellipsoid" => of(ten(|c: Vec3<S>| {
            let [x, y, z] = [n(62), n(62), n(40)];
            let columns = [vec3(x, n(0), n(0)), vec3(n(0), y, n(0)), vec3(n(0), n(0), z)];
            let ball = Sphere::around(Vec3::ZERO, S::ONE)?;
            Ok(Scaled::new(ball, AffineMap::with_columns(columns, c)?))
        })?),
        "torus" => of(ten(|c: Vec3<S>| Ok(Torus::along(Axis::Y, c, n(47), n(20))?))?),
        other => Err(format!("{other} is none of {}", KINDS.join(", ")).into()),
    }
}

fn of<S, T>(solids: T) -> Made<Scene>
where
    S: Scalar,
    T: Solid<Scalar = S> + Scan<OrthographicRays<S>> + 'static,
{
    let eye = vec3(n(200), n(300), n(400));
    let camera = Orthographic::look_at(eye, Vec3::ZERO, vec3(n(0), n(100), n(0)), n(440))?;
    let light = Lambert::new(vec3(n(25), n(85), n(45)), n(15))?;
    let size = Size::new(SIZE[0], SIZE[1])?;
    Ok(Box::new(move |frames| {
        let mut row = [Gray8(0); SIZE[0] as usize];
        let mut covered = 0;
        for _ in 0..frames {
            let mut picture = Picture::new(black_box(&solids), &camera, size, light, Gray8(0));
            for y in 0..SIZE[1] {
                let _ = picture.scanline(y).and_then(|mut line| line.render(&mut row));
                covered += black_box(&row).iter().filter(|pixel| pixel.0 > 0).count();
            }
        }
        covered
    }))
}

fn main() -> Made<()> {
    let mut words = std::env::args().skip(1).filter(|word| word != "--bench");
    if let Some(kind) = words.next() {
        let frames = words.next().map_or(Ok(1), |count| count.parse())?;
        println!("{} pixels see {kind}s", pictures::<f32>(&kind)?(frames));
        return Ok(());
    }
    println!("{:<12}{:>12}{:>12}{:>12}", "ten of", "f32, ns", "I16F16, ns", "covered");
    let pixels = usize::from(SIZE[0]) * usize::from(SIZE[1]);
    for kind in KINDS {
        let covered = pictures::<f32>(kind)?(1) as f64 / pixels as f64;
        let pass = |run: Scene| -> (Pass, usize) {
            let once = move || {
                run(1);
            };
            (Box::new(once), pixels)
        };
        let passes = vec![pass(pictures::<f32>(kind)?), pass(pictures::<I16F16>(kind)?)];
        let times = Rounds::of(passes, 9);
        let [float, fixed] = [0, 1].map(|pass| times.nanoseconds(pass));
        println!("{kind:<12}{float:>12.1}{fixed:>12.1}{:>11.1} %", 100.0 * covered);
    }
    Ok(())
}
