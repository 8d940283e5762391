//! Spheres that stand anywhere: rays at them, and what is compared on them.

use crate::formulas;
use crate::methods::{Gives, Method, SHIPPED, SurfacePoint};
use crate::methods::{narrowed, numbers_f32, of_grid};
use crate::rays::{Group, Set, Size};
use parry3d::query::RayCast;
use scancsg::geom::{Ray, vec3};
use scancsg::scalar::I16F16;
use scancsg::solid::{RayCast as _, Sphere};
use scancsg::span::SpanList;
use testkit::query::Query;
use testkit::random::Random;
use testkit::vector::{V, along, unit};

pub const SETS: &[Set] = &[
    Set { name: "sphere", group: Group::Sphere, size: Size::Sphere, draw: benign },
    Set { name: "sphere_inside", group: Group::SphereInside, size: Size::Sphere, draw: inside },
    Set { name: "sphere_graze", group: Group::SphereGraze, size: Size::Sphere, draw: graze },
    Set { name: "sphere_near", group: Group::SphereNear, size: Size::Sphere, draw: near },
];

/// A point of a sphere around the origin; uniform.
fn point_in(random: &mut Random, r: f64) -> V {
    let distance = r * random.between(0.0, 1.0).cbrt();
    random.direction().map(|x| distance * x)
}

/// From 3 to 10 radii away, towards a point in the sphere scaled by 1.2.
fn benign(random: &mut Random, r: f64, _: f64) -> [V; 2] {
    let distance = r * random.between(3.0, 10.0);
    let origin = random.direction().map(|x| distance * x);
    [origin, unit(along(point_in(random, 1.2 * r), -1.0, origin))]
}

fn inside(random: &mut Random, r: f64, _: f64) -> [V; 2] {
    [point_in(random, 0.999 * r), random.direction()]
}

/// Passes the surface at 10⁻⁵ (to half or twice as much) of the radius, inside or outside.
fn graze(random: &mut Random, r: f64, _: f64) -> [V; 2] {
    let (normal, way) = (random.direction(), random.direction());
    let rise: f64 = (0..3).map(|i| normal[i] * way[i]).sum();
    let direction = unit(along(way, -rise, normal));
    let distance = r * (1.0 + random.sign() * 1e-5 * random.between(0.5, 2.0));
    let nearest = normal.map(|x| distance * x);
    [along(nearest, -r * random.between(2.0, 10.0), direction), direction]
}

/// From a thousandth of the radius outside the surface.
fn near(random: &mut Random, r: f64, _: f64) -> [V; 2] {
    [random.direction().map(|x| 1.001 * r * x), random.direction()]
}

/// The first one is what every time is a multiple of.
pub fn methods() -> Vec<Method> {
    vec![
        Method::new(["textbook", "f32"], numbers_f32, textbook),
        Method::new(SHIPPED[0], ready_f32, trace_f32).with_point(point_f32),
        Method::new(["scancsg", "f64"], ready_f64, trace_f64),
        Method { gives: Gives::First, ..Method::new(["parry3d", "f32"], parry_input, parry) },
        Method::new(SHIPPED[1], ready_i16f16, trace_i16f16).on_grid().with_point(point_i16f16),
    ]
}

/// b² − 4ac with c = |o|² − r².
fn textbook(&[ox, oy, oz, dx, dy, dz, r, _]: &formulas::f32::Input) -> Option<[f32; 2]> {
    let a = dx * dx + dy * dy + dz * dz;
    let b = 2.0 * (ox * dx + oy * dy + oz * dz);
    let c = ox * ox + oy * oy + oz * oz - r * r;
    let discriminant = b * b - 4.0 * a * c;
    let root = (discriminant >= 0.0).then(|| discriminant.sqrt())?;
    Some([(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)])
}

type Ready<S> = ([S; 3], [S; 3], Sphere<S>);

macro_rules! shipped {
    ($Scalar:ident $number:path, $ready:ident $trace:ident $point:ident) => {
        fn $ready(query: &Query) -> Option<Ready<$Scalar>> {
            let [o, d, [x, y, z]] =
                [query.origin, query.direction, query.base].map(|v| v.map($number));
            Some((o, d, Sphere::<$Scalar>::new(vec3(x, y, z), $number(query.radius)).ok()?))
        }

        fn $trace(&(o, d, ref sphere): &Ready<$Scalar>) -> Option<[$Scalar; 2]> {
            let ray = Ray::new(o.into(), d.into()).ok()?;
            let mut list = SpanList::<$Scalar, 1>::new();
            sphere.trace(&ray, &mut list).first().map(|span| [span.enter.t, span.exit.t])
        }

        #[allow(dead_code)] // not of every type
        fn $point(query: &Query) -> Option<SurfacePoint> {
            let (o, d, sphere) = $ready(query)?;
            let ray = Ray::new(o.into(), d.into()).ok()?;
            let hit = sphere.hit(&ray, &mut SpanList::<$Scalar, 1>::new())?;
            Some(([hit.point.x, hit.point.y, hit.point.z].map(f64::from), true))
        }
    };
}

shipped!(f32 narrowed, ready_f32 trace_f32 point_f32);
shipped!(f64 f64::from, ready_f64 trace_f64 point_f64);
shipped!(I16F16 of_grid, ready_i16f16 trace_i16f16 point_i16f16);

fn parry_input(query: &Query) -> Option<(parry3d::query::Ray, parry3d::shape::Ball)> {
    let [ox, oy, oz, dx, dy, dz, r, _] = numbers_f32(query)?;
    let ray = parry3d::query::Ray::new([ox, oy, oz].into(), [dx, dy, dz].into());
    Some((ray, parry3d::shape::Ball::new(r)))
}

fn parry((ray, sphere): &(parry3d::query::Ray, parry3d::shape::Ball)) -> Option<[f32; 2]> {
    sphere.cast_local_ray(ray, f32::MAX, false).map(|t| [t, t])
}
