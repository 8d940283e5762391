//! Solids of a few units of fixed point: what is seen of them faces whoever sees it.

use scancsg::geom::{Ray, Vec3};
use scancsg::scalar::{I16F16, Scalar};
use scancsg::solid::{Cylinder, CylinderWall, Sphere};
use scancsg::solid::{RayCast, Solid};
use scancsg::span::SpanList;
use testkit::number::coordinates;
use testkit::random::Random;
use testkit::vector::{V, dot, length};

type S = I16F16;

/// The sine of 8°: by so much a normal may point away from the viewer.
const AWAY: f64 = 0.139_2;

fn point(bits: V) -> Vec3<S> {
    Vec3::from(bits.map(|x| S::from_bits(x.round() as i32)))
}

/// Checks the normal that a ray sees; returns whether it sees anything.
fn check(normal: Option<Vec3<S>>, way: V, about: &str) -> bool {
    let Some(normal) = normal.map(coordinates) else { return false };
    let long = length(normal);
    assert!((long - 1.0).abs() < 0.07, "{about}: a normal {normal:?} of length {long}");
    let away = dot(normal, way) / length(way) / long;
    assert!(away <= AWAY, "{about}: {normal:?} points away by {}°", away.asin().to_degrees());
    true
}

/// Rays from anywhere near, of any length, at solids anywhere.
fn rays(random: &mut Random, count: u32, mut ask: impl FnMut(&mut Random, V, &Ray<S>, V, u32)) {
    for _ in 0..count {
        let center = random.point(1000.0).map(f64::round);
        let radius = 1 + random.below(3) as u32;
        let far = random.between(1.0, 6.0).exp2();
        let (from, aim) = (random.direction(), random.point(f64::from(radius)));
        let start: V = std::array::from_fn(|i| center[i] + far * from[i]);
        let size = random.between(16.0, 20.0).exp2();
        let way: V = std::array::from_fn(|i| center[i] + aim[i] - start[i]);
        let way = way.map(|x| x / length(way) * size);
        let (origin, direction) = (point(start), point(way));
        let Ok(ray) = Ray::new(origin, direction) else { continue };
        ask(random, center, &ray, coordinates(direction), radius);
    }
}

fn hit(solid: &impl Solid<Scalar = S>, ray: &Ray<S>) -> Option<Vec3<S>> {
    solid.hit(ray, &mut SpanList::<S, 1>::new()).map(|hit| hit.normal)
}

#[test]
fn normals_of_tiny_balls_face_the_viewer() {
    let (mut random, mut seen) = (Random::named("tiny balls"), 0);
    rays(&mut random, 200_000, |_, center, ray, way, radius| {
        let ball = Sphere::<S>::new(point(center), S::from_bits(radius as i32)).unwrap();
        seen += u32::from(check(hit(&ball, ray), way, &format!("{radius} {center:?} {ray:?}")));
    });
    assert!(seen > 50_000, "{seen}");
}

#[test]
fn normals_of_tiny_cylinders_face_the_viewer() {
    let (mut random, mut seen) = (Random::named("tiny cylinders"), [0; 2]);
    rays(&mut random, 200_000, |random, center, ray, way, radius| {
        let r = S::from_bits(radius as i32);
        let long = random.direction().map(|x| x * random.between(2.0, 500.0));
        let end: V = std::array::from_fn(|i| center[i] + long[i]);
        let [x, y, z] = point(center).to_array();
        let rod = match random.below(4) {
            0 => Cylinder::<S>::along_x(y, z, r, x, x + S::from_bits(99)),
            1 => Cylinder::<S>::along_y(x, z, r, y, y + S::from_bits(5)),
            2 => Cylinder::<S>::along_z(x, y, r, z, z + S::MIN_RADIUS),
            _ => Cylinder::<S>::between(point(center), point(end), r),
        };
        let Ok(rod) = rod else { return };
        let about = format!("{radius} {rod:?} {ray:?}");
        seen[0] += u32::from(check(hit(&rod, ray), way, &about));
        let wall = CylinderWall::of(&rod).hit(ray).map(|hit| hit.normal);
        seen[1] += u32::from(check(wall, way, &about));
    });
    assert!(seen.iter().all(|&seen| seen > 30_000), "{seen:?}");
}
