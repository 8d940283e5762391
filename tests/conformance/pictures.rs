//! Pictures against a brute-force caster in `f64`, pixel by pixel.
//!
//! A pixel's class is hit or miss. It must be the caster's unless the pixel is very near to a
//! silhouette, that is, unless one of some rays moved by [`silhouette`] has another class than the
//! pixel's own. Depths must agree within [`tolerance`], and so must levels of grey within one; where a
//! surface is seen at a grazing angle, or another one begins, a pixel's neighbours show different
//! values, and the picture's has to lie among those.
//!
//! The caster is given the numbers as the type under test holds them.

#[path = "../../examples/scene/mod.rs"]
mod scene;

use crate::caster::{self, Camera as Model, Ray as ModelRay, Solid as ModelSolid, V};
use crate::limits;
use crate::number::{self, Tested, vector};
use proptest::prelude::*;
use scancsg::geom::{Ray, Rays, vec3};
use scancsg::render::{
    Camera, Depth, Gray8, Lambert, Orthographic, Perspective, Picture, Shader, Size, XRay,
};
use scancsg::solid::{
    Cone, Cylinder, Difference, Intersection, RayCast, Scan, Slab, Solid, Sphere, Torus, Union,
};
use scancsg::span::SpanList;

for_every_number!(
    tee_orthographic,
    tee_perspective,
    random_orthographic,
    along_a_coordinate_axis,
    nearly_along_a_coordinate_axis,
    random_perspective,
    from_far_away,
    from_within,
    nearly_along_a_wall,
    from_inside_a_bore,
    lambert_levels,
    depth_levels,
    xray_levels,
);

/// Scene units by which a pixel's ray may miss what it should see at a depth. A grid's error grows
/// with the distance from the eye.
fn silhouette<S: Tested>(view: &Model, depth: f64) -> f64 {
    if S::IS_FIXED { in_units::<S>(view, depth) } else { limits::SILHOUETTE }
}

/// Scene units by which a depth may be off.
fn tolerance<S: Tested>(view: &Model, depth: f64) -> f64 {
    if S::IS_FIXED { in_units::<S>(view, depth) } else { limits::DEPTH }
}

/// A few units: of the ray's point, of its direction, of the parameter.
fn in_units<S: Tested>(view: &Model, depth: f64) -> f64 {
    let from_eye = if view.is_perspective { view.distance() + depth.max(0.0) } else { 0.0 };
    limits::FIXED_PICTURE * S::UNIT * from_eye.max(1.0)
}

/// With a unit above this, what is left of a part may be thinner than a unit now and then, and be seen or
/// not: in 5 of 220,000 pictures in `I20F12`, and in none of 100,000 in `I16F16`. There, the same part
/// with every face moved by a unit may show what the picture does.
const COARSE: f64 = 1e-4;

/// Rays that a number type may take for a pixel's own. In floating point they run through the eye;
/// a grid is as coarse near the eye as far away.
fn rays_near<S: Tested>(view: &Model, pixel: [u16; 2], size: [u16; 2], by: f64) -> [ModelRay; 8] {
    if S::IS_FIXED { view.rays_beside(pixel, size, by) } else { view.rays_around(pixel, size, by) }
}

/// What a comparison found.
#[derive(Debug, Default)]
pub struct Found {
    pub covered: usize,
    /// Of another class than the caster says, at a silhouette.
    at_silhouettes: usize,
    /// Farther off in depth, but not than the pixel's surroundings.
    steep: usize,
    /// The largest difference in depth where the surroundings are flat.
    worst_depth: f64,
}

