//! Single rays at a torus against exact whole numbers: as many spans as Sturm's theorem says, and each
//! parameter by how far it is from its root.
//!
//! `TORUS_RAYS=100000 cargo test --release --test torus_exact -- --nocapture` measures more rays.

use scancsg::geom::Ray;
use scancsg::scalar::{I16F16, Scalar};
use scancsg::solid::RayCast;
use scancsg::span::SpanList;
use testkit::limits;
use testkit::number::{Tested, coordinates, vector};
use testkit::quartic::{Quartic, Torus as Model};
use testkit::random::Random;
use testkit::ulp::percentiles;
use testkit::vector::{V, add, along, cross, sub, times, unit};

fn rays() -> usize {
    std::env::var("TORUS_RAYS").ok().and_then(|count| count.parse().ok()).unwrap_or(1000)
}

/// How a ray is drawn.
#[derive(Debug, Clone, Copy)]
enum Kind {
    Ordinary,
    /// From so many ring radii away, as powers of ten.
    Far([f64; 2]),
    /// Past the surface by up to a tenth, and down to 10⁻⁶ of the tube.
    Grazing,
    /// Up to 10⁻² and down to 10⁻⁶ off the axis, or not at all.
    AlongAxis,
    /// The same off the plane of the ring.
    AlongPlane,
    FromInside,
    FromHole,
    FromSurface,
    /// A tube of a ten-thousandth of the ring.
    Thin,
    /// Through a hole of 10⁻¹ to 10⁻⁴ of the ring, or beside it.
    Pinhole,
}

struct Case<S: Scalar> {
    model: Model,
    origin: V,
    direction: V,
    solid: scancsg::solid::Torus<S>,
    ray: Ray<S>,
}

/// A point on the surface, and the outward normal.
fn on_surface(random: &mut Random, frame: &[V; 3], radii: [f64; 2]) -> (V, V) {
    let [_, cos, sin] = random.across();
    let out = add(times(frame[1], cos), times(frame[2], sin));
    let [_, cos, sin] = random.across();
    let normal = add(times(out, cos), times(frame[0], sin));
    (along(times(out, radii[0]), radii[1], normal), normal)
}

fn power(random: &mut Random, low: f64, high: f64) -> f64 {
    10f64.powf(random.between(low, high))
}

