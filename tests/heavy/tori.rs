//! The torus: in pictures what its lines say, and hits on its surface. Its lines alone are in
//! `tests/exact/torus.rs`.

use crate::aim::{direction, from_middle, up};
use crate::limits;
use crate::number::{Tested, coordinates, ray, spans, vector};
use proptest::prelude::*;
use scancsg::geom::{Pose, Ray, RayRow, Rays, Vec3};
use scancsg::render::{Camera, Gray8, Orthographic, Perspective, Picture, Size, XRay};
use scancsg::solid::{ByLine, Placed, RayCast, Scan, Solid, Torus};
use scancsg::span::{Face, Span, SpanList};
use std::cell::Cell;
use testkit::number::between;
use testkit::vector::{along, cross, dot, length, sub, times, unit};

for_every_number!(
    pictures_show_what_lines_say,
    silhouettes_of_any_size_cut_nothing_off,
    hits_are_on_the_surface,
    touching_lines_miss,
    lines_along_the_axis_and_in_the_plane,
    a_bead_on_a_rod,
);

fn torus<S: Tested>(center: [f64; 3], axis: [f64; 3], radii: [f64; 2]) -> Torus<S> {
    S::torus(vector(center), vector(axis), radii.map(S::near)).unwrap()
}

/// The spans of every pixel are those of its line, by the bit; returns how many there are, and how many
/// of them are the second ones of their lines.
fn check<S, T, C>(solid: &T, camera: &C, size: Size) -> Result<[u32; 2], TestCaseError>
where
    S: Tested,
    C: Camera<Rays: Rays<Scalar = S>>,
    T: Solid<Scalar = S> + Scan<C::Rays>,
{
    let mut picture = Picture::new(solid, camera, size, XRay::new(S::ONE).unwrap(), Gray8(0));
    let rays = camera.rays(size);
    let mut counts = [0; 2];
    for y in 0..size.height() {
        // A picture too large for the number type is an error.
        let Ok(mut scanline) = picture.scanline(y) else { return Ok(counts) };
        let row = rays.row(from_middle(y.into(), size.height().into()));
        for x in 0..size.width() {
            let [mut got, mut want] = [SpanList::<S, 8>::new(), SpanList::<S, 8>::new()];
            let got: &[Span<S>] = scanline.spans(x, &mut got);
            let line = row.line(from_middle(x.into(), size.width().into()));
            solid.spans(&line, Face(0), &mut want.stack());
            prop_assert_eq!(got, want.as_slice(), "{} {}", x, y);
            counts[0] += u32::from(!got.is_empty());
            counts[1] += u32::from(got.len() > 1);
        }
    }
    Ok(counts)
}

fn place() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(-1.0..1.0)
}

