//! Pictures in perspective and in fixed point against the same in `f64`: depths and silhouettes.
//!
//! `f64` takes another way: each pixel's chord, from its own vectors. Its numbers are those that fixed point
//! holds.

#![allow(clippy::unwrap_used)]

use fixed::types::I8F24;
use scancsg::geom::{Axis, PerspectiveRays, Vec3};
use scancsg::render::{Depth, Gray8, Perspective, Picture, Size};
use scancsg::scalar::{I16F16, Number, Scalar};
use scancsg::solid::{Cone, Cuboid, Cylinder, Difference, Scan, Solid};

/// The numbers of `tee` in hundredths: an axis, the other two coordinates, the radius and the ends.
type Rod = (Axis, [i32; 2], [i32; 3]);

const BODY: [Rod; 4] = [
    (Axis::X, [0, 0], [100, -200, 200]),
    (Axis::X, [0, 0], [160, -200, -170]),
    (Axis::X, [0, 0], [160, 170, 200]),
    (Axis::Y, [0, 0], [80, 0, 200]),
];
const BORES: [Rod; 6] = [
    (Axis::X, [0, 0], [70, -300, 300]),
    (Axis::Y, [0, 0], [50, 0, 300]),
    (Axis::X, [130, 0], [15, -300, 300]),
    (Axis::X, [-130, 0], [15, -300, 300]),
    (Axis::X, [0, 130], [15, -300, 300]),
    (Axis::X, [0, -130], [15, -300, 300]),
];

const SIZE: [u16; 2] = [160, 120];

/// The depths of all pixels, in units of the scene. Lengths are in hundredths, the field of view in
/// ten-thousandths.
fn depths<S: Scalar>(eye: [i32; 3], target: [i32; 3], field: i32) -> Vec<Option<f64>> {
    // As fixed point holds them.
    let held = |hundredths| S::from_f64(I16F16::from_ratio(hundredths, 100).to_f64());
    let rod = |(axis, at, [radius, low, high]): Rod| {
        Cylinder::along(axis, at.map(held), held(radius), held(low), held(high)).unwrap()
    };
    let part = Difference::new(BODY.map(rod), BORES.map(rod));
    let [eye, target, up] = [eye, target, [0, 100, 0]].map(|at| Vec3::from(at.map(held)));
    let field = S::from_f64(I16F16::from_ratio(field, 10_000).to_f64());
    let camera = Perspective::look_at(eye, target, up, field).unwrap();
    let shader = Depth::new(held(-100), held(100)).unwrap();
    let size = Size::new(SIZE[0], SIZE[1]).unwrap();
    let mut picture = Picture::new(&part, &camera, size, shader, Gray8(0));
    let mut all = Vec::new();
    for y in 0..SIZE[1] {
        let mut row = picture.scanline(y).unwrap();
        all.extend((0..SIZE[0]).map(|x| row.seen(x).map(|seen| seen.t.to_f64())));
    }
    all
}

/// The errors of depths in units of 2⁻¹⁶, 99 % and all of those in which both see something; and how many
/// pixels are seen by one alone.
fn errors(eye: [i32; 3], target: [i32; 3], field: i32) -> (f64, f64, usize) {
    let (got, want) = (depths::<I16F16>(eye, target, field), depths::<f64>(eye, target, field));
    let apart = got.iter().zip(&want).filter(|(got, want)| got.is_some() != want.is_some()).count();
    let mut errors: Vec<f64> = got
        .iter()
        .zip(&want)
        .filter_map(|(got, want)| Some((got.as_ref()? - want.as_ref()?).abs() * 65_536.0))
        .collect();
    errors.sort_by(f64::total_cmp);
    let most = errors.last().copied().unwrap();
    println!(
        "{eye:?}: {} seen, 99 % {:.2}, all {most:.1}, {apart} apart",
        errors.len(),
        errors[errors.len() * 99 / 100]
    );
    (errors[errors.len() * 99 / 100], most, apart)
}

#[test]
fn depths_are_good_to_few_units() {
    for (eye, target, field, limit) in [
        ([520, 500, 693], [0, 0, 0], 4_900, 1.0),
        ([-300, 250, 300], [0, 0, 0], 12_000, 1.0),
        // From inside of bores, if they were longer.
        ([0, 330, 0], [10, 0, 5], 12_000, 3.0),
        ([30_000, 20_000, -10_000], [0, 0, 0], 117, 1.0),
        ([240_000, 160_000, -80_000], [0, 0, 0], 15, 6.0),
    ] {
        let (most_of_99, _, apart) = errors(eye, target, field);
        assert!(most_of_99 <= limit, "{most_of_99} from {eye:?}");
        assert!(apart <= 2, "{apart} pixels from {eye:?}");
    }
}

/// Solids of fewer units than Q32.32 has digits for their squares, before an eye as near to them: as many pixels as
/// in `f64` show them.
#[test]
fn small_solids_before_a_near_eye_are_seen() {
    let counts = small_solids::<I8F24>().into_iter().zip(small_solids::<f64>());
    for (got, want) in counts {
        assert!(want > 600 && got.abs_diff(want) < 60, "{got} of {want}");
    }
}

/// In how many pixels a rod, a cone and a box are seen.
fn small_solids<S: Scalar>() -> [usize; 3] {
    let number = |bits: i32| S::from_f64(I8F24::from_bits(bits).to_f64());
    let point = |bits: [i32; 3]| Vec3::from(bits.map(number));
    let ends =
        [[8_898_405, 31_184_502, 12_200_095], [8_898_407, 31_184_429, 12_199_951]].map(point);
    let rod = Cylinder::from_to(ends[0], ends[1], number(93)).unwrap();
    let cone = Cone::from_to(ends[0], ends[1], [number(93), number(40)]).unwrap();
    let box_of = |[x, y, z]: [i32; 3]| {
        let [low, high] = [-80, 80].map(|by| point([x + by, y + by, z + by]));
        Cuboid::between(low, high).unwrap()
    };
    let cuboid = box_of([8_898_405, 31_184_502, 12_200_095]);
    let eye = point([8_898_278, 31_188_124, 12_207_265]);
    let target = point([8_898_814, 31_172_559, 12_176_462]);
    let up = point([11_950_390, 2_632_288, -11_477_552]);
    let camera = Perspective::look_at(eye, target, up, number(367_406)).unwrap();
    [shown(&rod, &camera), shown(&cone, &camera), shown(&cuboid, &camera)]
}

/// In how many pixels a solid is seen.
fn shown<S: Scalar>(
    solid: &(impl Solid<Scalar = S> + Scan<PerspectiveRays<S>>),
    camera: &Perspective<S>,
) -> usize {
    let shader = Depth::new(S::from_int(-1), S::from_int(1)).unwrap();
    let mut picture = Picture::new(solid, camera, Size::new(40, 30).unwrap(), shader, Gray8(0));
    let in_row = |y| {
        let mut row = picture.scanline(y).unwrap();
        (0..40).filter(|x| row.seen(*x).is_some()).count()
    };
    (0..30).map(in_row).sum()
}
