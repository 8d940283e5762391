//! Cones against exact whole numbers: whether a line meets one, and where.
//!
//! The oracle is given the numbers as the type under test holds them, so nothing is rounded but what the
//! crate rounds. Of a line that a cone grown by 10⁻⁶ at all sides meets, and one shrunk by as much as well, or
//! neither of them, the class is clear: then the crate's must be the same.

use scancsg::geom::Ray;
use scancsg::scalar::I16F16;
use scancsg::solid::{Cone, RayCast};
use scancsg::span::SpanList;
use testkit::cone_oracle::{Query, is_ahead, span, to_f64};
use testkit::limits;
use testkit::number::{Tested, coordinates, vector};
use testkit::random::Random;
use testkit::surd::Surd;
use testkit::ulp::percentiles;
use testkit::vector::{V, add, along, cross, dot, length, sub, times, unit};

/// Rays of a kind: 10⁵ of them with `--ignored`.
const FEW: usize = 1500;
const MANY: usize = 100_000;

/// 10⁻⁶ in units of 2⁻⁴⁰, and what is allowed for the rounding of an oblique axis and its caps: 2⁻¹⁷ in
/// floating point and 2⁻¹³ in fixed point, as a short cone's length is a tenth.
const GROWTH: i64 = 1_099_512;
const OBLIQUE: [i64; 2] = [1 << 23, 1 << 27];

#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    Ordinary,
    /// From 10³ to 10⁶ radii away; in fixed point, from as far as its numbers reach.
    Far,
    /// Past the side by 10⁻¹ to 10⁻⁶ of the radius, inside or outside.
    Grazing,
    AlongAxis,
    AlongSide,
    FromInside,
    FromSurface,
}

const KINDS: [Kind; 7] = [
    Kind::Ordinary,
    Kind::Far,
    Kind::Grazing,
    Kind::AlongAxis,
    Kind::AlongSide,
    Kind::FromInside,
    Kind::FromSurface,
];

fn sides(axis: V) -> [V; 2] {
    let way = if axis[0].abs() < 0.6 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
    let first = unit(cross(axis, way));
    [first, cross(unit(axis), first)]
}

/// A cone, and its numbers as they are held.
struct Subject<S: Tested> {
    cone: Cone<S>,
    query: Query,
    /// Whether its axis is not rounded.
    is_aligned: bool,
}

impl<S: Tested> Subject<S> {
    fn new(random: &mut Random) -> Option<Self> {
        let held = |x: f64| S::near(x).to_f64();
        let wide = held(random.between(0.5, 2.0));
        let other = match random.below(4) {
            0 => 0.0,
            1 => wide,
            _ => held(random.between(0.0, 2.0)),
        };
        let radii = if random.chance(0.5) { [wide, other] } else { [other, wide] };
        let bits = radii.map(S::near);
        let is_aligned = random.chance(0.7);
        // Flat ones and long ones.
        let long = held(10f64.powf(random.between(-1.0, 1.0)));
        if is_aligned {
            let axis = random.below(3);
            let middle = [(); 2].map(|()| held(random.between(-3.0, 3.0)));
            // With few digits, so that their difference is a number as well.
            let few = |x: f64| held(f64::from(x as f32));
            let low = few(random.between(-3.0, 3.0));
            let high = few(low + long);
            let cone =
                S::cone_along(axis, middle.map(S::near), bits, S::near(low), S::near(high)).ok()?;
            let mut from = [middle[0], middle[0], middle[1]];
            (from[(axis + 1) % 3], from[(axis + 2) % 3]) = match axis {
                1 => (middle[1], middle[0]),
                _ => (middle[0], middle[1]),
            };
            from[axis] = low;
            let mut way = [0.0; 3];
            way[axis] = high - low;
            let query = Query { from, axis: way, radii, origin: [0.0; 3], direction: [0.0; 3] };
            Some(Self { cone, query, is_aligned })
        } else {
            let from = random.point(3.0).map(held);
            let to = along(from, long, random.direction()).map(held);
            let cone = S::cone_between(vector(from), vector(to), bits).ok()?;
            let axis = sub(to, from);
            let query = Query { from, axis, radii, origin: [0.0; 3], direction: [0.0; 3] };
            Some(Self { cone, query, is_aligned })
        }
    }