/// What rays around a pixel see: on the edge of a disc, and on circles in it, because an edge may cut it.
/// Where one circle sees something and the next one nothing, also what is seen last between the two: a
/// depth is steepest at a silhouette.
fn depths_around(
    rays: impl Fn(f64) -> [ModelRay; 8],
    depth: impl Fn(&ModelRay) -> Option<f64> + Copy,
) -> Vec<Option<f64>> {
    let mut all = Vec::new();
    let circles = [0.0, 0.01, 0.03, 0.1, 0.3, 1.0].map(|part| (part, rays(part)));
    for pair in circles.windows(2) {
        for (i, (a, b)) in
            pair[0].1.iter().zip(&pair[1].1).map(|(a, b)| (depth(a), depth(b))).enumerate()
        {
            all.extend([a, b]);
            if a.is_some() == b.is_some() {
                continue;
            }
            let [mut inside, mut outside] = [pair[0].0, pair[1].0];
            for _ in 0..20 {
                let middle = (inside + outside) / 2.0;
                let seen = depth(&rays(middle)[i]);
                all.push(seen);
                if seen.is_some() == a.is_some() { inside = middle } else { outside = middle }
            }
        }
    }
    all
}

/// Levels of grey of rays around a pixel, and of those between them and the pixel's own: where there is a
/// step, just before it and just behind, because a level may change fastest at a silhouette.
fn levels_around(
    rays: impl Fn(f64) -> [ModelRay; 8],
    level: impl Fn(&ModelRay) -> f64,
) -> Vec<f64> {
    let mut all = Vec::new();
    for i in 0..8 {
        let at = |part: f64| (part, level(&rays(part)[i]));
        let [mut inside, mut outside] = [0.0, 1.0].map(at);
        all.extend([inside.1, outside.1]);
        for _ in 0..12 {
            let middle = at((inside.0 + outside.0) / 2.0);
            all.push(middle.1);
            let is_before = (middle.1 - inside.1).abs() > (outside.1 - middle.1).abs();
            if is_before { outside = middle } else { inside = middle }
        }
    }
    all
}

/// The smallest and the largest of what rays around a pixel see.
fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| [low.min(v), high.max(v)])
}

pub fn compare<S, T, C>(
    (solid, model): (&T, &ModelSolid),
    (camera, view): (&C, &Model),
    size: [u16; 2],
) -> Result<Found, TestCaseError>
where
    S: Tested,
    C: Camera<Rays: Rays<Scalar = S>>,
    T: Solid<Scalar = S> + Scan<C::Rays>,
{
    let [width, height] = size;
    let shader = XRay::new(S::ONE).unwrap();
    let mut picture =
        Picture::new(solid, camera, Size::new(width, height).unwrap(), shader, Gray8(0));
    let mut found = Found::default();
    for y in 0..height {
        let mut scanline = picture.scanline(y).unwrap();
        for x in 0..width {
            let pixel = [x, scanline.y()];
            let got = scanline.seen(x).map(|seen| seen.t.to_f64());
            let of = |model: &ModelSolid, ray: &ModelRay| {
                model.seen(ray, view.start()).map(|seen| seen.t)
            };
            let want = of(model, &view.ray(pixel, size, [0.0; 2]));
            found.covered += usize::from(got.is_some());
            let at = got.into_iter().chain(want).fold(0.0, f64::max);
            let (silhouette, allowed) = (silhouette::<S>(view, at), tolerance::<S>(view, at));

            let around = || {
                let rays = |part| rays_near::<S>(view, pixel, size, silhouette * part);
                let mut all = depths_around(rays, |ray| of(model, ray));
                if S::UNIT > COARSE {
                    for model in [S::UNIT, -S::UNIT].map(|by| model.grown(by)) {
                        all.extend(depths_around(rays, |ray| of(&model, ray)));
                    }
                }
                all
            };
            match (got, want) {
                (None, None) => {}
                (Some(got), Some(want)) if (got - want).abs() <= allowed => {
                    found.worst_depth = found.worst_depth.max((got - want).abs());
                }
                (Some(got), Some(want)) => {
                    let [low, high] = range(around().into_iter().flatten().chain([want]));
                    prop_assert!(
                        low - allowed <= got && got <= high + allowed,
                        "{:?}: depth {} is not {}, nor from {} to {}",
                        pixel,
                        got,
                        want,
                        low,
                        high
                    );
                    found.steep += 1;
                }
                (got, want) => {
                    let at_silhouette = around().iter().any(|t| t.is_some() != want.is_some());
                    prop_assert!(at_silhouette, "{:?}: {:?} is not {:?}", pixel, got, want);
                    found.at_silhouettes += 1;
                }
            }
        }
    }
    Ok(found)
}

