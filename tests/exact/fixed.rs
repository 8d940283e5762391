//! Fixed point against exact integers: every input is a whole number of units of the grid, so what
//! is true about a line and a solid can be decided without rounding anything.
//!
//! The span exists if and only if the line is inside the open solid for some length, and each end
//! is the whole number nearest to the exact parameter. Where both ends would be one number, one of
//! them is the next. A parameter outside of the type is its end.
//!
//! In units of the grid, a wall's parameters are `2ᶠ (b ± √D)/a` with whole a, b and D, which is
//! kept as it is: the order of such a number and a quotient is that of their squares.

use dashu_int::ops::SquareRoot;
use dashu_int::{IBig, UBig};
use fixed::types::{I8F24, I24F8};
use proptest::prelude::*;
use scancsg::geom::{Ray, Vec3, vec3};
use scancsg::scalar::I16F16;
use scancsg::solid::{Cylinder, CylinderWall, Hit, RayCast, Slab, Sphere};
use scancsg::span::{Face, Span, SpanList};
use std::cell::Cell;
use std::cmp::Ordering;
use testkit::number::Tested;
use testkit::surd::{Surd, square};

/// A fixed-point type of 32 bits.
trait Fixed: Tested {
    /// F, the bits behind the point.
    const FRACTION: u32;

    fn from_raw(raw: i64) -> Self;

    fn raw(self) -> i64;
}

macro_rules! fixed {
    ($($S:ident $fraction:literal),+) => {$(
        impl Fixed for $S {
            const FRACTION: u32 = $fraction;

            fn from_raw(raw: i64) -> Self {
                Self::from_bits(raw.try_into().unwrap())
            }

            fn raw(self) -> i64 {
                self.to_bits().into()
            }
        }
    )+};
}

fixed!(I8F24 24, I16F16 16, I24F8 8);

/// Coordinates and radii.
const MAX_COORDINATE: i64 = 1 << 28;
/// The largest coordinate of a direction; the smallest one is a half, 2^(F − 1).
const LONGEST: i64 = 1 << 30;
const LOWEST: i64 = i32::MIN as i64;
const HIGHEST: i64 = i32::MAX as i64;

type V = [i64; 3];

fn dot(a: V, b: V) -> IBig {
    (0..3).map(|i| IBig::from(a[i]) * b[i]).fold(IBig::ZERO, |sum, x| sum + x)
}

fn cross(a: V, b: V) -> [IBig; 3] {
    let part = |i: usize, j: usize| IBig::from(a[i]) * b[j] - IBig::from(a[j]) * b[i];
    [part(1, 2), part(2, 0), part(0, 1)]
}

/// The nearest whole numbers: two for a half. Beyond the type's range, its end.
fn nearest(t: &Surd) -> Vec<i64> {
    const GUARD: usize = 64;
    let root = UBig::try_from(&t.q << (2 * GUARD)).unwrap().sqrt();
    let about = ((&t.p << GUARD) + IBig::from(t.s) * IBig::from(root)) / (&t.d << GUARD);
    let half = |twice: IBig| t.compare(&twice, &IBig::from(2));
    let is_near = |whole: &IBig| half(whole * 2 - 1).is_ge() && half(whole * 2 + 1).is_le();
    let near: Vec<IBig> = (-2..=2).map(|by| &about + by).filter(is_near).collect();
    assert!(matches!(near.len(), 1 | 2), "{t:?}");
    let (low, high) = (IBig::from(LOWEST), IBig::from(HIGHEST));
    near.into_iter().map(|n| i64::try_from(n.clamp(low.clone(), high.clone())).unwrap()).collect()
}

/// A primitive; all numbers in units of the grid.
#[derive(Debug, Clone, Copy)]
enum Primitive {
    /// `middle` holds the two coordinates across the axis, in order.
    Cylinder {
        axis: usize,
        middle: [i64; 2],
        radius: i64,
        low: i64,
        high: i64,
    },
    Sphere {
        center: V,
        radius: i64,
    },
    Slab {
        axis: usize,
        low: i64,
        high: i64,
    },
}

use Primitive as P;

#[derive(Debug, Clone, Copy)]
struct Case {
    primitive: Primitive,
    origin: V,
    direction: V,
}