    /// A point of the wall, and the ways from there: out of the solid, along the side to the high end, and
    /// around.
    fn on_wall(&self, random: &mut Random) -> [V; 4] {
        let Query { from, axis, radii: [low, high], .. } = self.query;
        let part = random.between(0.0, 1.0);
        let [first, second] = sides(axis);
        let (sin, cos) = random.between(0.0, 6.3).sin_cos();
        let outwards = add(times(first, cos), times(second, sin));
        let point = along(along(from, part, axis), low + (high - low) * part, outwards);
        let side = unit(along(axis, high - low, outwards));
        let around = cross(unit(axis), outwards);
        [point, cross(around, side), side, around]
    }

    fn inside(&self, random: &mut Random) -> V {
        let [point, ..] = self.on_wall(random);
        let Query { from, axis, .. } = self.query;
        let part = dot(sub(point, from), axis) / dot(axis, axis);
        let middle = along(from, part, axis);
        along(middle, random.between(0.0, 1.0), sub(point, middle))
    }

    fn ray(&self, kind: Kind, random: &mut Random) -> [V; 2] {
        let Query { axis, radii, .. } = self.query;
        let wide = radii[0].max(radii[1]);
        let [point, normal, side, around] = self.on_wall(random);
        let little = |random: &mut Random| 10f64.powf(random.between(-7.0, -1.0)) * random.sign();
        let back = |random: &mut Random, point: V, way: V| {
            [along(point, -random.between(2.0, 20.0), way), way]
        };
        match kind {
            Kind::Ordinary => {
                let target = add(self.inside(random), random.point(0.5));
                let way = random.direction();
                back(random, target, way)
            }
            Kind::Far => {
                let target = add(self.inside(random), random.point(wide));
                let [nearest, farthest] = if S::IS_FIXED { [2.0, 3.5] } else { [3.0, 6.0] };
                let far = 10f64.powf(random.between(nearest, farthest));
                let way = random.direction();
                [along(target, -far, way), way]
            }
            Kind::Grazing => {
                let past = 10f64.powf(random.between(-6.0, -1.0)) * random.sign() * wide;
                let turn = random.between(-3.1, 3.1);
                let way = add(times(side, turn.cos()), times(around, turn.sin()));
                back(random, along(point, past, normal), way)
            }
            Kind::AlongAxis => {
                let way = along(unit(axis), little(random), around);
                let inside = add(self.inside(random), random.point(0.2));
                let sign = random.sign();
                back(random, inside, times(way, sign))
            }
            Kind::AlongSide => {
                let way = along(along(side, little(random), normal), little(random), around);
                let beside = along(point, little(random), normal);
                let sign = random.sign();
                back(random, beside, times(way, sign))
            }
            Kind::FromInside => [self.inside(random), random.direction()],
            Kind::FromSurface => [point, random.direction()],
        }
    }
}

/// What is wrong, and how far ends are off.
#[derive(Default)]
struct Found {
    clear: [usize; 2],
    wrong: Vec<String>,
    /// In units in the last place, or of the grid.
    off: Vec<f64>,
}

fn unit_of<S: Tested>(t: f64) -> f64 {
    if S::IS_FIXED { S::UNIT } else { t.abs().log2().floor().exp2() * S::UNIT }
}