/// The coordinates as the number type holds them.
pub fn held<S: Tested>(v: V) -> V {
    v.map(|x| S::near(x).to_f64())
}

/// A camera in both worlds.
pub fn orthographic<S: Tested>(
    way: V,
    target: V,
    up: V,
    frame_height: f64,
) -> (Orthographic<S>, Model) {
    let frame = S::near(frame_height);
    let camera = Orthographic::look_along(vector(way), vector(target), vector(up), frame).unwrap();
    let target = held::<S>(target);
    let view = Model {
        target,
        eye: caster::sub(target, held::<S>(way)),
        up: held::<S>(up),
        frame_height: frame.to_f64(),
        is_perspective: false,
    };
    (camera, view)
}

pub fn perspective<S: Tested>([eye, target]: [V; 2], up: V, field: f64) -> (Perspective<S>, Model) {
    let field = S::near(field);
    let camera = Perspective::look_at(vector(eye), vector(target), vector(up), field).unwrap();
    let (eye, target) = (held::<S>(eye), held::<S>(target));
    let distance = caster::length(caster::sub(target, eye));
    let view = Model {
        target,
        eye,
        up: held::<S>(up),
        frame_height: 2.0 * distance * (field.to_f64() / 2.0).tan(),
        is_perspective: true,
    };
    (camera, view)
}

// `tee`, by the numbers of its definition.

const BODY: [(usize, [f64; 2], [f64; 3]); 4] = [
    (0, [0.0, 0.0], [1.0, -2.0, 2.0]),
    (0, [0.0, 0.0], [1.6, -2.0, -1.7]),
    (0, [0.0, 0.0], [1.6, 1.7, 2.0]),
    (1, [0.0, 0.0], [0.8, 0.0, 2.0]),
];
const BORES: [(usize, [f64; 2], [f64; 3]); 6] = [
    (0, [0.0, 0.0], [0.7, -3.0, 3.0]),
    (1, [0.0, 0.0], [0.5, 0.0, 3.0]),
    (0, [1.3, 0.0], [0.15, -3.0, 3.0]),
    (0, [-1.3, 0.0], [0.15, -3.0, 3.0]),
    (0, [0.0, 1.3], [0.15, -3.0, 3.0]),
    (0, [0.0, -1.3], [0.15, -3.0, 3.0]),
];
pub const UP: V = [0.0, 1.0, 0.0];
const VIEW: V = [-0.6 * 0.866_025_4, -0.5, -0.8 * 0.866_025_4];
const TO_LIGHT: V = [0.25, 0.85, 0.45];

fn tee<S: Tested>() -> (scene::Tee<S>, ModelSolid) {
    let make = |(axis, middle, [radius, low, high]): (usize, [f64; 2], [f64; 3])| {
        let [radius, low, high] = [radius, low, high].map(S::near);
        S::along(axis, middle.map(S::near), radius, low, high).unwrap()
    };
    let model = |&(axis, [a, b], [radius, low, high]): &(usize, [f64; 2], [f64; 3])| {
        let at = |along: f64| held::<S>(if axis == 0 { [along, a, b] } else { [a, along, b] });
        ModelSolid::Cylinder { from: at(low), to: at(high), radius: S::near(radius).to_f64() }
    };
    let any = |cylinders: &[_]| Box::new(ModelSolid::Any(cylinders.iter().map(model).collect()));
    let solid = Difference::new(BODY.map(make), BORES.map(make));
    (solid, ModelSolid::Minus(any(&BODY), any(&BORES)))
}

fn tee_from_afar<S: Tested>() -> (Orthographic<S>, Model) {
    orthographic(VIEW, [0.0; 3], UP, 4.4)
}

