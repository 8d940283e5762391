//! Pictures in `f32` against a brute-force caster in `f64`, pixel by pixel.
//!
//! A pixel's class is hit or miss. It must be the caster's unless the pixel is within 10⁻⁵ units
//! of a silhouette, that is, unless one of eight rays moved by 10⁻⁵ units has another class than
//! the pixel's own. Depths must agree within 10⁻⁴, and so must levels of grey within one; where
//! a surface is seen at a grazing angle, or another one begins, a pixel's eight neighbours show
//! different values, and the picture's has to lie among those.

#![allow(clippy::unwrap_used)]

mod caster;
#[path = "../examples/scene/mod.rs"]
mod scene;

use caster::{Camera as Model, Ray as ModelRay, Solid as ModelSolid};
use proptest::prelude::*;
use scancsg::geom::{Ray, Rays, Vec3, vec3};
use scancsg::render::{
    Camera, Depth, Gray8, Lambert, Orthographic, Perspective, Picture, Shader, Size, XRay,
};
use scancsg::solid::{Cylinder, Difference, Intersection, Project, Slab, Solid, Sphere, Union};
use scancsg::span::SpanList;

const SILHOUETTE: f64 = 1e-5;
const DEPTH: f64 = 1e-4;

/// What a comparison found.
#[derive(Debug, Default)]
struct Found {
    covered: usize,
    /// Of another class than the caster says, within 10⁻⁵ units of a silhouette.
    at_silhouettes: usize,
    /// Farther off than 10⁻⁴ in depth, but not than the pixel's surroundings.
    steep: usize,
    /// The largest difference in depth where the surroundings are flat.
    worst_depth: f64,
}

/// The smallest and the largest of what rays around a pixel see.
fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| [low.min(v), high.max(v)])
}