fn found<S: Tested>(kind: Kind, count: usize) -> Found {
    let mut random = Random::named(&format!("cones {kind:?}"));
    let mut found = Found::default();
    while found.clear[0] + found.clear[1] < count {
        let Some(subject) = Subject::<S>::new(&mut random) else { continue };
        let [origin, direction] = subject.ray(kind, &mut random).map(vector::<S>);
        let Ok(ray) = Ray::new(origin, direction) else { continue };
        let [origin, direction] = [origin, direction].map(coordinates::<S>);
        let query = Query { origin, direction, ..subject.query };

        let growth = if subject.is_aligned { GROWTH } else { OBLIQUE[usize::from(S::IS_FIXED)] };
        let [grown, exact, shrunk] = [growth, 0, -growth].map(|growth| span(&query, growth));
        let mut list = SpanList::<S, 1>::new();
        let got = subject.cone.trace(&ray, &mut list).first().copied();
        let hit = subject.cone.hit(&ray, &mut SpanList::<S, 1>::new());
        let report = || {
            format!(
                "{query:?}: {got:?}, {hit:?}, not {:?}",
                exact.as_ref().map(|ends| ends.each_ref().map(to_f64))
            )
        };

        if grown.is_some() == shrunk.is_some() {
            found.clear[usize::from(grown.is_some())] += 1;
            let is_hit =
                |ends: &Option<[Surd; 2]>| ends.as_ref().is_some_and(|[_, exit]| is_ahead(exit));
            // On a grid, what ends just behind the start may end in it, or end before it.
            let ends_at_start = |ends: &Option<[Surd; 2]>| {
                ends.as_ref().is_some_and(|[_, exit]| to_f64(exit).abs() <= S::UNIT)
            };
            let is_clear =
                is_hit(&grown) == is_hit(&shrunk) && !(S::IS_FIXED && ends_at_start(&exact));
            if got.is_some() != grown.is_some() || is_clear && hit.is_some() != is_hit(&grown) {
                found.wrong.push(report());
                continue;
            }
        }
        if let (Some(got), Some(exact), Some(_)) = (got, &exact, &shrunk)
            && subject.is_aligned
        {
            for (t, want) in [got.enter.t, got.exit.t].into_iter().zip(exact) {
                let want = to_f64(want);
                found.off.push((t.to_f64() - want).abs() / unit_of::<S>(want));
            }
        }
        if let Some(hit) = hit {
            let [point, normal] = [hit.point, hit.normal].map(coordinates);
            // As well as the point is known, in parts of its distance from the axis.
            let from_axis = length(cross(sub(point, query.from), unit(query.axis)));
            let allowed = 8.0 * S::UNIT * (1.0 + length(point) / from_axis.max(S::UNIT));
            if (length(normal) - 1.0).abs() > allowed {
                found.wrong.push(format!("length of {normal:?}: {}", report()));
            }
            if dot(normal, unit(direction)) > allowed + 1e-3 {
                found.wrong.push(format!("{normal:?} is behind: {}", report()));
            }
        }
    }
    found
}

fn check<S: Tested>(count: usize) {
    for kind in KINDS {
        let Found { clear, wrong, off } = found::<S>(kind, count);
        println!(
            "{kind:?}: {clear:?} missed and hit, {} wrong, off {:?}",
            wrong.len(),
            percentiles(&off)
        );
        let [_, p99, largest] = percentiles(&off).unwrap();
        // On the surface, parameters are near zero, and a unit of them says nothing.
        let is_near = match kind {
            _ if S::IS_FIXED => largest <= limits::FIXED_P99,
            Kind::FromSurface => true,
            _ => p99 <= limits::HARD_P99,
        };
        assert!(is_near, "{kind:?}: {p99} {largest}");
        assert!(clear[1] * 5 > count, "{kind:?}: {clear:?}");
        assert!(
            wrong.is_empty(),
            "{kind:?}: {}\n{}",
            wrong.len(),
            wrong[..wrong.len().min(3)].join("\n")
        );
    }
}

#[test]
fn f32s() {
    check::<f32>(FEW);
}

#[test]
fn f64s() {
    check::<f64>(FEW);
}

#[test]
fn i16f16s() {
    check::<I16F16>(FEW);
}

#[test]
#[ignore = "minutes"]
fn many() {
    check::<f32>(MANY);
    check::<I16F16>(MANY);
}

#[test]
fn ways_across_an_axis() {
    let mut random = Random::named("sides");
    for _ in 0..100 {
        let axis = random.direction();
        let [first, second] = sides(axis);
        for at_right_angles in [dot(first, axis), dot(second, axis), dot(first, second)] {
            assert!(at_right_angles.abs() < 1e-12);
        }
    }
}
