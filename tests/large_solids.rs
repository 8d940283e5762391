//! Solids as large as formats with few fraction bits allow, seen from within and from beside: pictures against
//! the same in `f64`. Squares of such lengths leave the range of the numbers that set up a picture.

#![allow(clippy::unwrap_used)]

use fixed::FixedI32;
use fixed::types::extra::{U8, U10, U12, U16};
use scancsg::geom::PerspectiveRays;
use scancsg::geom::{Axis, Vec3};
use scancsg::render::{Gray8, Lambert, Perspective, Picture, Size};
use scancsg::scalar::{FixedPoint, Scalar};
use scancsg::scan::Scan;
use scancsg::solid::{ByLine, Cone, Cuboid, Cylinder, Solid};
use testkit::random::Random;

/// So many pixels across and down are looked at, each `STEP` from the next. One of them is the middle, whose ray
/// may run along an axis.
const COLUMNS: u16 = 24;
const ROWS: u16 = 16;
const STEP: u16 = 12;

/// A solid and an eye, as numbers that the format holds.
#[derive(Debug, Clone, Copy)]
struct Case {
    kind: usize,
    axis: Axis,
    /// The coordinates of a point of the axis, or of a corner.
    at: [f64; 3],
    /// Another point, or the opposite corner.
    to: [f64; 3],
    radii: [f64; 2],
    eye: [f64; 3],
    target: [f64; 3],
    field: f64,
}

fn vector<S: Scalar>(at: [f64; 3]) -> Vec3<S> {
    Vec3::from(at.map(S::from_f64))
}

/// Which pixels see the solid.
fn seen<S: Scalar>(case: &Case) -> Option<Vec<bool>> {
    let Case { kind, axis, at, to, radii, .. } = *case;
    let [from, to] = [at, to].map(vector::<S>);
    let [first, last] = radii.map(S::from_f64);
    let (middle, [low, high]) = match axis {
        Axis::X => ([from.y, from.z], [from.x, to.x]),
        Axis::Y => ([from.x, from.z], [from.y, to.y]),
        Axis::Z => ([from.x, from.y], [from.z, to.z]),
    };
    let of = |numbers: [S; 2]| numbers[0].min(numbers[1])..numbers[0].max(numbers[1]);
    let ends = of([low, high]);
    let corners = [[from.x, to.x], [from.y, to.y], [from.z, to.z]].map(of);
    let along = || Cylinder::along(axis, middle, first, ends.start, ends.end).ok();
    let oblique = || Cylinder::from_to(from, to, first).ok();
    match kind {
        0 => taken(&along()?, case),
        1 => taken(&oblique()?, case),
        2 => taken(&Cone::along(axis, middle, [first, last], ends.start, ends.end).ok()?, case),
        3 => taken(&Cone::from_to(from, to, [first, last]).ok()?, case),
        4 => {
            let [x, y, z] = corners;
            let [low, high] =
                [Vec3::new(x.start, y.start, z.start), Vec3::new(x.end, y.end, z.end)];
            taken(&ByLine::<_, 1>::new(Cuboid::between(low, high).ok()?), case)
        }
        _ => taken(&ByLine::<_, 1>::new(oblique()?), case),
    }
}

fn taken<S: Scalar, T>(solid: &T, case: &Case) -> Option<Vec<bool>>
where
    T: Solid<Scalar = S> + Scan<PerspectiveRays<S>>,
{
    let [eye, target] = [case.eye, case.target].map(vector::<S>);
    let up = vector([0.3125, 0.875, -0.25]);
    let camera = Perspective::look_at(eye, target, up, S::from_f64(case.field)).ok()?;
    let light = Lambert::new(vector([0.0, 0.0, 1.0]), S::ONE).unwrap();
    let size = Size::new(COLUMNS * STEP + 1, ROWS * STEP + 1).unwrap();
    let mut picture = Picture::new(solid, &camera, size, light, Gray8(0));
    let mut all = Vec::new();
    for y in 0..ROWS {
        // An error is a picture with pixels too large for the format.
        let mut row = picture.scanline(y * STEP).ok()?;
        all.extend((0..COLUMNS).map(|x| row.seen(x * STEP).is_some()));
    }
    Some(all)
}

