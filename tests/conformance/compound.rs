//! Capsules, rounded boxes and rings of holes: against the distance to what they are round about.

use crate::number::{Tested, coordinates, spans, vector};
use crate::pictures::held;
use proptest::prelude::*;
use scancsg::geom::{Axis, OrthographicRays, Ray, Rays, Vec3, vec3};
use scancsg::render::{Gray8, Orthographic, Picture, RowSource, Sample, Shader, Size};
use scancsg::scalar::I16F16;
use scancsg::solid::{
    Capsule, Cuboid, CuboidError, Cylinder, CylinderError, RayCast, RoundedCuboid, Scan, Solid,
};
use scancsg::span::SpanList;
use std::cell::Cell;
use testkit::random::Random;
use testkit::vector::{cross, dot, length, sub, unit};

for_every_number!(capsules, rounded_boxes, rings, bad_input, seams);

type V = [f64; 3];

fn place<S: Tested>(range: f64) -> impl Strategy<Value = V> {
    prop::array::uniform3(-range..range).prop_map(held::<S>)
}

/// The line is inside where the distance is below the radius, at the middle of every piece between crossings
/// that is long enough to tell; and outside before the first and behind the last.
fn check<S, T>(
    solid: &T,
    (from, way): (V, V),
    outside_by: impl Fn(V) -> f64,
) -> Result<(), TestCaseError>
where
    S: Tested,
    T: Solid<Scalar = S>,
{
    let Ok(ray) = Ray::new(vector(from), vector(way)) else { return Ok(()) };
    let (from, way) = (held::<S>(from), held::<S>(way));
    let mut marks = vec![-40.0];
    for (enter, exit) in spans(solid, &ray) {
        marks.extend([enter, exit]);
    }
    marks.push(40.0);
    for (pair, index) in marks.windows(2).zip(0..) {
        let is_inside = index % 2 == 1;
        for part in [0.25, 0.5, 0.75] {
            let t = pair[0] + part * (pair[1] - pair[0]);
            let by = outside_by(std::array::from_fn(|i| from[i] + t * way[i]));
            let is_clear = by.abs() > 16.0 * S::UNIT * 8.0;
            prop_assert!(!is_clear || (by < 0.0) == is_inside, "{by} at {t}, inside: {is_inside}");
        }
    }
    Ok(())
}

fn rays<S: Tested>() -> impl Strategy<Value = (V, V)> {
    (place::<S>(4.0), place::<S>(2.0)).prop_map(|(from, to)| (from, sub(to, from)))
}

fn capsules<S: Tested>() {
    proptest!(ProptestConfig::with_cases(500), |(
        from in place::<S>(2.0), to in place::<S>(2.0), radius in 0.1..1.0, ray in rays::<S>(),
    )| {
        let way = sub(to, from);
        prop_assume!(length(way) > 0.1);
        let radius = S::near(radius);
        let solid = Cylinder::capsule(vector(from), vector(to), radius).unwrap();
        check(&solid, ray, |p| {
            let u = sub(p, from);
            let t = (dot(u, way) / dot(way, way)).clamp(0.0, 1.0);
            length(std::array::from_fn(|i| u[i] - t * way[i])) - radius.to_f64()
        })?;
    });
}

fn rounded_boxes<S: Tested>() {
    proptest!(ProptestConfig::with_cases(500), |(
        low in place::<S>(2.0), size in prop::array::uniform3(0.6..2.0), radius in 0.05..0.25,
        ray in rays::<S>(),
    )| {
        let high = held::<S>(std::array::from_fn(|i| low[i] + size[i]));
        let radius = S::near(radius);
        let solid = Cuboid::rounded(vector(low), vector(high), radius).unwrap();
        let r = radius.to_f64();
        check(&solid, ray, |p| {
            let beyond = |i: usize| p[i] - p[i].clamp(low[i] + r, high[i] - r);
            let off: V = std::array::from_fn(beyond);
            let inside = (0..3).map(|i| (p[i] - low[i]).min(high[i] - p[i])).fold(f64::MAX, f64::min);
            if off == [0.0; 3] { -inside.max(r) } else { length(off) - r }
        })?;
    });
}