fn axis() -> impl Strategy<Value = [f64; 3]> {
    let aligned = prop::sample::select(vec![[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]);
    prop_oneof![2 => direction(), 1 => aligned]
}

fn pictures_show_what_lines_say<S: Tested>() {
    let total = Cell::new([0; 2]);
    let size = Size::new(40, 30).unwrap();
    proptest!(ProptestConfig::with_cases(60), |(
        center in place(), axis in axis(), ring in 0.3..1.5f64, part in 0.05..0.95f64,
        way in direction(), zoom in 0.5..6f64, far in prop_oneof![Just(0.5), Just(4.0)],
    )| {
        let solid = torus::<S>(center, axis, [ring, ring * part]);
        let frame = S::near(zoom);
        let mut count = [0; 2];
        let mut add = |[all, two]: [u32; 2]| count = [count[0] + all, count[1] + two];
        let pose = Pose::rotation_z(S::near(0.5)).unwrap();
        for way in [way, axis] {
            if let Ok(camera) = Orthographic::look_along(vector(way), Vec3::ZERO, up(), frame) {
                add(check(&solid, &camera, size)?);
                // As a solid of one's own, too.
                check(&ByLine::<_, 2>::new(solid), &camera, size)?;
            }
            let eye = vector(way.map(|x| -x * far));
            if let Ok(camera) = Perspective::look_at(eye, Vec3::ZERO, up(), S::near(0.9)) {
                add(check(&solid, &camera, size)?);
                let placed = Placed::new(&solid, pose);
                let mut picture =
                    Picture::new(&placed, &camera, size, XRay::new(S::ONE).unwrap(), Gray8(0));
                prop_assert!(picture.scanline(0).is_ok());
            }
        }
        total.set([total.get()[0] + count[0], total.get()[1] + count[1]]);
    });
    let [all, two] = total.get();
    assert!(all > 10_000 && two > 1000, "{all} {two}");
}

/// From a few pixels to much larger than the picture, near the picture's middle and far from it.
fn silhouettes_of_any_size_cut_nothing_off<S: Tested>() {
    let total = Cell::new(0);
    let size = Size::new(48, 24).unwrap();
    proptest!(ProptestConfig::with_cases(150), |(
        center in place(), axis in axis(), ring in -1.5..0.5f64, part in 0.01..0.99f64,
        way in direction(), side in direction(), zoom in -4.0..1.0f64, past in -1.0..1.0f64,
    )| {
        let ring = 10f64.powf(ring);
        let solid = torus::<S>(center, axis, [ring, ring * part]);
        // At a point of the outline, as seen along the axis or from the side, and just beside it.
        let zoom = 10f64.powf(zoom);
        let outline = unit(cross(axis, side));
        for (out, reach) in [(outline, ring * (1.0 + part)), (unit(axis), ring * part)] {
            let target = along(along(center, reach, out), zoom * past, side);
            let frame = S::near(zoom.max(1000.0 * S::ROUNDING.to_f64()));
            let mut found = 0;
            if let Ok(camera) = Orthographic::look_along(vector(way), vector(target), up(), frame) {
                found += check(&solid, &camera, size)?[0];
            }
            let eye: [f64; 3] = along(target, -3.0, way);
            let field = S::near((zoom / 3.0).max(1000.0 * S::ROUNDING.to_f64()));
            if let Ok(camera) = Perspective::look_at(vector(eye), vector(target), up(), field) {
                found += check(&solid, &camera, size)?[0];
            }
            total.set(total.get() + found);
        }
    });
    assert!(total.get() > 10_000, "{total:?}");
}

fn hits_are_on_the_surface<S: Tested>() {
    let hits = Cell::new(0);
    let on_grid = |x: f64| S::near(x).to_f64();
    proptest!(|(
        center in place(), axis in axis(), ring in 0.5..1.5f64, part in 0.1..0.9f64,
        from in prop::array::uniform3(-4.0..4.0f64), past in place(),
    )| {
        let (center, radii) = (center.map(on_grid), [ring, ring * part].map(on_grid));
        let solid = torus::<S>(center, axis, radii);
        let from = from.map(on_grid);
        let way: [f64; 3] = std::array::from_fn(|i| on_grid(center[i] + 1.5 * past[i] - from[i]));
        prop_assume!(way.iter().any(|x| x.abs() >= 0.5));
        let ray = Ray::<S>::new(vector(from), vector(way)).unwrap();
        let Some(hit) = solid.hit(&ray, &mut SpanList::<S, 2>::new()) else { return Ok(()) };
        hits.set(hits.get() + 1);
        // The way from the ring's nearest point, with the axis as it is rounded.
        let axis = unit(S::rounded_axis(vector(axis)));
        let u = sub(coordinates(hit.point), center);
        let across = along(u, -dot(u, axis), axis);
        let outward = sub(u, times(across, radii[0] / length(across)));
        let off = (length(outward) - radii[1]).abs();
        prop_assert!(off <= limits::TORUS_POINT.of::<S>(), "{off} off: {hit:?}");
        let side = if hit.inside { -1.0 } else { 1.0 };
        let normal = coordinates(hit.normal);
        let off = length(sub(normal, times(unit(outward), side)));
        let [of_point, own] = limits::TORUS_NORMAL.map(|units| units.of::<S>());
        prop_assert!(off <= of_point / radii[1] + own, "{normal:?} is {off} off");
        prop_assert!((length(normal) - 1.0).abs() <= own, "{normal:?}");
        prop_assert!(dot(normal, way) / length(way) <= 1e-3, "{normal:?} along the ray");
    });
    assert!(hits.get() > 50, "{hits:?}");
}

/// In the planes on either side, and around the outside, a line has no length inside.
fn touching_lines_miss<S: Tested>() {
    for axis in 0..3 {
        let turned = |v: [f64; 3]| std::array::from_fn(|i| v[(i + 3 - axis) % 3]);
        let solid = S::torus_along(axis, Vec3::ZERO, [2.0, 0.5].map(S::near)).unwrap();
        let count = |origin, way| spans(&solid, &ray::<S>(turned(origin), turned(way))).len();
        for side in [1.0, -1.0] {
            assert_eq!(count([0.5 * side, -4.0, 0.0], [0.0, 1.0, 0.0]), 0);
            assert_eq!(count([0.5 * side, -4.0, 1.0], [0.0, 1.0, 0.0]), 0);
            assert_eq!(count([0.0, 2.5 * side, -4.0], [0.0, 0.0, 1.0]), 0);
            assert_eq!(count([-4.0, 2.5 * side, 0.0], [1.0, 0.0, 0.0]), 0);
            assert_eq!(count([-4.0, 1.5 * side, 0.0], [1.0, 0.0, 0.0]), 0);
            assert_eq!(count([-4.0, 0.0, 0.0], [side, 0.0, 0.0]), 0);
            // A line that touches the hole from outside: it is inside on both sides.
            assert_eq!(count([0.0, 1.5 * side, -4.0], [0.0, 0.0, 1.0]), 1);
        }
    }
}

fn lines_along_the_axis_and_in_the_plane<S: Tested>() {
    let solid = S::torus_along(2, vector([1.0, 2.0, 3.0]), [2.0, 0.5].map(S::near)).unwrap();
    let ends = |origin, way| spans(&solid, &ray::<S>(origin, way));
    assert_eq!(ends([3.0, 2.0, 0.0], [0.0, 0.0, 1.0]), [(2.5, 3.5)]);
    assert_eq!(ends([-5.0, 2.0, 3.0], [1.0, 0.0, 0.0]), [(3.5, 4.5), (7.5, 8.5)]);
    assert_eq!(ends([1.0, 2.0, 3.0], [0.0, -1.0, 0.0]), [(-2.5, -1.5), (1.5, 2.5)]);
    // From inside the tube, from the middle of the hole: what is behind is negative.
    assert_eq!(ends([3.0, 2.0, 3.0], [0.0, 0.0, -2.0]), [(-0.25, 0.25)]);
}

/// Two spans meet one: in the middle of a tree, on either side.
fn a_bead_on_a_rod<S: Tested>() {
    let solid = torus::<S>([0.0; 3], [0.0, 0.0, 1.0], [2.0, 0.5]);
    let rod = between::<S>([-4.0, 0.0, 0.0], [4.0, 0.0, 0.0], 0.25);
    let level = ray::<S>([-8.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
    let steep = ray::<S>([2.0, 0.0, 8.0], [0.0, 0.0, -1.0]);
    assert_eq!(spans(&(solid | rod), &level), [(4.0, 12.0)]);
    assert_eq!(spans(&(rod - solid), &level), [(4.0, 5.5), (6.5, 9.5), (10.5, 12.0)]);
    assert_eq!(spans(&(solid & rod), &level), [(5.5, 6.5), (9.5, 10.5)]);
    assert_eq!(spans(&(solid - rod), &level), []);
    assert_eq!(spans(&(solid - rod), &steep), [(7.5, 7.75), (8.25, 8.5)]);
    assert_eq!(spans(&[solid, solid], &level), spans(&solid, &level));
}