/// A solid of any kind, and an eye in it or beside it, which looks along it or anywhere.
fn case(random: &mut Random, largest: f64, unit: f64) -> Case {
    let held = |x: f64| (x / unit).round() * unit;
    let reach = largest * random.between(0.02, 0.99);
    let kind = random.below(6);
    let axis = [Axis::X, Axis::Y, Axis::Z][random.below(3)];
    let at = random.point(reach).map(held);
    let to = random.point(reach).map(held);
    let radii = [(); 2].map(|()| held(reach * random.between(0.005, 0.9)));
    // Between the ends, off the axis by some of the radius.
    let part = random.between(0.05, 0.95);
    let is_along = matches!(kind, 0 | 2);
    let way: [f64; 3] = std::array::from_fn(|i| to[i] - at[i]);
    let index = match axis {
        Axis::X => 0,
        Axis::Y => 1,
        Axis::Z => 2,
    };
    let off = random.direction();
    let by = radii[0].min(radii[1]) * random.between(0.0, 3.0);
    let eye: [f64; 3] = std::array::from_fn(|i| {
        let on_axis = if is_along && i != index { at[i] } else { at[i] + part * way[i] };
        held((on_axis + by * off[i]).clamp(-largest, largest))
    });
    let looks_along = random.chance(0.4);
    let distance = 0.5f64.powf(random.between(1.0, 8.0));
    let anywhere = random.point(reach);
    let target: [f64; 3] = std::array::from_fn(|i| {
        let direction = match looks_along {
            true if is_along => {
                if i == index {
                    way[i]
                } else {
                    0.0
                }
            }
            true => way[i],
            false => anywhere[i] - eye[i],
        };
        held((eye[i] + distance * direction).clamp(-largest, largest))
    });
    Case { kind, axis, at, to, radii, eye, target, field: held(random.between(0.2, 1.5)) }
}

/// Pixels beside which `f64` sees the same all around are seen alike.
fn check<S: FixedPoint>() {
    let (largest, unit) = (S::MAX_COORDINATE.to_f64(), S::from_bits(1).to_f64());
    let mut random = Random::named("large solids");
    let (mut pictures, mut pixels) = (0, 0);
    for _ in 0..500 {
        let case = case(&mut random, largest, unit);
        let (Some(got), Some(want)) = (seen::<S>(&case), seen::<f64>(&case)) else { continue };
        pictures += 1;
        let at = |x: u16, y: u16| usize::from(y) * usize::from(COLUMNS) + usize::from(x);
        for y in 1..ROWS - 1 {
            for x in 1..COLUMNS - 1 {
                let sees = want[at(x, y)];
                let around = (y - 1..=y + 1).flat_map(|y| (x - 1..=x + 1).map(move |x| (x, y)));
                if around.into_iter().all(|(x, y)| want[at(x, y)] == sees) {
                    pixels += usize::from(sees);
                    assert_eq!(got[at(x, y)], sees, "column {x}, row {y} of {case:?}");
                }
            }
        }
    }
    println!("{largest}: {pictures} pictures, {pixels} pixels");
    assert!(pictures > 300 && pixels > 20_000, "{pictures} pictures, {pixels} pixels");
}

macro_rules! formats {
    ($($test:ident: $bits:ident,)+) => { $(
        #[test]
        fn $test() {
            check::<FixedI32<$bits>>();
        }
    )+ };
}

formats! {
    with_8_fraction_bits: U8,
    with_10_fraction_bits: U10,
    with_12_fraction_bits: U12,
    with_16_fraction_bits: U16,
}