/// An end of a span: nowhere, or at a crossing with one of some faces.
#[derive(Debug, Clone)]
struct End {
    at: Option<Surd>,
    faces: Vec<u16>,
}

/// What a line does with a part of a primitive.
enum Part {
    Outside,
    Inside,
    Between([Surd; 2]),
}

fn across(axis: usize, v: V) -> [i64; 2] {
    match axis {
        0 => [v[1], v[2]],
        1 => [v[0], v[2]],
        _ => [v[0], v[1]],
    }
}

/// |u + t·d| < r, for vectors with any number of coordinates.
fn round(
    a: &IBig,
    b: &IBig,
    moment_squared: &IBig,
    distance_squared: &IBig,
    r: i64,
    fraction: u32,
) -> Part {
    let radius_squared = square(&IBig::from(r));
    if *a == IBig::ZERO {
        return if *distance_squared < radius_squared { Part::Inside } else { Part::Outside };
    }
    let discriminant = radius_squared * a - moment_squared;
    if discriminant <= IBig::ZERO {
        return Part::Outside;
    }
    let at = |s| Surd {
        p: -b << fraction as usize,
        s,
        q: &discriminant << (2 * fraction) as usize,
        d: a.clone(),
    };
    Part::Between([at(-1), at(1)])
}

/// low < o + t·d < high; of the planes, the lower one belongs to it.
fn between(o: i64, d: i64, [low, high]: [i64; 2], fraction: u32) -> Part {
    if d == 0 {
        return if low <= o && o < high { Part::Inside } else { Part::Outside };
    }
    let at = |offset: i64| Surd::ratio(IBig::from(offset - o) << fraction as usize, IBig::from(d));
    Part::Between(if d > 0 { [at(low), at(high)] } else { [at(high), at(low)] })
}

impl Case {
    /// The wall of a cylinder, whether there is a length inside or not: tangents are roots.
    fn wall(&self, fraction: u32) -> Part {
        let P::Cylinder { axis, middle, radius, .. } = self.primitive else {
            return Part::Inside;
        };
        let [[x, y], [dx, dy]] = [self.origin, self.direction].map(|v| across(axis, v));
        let (u, d) = ([x - middle[0], y - middle[1], 0], [dx, dy, 0]);
        let [_, _, moment] = cross(u, d);
        round(&dot(d, d), &dot(u, d), &square(&moment), &dot(u, u), radius, fraction)
    }

    fn caps(&self, fraction: u32) -> Part {
        match self.primitive {
            P::Cylinder { axis, low, high, .. } | P::Slab { axis, low, high } => {
                between(self.origin[axis], self.direction[axis], [low, high], fraction)
            }
            P::Sphere { center, radius } => {
                let (d, u) = (self.direction, std::array::from_fn(|i| self.origin[i] - center[i]));
                let moment = cross(u, d).iter().map(square).fold(IBig::ZERO, |sum, x| sum + x);
                round(&dot(d, d), &dot(u, d), &moment, &dot(u, u), radius, fraction)
            }
        }
    }

    /// The line's span with the open solid.
    fn span(&self, fraction: u32) -> Option<[End; 2]> {
        // The faces that are met going in and out between the caps, or of a sphere.
        let forwards = match self.primitive {
            P::Cylinder { axis, .. } | P::Slab { axis, .. } => {
                if self.direction[axis] > 0 {
                    [0, 1]
                } else {
                    [1, 0]
                }
            }
            P::Sphere { .. } => [0, 0],
        };
        let single = |at: &Surd, face: u16| End { at: Some(at.clone()), faces: vec![face] };
        let nowhere = || End { at: None, faces: vec![0, 1, 2] };
        match (self.wall(fraction), self.caps(fraction)) {
            (Part::Outside, _) | (_, Part::Outside) => None,
            (Part::Inside, Part::Inside) => Some([nowhere(), nowhere()]),
            (Part::Between([enter, exit]), Part::Inside) => {
                Some([single(&enter, 2), single(&exit, 2)])
            }
            (Part::Inside, Part::Between([enter, exit])) => {
                Some([single(&enter, forwards[0]), single(&exit, forwards[1])])
            }
            (Part::Between([wall_in, wall_out]), Part::Between([cap_in, cap_out])) => {
                if wall_in.order(&cap_out).is_ge() || wall_out.order(&cap_in).is_le() {
                    return None;
                }
                let pick = |wall: &Surd, cap: &Surd, face: u16, wins: Ordering| {
                    // Where both would be rounded to one number, either face may be named.
                    let mut end =
                        if wall.order(cap) == wins { single(wall, 2) } else { single(cap, face) };
                    if nearest(wall).iter().any(|n| nearest(cap).contains(n)) {
                        end.faces = vec![2, face];
                    }
                    end
                };
                Some([
                    pick(&wall_in, &cap_in, forwards[0], Ordering::Greater),
                    pick(&wall_out, &cap_out, forwards[1], Ordering::Less),
                ])
            }
        }
    }
}

