//! Pictures in perspective at the ends of fixed-point formats, against the same in `f64`.
//!
//! Solids as large as a format with few fraction bits allows: squares of such lengths leave the range of the
//! numbers that set up a picture. Eyes so near to their target that half a pixel there has few digits.

#![allow(clippy::unwrap_used)]

use fixed::FixedI32;
use fixed::types::extra::{U8, U10, U12, U16, U20, U24, U28};
use scancsg::geom::{Axis, PerspectiveRays, Vec3};
use scancsg::render::{CameraError, Gray8, Lambert, Perspective, Picture, Size};
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

fn camera<S: Scalar>(case: &Case) -> Result<Perspective<S>, CameraError> {
    let [eye, target] = [case.eye, case.target].map(vector);
    // Exact in all formats.
    let up = vector([0.3125, 0.875, -0.25]);
    Perspective::look_at(eye, target, up, S::from_f64(case.field))
}

fn taken<S: Scalar, T>(solid: &T, case: &Case) -> Option<Vec<bool>>
where
    T: Solid<Scalar = S> + Scan<PerspectiveRays<S>>,
{
    let camera = camera::<S>(case).ok()?;
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
fn large(random: &mut Random, largest: f64, unit: f64) -> Case {
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

/// A solid some way before an eye whose target is `distance` away.
fn near(random: &mut Random, largest: f64, unit: f64, distance: f64) -> Case {
    let held = |x: f64| (x / unit).round() * unit;
    let reach = 0.4 * largest.min(8.0);
    let eye = random.point(0.3 * reach).map(held);
    let way = random.direction();
    let target: [f64; 3] = std::array::from_fn(|i| held(eye[i] + distance * way[i]));
    let far = reach * random.between(0.1, 1.0);
    let mut beside = |from: f64| random.point(0.3 * far).map(|x| x + from);
    let (one, other) = (beside(0.0), beside(0.0));
    let at: [f64; 3] = std::array::from_fn(|i| held(eye[i] + far * way[i] + one[i]));
    let to: [f64; 3] = std::array::from_fn(|i| held(eye[i] + far * way[i] + other[i]));
    let radii = [(); 2].map(|()| held(far * random.between(0.05, 0.5)));
    let axis = [Axis::X, Axis::Y, Axis::Z][random.below(3)];
    let (kind, field) = (random.below(6), held(random.between(0.3, 0.9)));
    Case { kind, axis, at, to, radii, eye, target, field }
}

/// Pixels beside which `f64` sees the same all around are seen alike. How many of them see the solid, if there
/// is a picture.
fn check_alike<S: Scalar>(case: &Case) -> Option<usize> {
    let (got, want) = (seen::<S>(case)?, seen::<f64>(case)?);
    let mut pixels = 0;
    let at = |x: u16, y: u16| usize::from(y) * usize::from(COLUMNS) + usize::from(x);
    for y in 1..ROWS - 1 {
        for x in 1..COLUMNS - 1 {
            let sees = want[at(x, y)];
            let mut around = (y - 1..=y + 1).flat_map(|y| (x - 1..=x + 1).map(move |x| (x, y)));
            if around.all(|(x, y)| want[at(x, y)] == sees) {
                pixels += usize::from(sees);
                assert_eq!(got[at(x, y)], sees, "column {x}, row {y} of {case:?}");
            }
        }
    }
    Some(pixels)
}

fn check_large<S: FixedPoint>() {
    let (largest, unit) = (S::MAX_COORDINATE.to_f64(), S::from_bits(1).to_f64());
    let mut random = Random::named("large solids");
    let cases = (0..500).map(|_| large(&mut random, largest, unit));
    let pixels: Vec<usize> = cases.filter_map(|case| check_alike::<S>(&case)).collect();
    let sum: usize = pixels.iter().sum();
    assert!(pixels.len() > 300 && sum > 20_000, "{} pictures, {sum} pixels", pixels.len());
}

fn check_near<S: FixedPoint>() {
    let (largest, unit) = (S::MAX_COORDINATE.to_f64(), S::from_bits(1).to_f64());
    let mut random = Random::named("near targets");
    let (mut pictures, mut pixels, mut refused) = (0, 0, 0);
    for _ in 0..300 {
        // From a few units to a quarter.
        let distance = 0.25 * (4.0 * unit).powf(random.between(0.0, 1.0));
        let case = near(&mut random, largest, unit, distance);
        let (eye, target) = (case.eye, case.target);
        let apart = (0..3).map(|i| (eye[i] - target[i]).powi(2)).sum::<f64>().sqrt();
        let is_too_near = camera::<S>(&case) == Err(CameraError::TooNear);
        assert_eq!(is_too_near, apart < 1.0 / 1024.0, "{apart} in {case:?}");
        assert!(camera::<f64>(&case).is_ok(), "{case:?}");
        if is_too_near {
            refused += 1;
        } else if let Some(seen) = check_alike::<S>(&case) {
            pictures += 1;
            pixels += seen;
        }
    }
    assert!(pictures > 80 && pixels > 5_000, "{pictures} pictures, {pixels} pixels");
    assert!(refused > 20, "{refused}");
}

macro_rules! formats {
    ($check:ident: $($test:ident $bits:ident,)+) => { $(
        #[test]
        fn $test() {
            $check::<FixedI32<$bits>>();
        }
    )+ };
}

formats! { check_large:
    large_with_8_fraction_bits U8,
    large_with_10_fraction_bits U10,
    large_with_12_fraction_bits U12,
    large_with_16_fraction_bits U16,
}

formats! { check_near:
    near_with_12_fraction_bits U12,
    near_with_16_fraction_bits U16,
    near_with_20_fraction_bits U20,
    near_with_24_fraction_bits U24,
    near_with_28_fraction_bits U28,
}
