//! Capsules, rounded boxes and rings of holes: against the distance to what they are round about.

use crate::number::{Tested, coordinates, spans, vector};
use crate::pictures::held;
use proptest::prelude::*;
use scancsg::geom::{Axis, Ray, vec3};
use scancsg::solid::{Cuboid, CuboidError, Cylinder, CylinderError, Solid};

for_every_number!(capsules, rounded_boxes, rings, bad_input);

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

fn sub(a: V, b: V) -> V {
    std::array::from_fn(|i| a[i] - b[i])
}

fn length(v: V) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
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
            let dot = |a: V, b: V| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
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