fn rings<S: Tested>() {
    let [ring, radius, low, high] = [1.5, 0.25, -1.0, 1.0].map(S::near);
    for axis in Axis::ALL {
        let at = [S::near(0.5), S::near(-0.25)];
        let holes = Cylinder::ring::<7>(axis, at, ring, radius, low, high).unwrap();
        for (k, hole) in holes.iter().enumerate() {
            let angle = std::f64::consts::TAU * k as f64 / 7.0;
            let [u, v] = [0.5 + 1.5 * angle.cos(), -0.25 + 1.5 * angle.sin()].map(S::near);
            let [from, way]: [scancsg::geom::Vec3<S>; 2] = match axis {
                Axis::X => [vec3(S::from_int(5), u, v), vec3(S::ONE.negated(), S::ZERO, S::ZERO)],
                Axis::Y => [vec3(u, S::from_int(5), v), vec3(S::ZERO, S::ONE.negated(), S::ZERO)],
                Axis::Z => [vec3(u, v, S::from_int(5)), vec3(S::ZERO, S::ZERO, S::ONE.negated())],
            };
            let ray = Ray::new(from, way).unwrap();
            assert_eq!(spans(hole, &ray), [(4.0, 6.0)], "{:?}", coordinates(from));
            let others = holes.iter().enumerate().filter(|(i, _)| *i != k);
            assert!(others.clone().all(|(_, other)| spans(other, &ray).is_empty()));
        }
    }
}

fn bad_input<S: Tested>() {
    let [zero, one, two] = [0.0, 1.0, 2.0].map(S::near);
    let [low, high] = [vec3(zero, zero, zero), vec3(two, two, two)];
    let round = |radius| Cuboid::rounded(low, high, radius).map(|_| ());
    assert_eq!(round(one), Err(CuboidError::Radius));
    assert_eq!(round(zero), Err(CuboidError::Radius));
    assert_eq!(round(one.negated()), Err(CuboidError::Radius));
    assert_eq!(round(S::near(0.5)), Ok(()));
    assert_eq!(Cuboid::rounded(high, low, one).map(|_| ()), Err(CuboidError::Empty));
    let ring = |r| Cylinder::ring::<3>(Axis::X, [zero; 2], r, one, zero, one).map(|_| ());
    assert_eq!(ring(zero), Err(CylinderError::Radius));
    assert_eq!(ring(two), Ok(()));
    assert_eq!(Cylinder::capsule(low, low, one).map(|_| ()), Err(CylinderError::Empty));
    for &none in S::NO_NUMBERS {
        assert!(round(none).is_err() && ring(none).is_err());
        assert!(Cylinder::capsule(low, vec3(none, zero, zero), one).is_err());
    }
}