fn compare<T, C>(
    solid: &T,
    camera: &C,
    size: [u16; 2],
    model: &ModelSolid,
    view: &Model,
) -> Result<Found, TestCaseError>
where
    C: Camera<Rays: Rays<Scalar = f32>>,
    T: Solid<Scalar = f32> + Project<C::Rays>,
{
    let [width, height] = size;
    let shader = XRay::new(1.0).unwrap();
    let picture = Picture::new(solid, camera, Size::new(width, height).unwrap(), shader, Gray8(0));
    let mut list = SpanList::<f32, 64>::new();
    let mut found = Found::default();
    for scanline in picture.scanlines() {
        let mut next = 0;
        for run in scanline.runs() {
            prop_assert!(run.columns.start == next && run.columns.end > next, "{:?}", run);
            next = run.columns.end;
        }
        prop_assert_eq!(next, width, "the runs do not fill the row");

        for x in 0..width {
            let pixel = [x, scanline.y()];
            let got = scanline.seen(x, &mut list).map(|seen| f64::from(seen.t));
            let depth = |ray: &ModelRay| model.seen(ray, view.start()).map(|seen| seen.t);
            let want = depth(&view.ray(pixel, size, [0.0; 2]));
            found.covered += usize::from(got.is_some());

            // The disc, on circles in it as well: it may be cut by an edge.
            let around = || {
                [1.0, 0.3, 0.1, 0.03, 0.01]
                    .map(|part| view.rays_around(pixel, size, SILHOUETTE * part))
                    .as_flattened()
                    .iter()
                    .map(depth)
                    .collect::<Vec<_>>()
            };
            match (got, want) {
                (None, None) => {}
                (Some(got), Some(want)) if (got - want).abs() <= DEPTH => {
                    found.worst_depth = found.worst_depth.max((got - want).abs());
                }
                (Some(got), Some(want)) => {
                    let [low, high] = range(around().into_iter().flatten().chain([want]));
                    prop_assert!(
                        low - DEPTH <= got && got <= high + DEPTH,
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

const SIZES: [[u16; 2]; 3] = [[96, 72], [33, 47], [1, 1]];

#[test]
fn tee_orthographic() {
    let camera = scene::f32::orthographic().unwrap();
    for size in SIZES {
        let view = caster::tee_orthographic();
        let found = compare(&scene::f32::TEE, &camera, size, &caster::tee(), &view).unwrap();
        println!("{size:?} {found:?}");
        // No pixel of these pictures is anywhere near a silhouette or seen at a grazing angle.
        assert_eq!((found.at_silhouettes, found.steep), (0, 0));
    }
}

#[test]
fn tee_perspective() {
    let camera = scene::f32::perspective().unwrap();
    for size in SIZES {
        let view = caster::tee_perspective();
        let found = compare(&scene::f32::TEE, &camera, size, &caster::tee(), &view).unwrap();
        println!("{size:?} {found:?}");
        assert_eq!((found.at_silhouettes, found.steep), (0, 0));
    }
}

/// The number of the benchmark: 55 % of 320×240.
#[test]
fn tee_covers_41937_pixels() {
    let camera = scene::f32::orthographic().unwrap();
    let size = Size::new(320, 240).unwrap();
    let picture = Picture::new(&scene::f32::TEE, &camera, size, XRay::new(1.0).unwrap(), Gray8(0));
    let mut list = SpanList::<f32, 64>::new();
    let covered: usize = picture
        .scanlines()
        .map(|row| (0..320).filter(|&x| row.seen(x, &mut list).is_some()).count())
        .sum();
    assert_eq!(covered, 41_937);
}

// Random scenes.

type Part = Difference<
    Union<[Cylinder<f32>; 3], [Sphere<f32>; 2]>,
    Union<[Cylinder<f32>; 2], Intersection<Slab<f32>, Sphere<f32>>>,
>;

fn point() -> impl Strategy<Value = [f32; 3]> {
    prop::array::uniform3(-2f32..2.0)
}

fn vector([x, y, z]: [f32; 3]) -> Vec3<f32> {
    vec3(x, y, z)
}

fn widen(v: [f32; 3]) -> caster::V {
    v.map(f64::from)
}

/// A cylinder, oblique or exactly along x, y or z, in both worlds.
fn cylinder() -> impl Strategy<Value = (Cylinder<f32>, ModelSolid)> {
    let way = prop_oneof![
        point(),
        (0..3usize, 0.5f32..3.0).prop_map(|(axis, length)| {
            std::array::from_fn(|i| if i == axis { length } else { 0.0 })
        }),
    ];
    (point(), way, 0.2f32..1.2).prop_filter_map("too short", |(from, way, radius)| {
        let to: [f32; 3] = std::array::from_fn(|i| from[i] + way[i]);
        let model =
            ModelSolid::Cylinder { from: widen(from), to: widen(to), radius: radius.into() };
        let is_long = caster::length(widen(way)) > 0.1;
        let solid = Cylinder::<f32>::between(vector(from), vector(to), radius).ok()?;
        is_long.then_some((solid, model))
    })
}

fn sphere() -> impl Strategy<Value = (Sphere<f32>, ModelSolid)> {
    (point(), 0.3f32..1.2).prop_map(|(center, radius)| {
        let model = ModelSolid::Sphere { center: widen(center), radius: radius.into() };
        (Sphere::<f32>::new(vector(center), radius).unwrap(), model)
    })
}

fn slab() -> impl Strategy<Value = (Slab<f32>, ModelSolid)> {
    (point(), -1f32..1.0, 0.2f32..1.5).prop_filter_map("no normal", |(normal, low, width)| {
        let (high, n) = (low + width, widen(normal));
        let model = ModelSolid::Slab { normal: n, low: low.into(), high: high.into() };
        let solid = Slab::<f32>::new(vector(normal), low, high).ok()?;
        (caster::length(n) > 0.1).then_some((solid, model))
    })
}

fn part() -> BoxedStrategy<(Part, ModelSolid)> {
    let cylinders = (cylinder(), cylinder(), cylinder(), cylinder(), cylinder());
    (cylinders, (sphere(), sphere(), sphere()), slab())
        .prop_map(|((a, b, c, d, e), (f, g, h), i)| {
            let solid = Difference::new(
                Union::new([a.0, b.0, c.0], [f.0, g.0]),
                Union::new([d.0, e.0], Intersection::new(i.0, h.0)),
            );
            let cut = ModelSolid::Any(vec![d.1, e.1, ModelSolid::All(vec![i.1, h.1])]);
            let body = ModelSolid::Any(vec![a.1, b.1, c.1, f.1, g.1]);
            (solid, ModelSolid::Minus(Box::new(body), Box::new(cut)))
        })
        .boxed()
}

const SIZE: [u16; 2] = [24, 19];

/// An orthographic picture along `way` with 6 units of frame height.
fn orthographic(part: &(Part, ModelSolid), way: [f32; 3]) -> Result<Found, TestCaseError> {
    let up = if way[1].abs() > 0.9 * caster::length(widen(way)) as f32 {
        [1.0, 0.0, 0.0]
    } else {
        [0.0, 1.0, 0.0]
    };
    let target = [0.25, -0.125, 0.5];
    let camera = Orthographic::look_along(vector(way), vector(target), vector(up), 6.0).unwrap();
    let view = Model {
        target: widen(target),
        eye: caster::sub(widen(target), widen(way)),
        up: widen(up),
        frame_height: 6.0,
        is_perspective: false,
    };
    compare(&part.0, &camera, SIZE, &part.1, &view)
}

fn perspective(
    part: &(Part, ModelSolid),
    [eye, target]: [[f32; 3]; 2],
    up: [f32; 3],
    field_of_view: f32,
) -> Result<Found, TestCaseError> {
    let camera =
        Perspective::look_at(vector(eye), vector(target), vector(up), field_of_view).unwrap();
    let distance = caster::length(caster::sub(widen(target), widen(eye)));
    let view = Model {
        target: widen(target),
        eye: widen(eye),
        up: widen(up),
        frame_height: 2.0 * distance * (f64::from(field_of_view) / 2.0).tan(),
        is_perspective: true,
    };
    compare(&part.0, &camera, SIZE, &part.1, &view)
}

fn direction() -> impl Strategy<Value = [f32; 3]> {
    prop::array::uniform3(-1f32..1.0).prop_filter("too short", |&v| caster::length(widen(v)) > 0.2)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn random_orthographic(part in part(), way in direction()) {
        orthographic(&part, way)?;
    }

    /// Cylinders along the view have a = 0, and slabs are seen edge-on.
    #[test]
    fn along_a_coordinate_axis(part in part(), axis in 0..3usize, back in prop::bool::ANY) {
        let sign = if back { -1.0 } else { 1.0 };
        orthographic(&part, std::array::from_fn(|i| if i == axis { sign } else { 0.0 }))?;
    }

    /// Nearly along an axis a is tiny, and the entries through walls move fast with the pixel.
    #[test]
    fn nearly_along_a_coordinate_axis(
        part in part(), axis in 0..3usize, off in prop::array::uniform3(-1f32..1.0), power in 1..6i32,
    ) {
        let off = off.map(|k| k * 10f32.powi(-power));
        orthographic(&part, std::array::from_fn(|i| if i == axis { 1.0 } else { off[i] }))?;
    }

    #[test]
    fn random_perspective(
        part in part(), way in direction(), distance in 1f32..12.0, field in 0.2f32..1.5,
    ) {
        let to = [0.25, -0.125, 0.5];
        let scale = distance / caster::length(widen(way)) as f32;
        let from = std::array::from_fn(|i| to[i] - way[i] * scale);
        prop_assume!(way[0].abs() + way[2].abs() > 0.05);
        perspective(&part, [from, to], [0.0, 1.0, 0.0], field)?;
    }

    /// From 10⁵ units away: with the usual quadratic, b² − ac has not one correct digit in
    /// `f32`, and the eye's coordinates resolve hundredths of a unit at best.
    #[test]
    fn from_far_away(part in part(), way in direction()) {
        let scale = 1e5 / caster::length(widen(way)) as f32;
        prop_assume!(way[0].abs() + way[2].abs() > 0.05);
        perspective(&part, [way.map(|k| k * scale), [0.0; 3]], [0.0, 1.0, 0.0], 6e-5)?;
    }

    /// An eye inside a part sees faces from within, and must not see what is behind it.
    #[test]
    fn from_within(part in part(), eye in point(), to in point()) {
        let way = caster::sub(widen(to), widen(eye));
        prop_assume!(way[0].abs() + way[2].abs() > 0.3);
        perspective(&part, [eye, to], [0.0, 1.0, 0.0], 1.2)?;
    }
}

/// From inside a bore, looking along its axis exactly: every ray of the middle is parallel to the
/// wall or nearly so, and the mouth of the bore is all that one sees of the world outside.
#[test]
fn from_inside_a_bore() {
    let shaft = Cylinder::<f32>::along_x(0.0, 0.0, 1.0, -2.0, 2.0).unwrap();
    let bore = Cylinder::<f32>::along_x(0.0, 0.0, 0.5, -3.0, 3.0).unwrap();
    let ball = Sphere::<f32>::new(vec3(5.0, 0.0, 0.0), 0.25).unwrap();
    let along_x = |radius: f64, half: f64| ModelSolid::Cylinder {
        from: [-half, 0.0, 0.0],
        to: [half, 0.0, 0.0],
        radius,
    };
    let pipe = ModelSolid::Minus(Box::new(along_x(1.0, 2.0)), Box::new(along_x(0.5, 3.0)));
    let model =
        ModelSolid::Any(vec![pipe, ModelSolid::Sphere { center: [5.0, 0.0, 0.0], radius: 0.25 }]);
    let solid = (shaft - bore) | ball;
    for eye in [[-1.5, 0.0, 0.0], [-1.0, 0.25, 0.125], [0.0, 0.0, 0.4375]] {
        let to = [3.0, eye[1], eye[2]];
        let camera =
            Perspective::look_at(vector(eye), vector(to), vec3(0.0, 1.0, 0.0), 1.5).unwrap();
        let view = Model {
            target: widen(to),
            eye: widen(eye),
            up: [0.0, 1.0, 0.0],
            frame_height: 2.0 * f64::from(to[0] - eye[0]) * 0.75_f64.tan(),
            is_perspective: true,
        };
        for size in [[33, 33], [24, 18]] {
            let found = compare(&solid, &camera, size, &model, &view).unwrap();
            assert!(found.covered > 100, "{found:?}");
        }
    }
}

/// A picture's own formulas, view by view and row by row, against single rays: in `f64`, where
/// both must be all but the same.
fn rows_are_rays<C>(camera: &C, view: &Model) -> usize
where
    C: Camera<Rays: Rays<Scalar = f64>>,
    scene::Tee<f64>: Project<C::Rays, Scalar = f64>,
{
    let size = [97, 61];
    let solid = scene::f64::TEE;
    let (pixels, shader) = (Size::new(97, 61).unwrap(), XRay::new(1.0).unwrap());
    let picture = Picture::new(&solid, camera, pixels, shader, Gray8(0));
    let [mut of_row, mut of_ray] = [const { SpanList::<f64, 64>::new() }; 2];
    let mut count = 0;
    for scanline in picture.scanlines() {
        for x in 0..97 {
            let ModelRay { origin, direction } = view.ray([x, scanline.y()], size, [0.0; 2]);
            let of = |[x, y, z]: caster::V| vec3(x, y, z);
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
    assert!(rows_are_rays(&camera, &caster::tee_orthographic()) > 3000);
}

#[test]
fn rows_are_rays_perspective() {
    let camera = scene::f64::perspective().unwrap();
    assert!(rows_are_rays(&camera, &caster::tee_perspective()) > 3000);
}

/// Levels of grey against the definition of the shader, for both cameras.
fn check_levels<H: Shader<f32> + Copy>(
    shader: H,
    level: impl Fn(&ModelSolid, &ModelRay, f64) -> Option<f64>,
) {
    let size = [80, 60];
    let tee = caster::tee();
    let to_byte = |level: f64| (level.clamp(0.0, 1.0) * 255.0).round();
    let check = |view: &Model, pixel: [u16; 2], got: u8| {
        let of = |ray: &ModelRay| level(&tee, ray, view.start()).map_or(0.0, to_byte);
        let want = of(&view.ray(pixel, size, [0.0; 2]));
        if (f64::from(got) - want).abs() > 1.0 {
            let around = view.rays_around(pixel, size, SILHOUETTE);
            let [low, high] = range(around.iter().map(of).chain([want]));
            assert!(
                low - 1.0 <= f64::from(got) && f64::from(got) <= high + 1.0,
                "{pixel:?}: {got} is not {want}"
            );
        }
    };
    let pixels = Size::new(80, 60).unwrap();
    let mut list = SpanList::<f32, 64>::new();
    let mut row = [Gray8(0); 80];
    let camera = scene::f32::orthographic().unwrap();
    let picture = Picture::new(&scene::f32::TEE, &camera, pixels, shader, Gray8(0));
    for scanline in picture.scanlines() {
        scanline.render(&mut list, &mut row).unwrap();
        let view = caster::tee_orthographic();
        (0..80).for_each(|x| check(&view, [x, scanline.y()], row[usize::from(x)].0));
    }
    let camera = scene::f32::perspective().unwrap();
    let picture = Picture::new(&scene::f32::TEE, &camera, pixels, shader, Gray8(0));
    for scanline in picture.scanlines() {
        scanline.render(&mut list, &mut row).unwrap();
        let view = caster::tee_perspective();
        (0..80).for_each(|x| check(&view, [x, scanline.y()], row[usize::from(x)].0));
    }
}

#[test]
fn lambert_levels() {
    let light = caster::unit([0.25, 0.85, 0.45]);
    check_levels(Lambert::new(scene::f32::TO_LIGHT, 0.125).unwrap(), |solid, ray, start| {
        let seen = solid.seen(ray, start)?;
        Some(0.125 + 0.875 * caster::dot(seen.normal, light).max(0.0))
    });
}

#[test]
fn depth_levels() {
    check_levels(Depth::new(-2.0, 2.5).unwrap(), |solid, ray, start| {
        Some((2.5 - solid.seen(ray, start)?.t) / 4.5)
    });
}

#[test]
fn xray_levels() {
    check_levels(XRay::new(3.0).unwrap(), |solid, ray, start| {
        solid.seen(ray, start)?;
        let inside = |[a, b]: &[caster::Crossing; 2]| (b.t - a.t.max(start)).max(0.0);
        let sum: f64 = solid.spans(ray).iter().map(inside).sum();
        Some(sum * caster::length(ray.direction) / 3.0)
    });
}

/// Whole rows and their pieces are the same pixels.
#[test]
fn rows_are_their_runs() {
    let camera = scene::f32::perspective().unwrap();
    let light = Lambert::new(scene::f32::TO_LIGHT, 0.125).unwrap();
    let size = Size::new(80, 60).unwrap();
    let picture = Picture::new(&scene::f32::PAINTED_TEE, &camera, size, light, Gray8(9));
    let mut list = SpanList::<f32, 64>::new();
    let mut has_background = false;
    for scanline in picture.scanlines() {
        let [mut whole, mut pieces] = [[Gray8(1); 80], [Gray8(2); 80]];
        scanline.render(&mut list, &mut whole).unwrap();
        for run in scanline.runs() {
            let columns = usize::from(run.columns.start)..usize::from(run.columns.end);
            has_background |= run.is_background;
            scanline.render_run(&run, &mut list, &mut pieces[columns]).unwrap();
        }
        assert_eq!(whole, pieces);
    }
    assert!(has_background);
}