fn tee_from_ten_units<S: Tested>() -> (Perspective<S>, Model) {
    perspective([VIEW.map(|x| -10.0 * x), [0.0; 3]], UP, 0.489_957_3)
}

const SIZES: [[u16; 2]; 3] = [[96, 72], [33, 47], [1, 1]];

/// Few pixels of these pictures are anywhere near a silhouette or seen at a grazing angle, and none
/// as near as floats could tell.
fn check_tee(found: &Found) {
    println!("{found:?}");
    let doubtful = found.at_silhouettes + found.steep;
    assert!(doubtful == 0 || doubtful * 100 < found.covered, "{found:?}");
}

fn tee_orthographic<S: Tested>() {
    let ((solid, model), (camera, view)) = (tee::<S>(), tee_from_afar());
    for size in SIZES {
        let found = compare((&solid, &model), (&camera, &view), size).unwrap();
        check_tee(&found);
        assert!(S::IS_FIXED || found.at_silhouettes + found.steep == 0);
    }
}

fn tee_perspective<S: Tested>() {
    let ((solid, model), (camera, view)) = (tee::<S>(), tee_from_ten_units());
    for size in SIZES {
        let found = compare((&solid, &model), (&camera, &view), size).unwrap();
        check_tee(&found);
        assert!(S::IS_FIXED || found.at_silhouettes + found.steep == 0);
    }
}

/// Small pictures of `tee`, for number types that nothing else is asked of.
pub fn check_tee_in<S: Tested>() {
    let (solid, model) = tee::<S>();
    let size = [40, 30];
    let (camera, view) = tee_from_afar();
    check_tee(&compare((&solid, &model), (&camera, &view), size).unwrap());
    let (camera, view) = tee_from_ten_units();
    check_tee(&compare((&solid, &model), (&camera, &view), size).unwrap());
}

/// The number of the benchmark: 55 % of 320×240.
#[test]
fn tee_covers_41937_pixels() {
    let camera = scene::f32::orthographic().unwrap();
    let size = Size::new(320, 240).unwrap();
    let mut picture =
        Picture::new(&scene::f32::TEE, &camera, size, XRay::new(1.0).unwrap(), Gray8(0));
    let mut covered = 0;
    for y in 0..240 {
        let mut row = picture.scanline(y).unwrap();
        covered += (0..320).filter(|&x| row.seen(x).is_some()).count();
    }
    assert_eq!(covered, 41_937);
}

// Random scenes.

type Part<S> = Difference<
    Union<Union<Union<[Cylinder<S>; 3], [Sphere<S>; 2]>, Cone<S>>, Torus<S>>,
    Union<Union<[Cylinder<S>; 2], Intersection<Slab<S>, Sphere<S>>>, Cone<S>>,
>;

pub fn point<S: Tested>() -> impl Strategy<Value = V> {
    prop::array::uniform3(-2.0..2.0).prop_map(held::<S>)
}

/// A cylinder, oblique or exactly along x, y or z, in both worlds.
fn cylinder<S: Tested>() -> impl Strategy<Value = (Cylinder<S>, ModelSolid)> {
    let way = prop_oneof![
        point::<S>(),
        (0..3usize, 0.5..3.0).prop_map(|(axis, length)| {
            std::array::from_fn(|i| if i == axis { length } else { 0.0 })
        }),
    ];
    (point::<S>(), way, 0.2..1.2).prop_filter_map("too short", |(from, way, radius)| {
        let to = held::<S>(caster::add(from, way));
        let radius = S::near(radius);
        let model = ModelSolid::Cylinder { from, to, radius: radius.to_f64() };
        let is_long = caster::length(caster::sub(to, from)) > 0.1;
        let solid = S::between(vector(from), vector(to), radius).ok()?;
        is_long.then_some((solid, model))
    })
}