/// Solids of about a hundred units, so that many rays meet two parts within the rounding of a parameter: aimed at
/// seams, and in pictures. What is seen has the normal of the round surface.
fn seams<S: Tested>() {
    let r = if S::IS_FIXED { 100.0 * S::UNIT } else { 0.3 };
    let mut random = Random::named(std::any::type_name::<S>());
    let ends = [[-2.0, -1.0, 0.5], [1.5, 1.0, -0.25]].map(|end| held::<S>(end.map(|x| x * r)));
    let [from, to] = ends;
    let radius = S::near(r);
    let capsule = Cylinder::capsule(vector(from), vector(to), radius).unwrap();
    let way = sub(to, from);
    let beside = |p: V| {
        let t = (dot(sub(p, from), way) / dot(way, way)).clamp(0.0, 1.0);
        std::array::from_fn(|i| p[i] - from[i] - t * way[i])
    };
    watch(&capsule, r, &mut random, beside, |random| {
        let out = unit(cross(way, random.direction()));
        (ends[random.below(2)], out)
    });
    let corner = held::<S>([2.5, 2.0, 1.5].map(|x| x * r));
    let low = corner.map(|x| -x);
    let rounded = Cuboid::rounded(vector(low), vector(corner), radius).unwrap();
    let inner = corner.map(|x| x - radius.to_f64());
    let beside = |p: V| std::array::from_fn(|i| p[i] - p[i].clamp(-inner[i], inner[i]));
    watch(&rounded, r, &mut random, beside, |random| {
        // On an edge, where it begins or somewhere: towards one of the plates, or anywhere between them.
        let out = unit(random.direction().map(f64::abs));
        let along = random.below(3);
        let is_end = random.chance(0.5);
        let out: V = std::array::from_fn(|i| if i == along { 0.0 } else { out[i] });
        let to_plate: V = std::array::from_fn(|i| f64::from(u8::from(i == (along + 1) % 3)));
        let mut middle = inner;
        if !is_end {
            middle[along] = random.between(-inner[along], inner[along]);
        }
        (middle, if is_end { unit(out) } else { to_plate })
    });
}

/// Counts rays that are aimed at seams, and pixels, with another normal than that of the surface: `beside` is the
/// way to a point from what the solid is round about, and `seam` gives a point there and the way out.
fn watch<S, T>(
    solid: &T,
    r: f64,
    random: &mut Random,
    beside: impl Fn(V) -> V,
    seam: impl Fn(&mut Random) -> (V, V),
) where
    S: Tested,
    T: Solid<Scalar = S> + Scan<OrthographicRays<S>>,
{
    let is_wrong = |at: V, normal: V| dot(unit(beside(at)), normal) < 0.9;
    let mut wrong = 0;
    for _ in 0..3000 {
        let (middle, out) = seam(random);
        let towards = unit(random.direction());
        let towards = if dot(towards, out) < 0.0 { towards.map(|x| -x) } else { towards };
        let way = unit(std::array::from_fn(|i| -towards[i] - out[i]));
        let origin: V = std::array::from_fn(|i| middle[i] + (out[i] - 4.0 * way[i]) * r);
        let ray = Ray::new(vector::<S>(origin), vector(way)).unwrap();
        let hit = solid.hit(&ray, &mut SpanList::<S, 64>::new()).unwrap();
        wrong += u32::from(is_wrong(coordinates(hit.point), coordinates(hit.normal)));
    }
    let watch = Watch { is_wrong, wrong: Cell::new(0), seen: Cell::new(0) };
    for _ in 0..40 {
        let along = vector::<S>(random.direction());
        let up = vector(random.direction());
        let camera = Orthographic::look_along(along, Vec3::ZERO, up, S::near(7.0 * r)).unwrap();
        let size = Size::new(36, 30).unwrap();
        let mut picture = Picture::new(solid, &camera, size, &watch, Gray8(0));
        let mut row = [Gray8(0); 36];
        for y in 0..30 {
            picture.render(y, &mut row).unwrap();
        }
    }
    assert!(watch.seen.get() > 1000, "{:?}", watch.seen);
    assert_eq!((wrong, watch.wrong.get()), (0, 0), "rays aimed at seams, pixels");
}

/// A shader that counts.
struct Watch<F> {
    is_wrong: F,
    wrong: Cell<u32>,
    seen: Cell<u32>,
}

