//! Laws that every scene and every ray obey.
//!
//! The laws of boolean algebra hold bit for bit, because both sides of an equation are made of
//! the same crossings. Counts of spans are claimed only where nothing is rounded: on rays and
//! solids whose coordinates are small whole numbers.

use crate::limits;
use crate::number::{Tested, between, coordinates, ray, rod, spans, vector};
use proptest::prelude::*;
use scancsg::geom::{Line, Pose, Ray, Vec3, vec3};
use scancsg::solid::{
    Cone, Cylinder, Difference, Intersection, Placed, RayCast, Scaled, Shape, Slab, Solid, Sphere,
    Torus, Union,
};
use scancsg::span::{Face, SpanList, SpanStack};

for_every_number!(
    union_and_intersection_commute,
    a_solid_with_itself,
    de_morgan_on_a_bounded_universe,
    associative,
    absorbing,
    groups_are_nested_unions,
    placed_where_it_was,
    a_hit_is_the_first_crossing_of_the_trace,
    a_turned_direction_mirrors_the_parameters,
    seen_from_the_other_end,
    shifted_on_the_grid,
    abutting_cylinders_are_one,
    caps_do_not_move_the_wall,
    flush_holes_leave_no_skin,
    oblique_cylinders_abut_without_a_wall,
);

/// Any primitive, so that one scene type can be filled at random.
#[derive(Debug, Clone, Copy)]
enum Primitive<S: Tested> {
    Cylinder(Cylinder<S>),
    Cone(Cone<S>),
    Slab(Slab<S>),
    Sphere(Sphere<S>),
    Scaled(Scaled<Sphere<S>>),
    Torus(Torus<S>),
}

impl<S: Tested> Shape for Primitive<S> {
    type Scalar = S;
    const SPANS: usize = 2;
    const STACK: usize = 2;
    const FACES: u16 = 3;
}

impl<S: Tested> Solid for Primitive<S> {
    fn spans(&self, line: &Line<S>, first: Face, stack: &mut SpanStack<'_, S>) {
        match self {
            Self::Cylinder(solid) => solid.spans(line, first, stack),
            Self::Cone(solid) => solid.spans(line, first, stack),
            Self::Slab(solid) => solid.spans(line, first, stack),
            Self::Sphere(solid) => solid.spans(line, first, stack),
            Self::Scaled(solid) => solid.spans(line, first, stack),
            Self::Torus(solid) => solid.spans(line, first, stack),
        }
    }

    fn normal(&self, face: Face, at: Vec3<S>) -> Vec3<S> {
        match self {
            Self::Cylinder(solid) => solid.normal(face, at),
            Self::Cone(solid) => solid.normal(face, at),
            Self::Slab(solid) => solid.normal(face, at),
            Self::Sphere(solid) => solid.normal(face, at),
            Self::Scaled(solid) => solid.normal(face, at),
            Self::Torus(solid) => solid.normal(face, at),
        }
    }
}

fn same<S, A, B>(left: &A, right: &B, ray: &Ray<S>) -> Result<(), TestCaseError>
where
    S: Tested,
    A: Solid<Scalar = S>,
    B: Solid<Scalar = S>,
{
    prop_assert_eq!(spans(left, ray), spans(right, ray));
    Ok(())
}

fn coordinate<S: Tested>() -> impl Strategy<Value = S> {
    // Halves make shared faces and exact ties; the rest is generic.
    prop_oneof![3 => -2.0..2.0, 2 => (-4..=4i8).prop_map(|halves| f64::from(halves) * 0.5)]
        .prop_map(S::near)
}

fn size<S: Tested>() -> impl Strategy<Value = S> {
    prop_oneof![0.3..1.5, (1..=3u8).prop_map(|halves| f64::from(halves) * 0.5)].prop_map(S::near)
}

fn point<S: Tested>() -> impl Strategy<Value = Vec3<S>> {
    [coordinate(), coordinate(), coordinate()].prop_map(|[x, y, z]| Vec3::new(x, y, z))
}