/// The solid of a primitive, whichever it is.
#[derive(Debug, Clone, Copy)]
enum Any<S: Fixed> {
    Cylinder(Cylinder<S>),
    Sphere(Sphere<S>),
    Slab(Slab<S>),
}

fn numbers<S: Fixed>(v: V) -> Vec3<S> {
    let [x, y, z] = v.map(S::from_raw);
    vec3(x, y, z)
}

impl<S: Fixed> Any<S> {
    fn of(primitive: &Primitive) -> Self {
        match *primitive {
            P::Cylinder { axis, middle, radius, low, high } => {
                let [radius, low, high] = [radius, low, high].map(S::from_raw);
                Self::Cylinder(S::along(axis, middle.map(S::from_raw), radius, low, high).unwrap())
            }
            P::Sphere { center, radius } => {
                Self::Sphere(S::sphere(numbers(center), S::from_raw(radius)).unwrap())
            }
            P::Slab { axis, low, high } => {
                Self::Slab(S::slab_along(axis, S::from_raw(low), S::from_raw(high)).unwrap())
            }
        }
    }

    fn trace(&self, ray: &Ray<S>) -> Option<Span<S>> {
        let mut list = SpanList::<S, 1>::new();
        let spans = match self {
            Self::Cylinder(solid) => solid.trace(ray, &mut list),
            Self::Sphere(solid) => solid.trace(ray, &mut list),
            Self::Slab(solid) => solid.trace(ray, &mut list),
        };
        spans.first().copied()
    }

    fn hit(&self, ray: &Ray<S>) -> Option<Hit<S>> {
        let mut list = SpanList::<S, 1>::new();
        match self {
            Self::Cylinder(solid) => solid.hit(ray, &mut list),
            Self::Sphere(solid) => solid.hit(ray, &mut list),
            Self::Slab(solid) => solid.hit(ray, &mut list),
        }
    }
}

/// The pairs of parameters that a span may have.
fn allowed([enter, exit]: &[End; 2]) -> Vec<(i64, i64)> {
    let near = |end: &End, nowhere| end.at.as_ref().map_or(vec![nowhere], nearest);
    let (enters, exits) = (near(enter, LOWEST), near(exit, HIGHEST));
    let pairs = enters.iter().flat_map(|&a| exits.iter().map(move |&b| (a, b)));
    pairs
        .flat_map(|(a, b)| if a < b { vec![(a, b)] } else { vec![(a - 1, b), (a, b + 1)] })
        .filter(|&(a, b)| LOWEST <= a && b <= HIGHEST)
        .collect()
}

fn check<S: Fixed>(case: &Case) -> Result<(), TestCaseError> {
    let ray = Ray::new(numbers::<S>(case.origin), numbers(case.direction)).unwrap();
    let solid = Any::<S>::of(&case.primitive);
    let got = solid.trace(&ray);
    let want = case.span(S::FRACTION);
    match (&got, &want) {
        (None, None) => {}
        (Some(got), Some(want)) => {
            let pairs = allowed(want);
            let pair = (got.enter.t.raw(), got.exit.t.raw());
            prop_assert!(pairs.contains(&pair), "{:?} is none of {:?}", pair, pairs);
            for (crossing, end) in [(got.enter, &want[0]), (got.exit, &want[1])] {
                let Face(face) = crossing.face;
                prop_assert!(end.faces.contains(&face), "face {} in {:?}", face, end.faces);
            }
        }
        // All of it lies beyond the type's range, where there is no parameter for it.
        (None, Some(want)) if is_beyond(want) => {}
        (None, Some(want)) => prop_assert!(false, "missed: {:?}", allowed(want)),
        (Some(got), None) => prop_assert!(false, "hit: {:?}", got),
    }
    check_hit(case, &got, &solid.hit(&ray))?;
    if let Any::Cylinder(cylinder) = &solid {
        check_wall(case, CylinderWall::of(cylinder).hit(&ray).map(|hit| (hit.t, hit.inner)))?;
    }
    Ok(())
}

