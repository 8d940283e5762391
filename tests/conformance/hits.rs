//! What a ray sees: the point is on the surface, and the normal has length 1 and points towards the ray,
//! also where a parameter's unit is longer than the solid.

use crate::limits;
use crate::number::{Tested, coordinates, vector};
use proptest::prelude::*;
use scancsg::geom::{Ray, Vec3};
use scancsg::solid::{CylinderWall, RayCast};
use scancsg::span::SpanList;
use testkit::vector::dot;

for_every_number!(
    walls_and_balls_are_seen_from_outside_and_inside,
    thinner_than_a_unit_of_the_parameter
);

/// The point's distance from a surface at `radius` around the centre, or around the axis through it.
fn off_surface<S: Tested>(
    point: Vec3<S>,
    center: [f64; 3],
    axis: Option<usize>,
    radius: f64,
) -> f64 {
    let point = coordinates(point);
    let mut u: [f64; 3] = std::array::from_fn(|i| point[i] - center[i]);
    if let Some(axis) = axis {
        u[axis] = 0.0;
    }
    (dot(u, u).sqrt() - radius).abs()
}

/// Hits of a ball, of a long cylinder along a coordinate axis, and of its wall, around the same centre. The
/// cosine of normal and direction is at most `most_along`.
fn check<S: Tested>(
    axis: usize,
    center: [f64; 3],
    radius: f64,
    ray: &Ray<S>,
    way: [f64; 3],
    most_along: f64,
) -> Result<(), TestCaseError> {
    let [x, y, z] = center;
    let middle = [[y, z], [x, z], [x, y]][axis];
    let [low, high] = [-S::MAX_COORDINATE.to_f64(), S::MAX_COORDINATE.to_f64()].map(S::near);
    let rod = S::along(axis, middle.map(S::near), S::near(radius), low, high).unwrap();
    let ball = S::sphere(vector(center), S::near(radius)).unwrap();
    let mut list = SpanList::<S, 1>::new();
    let seen = |hit: scancsg::solid::Hit<S>| (hit.point, hit.normal);
    let hits = [
        (None, ball.hit(ray, &mut list).map(seen)),
        (Some(axis), rod.hit(ray, &mut list).map(seen)),
        (Some(axis), CylinderWall::of(&rod).hit(ray).map(|hit| (hit.point, hit.normal))),
    ];
    for (axis, hit) in hits {
        let Some((point, normal)) = hit else { continue };
        // Coordinates are below 4.
        let unit = if S::IS_FIXED { S::UNIT } else { 2.0 * S::UNIT };
        let allowed = limits::HIT_POINT.of::<S>();
        prop_assert!(off_surface(point, center, axis, radius) <= allowed, "{point:?}");
        let normal = coordinates(normal);
        let off = (dot(normal, normal).sqrt() - 1.0).abs();
        prop_assert!(off <= limits::NORMAL_LENGTH * (unit / radius + S::UNIT), "{normal:?}");
        let along = dot(normal, way) / dot(way, way).sqrt();
        prop_assert!(along <= most_along, "{normal:?} along the ray");
    }
    Ok(())
}

/// Whatever a ray starts from and is aimed at.
fn walls_and_balls_are_seen_from_outside_and_inside<S: Tested>() {
    let on_grid = |x: f64| S::near(x).to_f64();
    proptest!(|(
        axis in 0..3usize, center in prop::array::uniform3(-2.0..2.0), radius in 0.3..1.5,
        from in prop::array::uniform3(-6.0..6.0), past in prop::array::uniform3(-1.0..1.0),
    )| {
        let (center, radius): ([f64; 3], _) = (center.map(on_grid), on_grid(radius));
        let way = std::array::from_fn(|i| on_grid(center[i] + 1.2 * radius * past[i] - from[i]));
        prop_assume!(way.iter().any(|x: &f64| x.abs() >= 0.5));
        let ray = Ray::<S>::new(vector(from), vector(way)).unwrap();
        check(axis, center, radius, &ray, way, 1e-3)?;
    });
}

/// A parameter is rounded by more than the solid is long, so the point there may be anywhere in it, or
/// beyond it.
fn thinner_than_a_unit_of_the_parameter<S: Tested>() {
    let on_grid = |x: f64| S::near(x).to_f64();
    let thin = if S::IS_FIXED { 100.0 * S::UNIT } else { 1e-3 };
    let longest = if S::IS_FIXED { S::LONGEST.to_f64() } else { 16384.0 };
    proptest!(|(
        axis in 0..3usize, center in prop::array::uniform3(-2.0..2.0), radius in 0.2..10.0,
        steps in -3..=-1i32, past in prop::array::uniform3(-0.5..0.5), way in prop::array::uniform3(-1.0..1.0),
        scale in -6..=0i32, on_axis: bool,
    )| {
        let (center, radius): ([f64; 3], _) = (center.map(on_grid), on_grid(radius * thin));
        let way: [f64; 3] = way.map(|x: f64| on_grid(x * longest * 2f64.powi(scale)));
        prop_assume!(way.iter().any(|x| x.abs() >= 0.5));
        // From a few units of t away, and past the middle by half of the radius at most, or not at all.
        let from: [f64; 3] = std::array::from_fn(|i| {
            let past = if on_axis { 0.0 } else { past[i] * radius };
            center[i] + past + f64::from(steps) * S::UNIT * way[i]
        });
        let ray = Ray::<S>::new(vector(from), vector(way)).unwrap();
        check(axis, center, radius, &ray, way, 0.2)?;
    });
    // By half a unit of t: the nearest point of the line that t can say is on the axis.
    let rod = S::along(0, [S::ZERO; 2], S::near(0.1), S::ONE.negated(), S::ONE).unwrap();
    let ray = Ray::new(vector([0.0, -4.0, 0.0]), vector([0.0, longest, 0.0])).unwrap();
    let hit = rod.hit(&ray, &mut SpanList::<S, 1>::new()).unwrap();
    assert_eq!(coordinates(hit.normal), [0.0, -1.0, 0.0]);
    assert_eq!(coordinates(hit.point), [0.0, -S::near(0.1).to_f64(), 0.0]);
}