/// A cone, oblique or exactly along x, y or z, in both worlds: with a tip, about as wide at both ends, or
/// neither.
pub fn cone<S: Tested>() -> impl Strategy<Value = (Cone<S>, ModelSolid)> {
    let slope = prop_oneof![Just(0.0), 0.0..1.0, 0.98..1.0];
    (cylinder::<S>(), slope, prop::bool::ANY).prop_filter_map("no cone", |(rod, part, turn)| {
        let ModelSolid::Cylinder { from, to, radius } = rod.1 else { return None };
        let other = S::near(radius * part);
        let radii = if turn { [other, S::near(radius)] } else { [S::near(radius), other] };
        let solid = S::cone_between(vector(from), vector(to), radii).ok()?;
        Some((solid, ModelSolid::Cone { from, to, radii: radii.map(S::to_f64) }))
    })
}

fn sphere<S: Tested>() -> impl Strategy<Value = (Sphere<S>, ModelSolid)> {
    (point::<S>(), 0.3..1.2).prop_map(|(center, radius)| {
        let solid = number::ball(center, radius);
        (solid, ModelSolid::Sphere { center, radius: S::near(radius).to_f64() })
    })
}

fn torus<S: Tested>() -> impl Strategy<Value = (Torus<S>, ModelSolid)> {
    let axis = (point::<S>(), 0..4usize).prop_map(|(axis, along)| {
        if along == 3 { axis } else { std::array::from_fn(|i| f64::from(u8::from(i == along))) }
    });
    (point::<S>(), axis, 0.4..1.5, 0.1..0.9).prop_filter_map(
        "no axis",
        |(center, axis, ring, part)| {
            let radii: [S; 2] = [ring, ring * part].map(S::near);
            let solid = S::torus(vector(center), vector(axis), radii).ok()?;
            let [ring, tube] = radii.map(S::to_f64);
            let model = ModelSolid::Torus { center, axis, ring, tube };
            (caster::length(axis) > 0.1).then_some((solid, model))
        },
    )
}

fn slab<S: Tested>() -> impl Strategy<Value = (Slab<S>, ModelSolid)> {
    (point::<S>(), -1.0..1.0, 0.2..1.5).prop_filter_map("no normal", |(normal, low, width)| {
        let [low, high]: [S; 2] = [low, low + width].map(S::near);
        let model = ModelSolid::Slab { normal, low: low.to_f64(), high: high.to_f64() };
        let solid = S::slab(vector(normal), low, high).ok()?;
        (caster::length(normal) > 0.1).then_some((solid, model))
    })
}

fn part<S: Tested>() -> BoxedStrategy<(Part<S>, ModelSolid)> {
    let cylinders = (cylinder(), cylinder(), cylinder(), cylinder(), cylinder());
    (cylinders, (sphere(), sphere(), sphere()), slab(), (cone(), cone(), torus()))
        .prop_map(|((a, b, c, d, e), (f, g, h), i, (j, k, l))| {
            let solid = Difference::new(
                Union::new(Union::new(Union::new([a.0, b.0, c.0], [f.0, g.0]), j.0), l.0),
                Union::new(Union::new([d.0, e.0], Intersection::new(i.0, h.0)), k.0),
            );
            let cut = ModelSolid::Any(vec![d.1, e.1, ModelSolid::All(vec![i.1, h.1]), k.1]);
            let body = ModelSolid::Any(vec![a.1, b.1, c.1, f.1, g.1, j.1, l.1]);
            (solid, ModelSolid::Minus(Box::new(body), Box::new(cut)))
        })
        .boxed()
}

pub const SIZE: [u16; 2] = [24, 19];

/// An orthographic picture along `way` with 6 units of frame height.
fn check_orthographic<S: Tested>(
    part: &(Part<S>, ModelSolid),
    way: V,
) -> Result<(), TestCaseError> {
    let up = if way[1].abs() > 0.9 * caster::length(way) { [1.0, 0.0, 0.0] } else { UP };
    let (camera, view) = orthographic::<S>(way, [0.25, -0.125, 0.5], up, 6.0);
    compare((&part.0, &part.1), (&camera, &view), SIZE).map(|_| ())
}