fn primitive<S: Tested>() -> BoxedStrategy<Primitive<S>> {
    let along = (0..3usize, [coordinate(), coordinate()], size(), coordinate(), size());
    prop_oneof![
        3 => along.prop_map(|(axis, middle, radius, low, length)| {
            Primitive::Cylinder(S::along(axis, middle, radius, low, low.plus(length)).unwrap())
        }),
        2 => (point(), point(), size()).prop_filter_map("coincident", |(from, to, radius)| {
            S::between(from, to, radius).ok().map(Primitive::Cylinder)
        }),
        2 => (point(), point(), size(), size()).prop_filter_map("coincident", |(from, to, a, b)| {
            // A tip for the smallest sizes.
            let b = if b < S::near(0.6) { S::ZERO } else { b };
            S::cone_between(from, to, [a, b]).ok().map(Primitive::Cone)
        }),
        1 => (point(), coordinate(), size())
            .prop_filter_map("no normal", |(normal, low, width): (_, S, S)| {
                S::slab(normal, low, low.plus(width)).ok().map(Primitive::Slab)
            }),
        1 => (point(), size())
            .prop_map(|(center, radius)| Primitive::Sphere(S::sphere(center, radius).unwrap())),
        1 => (point(), size(), [size::<S>(), size(), size()]).prop_map(|(center, radius, factors)| {
            let ball = S::sphere(center, radius).unwrap();
            Primitive::Scaled(Scaled::by(ball, factors).unwrap())
        }),
        1 => (point(), point(), size::<S>(), size()).prop_filter_map("no torus", |(at, axis, one, other)| {
            S::torus(at, axis, [one.max(other), one.min(other)]).ok().map(Primitive::Torus)
        }),
    ]
    .boxed()
}

/// From anywhere around the scene towards a point of it, or along a coordinate axis.
fn any_ray<S: Tested>() -> BoxedStrategy<Ray<S>> {
    let towards = (point::<S>(), point()).prop_filter_map("no way", |(from, to)| {
        let [from, to] = [from, to].map(coordinates);
        let from = from.map(|x| 3.0 * x);
        let way = std::array::from_fn(|i| to[i] - from[i]);
        Ray::new(vector(from), vector(way)).ok()
    });
    let along = (point(), 0..3usize, prop::bool::ANY).prop_map(|(origin, axis, back)| {
        let mut direction = [0.0; 3];
        direction[axis] = if back { -1.0 } else { 1.0 };
        Ray::new(origin, vector(direction)).unwrap()
    });
    prop_oneof![3 => towards, 1 => along].boxed()
}

type Pair<S> = (Difference<Primitive<S>, Primitive<S>>, Union<Primitive<S>, Primitive<S>>);

/// Solids with up to two spans on any line.
fn pair<S: Tested>() -> BoxedStrategy<Pair<S>> {
    (primitive(), primitive(), primitive(), primitive())
        .prop_map(|(a, b, c, d)| (Difference::new(a, b), Union::new(c, d)))
        .boxed()
}

fn union_and_intersection_commute<S: Tested>() {
    proptest!(|((a, b) in pair::<S>(), ray in any_ray())| {
        same(&Union::new(a, b), &Union::new(b, a), &ray)?;
        same(&Intersection::new(a, b), &Intersection::new(b, a), &ray)?;
    });
}

/// Coincident faces cancel only if both operands give the same bits: a tolerance, or an order of
/// crossings, leaves a skin.
fn a_solid_with_itself<S: Tested>() {
    proptest!(|((a, _) in pair::<S>(), ray in any_ray())| {
        prop_assert_eq!(spans(&Difference::new(a, a), &ray), []);
        same(&Union::new(a, a), &a, &ray)?;
        same(&Intersection::new(a, a), &a, &ray)?;
        same(&[a, a, a], &a, &ray)?;
    });
}

fn de_morgan_on_a_bounded_universe<S: Tested>() {
    proptest!(|((a, b) in pair::<S>(), ray in any_ray(), edge in 1..6u8)| {
        let edge = S::near(f64::from(edge) * 0.5);
        let [x, y, z] = [0, 1, 2].map(|axis| S::slab_along(axis, edge.negated(), edge).unwrap());
        let universe = x & y & z;
        let without_a = Difference::new(universe, a);
        let without_b = Difference::new(universe, b);
        let none = Difference::new(universe, Union::new(a, b));
        same(&none, &Intersection::new(without_a, without_b), &ray)?;
        let not_both = Difference::new(universe, Intersection::new(a, b));
        same(&not_both, &Union::new(without_a, without_b), &ray)?;
    });
}