fn draw<S: Tested>(random: &mut Random, kind: Kind, is_oblique: bool) -> Option<Case<S>> {
    let ring = power(random, -0.5, 0.5);
    let part = match kind {
        Kind::Thin => 1e-4,
        Kind::Pinhole => 1.0 - power(random, -4.0, -1.0),
        _ => random.between(0.02, 0.95),
    };
    let tube = ring * part;
    let center = times(random.direction(), random.between(0.0, 3.0));
    let axis: V = if is_oblique {
        random.direction()
    } else {
        let mut axis = [0.0; 3];
        axis[random.below(3)] = random.sign();
        axis
    };
    let first =
        unit(cross(axis, if axis[0].abs() < 0.7 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] }));
    let frame = [axis, first, cross(axis, first)];
    let (surface, normal) = on_surface(random, &frame, [ring, tube]);
    let inside = along(surface, -tube * random.between(0.001, 1.999), normal);
    let any = unit(random.direction());
    let small = if random.chance(0.1) { 0.0 } else { power(random, -6.0, -2.0) };
    // A point of the line, its direction, and how far before the point it starts.
    let (at, way, back) = match kind {
        Kind::Ordinary | Kind::Thin => {
            let aim = along(inside, random.between(0.0, 1.0) * tube, random.direction());
            (aim, any, ring * random.between(2.5, 10.0))
        }
        Kind::Far([low, high]) => (inside, any, ring * power(random, low, high)),
        Kind::Grazing => {
            let past = tube * random.sign() * power(random, -6.0, -1.0);
            let tangent = unit(cross(normal, any));
            (along(surface, past, normal), tangent, ring * random.between(-1.0, 6.0))
        }
        Kind::AlongAxis => {
            let side = unit(cross(axis, any));
            (inside, add(axis, times(side, small)), ring * random.between(2.5, 10.0))
        }
        Kind::AlongPlane => {
            let side = unit(cross(axis, any));
            let height = axis.map(|x| x * tube * random.between(-1.05, 1.05));
            let aim = add(times(side, random.between(-1.0, 1.0) * (ring + tube)), height);
            (aim, add(unit(cross(axis, random.direction())), times(axis, small)), ring * 5.0)
        }
        Kind::FromInside => (inside, any, 0.0),
        Kind::FromHole => {
            let hole = ring - tube;
            let side = unit(cross(axis, random.direction()));
            let at = along(
                times(side, hole * random.between(0.0, 0.99)),
                random.between(-1.0, 1.0) * tube,
                axis,
            );
            (at, sub(inside, at), 0.0)
        }
        Kind::Pinhole => {
            let side = unit(cross(axis, any));
            let at = times(side, (ring - tube) * random.between(0.0, 1.5));
            (at, add(axis, times(random.direction(), 0.1)), ring * random.between(2.5, 10.0))
        }
        Kind::FromSurface => (surface, any, 0.0),
    };
    let origin = vector::<S>(add(center, along(at, -back, unit(way))));
    let direction = vector::<S>(unit(way));
    let (center, axis) = (vector::<S>(center), vector::<S>(axis));
    let radii = [ring, tube].map(S::near);
    let solid = S::torus(center, axis, radii).ok()?;
    let ray = Ray::new(origin, direction).ok()?;
    let [ring, tube] = radii.map(S::to_f64);
    let model = Model { center: coordinates(center), axis: S::rounded_axis(axis), ring, tube };
    Some(Case { model, origin: coordinates(origin), direction: coordinates(direction), solid, ray })
}

/// The exponent of the unit that a parameter's error is counted in: of its last place, but not of
/// less than that of a thousandth, or in `f64` of 1; in fixed point always of the grid.
fn unit_exponent<S: Tested>(t: f64) -> i32 {
    let least = if S::UNIT < 1e-12 { 1.0 } else { 1e-3 };
    let size = if S::IS_FIXED { 1.0 } else { t.abs().max(least) };
    (size.log2().floor() + S::UNIT.log2()) as i32
}

#[derive(Debug, Default)]
struct Found {
    clear: usize,
    wrong: usize,
    two: usize,
    /// Of an unclear ray, or shorter than a unit.
    skipped: usize,
    errors: Vec<f64>,
}

fn measure<S: Tested>(kind: Kind, is_oblique: bool) -> Found {
    let mut random = Random::named(&format!("{kind:?}"));
    let mut found = Found::default();
    for _ in 0..rays() {
        let Some(Case { model, origin, direction, solid, ray }) =
            draw::<S>(&mut random, kind, is_oblique)
        else {
            continue;
        };
        let [less, exact, more] = [-1, 0, 1].map(|by| Quartic::new(&model, origin, direction, by));
        let count = exact.roots().0;
        let is_clear = [&less, &more].iter().all(|one| one.roots() == (count, true));
        let mut list = SpanList::<S, 2>::new();
        let spans = solid.trace(&ray, &mut list);
        if !is_clear {
            found.skipped += 1;
            continue;
        }
        found.clear += 1;
        found.two += usize::from(count == 4);
        if 2 * spans.len() != count {
            found.wrong += 1;
            if found.wrong <= 3 {
                println!(
                    "{kind:?}: {spans:?} but {count} roots: {model:?} {origin:?} {direction:?}"
                );
            }
            continue;
        }
        for span in spans {
            let [enter, exit] = [span.enter.t, span.exit.t].map(S::to_f64);
            if exit - enter < 2.0 * f64::from(unit_exponent::<S>(exit)).exp2() {
                // Its ends may be on either side of both roots.
                found.skipped += 1;
                continue;
            }
            for (t, inwards) in [(span.enter.t, true), (span.exit.t, false)] {
                let t = t.to_f64();
                let error = exact.error(t, unit_exponent::<S>(t), inwards);
                if error.is_none_or(|error| error > 1000.0)
                    && found.errors.iter().filter(|e| **e > 1000.0).count() < 3
                {
                    println!("{kind:?}: {t} is {error:?} off: {model:?} {origin:?} {direction:?}");
                }
                found.errors.push(error.unwrap_or(f64::INFINITY));
            }
        }
    }
    found
}