fn is_beyond(want: &[End; 2]) -> bool {
    let all_are = |end: &End, limit| {
        end.at.as_ref().is_some_and(|at| nearest(at).iter().all(|&n| n == limit))
    };
    all_are(&want[1], LOWEST) || all_are(&want[0], HIGHEST)
}

/// A hit is the first crossing of the trace at t ≥ 0.
fn check_hit<S: Fixed>(
    case: &Case,
    trace: &Option<Span<S>>,
    hit: &Option<Hit<S>>,
) -> Result<(), TestCaseError> {
    let first = trace.as_ref().and_then(|span| {
        let ends = [(span.enter, false), (span.exit, true)];
        ends.into_iter().find(|(end, _)| (0..HIGHEST).contains(&end.t.raw()))
    });
    let what = |(end, inside): (scancsg::span::Crossing<S>, bool)| (end.t.raw(), end.face, inside);
    prop_assert_eq!(hit.map(|hit| (hit.t.raw(), hit.face, hit.inside)), first.map(what));
    let Some(hit) = hit else { return Ok(()) };

    // A parameter's unit is a way of |d| units: the longer the direction, the farther from the
    // surface a point may lie, and a small solid has no room for that.
    let unit = 1i64 << S::FRACTION;
    let is_tame = case.direction.iter().all(|d| d.abs() <= unit);
    let radius = match case.primitive {
        P::Cylinder { radius, .. } | P::Sphere { radius, .. } => radius,
        P::Slab { .. } => unit,
    };
    if !is_tame || radius < 64 {
        return Ok(());
    }
    let point = hit.point.to_array().map(S::raw);
    let normal = hit.normal.to_array().map(S::raw);
    let within = |squared: &IBig, length: i64, off: i64| {
        square(&IBig::from(length - off)) <= *squared
            && *squared <= square(&IBig::from(length + off))
    };
    // The coordinates' rounding is 0.9 units together; the formulas may add another one.
    let Face(face) = hit.face;
    let on_face = match case.primitive {
        P::Cylinder { axis, low, high, .. } | P::Slab { axis, low, high } if face < 2 => {
            (point[axis] - [low, high][usize::from(face)]).abs() <= 2
        }
        P::Cylinder { axis, middle, .. } => {
            let [x, y] = across(axis, point);
            let u = [x - middle[0], y - middle[1], 0];
            within(&dot(u, u), radius, 2)
        }
        P::Sphere { center, .. } => {
            let u = std::array::from_fn(|i| point[i] - center[i]);
            within(&dot(u, u), radius, 2)
        }
        P::Slab { .. } => false,
    };
    prop_assert!(on_face, "{:?} is not on face {}", point, face);
    // A normal is known as well as the point is, against the radius.
    let blur = 4 + 4 * unit / radius;
    prop_assert!(within(&dot(normal, normal), unit, blur), "{:?} has not length 1", normal);
    let against = dot(normal, case.direction);
    prop_assert!(against <= IBig::from(2 * blur * unit), "the far side: {:?}", normal);
    Ok(())
}

