//! Rays that start on a surface: they leave the face that they start on.

use crate::number::{Tested, vector};
use crate::pictures::{direction, held};
use proptest::prelude::*;
use scancsg::geom::{AffineMap, Axis, Pose, Ray, Vec3};
use scancsg::solid::{
    Cone, Cuboid, Cylinder, HalfSpace, Placed, Polyhedron, RayCast, Scaled, Slab, Solid, Sphere,
    Torus,
};
use scancsg::span::SpanList;
use std::cell::Cell;

for_every_number!(convex_solids_are_left, placed_solids_are_left, cut_solids_are_left);

/// Rays a solid and number type; more where `SCANCSG_CASES` says so.
fn cases() -> u32 {
    std::env::var("SCANCSG_CASES").ok().map_or(2000, |cases| cases.parse().unwrap())
}

type V = [f64; 3];

/// No coordinate is larger.
fn scene<S: Tested>() -> S {
    S::from_int(5)
}

fn place<S: Tested>() -> impl Strategy<Value = V> {
    prop::array::uniform3(-3.0..3.0).prop_map(held::<S>)
}

/// A small or a large length.
fn length() -> impl Strategy<Value = f64> {
    prop_oneof![0.015..0.1, 0.1..2.0]
}

/// Rays at a point near a solid, and a way on from where they meet it.
fn aim<S: Tested>() -> impl Strategy<Value = (V, V, V)> {
    (direction::<S>(), prop::array::uniform3(-0.7..0.7), direction::<S>())
}

fn diagonal<S: Tested>([x, y, z]: [S; 3]) -> [Vec3<S>; 3] {
    let o = S::ZERO;
    [Vec3::new(x, o, o), Vec3::new(o, y, o), Vec3::new(o, o, z)]
}

/// From outside, a way on from a convex solid's face to its outer side meets nothing; to its inner side, what
/// it meets is the way out, a good way off.
fn check<S, T>(
    solid: &T,
    (center, size): (V, f64),
    (way, off, on): (V, V, V),
    met: &Cell<u32>,
) -> Result<(), TestCaseError>
where
    S: Tested,
    T: Solid<Scalar = S>,
{
    let mut list = SpanList::<S, 4>::new();
    let from: V = std::array::from_fn(|i| center[i] - 8.0 * way[i]);
    let to: V = std::array::from_fn(|i| 8.0 * way[i] + size * off[i]);
    let Ok(ray) = Ray::new(vector(from), vector(to)) else { return Ok(()) };
    let Some(hit) = solid.hit(&ray, &mut list) else { return Ok(()) };
    if hit.inside {
        return Ok(());
    }
    // Grazing ways as well.
    let graze = |v: Vec3<S>| v + hit.normal * hit.normal.dot(v).times(S::near(0.001)).negated();
    for on in [vector::<S>(on), graze(vector(on))] {
        let Ok(next) = hit.leave(on, scene::<S>()) else { continue };
        // A normal in fixed point is rounded: along the face, a way may lead through it.
        let rounding = if S::IS_FIXED { S::near(8.0 * S::UNIT) } else { S::ZERO };
        let along = hit.normal.dot(on);
        let leaves = along >= rounding;
        if along >= S::ZERO && !leaves {
            continue;
        }
        met.set(met.get() + 1);
        match solid.hit(&next, &mut list) {
            None => {}
            Some(again) => {
                prop_assert!(!leaves, "{again:?} behind {hit:?}");
                // At a sharp edge, the start may have gone through the next face.
                let is_other = again.face != hit.face;
                prop_assert!(again.inside || is_other, "it is outside of the face");
            }
        }
    }
    Ok(())
}

fn convex_solids_are_left<S: Tested>() {
    let met = Cell::new(0);
    proptest!(ProptestConfig::with_cases(cases()), |(
        center in place::<S>(), size in length(), to in direction::<S>(), aim in aim::<S>(),
    )| {
        let [c, r] = [vector::<S>(center), vector([size, size, size])];
        let reach = vector::<S>(to.map(|x| x * size));
        let at = (center, size);
        check(&Sphere::around(c, r.x).unwrap(), at, aim, &met)?;
        check(&Cuboid::around(c, r).unwrap(), at, aim, &met)?;
        if let Ok(rod) = Cylinder::from_to(c - reach, c + reach, r.x) {
            check(&rod, at, aim, &met)?;
        }
        let ends = [c.z.minus(r.z), c.z.plus(r.z)];
        check(&Cylinder::along(Axis::Z, [c.x, c.y], r.x, ends[0], ends[1]).unwrap(), at, aim, &met)?;
        let offset = vector::<S>(to).dot(c);
        if let Ok(half) = HalfSpace::facing(vector(to), offset) {
            check(&half, at, aim, &met)?;
        }
        if let Ok(slab) = Slab::facing(vector(to), offset, offset.plus(r.x)) {
            check(&slab, at, aim, &met)?;
        }
        let polygon: [[S; 2]; 5] = std::array::from_fn(|i| {
            let angle = std::f64::consts::TAU * i as f64 / 5.0;
            [center[0] + size * angle.cos(), center[1] + size * angle.sin()].map(S::near)
        });
        let radii = [r.x, S::near(size * 0.4)];
        if let Ok(cone) = Cone::from_to(c - reach, c + reach, radii) {
            check(&cone, at, aim, &met)?;
        }
        check(&Cone::along(Axis::Y, [c.x, c.z], radii, c.y.minus(r.y), c.y.plus(r.y)).unwrap(), at, aim, &met)?;
        let stretch = [1.5, -0.5, 0.75].map(S::near);
        let shift = AffineMap::with_columns(diagonal(stretch), c).unwrap();
        let egg = Scaled::new(Sphere::around(Vec3::ZERO, r.x).unwrap(), shift);
        check(&egg, at, aim, &met)?;
        if let Ok(prism) = Polyhedron::<S, 7>::extruded(Axis::Z, polygon, ends[0], ends[1]) {
            check(&prism, at, aim, &met)?;
        }
    });
    assert!(met.get() > 5 * cases(), "{met:?}");
}