fn associative<S: Tested>() {
    proptest!(|((a, b) in pair::<S>(), c in primitive(), ray in any_ray())| {
        let left = Union::new(Union::new(a, b), c);
        same(&left, &Union::new(a, Union::new(b, c)), &ray)?;
        let left = Intersection::new(Intersection::new(a, b), c);
        same(&left, &Intersection::new(a, Intersection::new(b, c)), &ray)?;
        let left = Difference::new(Difference::new(a, b), c);
        same(&left, &Difference::new(a, Union::new(b, c)), &ray)?;
    });
}

fn absorbing<S: Tested>() {
    proptest!(|((a, b) in pair::<S>(), ray in any_ray())| {
        same(&Union::new(a, Intersection::new(a, b)), &a, &ray)?;
        same(&Intersection::new(a, Union::new(a, b)), &a, &ray)?;
        let in_b = Intersection::new(a, b);
        let rest = Difference::new(a, b);
        same(&Union::new(in_b, rest), &a, &ray)?;
        same(&Difference::new(a, rest), &in_b, &ray)?;
    });
}

fn groups_are_nested_unions<S: Tested>() {
    proptest!(|([a, b, c, d] in prop::array::uniform4(primitive::<S>()), ray in any_ray())| {
        let nested = Union::new(a, Union::new(b, Union::new(c, d)));
        same(&[a, b, c, d], &nested, &ray)?;
        same(&[d, b, a, c], &nested, &ray)?;
        same(&[[a, b], [c, d]], &nested, &ray)?;
    });
}

fn placed_where_it_was<S: Tested>() {
    proptest!(|((a, _) in pair::<S>(), ray in any_ray())| {
        same(&Placed::new(&a, Pose::IDENTITY), &a, &ray)?;
        same(&Placed::new(&a, Pose::rotation_z(S::ZERO).unwrap()), &a, &ray)?;
    });
}

/// Both ask the same line; a hit that rounded for itself would see another face now and then.
fn a_hit_is_the_first_crossing_of_the_trace<S: Tested>() {
    proptest!(|((a, _) in pair::<S>(), ray in any_ray())| {
        let mut list = SpanList::<S, 64>::new();
        let hit = a.hit(&ray, &mut list).map(|hit| (hit.t, hit.face, hit.inside));
        let ends = a.trace(&ray, &mut list).iter();
        let first = ends
            .flat_map(|span| [(span.enter, false), (span.exit, true)])
            .find(|(end, _)| end.t >= S::ZERO && end.t < S::HIGHEST)
            .map(|(end, inside)| (end.t, end.face, inside));
        prop_assert_eq!(hit, first);
    });
}

/// Sums and products change their sign with the direction and nothing else. A parameter on a half
/// of a fixed-point unit may be rounded either way, and that's all.
fn a_turned_direction_mirrors_the_parameters<S: Tested>() {
    proptest!(|((a, b) in pair::<S>(), from in point(), to in point())| {
        let solid = Difference::new(a, b);
        let [start, end] = [from, to].map(coordinates);
        let way: [f64; 3] = std::array::from_fn(|i| end[i] - start[i]);
        let (ahead, back) = (vector::<S>(way), vector(way.map(|x| -x)));
        let (Ok(ahead), Ok(back)) = (Ray::new(from, ahead), Ray::new(from, back)) else {
            return Err(TestCaseError::reject("no way"));
        };
        let forwards: Vec<(f64, f64)> =
            spans(&solid, &ahead).iter().rev().map(|(enter, exit)| (0.0 - exit, 0.0 - enter)).collect();
        let backwards = spans(&solid, &back);
        if S::IS_FIXED {
            prop_assert_eq!(backwards.len(), forwards.len());
            for (a, b) in backwards.iter().zip(&forwards) {
                let off = (a.0 - b.0).abs().max((a.1 - b.1).abs());
                prop_assert!(off <= limits::SAME_SOLID.of::<S>(), "{:?} {:?}", a, b);
            }
        } else {
            prop_assert_eq!(backwards, forwards);
        }
    });
}