/// Roots of the open wall that count, don't count, or lie within a unit of where that changes.
fn check_wall<S: Fixed>(case: &Case, got: Option<(S, bool)>) -> Result<(), TestCaseError> {
    let P::Cylinder { axis, low, high, .. } = case.primitive else { return Ok(()) };
    let Part::Between(roots) = case.wall(S::FRACTION) else {
        // Whether the line is a tangent is asked elsewhere: see `tangents_touch_the_wall`.
        prop_assert!(got.is_none() || is_tangent(case), "{:?}", got);
        return Ok(());
    };
    let (x, dx) = (case.origin[axis], case.direction[axis]);
    let mut may_be = Vec::new();
    let mut is_certain = false;
    for (inner, root) in [false, true].into_iter().zip(&roots) {
        // t ≥ by, and low − by·(1 + |dx|) ≤ x(t) ≤ high + by·(1 + |dx|), t to within `by`.
        let unit = IBig::ONE << S::FRACTION as usize;
        let counts = |by: i64| {
            let room = IBig::from(by) * (&unit + dx.abs());
            let from = (IBig::from(low - x) << S::FRACTION as usize) - &room;
            let to = (IBig::from(high - x) << S::FRACTION as usize) + room;
            let between = match dx.cmp(&0) {
                Ordering::Equal => from <= IBig::ZERO && IBig::ZERO <= to,
                order => {
                    let (from, to) = if order.is_gt() { (from, to) } else { (-to, -from) };
                    let speed = IBig::from(dx.abs());
                    root.compare(&from, &speed).is_ge() && root.compare(&to, &speed).is_le()
                }
            };
            between && root.compare(&IBig::from(-by), &IBig::ONE).is_ge()
        };
        if counts(1) {
            may_be.extend(
                nearest(root).into_iter().flat_map(|t| [t - 1, t, t + 1]).map(|t| (t, inner)),
            );
        }
        if counts(-1) {
            is_certain = true;
            break;
        }
    }
    match got {
        None => prop_assert!(!is_certain, "missed the wall: {:?}", may_be),
        Some((t, inner)) => {
            let got = (t.raw(), inner);
            prop_assert!(may_be.contains(&got), "{:?} is none of {:?}", got, may_be);
        }
    }
    Ok(())
}

fn is_tangent(case: &Case) -> bool {
    let P::Cylinder { axis, middle, radius, .. } = case.primitive else { return false };
    let [[x, y], [dx, dy]] = [case.origin, case.direction].map(|v| across(axis, v));
    let (u, d) = ([x - middle[0], y - middle[1], 0], [dx, dy, 0]);
    let [_, _, moment] = cross(u, d);
    let length_squared = dot(d, d);
    length_squared > IBig::ZERO && square(&IBig::from(radius)) * length_squared == square(&moment)
}

// What is drawn.

/// From −limit to limit, small numbers as often as large ones.
fn whole(limit: i64) -> BoxedStrategy<i64> {
    let bits = 64 - limit.leading_zeros();
    prop_oneof![
        2 => -8..=8i64,
        4 => (0..=bits, -1f64..1.0).prop_map(|(bits, x)| (x * 2f64.powi(bits as i32)) as i64),
        3 => -limit..=limit,
        1 => prop::sample::select(vec![-limit, -limit + 1, limit - 1, limit]),
    ]
    .prop_map(move |x| x.clamp(-limit, limit))
    .boxed()
}

fn point(limit: i64) -> BoxedStrategy<V> {
    [whole(limit), whole(limit), whole(limit)].boxed()
}

fn radius(limit: i64) -> BoxedStrategy<i64> {
    whole(limit).prop_map(|r| r.abs().max(1)).boxed()
}

fn range(limit: i64) -> BoxedStrategy<[i64; 2]> {
    (whole(limit), whole(limit), 1..=8i64)
        .prop_map(move |(a, b, short)| match a.cmp(&b) {
            Ordering::Less => [a, b],
            Ordering::Equal if a + short <= limit => [a, a + short],
            Ordering::Equal => [a - short, a],
            Ordering::Greater => [b, a],
        })
        .boxed()
}

fn primitive(limit: i64) -> BoxedStrategy<Primitive> {
    let cylinder = (0..3usize, [whole(limit), whole(limit)], radius(limit), range(limit)).prop_map(
        |(axis, middle, radius, [low, high])| P::Cylinder { axis, middle, radius, low, high },
    );
    let sphere =
        (point(limit), radius(limit)).prop_map(|(center, radius)| P::Sphere { center, radius });
    let slab =
        (0..3usize, range(limit)).prop_map(|(axis, [low, high])| P::Slab { axis, low, high });
    prop_oneof![6 => cylinder, 3 => sphere, 2 => slab].boxed()
}