/// Turned, a solid's faces are known as well as its size allows: `leave` is told how large it is.
fn placed_solids_are_left<S: Tested>() {
    let met = Cell::new(0);
    proptest!(ProptestConfig::with_cases(cases()), |(
        half in prop_oneof![0.1..2.0, 2.0..100.0], axis in direction::<S>(), angle in -3.0..3.0,
        (way, off, on) in aim::<S>(),
    )| {
        let h = S::near(half);
        let cuboid = Cuboid::around(Vec3::ZERO, Vec3::new(h, h, h)).unwrap();
        let pose = Pose::about(vector(axis), S::near(angle)).unwrap();
        let solid = Placed::new(cuboid, pose);
        let mut list = SpanList::<S, 4>::new();
        let from: V = std::array::from_fn(|i| 3.0 * half * way[i]);
        let to: V = std::array::from_fn(|i| half * off[i] - from[i]);
        let longest = to.iter().fold(0.0f64, |most, x| most.max(x.abs()));
        let to = to.map(|x| x / longest);
        let Ok(ray) = Ray::new(vector(from), vector(to)) else { return Ok(()) };
        let Some(hit) = solid.hit(&ray, &mut list) else { return Ok(()) };
        let on = vector::<S>(on);
        if hit.inside || hit.normal.dot(on).to_f64() < 0.01 {
            return Ok(());
        }
        let Ok(next) = hit.leave(on, h.plus(h)) else { return Ok(()) };
        met.set(met.get() + 1);
        let again = solid.hit(&next, &mut list);
        prop_assert!(again.is_none(), "{:?} behind {:?}", again, hit);
    });
    assert!(met.get() > cases() / 5, "{met:?}");
}

/// In a bore, what is met next lies on the chord: never at the start.
fn cut_solids_are_left<S: Tested>() {
    let met = Cell::new(0);
    proptest!(ProptestConfig::with_cases(cases()), |(
        center in place::<S>(), size in length(), (way, off, on) in aim::<S>(),
    )| {
        let [x, y, z] = vector::<S>(center).to_array();
        let [r, bore] = [size, size / 2.0].map(S::near);
        let rod = |radius| Cylinder::along(Axis::Z, [x, y], radius, z.minus(r), z.plus(r)).unwrap();
        let tube = rod(r) - rod(bore);
        let ring = Torus::along(Axis::Z, vector(center), r, S::near(size / 3.0)).unwrap();
        check_next(&ring, (center, size), (way, off, on), &met)?;
        check_next(&tube, (center, size), (way, off, on), &met)?;
    });
    assert!(met.get() > cases() / 20, "{met:?}");
}

/// From outside of a solid that isn't convex, and not too flat: the next face is some way off.
fn check_next<S, T>(
    solid: &T,
    (center, size): (V, f64),
    (way, off, on): (V, V, V),
    met: &Cell<u32>,
) -> Result<(), TestCaseError>
where
    S: Tested,
    T: Solid<Scalar = S>,
{
    let mut list = SpanList::<S, 8>::new();
    let from: V = std::array::from_fn(|i| center[i] + size * 0.3 * off[i]);
    let Ok(ray) = Ray::new(vector(from), vector(way)) else { return Ok(()) };
    let Some(hit) = solid.hit(&ray, &mut list) else { return Ok(()) };
    let on = vector::<S>(on);
    let cosine = hit.normal.dot(on);
    // At right angles to the wall, a chord has 2 r cos of its angle to the normal: more than rounding.
    if hit.inside || cosine.to_f64() < 0.05 {
        return Ok(());
    }
    let Ok(next) = hit.leave(on, scene::<S>()) else { return Ok(()) };
    met.set(met.get() + 1);
    if let Some(again) = solid.hit(&next, &mut list) {
        let way = again.t.to_f64() * on.length_squared().to_f64().sqrt();
        prop_assert!(!again.inside && way > 0.02 * size, "{} of {}", way, size);
    }
    Ok(())
}