/// From the other end, and the other way: the same pieces of the line. All numbers that decide
/// about a wall are whole and below 2²⁴, so the count is the same also for tangents. Left out are
/// rays through a point of a rim exactly: there, floats meet a wall and a cap at one parameter, by
/// two roundings.
fn seen_from_the_other_end<S: Tested>() {
    proptest!(|(
        [x, y, z, dx, dy, dz] in prop::array::uniform6(-8..=8i8),
        [cy, cz, low] in prop::array::uniform3(-4..=4i8),
        radius in 1..=5u8, length in 1..=5u8, steps in 1..=4u8,
    )| {
        prop_assume!((dx, dy, dz) != (0, 0, 0));
        let hits_rim = |cap: i32| {
            let whole = |at: i8, way: i8, center: i8| {
                let (at, way) = (i32::from(at) - i32::from(center), i32::from(way));
                at * i32::from(dx) + way * (cap - i32::from(x))
            };
            let [a, b] = [whole(y, dy, cy), whole(z, dz, cz)];
            a * a + b * b == (i32::from(radius) * i32::from(dx)).pow(2)
        };
        let is_clear = !hits_rim(low.into()) && !hits_rim(i32::from(low) + i32::from(length));
        prop_assume!(S::IS_FIXED || is_clear);
        let [cy, cz, low] = [cy, cz, low].map(f64::from);
        let (origin, direction) = ([x, y, z].map(f64::from), [dx, dy, dz].map(f64::from));
        let [radius, length, steps] = [radius, length, steps].map(f64::from);
        let cylinder = S::along(
            0, [S::near(cy), S::near(cz)], S::near(radius), S::near(low), S::near(low + length),
        ).unwrap();
        let there = ray::<S>(origin, direction);
        let end = std::array::from_fn(|i| origin[i] + direction[i] * steps);
        let back = ray::<S>(end, direction.map(|x| -x));
        let (a, b) = (spans(&cylinder, &there), spans(&cylinder, &back));
        prop_assert_eq!(a.len(), b.len());
        for (a, b) in a.iter().zip(b) {
            for (t, mirrored) in [(a.0, b.1), (a.1, b.0)] {
                // In floating point both discriminants are the same whole number, a root has an
                // error of 1.5 ulp at most, and the middles differ by the rounding of a quotient
                // each: 4 ulp of the largest parameter in play. In fixed point, half a unit each.
                let largest =
                    [t, mirrored, steps, a.0, a.1, b.0, b.1].map(f64::abs).into_iter().fold(0.0, f64::max);
                let allowed = limits::MIRRORED.of::<S>() * if S::IS_FIXED { 1.0 } else { largest };
                let gap = (steps - mirrored) - t;
                prop_assert!(gap.abs() <= allowed, "{t} and {mirrored} of {steps}");
            }
        }
    });
}

/// A shift by whole numbers moves whole numbers without rounding: the numbers decide, not where
/// they were written down.
fn shifted_on_the_grid<S: Tested>() {
    proptest!(|(
        [x, y, z, dx, dy, dz] in prop::array::uniform6(-8..=8i8),
        shift in prop::array::uniform3(-4..=4i8),
        radius in 1..=5u8, length in 1..=5u8,
    )| {
        prop_assume!((dx, dy, dz) != (0, 0, 0));
        // A line that passes (0, 0, 0) much nearer than it starts is counted from a point of it there,
        // which is rounded. Of these, that are lines through it.
        let [o, d] = [[x, y, z], [dx, dy, dz]].map(|v| Vec3::from(v.map(f64::from)));
        prop_assume!(o.cross(d) != Vec3::ZERO || o == Vec3::ZERO);
        let [radius, length] = [radius, length].map(f64::from);
        let shift = shift.map(f64::from);
        let ray = ray::<S>([x, y, z].map(f64::from), [dx, dy, dz].map(f64::from));
        let at_home = rod::<S>(radius, 0.0, length);
        let [sx, sy, sz] = shift.map(S::near);
        let there =
            S::along(0, [sy, sz], S::near(radius), sx, sx.plus(S::near(length))).unwrap();
        same(&Placed::new(&at_home, S::translation(vector(shift)).unwrap()), &there, &ray)?;
    });
}

/// Whether no span of a solid is as short as a unit. Such a one may be longer than the solid is,
/// in fixed point, and reach into its neighbour.
fn is_clear<S: Tested>(solid: &impl Solid<Scalar = S>, ray: &Ray<S>) -> bool {
    spans(solid, ray).iter().all(|(enter, exit)| exit - enter > S::UNIT)
}