/// The direction times a power of two, so that it is one that a ray takes, or `None`.
fn stretched<S: Fixed>(direction: V, more: u32) -> Option<V> {
    let mut direction = direction;
    let largest = |v: V| v.map(i64::abs).into_iter().max().unwrap_or(0);
    if largest(direction) == 0 {
        return None;
    }
    let half = 1 << (S::FRACTION - 1);
    while largest(direction) < half {
        direction = direction.map(|x| 2 * x);
    }
    for _ in 0..more {
        let twice = direction.map(|x| 2 * x);
        if largest(twice) <= LONGEST {
            direction = twice;
        }
    }
    (largest(direction) <= LONGEST).then_some(direction)
}

/// A point of the solid's surface if `around` is one: 3-4-5 triangles make it exact, where the
/// radius is five times something.
fn landmark(primitive: &Primitive, [i, j]: [usize; 2]) -> (V, V) {
    const FIFTHS: [[i64; 2]; 8] =
        [[5, 0], [3, 4], [-4, 3], [0, -5], [-3, -4], [4, -3], [3, -4], [-5, 0]];
    let [a, b] = FIFTHS[i % 8];
    match *primitive {
        P::Cylinder { axis, middle, radius, low, high } => {
            let fifth = radius / 5;
            let along = [low, high, low + (high - low) / 2][j % 3];
            let round = [middle[0] + a * fifth, middle[1] + b * fifth];
            let tangent = [-b, a];
            (spread(axis, along, round), spread(axis, 0, tangent))
        }
        P::Sphere { center, radius } => {
            let fifth = radius / 5;
            let [u, v] = [spread(j % 3, 0, [a * fifth, b * fifth]), spread(j % 3, 1, [-b, a])];
            (std::array::from_fn(|k| center[k] + u[k]), v)
        }
        P::Slab { axis, low, high } => {
            (spread(axis, [low, high][j % 2], [a, b]), spread(axis, 0, [b, a]))
        }
    }
}

/// The inverse of `across`.
fn spread(axis: usize, along: i64, [a, b]: [i64; 2]) -> V {
    match axis {
        0 => [along, a, b],
        1 => [a, along, b],
        _ => [a, b, along],
    }
}

/// With five times a whole number as the radius, if it was large enough for that.
fn in_fifths(primitive: Primitive) -> Primitive {
    let fifths = |r: i64| if r >= 5 { r / 5 * 5 } else { r };
    match primitive {
        P::Cylinder { axis, middle, radius, low, high } => {
            P::Cylinder { axis, middle, radius: fifths(radius), low, high }
        }
        P::Sphere { center, radius } => P::Sphere { center, radius: fifths(radius) },
        slab @ P::Slab { .. } => slab,
    }
}

/// Rays anywhere, of any direction.
fn anywhere<S: Fixed>(limit: i64) -> BoxedStrategy<Case> {
    (primitive(limit), point(limit), point(LONGEST), 0..8u32)
        .prop_filter_map("no direction", |(primitive, origin, direction, more)| {
            Some(Case { primitive, origin, direction: stretched::<S>(direction, more)? })
        })
        .boxed()
}

/// Rays to a point of the surface or next to it: rims, wall, caps.
fn aimed<S: Fixed>(limit: i64) -> BoxedStrategy<Case> {
    let near = || prop_oneof![2 => Just([0; 3]), 1 => prop::array::uniform3(-1..=1i64)];
    (primitive(limit), point(limit), [0..8usize, 0..3], near(), 0..4u32)
        .prop_filter_map("no direction", |(primitive, origin, place, near, more)| {
            let primitive = in_fifths(primitive);
            let (target, _) = landmark(&primitive, place);
            let way = std::array::from_fn(|i| target[i] + near[i] - origin[i]);
            Some(Case { primitive, origin, direction: stretched::<S>(way, more)? })
        })
        .boxed()
}