impl<S: Tested, F: Fn(V, V) -> bool> Shader<S> for &Watch<F> {
    fn level<T, R>(&self, sample: Sample<'_, T, R>) -> u8
    where
        T: Solid<Scalar = S> + Scan<R>,
        R: Rays<Scalar = S>,
    {
        let at = coordinates(sample.line().at(sample.seen.t));
        let axes = [0, 1, 2].map(|i| vector(std::array::from_fn(|k| f64::from(u8::from(i == k)))));
        let cosines = axes.map(|axis| sample.cosine(axis).to_f64());
        let is_wrong = (self.is_wrong)(at, coordinates(sample.normal()));
        let is_wrong = is_wrong || (self.is_wrong)(at, cosines);
        self.wrong.set(self.wrong.get() + u32::from(is_wrong));
        self.seen.set(self.seen.get() + 1);
        255
    }
}

type Makes<S, T, E> = fn(Vec3<S>, Vec3<S>, S) -> Result<T, E>;
type MakesRing<S> = fn(Axis, [S; 2], S, S, S, S) -> Result<[Cylinder<S>; 7], CylinderError>;

/// What constants call makes the same solids, and the same errors, as what any number type has.
fn constants<S: Tested>(
    capsule: Makes<S, Capsule<S>, CylinderError>,
    rounded: Makes<S, RoundedCuboid<S>, CuboidError>,
    ring: MakesRing<S>,
) {
    let number = || {
        prop_oneof![9 => (-4f64..4.0).prop_map(S::near), 1 => prop::sample::select(vec![
            S::ZERO, S::MIN_RADIUS, S::MAX_COORDINATE, S::LOWEST, S::HIGHEST,
        ])]
    };
    let numbers = prop::array::uniform6(number());
    let radius = prop_oneof![3 => (0.01..1.0).prop_map(S::near), 1 => number()];
    let axis = prop::sample::select(Axis::ALL.to_vec());
    let good = [Cell::new(0), Cell::new(0), Cell::new(0)];
    proptest!(ProptestConfig::with_cases(500), |(
        [a, b, c, d, e, f] in numbers, radius in radius, axis in axis,
    )| {
        let (p, q) = (vec3(a, b, c), vec3(d, e, f));
        prop_assert_eq!(Cylinder::capsule(p, q, radius), capsule(p, q, radius));
        let higher = vec3(a.max(d), b.max(e), c.max(f));
        let lower = vec3(a.min(d), b.min(e), c.min(f));
        for [low, high] in [[p, q], [lower, higher]] {
            prop_assert_eq!(Cuboid::rounded(low, high, radius), rounded(low, high, radius));
        }
        let made = Cylinder::ring::<7>(axis, [a, b], c, radius, d, e);
        let constant = ring(axis, [a, b], c, radius, d, e);
        prop_assert_eq!(made.map(|_| ()), constant.map(|_| ()));
        let is_good = [
            capsule(p, q, radius).is_ok(), rounded(lower, higher, radius).is_ok(), constant.is_ok(),
        ];
        for (count, is_good) in good.iter().zip(is_good) {
            count.set(count.get() + u32::from(is_good));
        }
        if let (Ok(made), Ok(constant)) = (made, constant) {
            // Their axes are where a ray along them enters and leaves; off by a rounding error, they still do.
            let most = 16.0 * S::UNIT;
            for (made, constant) in made.iter().zip(constant) {
                let [a, b] = [made, &constant].map(|cylinder| match cylinder.bounds() {
                    scancsg::solid::Bounds::Ball { center, .. } => coordinates(center),
                    other => panic!("{other:?}"),
                });
                let size = a.iter().fold(1f64, |size, x| size.max(x.abs()));
                prop_assert!(length(sub(a, b)) <= most * size, "{:?} {:?}", a, b);
            }
        }
    });
    assert!(good.iter().all(|count| count.get() > 20), "{good:?}");
}

#[test]
fn constants_are_those_of_any_number() {
    constants::<f32>(Capsule::<f32>::new, RoundedCuboid::<f32>::new, Cylinder::<f32>::ring_along);
    constants::<f64>(Capsule::<f64>::new, RoundedCuboid::<f64>::new, Cylinder::<f64>::ring_along);
    constants::<I16F16>(
        Capsule::<I16F16>::new,
        RoundedCuboid::<I16F16>::new,
        Cylinder::<I16F16>::ring_along,
    );
}