fn check_perspective<S: Tested>(
    part: &(Part<S>, ModelSolid),
    eye_and_target: [V; 2],
    field: f64,
) -> Result<(), TestCaseError> {
    let (camera, view) = perspective::<S>(eye_and_target, UP, field);
    compare((&part.0, &part.1), (&camera, &view), SIZE).map(|_| ())
}

pub fn direction<S: Tested>() -> impl Strategy<Value = V> {
    prop::array::uniform3(-1.0..1.0)
        .prop_map(held::<S>)
        .prop_filter("too short", |&v| caster::length(v) > 0.2)
}

/// Most for those types that pictures are made with on small computers.
pub fn config<S: Tested>() -> ProptestConfig {
    let is_of_small_computers = size_of::<S>() == 4 && S::UNIT < COARSE;
    ProptestConfig::with_cases(if is_of_small_computers { 50 } else { 10 })
}

fn random_orthographic<S: Tested>() {
    proptest!(config::<S>(), |(part in part::<S>(), way in direction::<S>())| {
        check_orthographic(&part, way)?;
    });
}

/// Cylinders along the view have a = 0, and slabs are seen edge-on.
fn along_a_coordinate_axis<S: Tested>() {
    proptest!(config::<S>(), |(part in part::<S>(), axis in 0..3usize, back in prop::bool::ANY)| {
        let sign = if back { -1.0 } else { 1.0 };
        check_orthographic(&part, std::array::from_fn(|i| if i == axis { sign } else { 0.0 }))?;
    });
}

/// Nearly along an axis a is tiny, and the entries through walls move fast with the pixel.
fn nearly_along_a_coordinate_axis<S: Tested>() {
    proptest!(config::<S>(), |(
        part in part::<S>(), axis in 0..3usize, off in prop::array::uniform3(-1.0..1.0), power in 1..6i32,
    )| {
        let off = off.map(|k: f64| k * 10f64.powi(-power));
        check_orthographic(&part, std::array::from_fn(|i| if i == axis { 1.0 } else { off[i] }))?;
    });
}

fn random_perspective<S: Tested>() {
    proptest!(config::<S>(), |(
        part in part::<S>(), way in direction::<S>(), distance in 1.0..12.0, field in 0.2..1.5,
    )| {
        let to = [0.25, -0.125, 0.5];
        let from = caster::sub(to, caster::times(way, distance / caster::length(way)));
        prop_assume!(way[0].abs() + way[2].abs() > 0.05);
        check_perspective(&part, [from, to], field)?;
    });
}

/// From 10⁵ units away: with the usual quadratic, b² − ac has not one correct digit in `f32`, and
/// the eye's coordinates resolve hundredths of a unit at best. In fixed point, from nearly as far
/// away as can be, or as far as leaves a hundred units to the field of view.
fn from_far_away<S: Tested>() {
    let far = if S::IS_FIXED {
        (0.9 * S::MAX_COORDINATE.to_f64()).min(6.0 / (100.0 * S::UNIT))
    } else {
        1e5
    };
    proptest!(config::<S>(), |(part in part::<S>(), way in direction::<S>())| {
        prop_assume!(way[0].abs() + way[2].abs() > 0.05);
        let eye = caster::times(way, far / caster::length(way));
        check_perspective(&part, [eye, [0.0; 3]], 6.0 / far)?;
    });
}

/// An eye inside a part sees faces from within, and must not see what is behind it.
fn from_within<S: Tested>() {
    proptest!(config::<S>(), |(part in part::<S>(), eye in point::<S>(), to in point::<S>())| {
        let way = caster::sub(to, eye);
        prop_assume!(way[0].abs() + way[2].abs() > 0.3);
        check_perspective(&part, [eye, to], 1.2)?;
    });
}