/// Rays along the surface: tangents, rays in a cap's plane, rays on the wall; or a unit beside.
fn along_the_surface<S: Fixed>(limit: i64) -> BoxedStrategy<Case> {
    let near = || prop_oneof![2 => Just([0; 3]), 1 => prop::array::uniform3(-1..=1i64)];
    let steps = (-(1i64 << 24)..=1 << 24, 0..24u32).prop_map(|(n, cut)| n >> cut);
    (primitive(limit), [0..8usize, 0..3], near(), steps, -6..=6i64, 0..4u32)
        .prop_filter_map("too far", |(primitive, place, near, steps, slope, more)| {
            let primitive = in_fifths(primitive);
            let (target, mut way) = landmark(&primitive, place);
            if let P::Cylinder { axis, .. } = primitive {
                way[axis] = slope;
            }
            let origin: V = std::array::from_fn(|i| target[i] + near[i] - steps * way[i]);
            let is_near = origin.iter().all(|x| x.abs() <= MAX_COORDINATE);
            let direction = stretched::<S>(way, more)?;
            is_near.then_some(Case { primitive, origin, direction })
        })
        .boxed()
}

/// A few units, and directions of a few halves: nearly everything is a tie.
fn tiny<S: Fixed>() -> BoxedStrategy<Case> {
    let grid = |limit: i64| prop::array::uniform3(-limit..=limit);
    let range = (-8..=8i64, 1..=8i64).prop_map(|(low, length)| [low, low + length]);
    let cylinder = (0..3usize, [-8..=8i64, -8..=8i64], 1..=6i64, range.clone()).prop_map(
        |(axis, middle, radius, [low, high])| P::Cylinder { axis, middle, radius, low, high },
    );
    let sphere = (grid(8), 1..=6i64).prop_map(|(center, radius)| P::Sphere { center, radius });
    let slab = (0..3usize, range).prop_map(|(axis, [low, high])| P::Slab { axis, low, high });
    let primitive = prop_oneof![4 => cylinder, 2 => sphere, 1 => slab];
    (primitive, grid(8), grid(4), 0..3u32)
        .prop_filter_map("no direction", |(primitive, origin, direction, more)| {
            Some(Case { primitive, origin, direction: stretched::<S>(direction, more)? })
        })
        .boxed()
}

const CASES: u32 = 2000;

fn test<S: Fixed>(cases: BoxedStrategy<Case>) {
    proptest!(ProptestConfig::with_cases(CASES), |(case in cases)| check::<S>(&case)?);
}

macro_rules! exact {
    ($($name:ident $S:ident),+) => {$(
        mod $name {
            use super::*;

            #[test]
            fn on_a_few_units() {
                test::<$S>(tiny::<$S>());
            }

            #[test]
            fn anywhere() {
                test::<$S>(super::anywhere::<$S>(MAX_COORDINATE));
            }

            #[test]
            fn anywhere_nearby() {
                test::<$S>(super::anywhere::<$S>(1 << $S::FRACTION));
            }

            #[test]
            fn at_landmarks() {
                test::<$S>(aimed::<$S>(MAX_COORDINATE));
            }

            #[test]
            fn at_landmarks_nearby() {
                test::<$S>(aimed::<$S>(1 << 10));
            }

            #[test]
            fn along_the_surface() {
                test::<$S>(super::along_the_surface::<$S>(MAX_COORDINATE));
            }

            #[test]
            fn along_the_surface_nearby() {
                test::<$S>(super::along_the_surface::<$S>(1 << 10));
            }
        }
    )+};
}

exact!(i8f24 I8F24, i16f16 I16F16, i24f8 I24F8);