macro_rules! kinds {
    ($($number:ident $S:ty { $($name:ident $kind:expr, $limits:expr;)+ })+) => {$(
        mod $number {
            use super::*;

            $(#[test]
            fn $name() {
                for is_oblique in [false, true] {
                    let found = measure::<$S>($kind, is_oblique);
                    let [half, most, all] = percentiles(&found.errors).unwrap();
                    println!(
                        "{:7} {:32} oblique {is_oblique:5}: {:6} clear, {:6} of two spans, {} wrong, {} unclear; 50 % {half} 99 % {most} all {all}",
                        stringify!($number), format!("{:?}", $kind), found.clear, found.two, found.wrong, found.skipped,
                    );
                    // One of 100,000, so none of a thousand.
                    assert!(found.wrong * 100_000 <= found.clear, "{} wrong", found.wrong);
                    assert!(found.clear * 2 > rays());
                    assert!(most <= $limits[0] && all <= $limits[1], "{most} {all}");
                }
            })+
        }
    )+};
}

const FAR: Kind = Kind::Far([3.0, 6.0]);
const FIXED_FAR: Kind = Kind::Far([2.0, 3.0]);

kinds! {
    f32 f32 {
        ordinary Kind::Ordinary, limits::TORUS_F32;
        far FAR, limits::TORUS_F32;
        grazing Kind::Grazing, limits::TORUS_F32;
        along_the_axis Kind::AlongAxis, limits::TORUS_F32;
        along_the_plane Kind::AlongPlane, limits::TORUS_F32;
        from_inside Kind::FromInside, limits::TORUS_F32;
        from_the_hole Kind::FromHole, limits::TORUS_F32;
        from_the_surface Kind::FromSurface, limits::TORUS_F32;
        thin Kind::Thin, limits::TORUS_F32;
        through_a_pinhole Kind::Pinhole, limits::TORUS_F32;
    }
    f64 f64 {
        ordinary Kind::Ordinary, limits::TORUS_F64;
        far FAR, limits::TORUS_F64;
        grazing Kind::Grazing, limits::TORUS_F64_GRAZING;
        along_the_axis Kind::AlongAxis, limits::TORUS_F64;
        along_the_plane Kind::AlongPlane, limits::TORUS_F64;
        from_inside Kind::FromInside, limits::TORUS_F64;
        from_the_hole Kind::FromHole, limits::TORUS_F64;
        from_the_surface Kind::FromSurface, limits::TORUS_F64;
        thin Kind::Thin, limits::TORUS_F64_GRAZING;
        through_a_pinhole Kind::Pinhole, limits::TORUS_F64_GRAZING;
    }
    i16f16 I16F16 {
        ordinary Kind::Ordinary, limits::TORUS_FIXED;
        far FIXED_FAR, limits::TORUS_FIXED;
        grazing Kind::Grazing, limits::TORUS_FIXED;
        along_the_axis Kind::AlongAxis, limits::TORUS_FIXED;
        along_the_plane Kind::AlongPlane, limits::TORUS_FIXED;
        from_inside Kind::FromInside, limits::TORUS_FIXED;
        from_the_hole Kind::FromHole, limits::TORUS_FIXED;
        from_the_surface Kind::FromSurface, limits::TORUS_FIXED;
        through_a_pinhole Kind::Pinhole, limits::TORUS_FIXED;
    }
}