/// From beside a wall, nearly along it: rays at small angles to the axis. The distance of such a ray
/// from the axis is a quotient of two small numbers, and what a rounded numerator is off becomes 20
/// times as much and more.
fn nearly_along_a_wall<S: Tested>() {
    let (from, to) = ([0.0, 0.0, -2.0], [0.0, 0.0, 2.0]);
    let rod = S::between(vector(from), vector(to), S::near(0.5)).unwrap();
    let model = ModelSolid::Cylinder { from, to, radius: 0.5 };
    // An eye on the wall, by the type's digits, may be on either side.
    let gap = || prop_oneof![-0.1..-0.002, 0.002..0.1, -0.004..-0.002, 0.002..0.004];
    proptest!(config::<S>(), |(
        gap in gap(), turn in 0.0..6.3, along in -1.5..1.5, way in prop::array::uniform2(-0.2..0.2),
    )| {
        let around = |radius: f64| [radius * f64::cos(turn), radius * f64::sin(turn)];
        let [x, y] = around(0.5 + gap);
        let eye = [x, y, along];
        let [target, up] = [[x + way[0], y + way[1], along + 1.0], UP];
        let (camera, view) = perspective::<S>([eye, target], up, 0.8);
        compare((&rod, &model), (&camera, &view), SIZE)?;
    });
}

/// From inside a bore, looking along its axis exactly: every ray of the middle is parallel to the
/// wall or nearly so, and the mouth of the bore is all that one sees of the world outside.
fn from_inside_a_bore<S: Tested>() {
    let (shaft, bore) = (number::rod::<S>(1.0, -2.0, 2.0), number::rod(0.5, -3.0, 3.0));
    let solid = (shaft - bore) | number::ball([5.0, 0.0, 0.0], 0.25);
    let along_x = |radius: f64, half: f64| ModelSolid::Cylinder {
        from: [-half, 0.0, 0.0],
        to: [half, 0.0, 0.0],
        radius,
    };
    let pipe = ModelSolid::Minus(Box::new(along_x(1.0, 2.0)), Box::new(along_x(0.5, 3.0)));
    let model =
        ModelSolid::Any(vec![pipe, ModelSolid::Sphere { center: [5.0, 0.0, 0.0], radius: 0.25 }]);
    for eye in [[-1.5, 0.0, 0.0], [-1.0, 0.25, 0.125], [0.0, 0.0, 0.4375]] {
        let (camera, view) = perspective::<S>([eye, [3.0, eye[1], eye[2]]], UP, 1.5);
        for size in [[33, 33], [24, 18]] {
            let found = compare((&solid, &model), (&camera, &view), size).unwrap();
            assert!(found.covered > 100, "{found:?}");
        }
    }
}

/// A picture's own formulas, view by view and row by row, against single rays: in `f64`, where
/// both must be all but the same.
fn rows_are_rays<C>(camera: &C, view: &Model) -> usize
where
    C: Camera<Rays: Rays<Scalar = f64>>,
    scene::Tee<f64>: Scan<C::Rays, Scalar = f64>,
{
    let size = [97, 61];
    let solid = scene::f64::TEE;
    let (pixels, shader) = (Size::new(97, 61).unwrap(), XRay::new(1.0).unwrap());
    let mut picture = Picture::new(&solid, camera, pixels, shader, Gray8(0));
    let [mut of_row, mut of_ray] = [const { SpanList::<f64, 64>::new() }; 2];
    let mut count = 0;
    for y in 0..61 {
        let mut scanline = picture.scanline(y).unwrap();
        for x in 0..97 {
            let ModelRay { origin, direction } = view.ray([x, scanline.y()], size, [0.0; 2]);
            let of = |[x, y, z]: V| vec3(x, y, z);
            let ray = Ray::new(of(origin), of(direction)).unwrap();
            let want = solid.trace(&ray, &mut of_ray);
            let got = scanline.spans(x, &mut of_row);
            assert_eq!(got.len(), want.len(), "in column {x} of row {}", scanline.y());
            for (got, want) in got.iter().zip(want) {
                count += 1;
                for (got, want) in [(got.enter, want.enter), (got.exit, want.exit)] {
                    assert_eq!(got.face, want.face);
                    assert!((got.t - want.t).abs() <= 1e-9, "{} is not {}", got.t, want.t);
                }
            }
        }
    }
    count
}