/// Cases in which the wall's chord or the way between the caps is shorter than a unit. If such a span is
/// given a length first and cut by the other one then, there is a hit where there is none, or the exit
/// is at a face that comes later; and a root of the open wall counts that lies beyond the end.
#[test]
fn cut_before_it_is_given_a_length() {
    let case = |[axis, a, b, radius, low, high]: [i64; 6], origin, direction| Case {
        primitive: P::Cylinder { axis: axis as usize, middle: [a, b], radius, low, high },
        origin,
        direction,
    };
    let far = (1 << 28) - 1;
    let found = [
        // Wall and cap are crossed in one point of the rim, and nothing is inside.
        case([2, 0, 0, 5, 0, 1], [0, far, -1], [0, -far - 5, 1]),
        // Inside the wall only after the line has left the caps, half a unit later.
        case([1, 0, 0, 1, -2, -1], [0, -3, 0], [0, -1232, -2036].map(|x| x << 8)),
        // Out through the wall, and not through the cap a unit later.
        case([0, 0, 0, 1, -3, 0], [0; 3], [-163_840, 0, 163_840]),
        // The open wall, beyond its end by a hundred units.
        case([1, 0, -53_381, 27_665, 0, 1], [12_178, 0, -11_553], [0, 5_785_312, -742_196_880]),
    ];
    let wrong = found.iter().filter_map(|case| Some((check::<I16F16>(case).err()?, case)));
    let wrong: Vec<_> = wrong.map(|(error, case)| format!("{error} for {case:?}")).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// The open wall is a surface and touched once by a tangent, at the nearest parameter.
#[test]
fn tangents_touch_the_wall() {
    let touched = Cell::new(0);
    let cases = along_the_surface::<I16F16>(MAX_COORDINATE).prop_filter("no tangent", is_tangent);
    proptest!(ProptestConfig::with_cases(300), |(case in cases)| {
        let P::Cylinder { axis, low, high, .. } = case.primitive else { unreachable!() };
        let Any::Cylinder(cylinder) = Any::<I16F16>::of(&case.primitive) else { unreachable!() };
        let ray = Ray::new(numbers(case.origin), numbers(case.direction)).unwrap();
        let got = CylinderWall::of(&cylinder).hit(&ray);
        let [[x, y], [dx, dy]] = [case.origin, case.direction].map(|v| across(axis, v));
        let P::Cylinder { middle, .. } = case.primitive else { unreachable!() };
        let (u, d) = ([x - middle[0], y - middle[1], 0], [dx, dy, 0]);
        let t = Surd::ratio(-dot(u, d) << 16, dot(d, d));
        // Well between the ends, and well after the start.
        let (start, speed) = (case.origin[axis], case.direction[axis]);
        let x_at = |t: i64| start as f64 + t as f64 * speed as f64 / 65536.0;
        let room = 2.0 + 2.0 * speed.abs() as f64 / 65536.0;
        let near = nearest(&t);
        let is_inside = near.iter().all(|&t| {
            t > 1 && low as f64 + room < x_at(t) && x_at(t) < high as f64 - room
        });
        if is_inside {
            prop_assert!(got.is_some(), "missed");
            let got = got.unwrap();
            prop_assert!(near.contains(&got.t.raw()) && !got.inner, "{:?} not {:?}", got, near);
            touched.set(touched.get() + 1);
        }
    });
    assert!(touched.get() > 20, "{touched:?}");
}

/// The model would prove nothing if its cases were all alike.
#[test]
fn the_cases_are_worth_it() {
    use proptest::strategy::ValueTree;
    let strategies = [
        tiny::<I16F16>(),
        anywhere::<I16F16>(MAX_COORDINATE),
        aimed::<I16F16>(MAX_COORDINATE),
        along_the_surface::<I16F16>(MAX_COORDINATE),
        aimed::<I16F16>(1 << 10),
        along_the_surface::<I16F16>(1 << 10),
    ];
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let mut counts = [0; 6];
    for cases in strategies {
        for _ in 0..1000 {
            let case = cases.new_tree(&mut runner).unwrap().current();
            let span = case.span(16);
            let pairs = span.as_ref().map(allowed).unwrap_or_default();
            let rim = match (case.wall(16), case.caps(16)) {
                (Part::Between(wall), Part::Between(caps)) => {
                    wall.iter().any(|at| caps.iter().any(|cap| at.order(cap).is_eq()))
                }
                _ => false,
            };
            let ends = || span.iter().flatten().filter_map(|end| end.at.as_ref());
            let out_of_range = |n: &i64| *n == LOWEST || *n == HIGHEST;
            for (count, is_one) in counts.iter_mut().zip([
                span.is_some(),
                span.is_none(),
                is_tangent(&case),
                rim,
                // A tie of both ends, or an end on a half.
                pairs.len() > 1,
                ends().any(|end| nearest(end).iter().any(out_of_range)),
            ]) {
                *count += usize::from(is_one);
            }
        }
    }
    println!("hits, misses, tangents, rims, ties, saturated: {counts:?}");
    assert!(counts.iter().all(|&count| count > 30), "{counts:?}");
}