/// Two cylinders with a cap plane in common are one cylinder: no wall is left at the plane,
/// whichever of the two is asked first.
fn abutting_cylinders_are_one<S: Tested>() {
    proptest!(|(
        low in coordinate::<S>(), left in size(), right in size(),
        middle in [coordinate(), coordinate()], radius in size(), ray in any_ray(), axis in 0..3usize,
    )| {
        let plane = low.plus(left);
        let high = plane.plus(right);
        let make = |low, high| S::along(axis, middle, radius, low, high).unwrap();
        let (one, first, second) = (make(low, high), make(low, plane), make(plane, high));
        prop_assume!(is_clear(&first, &ray) && is_clear(&second, &ray));
        same(&(first | second), &one, &ray)?;
        same(&[second, first], &one, &ray)?;
        same(&(one - first), &second, &ray)?;
        prop_assert_eq!(spans(&(first & second), &ray), []);
    });
}

/// A ray in the plane of a cap meets the wall where it does without that cap: one of two cylinders that
/// abut there has the span of both, by the bit.
fn caps_do_not_move_the_wall<S: Tested>() {
    proptest!(|(
        low in coordinate::<S>(), left in size(), right in size(),
        middle in [coordinate(), coordinate()], radius in size(), axis in 0..3usize,
        from in [coordinate::<S>(), coordinate()], way in prop::array::uniform2(-1.0..1.0),
    )| {
        let plane = low.plus(left);
        let make = |low, high| S::along(axis, middle, radius, low, high).unwrap();
        let (one, first, second) =
            (make(low, plane.plus(right)), make(low, plane), make(plane, plane.plus(right)));
        let placed = |along: S, [a, b]: [S; 2]| {
            let mut at = [a, b, along];
            at.rotate_left(2 - axis);
            vec3(at[0], at[1], at[2])
        };
        prop_assume!(way != [0.0, 0.0]);
        let ray = Ray::new(placed(plane, from), placed(S::ZERO, way.map(S::near)));
        prop_assume!(ray.is_ok());
        let ray = ray.unwrap();
        prop_assume!(is_clear(&one, &ray));
        let [first, second] = [&first, &second].map(|solid| spans(solid, &ray));
        prop_assert!(first.is_empty() || second.is_empty());
        prop_assert_eq!([first, second].concat(), spans(&one, &ray));
    });
}

/// Drilling from cap to cap is drilling through: no skin of no thickness is left.
fn flush_holes_leave_no_skin<S: Tested>() {
    proptest!(|(
        low in coordinate::<S>(), length in size(), radius in size(), bore in 0.15..0.75,
        ray in any_ray(),
    )| {
        let high = low.plus(length);
        let make = |r, low, high| S::along(2, [S::ZERO; 2], r, low, high).unwrap();
        let (shaft, bore) = (make(radius, low, high), S::near(bore));
        let flush = make(bore, low, high);
        let through = make(bore, low.minus(S::ONE), high.plus(S::ONE));
        prop_assume!(is_clear(&shaft, &ray) && is_clear(&flush, &ray));
        same(&(shaft - flush), &(shaft - through), &ray)?;
    });
}

/// Cylinders by end points meet at a rounded plane: both have to round it alike.
fn oblique_cylinders_abut_without_a_wall<S: Tested>() {
    let [a, b, c] = [0.0, 0.75, 1.5].map(|k: f64| [k, k * 2.0, k * -0.5]);
    let (first, second) = (between::<S>(a, b, 0.5), between::<S>(b, c, 0.5));
    for i in 0..100u8 {
        // Through points of the common disk, at up to half the radius.
        let [u, v] = [i % 10, i / 10].map(|k| f64::from(k) * 0.04 - 0.2);
        let target = [b[0] + u + 0.5 * v, b[1] - 0.25 * v, b[2] + 2.0 * u];
        let from = [3.0 + v, 5.0 - u, -1.0 + u * v];
        let way = std::array::from_fn(|k| target[k] - from[k]);
        for solid in [[first, second], [second, first]] {
            let spans = spans(&solid, &ray::<S>(from, way));
            assert_eq!(spans.len(), 1, "through {target:?}: {spans:?}");
        }
    }
}