#[test]
fn rows_are_rays_orthographic() {
    let camera = scene::f64::orthographic().unwrap();
    assert!(rows_are_rays(&camera, &tee_from_afar::<f64>().1) > 3000);
}

#[test]
fn rows_are_rays_perspective() {
    let camera = scene::f64::perspective().unwrap();
    assert!(rows_are_rays(&camera, &tee_from_ten_units::<f64>().1) > 3000);
}

/// Levels of grey against the definition of the shader, for both cameras.
fn check_levels<S: Tested, H: Shader<S> + Copy>(
    shader: H,
    level: impl Fn(&ModelSolid, &ModelRay, f64) -> Option<f64> + Copy,
) {
    let part = tee::<S>();
    let (camera, view) = tee_from_afar();
    check_levels_seen(&part, (&camera, &view), shader, level);
    let (camera, view) = tee_from_ten_units();
    check_levels_seen(&part, (&camera, &view), shader, level);
}

fn check_levels_seen<S, C, H>(
    (solid, model): &(scene::Tee<S>, ModelSolid),
    (camera, view): (&C, &Model),
    shader: H,
    level: impl Fn(&ModelSolid, &ModelRay, f64) -> Option<f64>,
) where
    S: Tested,
    C: Camera<Rays: Rays<Scalar = S>>,
    H: Shader<S>,
    scene::Tee<S>: Scan<C::Rays, Scalar = S>,
{
    let size = [80, 60];
    let to_byte = |level: f64| (level.clamp(0.0, 1.0) * 255.0).round();
    let of = |ray: &ModelRay| level(model, ray, view.start()).map_or(0.0, to_byte);
    let mut picture = Picture::new(solid, camera, Size::new(80, 60).unwrap(), shader, Gray8(0));
    let mut row = [Gray8(0); 80];
    for y in 0..60 {
        let mut scanline = picture.scanline(y).unwrap();
        scanline.render(&mut row).unwrap();
        for (x, &Gray8(got)) in (0..).zip(&row) {
            let (pixel, got) = ([x, scanline.y()], f64::from(got));
            let want = of(&view.ray(pixel, size, [0.0; 2]));
            if (got - want).abs() > limits::LEVEL {
                let depth = model.seen(&view.ray(pixel, size, [0.0; 2]), view.start());
                let by = silhouette::<S>(view, depth.map_or(0.0, |seen| seen.t));
                let rays = |part| rays_near::<S>(view, pixel, size, by * part);
                let mut around: Vec<f64> = rays(1.0).iter().map(&of).chain([want]).collect();
                if S::UNIT > COARSE {
                    around.extend(levels_around(rays, of));
                }
                let [low, high] = range(around.into_iter());
                assert!(low - 1.0 <= got && got <= high + 1.0, "{pixel:?}: {got} is not {want}");
            }
        }
    }
}

fn lambert_levels<S: Tested>() {
    let light = caster::unit(held::<S>(TO_LIGHT));
    let shader = Lambert::new(vector(TO_LIGHT), S::near(0.125)).unwrap();
    check_levels::<S, _>(shader, |solid, ray, start| {
        let seen = solid.seen(ray, start)?;
        Some(0.125 + 0.875 * caster::dot(seen.normal, light).max(0.0))
    });
}

fn depth_levels<S: Tested>() {
    let shader = Depth::new(S::near(-2.0), S::near(2.5)).unwrap();
    check_levels::<S, _>(shader, |solid, ray, start| Some((2.5 - solid.seen(ray, start)?.t) / 4.5));
}

fn xray_levels<S: Tested>() {
    check_levels::<S, _>(XRay::new(S::near(3.0)).unwrap(), |solid, ray, start| {
        solid.seen(ray, start)?;
        let inside = |[a, b]: &[caster::Crossing; 2]| (b.t - a.t.max(start)).max(0.0);
        let sum: f64 = solid.spans(ray).iter().map(inside).sum();
        Some(sum * caster::length(ray.direction) / 3.0)
    });
}
