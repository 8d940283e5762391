//! Laws that every scene and every ray obey, in `f32` and `f64`.
//!
//! The laws of boolean algebra hold bit for bit, because both sides of an equation are made of
//! the same crossings. Counts of spans are claimed only where nothing is rounded: on rays and
//! solids whose coordinates are small whole numbers.

#![allow(clippy::unwrap_used)]

use proptest::prelude::*;
use scancsg::geom::{Line, Pose, Ray, Vec3, vec3};
use scancsg::solid::{
    Cylinder, Difference, Intersect, Intersection, Placed, Shape, Slab, Solid, Sphere, Union,
};
use scancsg::span::{Face, SpanList, SpanStack};

/// Any primitive, so that one scene type can be filled at random.
#[derive(Debug, Clone, Copy)]
enum Primitive<S: Intersect> {
    Cylinder(Cylinder<S>),
    Slab(Slab<S>),
    Sphere(Sphere<S>),
}

impl<S: Intersect> Shape for Primitive<S> {
    type Scalar = S;
    const SPANS: usize = 1;
    const STACK: usize = 1;
    const FACES: u16 = 3;
}

impl<S: Intersect> Solid for Primitive<S> {
    fn spans(&self, line: &Line<S>, first: Face, stack: &mut SpanStack<'_, S>) {
        match self {
            Self::Cylinder(solid) => solid.spans(line, first, stack),
            Self::Slab(solid) => solid.spans(line, first, stack),
            Self::Sphere(solid) => solid.spans(line, first, stack),
        }
    }

    fn normal(&self, face: Face, at: Vec3<S>) -> Vec3<S> {
        match self {
            Self::Cylinder(solid) => solid.normal(face, at),
            Self::Slab(solid) => solid.normal(face, at),
            Self::Sphere(solid) => solid.normal(face, at),
        }
    }
}

macro_rules! laws {
    ($scalar:ident) => {
        mod $scalar {
            use super::*;

            type S = $scalar;
            type P = Primitive<S>;

            fn bits<T: Solid<Scalar = S>>(solid: &T, ray: &Ray<S>) -> Vec<[u64; 2]> {
                let mut list = SpanList::<S, 64>::new();
                // + 0.0 makes −0 into 0, which is the same parameter.
                let bits = |t: S| u64::from((t + 0.0).to_bits());
                let spans = solid.trace(ray, &mut list).iter();
                spans.map(|span| [bits(span.enter.t), bits(span.exit.t)]).collect()
            }

            fn same<A, B>(left: &A, right: &B, ray: &Ray<S>) -> Result<(), TestCaseError>
            where
                A: Solid<Scalar = S>,
                B: Solid<Scalar = S>,
            {
                prop_assert_eq!(bits(left, ray), bits(right, ray));
                Ok(())
            }

            fn coordinate() -> impl Strategy<Value = S> {
                // Halves make shared faces and exact ties; the rest is generic.
                prop_oneof![
                    3 => -2.0..2.0 as S,
                    2 => (-4..=4i8).prop_map(|halves| S::from(halves) * 0.5),
                ]
            }

            fn size() -> impl Strategy<Value = S> {
                prop_oneof![0.3..1.5 as S, (1..=3u8).prop_map(|halves| S::from(halves) * 0.5)]
            }

            fn point() -> impl Strategy<Value = Vec3<S>> {
                (coordinate(), coordinate(), coordinate()).prop_map(|(x, y, z)| vec3(x, y, z))
            }

            fn primitive() -> BoxedStrategy<P> {
                let along = (0..3u8, coordinate(), coordinate(), size(), coordinate(), size());
                prop_oneof![
                    3 => along.prop_map(|(axis, a, b, radius, low, length)| {
                        let high = low + length;
                        P::Cylinder(match axis {
                            0 => Cylinder::<S>::along_x(a, b, radius, low, high),
                            1 => Cylinder::<S>::along_y(a, b, radius, low, high),
                            _ => Cylinder::<S>::along_z(a, b, radius, low, high),
                        }.unwrap())
                    }),
                    2 => (point(), point(), size())
                        .prop_filter_map("coincident", |(from, to, radius)| {
                            Cylinder::<S>::between(from, to, radius).ok().map(P::Cylinder)
                        }),
                    1 => (point(), coordinate(), size())
                        .prop_filter_map("no normal", |(normal, low, width)| {
                            Slab::<S>::new(normal, low, low + width).ok().map(P::Slab)
                        }),
                    1 => (point(), size()).prop_map(|(center, radius)| {
                        P::Sphere(Sphere::<S>::new(center, radius).unwrap())
                    }),
                ]
.boxed()
            }

            /// From anywhere around the scene towards a point of it, or along a coordinate axis.
            fn ray() -> BoxedStrategy<Ray<S>> {
                let towards = (point(), point()).prop_filter_map("no way", |(from, to)| {
                    Ray::new(from * 3.0, to - from * 3.0).ok()
                });
                let along = (point(), 0..3usize, prop::bool::ANY).prop_map(|(origin, axis, back)| {
                    let mut direction: [S; 3] = [0.0; 3];
                    direction[axis] = if back { -1.0 } else { 1.0 };
                    let [x, y, z] = direction;
                    Ray::new(origin, vec3(x, y, z)).unwrap()
                });
                prop_oneof![3 => towards, 1 => along].boxed()
            }

            /// Solids with up to two spans on any line.
            fn pair() -> BoxedStrategy<(Difference<P, P>, Union<P, P>)> {
                (primitive(), primitive(), primitive(), primitive())
                    .prop_map(|(a, b, c, d)| (Difference::new(a, b), Union::new(c, d)))
                    .boxed()
            }

            proptest! {
                #[test]
                fn union_and_intersection_commute((a, b) in pair(), ray in ray()) {
                    same(&Union::new(a, b), &Union::new(b, a), &ray)?;
                    same(&Intersection::new(a, b), &Intersection::new(b, a), &ray)?;
                }

                #[test]
                fn a_solid_with_itself((a, _) in pair(), ray in ray()) {
                    prop_assert_eq!(bits(&Difference::new(a, a), &ray), Vec::<[u64; 2]>::new());
                    same(&Union::new(a, a), &a, &ray)?;
                    same(&Intersection::new(a, a), &a, &ray)?;
                    same(&[a, a, a], &a, &ray)?;
                }

                #[test]
                fn de_morgan_on_a_bounded_universe(
                    (a, b) in pair(), ray in ray(), edge in 1..6u8,
                ) {
                    let edge = S::from(edge) * 0.5;
                    let universe = Intersection::new(
                        Slab::<S>::along_x(-edge, edge).unwrap() & Slab::<S>::along_y(-edge, edge).unwrap(),
                        Slab::<S>::along_z(-edge, edge).unwrap(),
                    );
                    let without_a = Difference::new(universe, a);
                    let without_b = Difference::new(universe, b);
                    let none = Difference::new(universe, Union::new(a, b));
                    same(&none, &Intersection::new(without_a, without_b), &ray)?;
                    let not_both = Difference::new(universe, Intersection::new(a, b));
                    same(&not_both, &Union::new(without_a, without_b), &ray)?;
                }

                #[test]
                fn associative((a, b) in pair(), c in primitive(), ray in ray()) {
                    let left = Union::new(Union::new(a, b), c);
                    same(&left, &Union::new(a, Union::new(b, c)), &ray)?;
                    let left = Intersection::new(Intersection::new(a, b), c);
                    same(&left, &Intersection::new(a, Intersection::new(b, c)), &ray)?;
                    let left = Difference::new(Difference::new(a, b), c);
                    same(&left, &Difference::new(a, Union::new(b, c)), &ray)?;
                }

                #[test]
                fn absorbing((a, b) in pair(), ray in ray()) {
                    same(&Union::new(a, Intersection::new(a, b)), &a, &ray)?;
                    same(&Intersection::new(a, Union::new(a, b)), &a, &ray)?;
                    let in_b = Intersection::new(a, b);
                    let rest = Difference::new(a, b);
                    same(&Union::new(in_b, rest), &a, &ray)?;
                    same(&Difference::new(a, rest), &in_b, &ray)?;
                }

                #[test]
                fn groups_are_nested_unions(
                    parts in prop::array::uniform4(primitive()), ray in ray(),
                ) {
                    let [a, b, c, d] = parts;
                    let nested = Union::new(a, Union::new(b, Union::new(c, d)));
                    same(&parts, &nested, &ray)?;
                    same(&[d, b, a, c], &nested, &ray)?;
                    same(&[[a, b], [c, d]], &nested, &ray)?;
                }

                #[test]
                fn placed_where_it_was((a, _) in pair(), ray in ray()) {
                    same(&Placed::new(&a, Pose::IDENTITY), &a, &ray)?;
                    same(&Placed::new(&a, Pose::rotation_z(0.0)), &a, &ray)?;
                }

                /// Sums and products change their sign with the direction and nothing else.
                #[test]
                fn a_turned_direction_mirrors_the_parameters(
                    (a, b) in pair(), from in point(), to in point(),
                ) {
                    prop_assume!(to != from);
                    let solid = Difference::new(a, b);
                    let mut list = SpanList::<S, 64>::new();
                    let ahead = Ray::new(from, to - from).unwrap();
                    let mut forwards = [(0.0, 0.0); 8];
                    let spans = solid.trace(&ahead, &mut list);
                    let count = spans.len();
                    for (slot, span) in forwards.iter_mut().zip(spans.iter().rev()) {
                        *slot = (-span.exit.t, -span.enter.t);
                    }
                    let back = Ray::new(from, from - to).unwrap();
                    let spans = solid.trace(&back, &mut list).iter();
                    let backwards: Vec<_> = spans.map(|s| (s.enter.t, s.exit.t)).collect();
                    prop_assert_eq!(backwards, forwards[..count].to_vec());
                }

                /// From the other end, and the other way: the same pieces of the line. All
                /// numbers that decide about a wall are whole and below 2²⁴, so the count is the
                /// same also for tangents. Left out are rays through a point of a rim exactly:
                /// there, a wall and a cap are met at one parameter, by two roundings.
                #[test]
                fn seen_from_the_other_end(
                    [x, y, z, dx, dy, dz] in prop::array::uniform6(-8..=8i8),
                    [cy, cz, low] in prop::array::uniform3(-4..=4i8),
                    radius in 1..=5u8, length in 1..=5u8, steps in 1..=4u8,
                ) {
                    prop_assume!((dx, dy, dz) != (0, 0, 0));
                    let hits_rim = |cap: i32| {
                        let whole = |at: i8, way: i8, center: i8| {
                            let (at, way) = (i32::from(at) - i32::from(center), i32::from(way));
                            at * i32::from(dx) + way * (cap - i32::from(x))
                        };
                        let [a, b] = [whole(y, dy, cy), whole(z, dz, cz)];
                        a * a + b * b == (i32::from(radius) * i32::from(dx)).pow(2)
                    };
                    prop_assume!(!hits_rim(low.into()) && !hits_rim(i32::from(low) + i32::from(length)));
                    let of = |x: i8, y: i8, z: i8| vec3(S::from(x), S::from(y), S::from(z));
                    let (origin, direction) = (of(x, y, z), of(dx, dy, dz));
                    let cylinder = Cylinder::<S>::along_x(
                        cy.into(), cz.into(), radius.into(), low.into(),
                        S::from(low) + S::from(length),
                    ).unwrap();
                    let steps = S::from(steps);
                    let there = Ray::new(origin, direction).unwrap();
                    let back = Ray::new(origin + direction * steps, -direction).unwrap();
                    let [mut a, mut b] = [const { SpanList::<S, 1>::new() }; 2];
                    let (a, b) = (cylinder.trace(&there, &mut a), cylinder.trace(&back, &mut b));
                    prop_assert_eq!(a.len(), b.len());
                    for (a, b) in a.iter().zip(b) {
                        for (t, mirrored) in [(a.enter.t, b.exit.t), (a.exit.t, b.enter.t)] {
                            // Both discriminants are the same whole number, a root has an error
                            // of 1.5 ulp at most, and the middles differ by the rounding of a
                            // quotient each: 4 ulp of the largest parameter in play.
                            let largest = [t, mirrored, steps].into_iter()
                                .chain([a.enter.t, a.exit.t, b.enter.t, b.exit.t])
                                .fold(0.0, |m: S, t| m.max(t.abs()));
                            let gap = (steps - mirrored) - t;
                            prop_assert!(gap.abs() <= 4.0 * S::EPSILON * largest,
                                "{t} and {mirrored} of {steps}");
                        }
                    }
                }

                /// A shift by whole numbers moves whole numbers without rounding: the numbers
                /// decide, not where they were written down.
                #[test]
                fn shifted_on_the_grid(
                    [x, y, z, dx, dy, dz] in prop::array::uniform6(-8..=8i8),
                    [sx, sy, sz] in prop::array::uniform3(-4..=4i8),
                    radius in 1..=5u8, length in 1..=5u8,
                ) {
                    prop_assume!((dx, dy, dz) != (0, 0, 0));
                    let of = |x: i8, y: i8, z: i8| vec3(S::from(x), S::from(y), S::from(z));
                    let ray = Ray::new(of(x, y, z), of(dx, dy, dz)).unwrap();
                    let at_home =
                        Cylinder::<S>::along_x(0.0, 0.0, radius.into(), 0.0, length.into()).unwrap();
                    let there = Cylinder::<S>::along_x(
                        sy.into(), sz.into(), radius.into(), sx.into(),
                        S::from(sx) + S::from(length),
                    ).unwrap();
                    let placed = Placed::new(&at_home, Pose::translation(of(sx, sy, sz)));
                    prop_assert_eq!(bits(&placed, &ray).len(), bits(&there, &ray).len());
                    same(&placed, &there, &ray)?;
                }

                /// Two cylinders with a cap plane in common are one cylinder: no wall is left at
                /// the plane, whichever of the two is asked first.
                #[test]
                fn abutting_cylinders_are_one(
                    low in coordinate(), left in size(), right in size(), a in coordinate(),
                    b in coordinate(), radius in size(), ray in ray(), axis in 0..3u8,
                ) {
                    let (middle, high) = (low + left, low + left + right);
                    let make = |low, high| match axis {
                        0 => Cylinder::<S>::along_x(a, b, radius, low, high),
                        1 => Cylinder::<S>::along_y(a, b, radius, low, high),
                        _ => Cylinder::<S>::along_z(a, b, radius, low, high),
                    }.unwrap();
                    // A ray that lies in the common plane has no inside and outside there.
                    let (at, along) = (ray.line().origin, ray.line().direction);
                    let axis = usize::from(axis);
                    let (at, along) = (at.to_array()[axis], along.to_array()[axis]);
                    prop_assume!(along != 0.0 || at != middle);

                    let (one, first, second) =
                        (make(low, high), make(low, middle), make(middle, high));
                    same(&(first | second), &one, &ray)?;
                    same(&[second, first], &one, &ray)?;
                    same(&(one - first), &second, &ray)?;
                }

                /// Drilling from cap to cap is drilling through: no skin of no thickness is left.
                #[test]
                fn flush_holes_leave_no_skin(
                    low in coordinate(), length in size(), radius in size(),
                    bore in size(), ray in ray(),
                ) {
                    let high = low + length;
                    let shaft = Cylinder::<S>::along_z(0.0, 0.0, radius, low, high).unwrap();
                    let flush = Cylinder::<S>::along_z(0.0, 0.0, bore * 0.5, low, high).unwrap();
                    let through =
                        Cylinder::<S>::along_z(0.0, 0.0, bore * 0.5, low - 1.0, high + 1.0).unwrap();
                    same(&(shaft - flush), &(shaft - through), &ray)?;
                }
            }

            fn spans_along<T>(solid: &T, origin: [S; 3], direction: [S; 3]) -> Vec<(S, S)>
            where
                T: Solid<Scalar = S>,
            {
                let [[ox, oy, oz], [dx, dy, dz]] = [origin, direction];
                let ray = Ray::new(vec3(ox, oy, oz), vec3(dx, dy, dz)).unwrap();
                let mut list = SpanList::<S, 16>::new();
                let spans = solid.trace(&ray, &mut list).iter();
                spans.map(|span| (span.enter.t, span.exit.t)).collect()
            }

            /// A rim point lies on the wall and on a cap. Code that tests the three surfaces one
            /// by one counts it never or twice; here it is one end of one span.
            #[test]
            fn a_rim_hit_counts_once() {
                let cylinder = Cylinder::<S>::along_x(0.0, 0.0, 5.0, -2.0, 2.0).unwrap();
                // Through the rim point (2, 3, 4) and the middle, then through two rims.
                let diagonal = spans_along(&cylinder, [4.0, 6.0, 8.0], [-2.0, -3.0, -4.0]);
                assert_eq!(diagonal, [(1.0, 3.0)]);
                let other = spans_along(&cylinder, [6.0, 9.0, 12.0], [-4.0, -6.0, -8.0]);
                assert_eq!(other, [(1.0, 2.0)]);
                // In at the rim, out through the opposite cap.
                let slanted = spans_along(&cylinder, [4.0, 6.0, 8.0], [-1.0, -1.5, -2.0]);
                assert_eq!(slanted, [(2.0, 6.0)]);
                // In at the rim, along the cap's plane it would leave again at once.
                let skew = spans_along(&cylinder, [3.0, 3.0, 4.0], [-1.0, 0.0, 0.0]);
                assert_eq!(skew.len(), 0, "a ray on the wall has no length inside");
            }

            /// This line meets wall and cap in the rim point only, from outside: an intersection
            /// of closed intervals would report a span of no length.
            #[test]
            fn a_touched_rim_is_no_span() {
                let cylinder = Cylinder::<S>::along_x(0.0, 0.0, 5.0, -2.0, 2.0).unwrap();
                assert_eq!(spans_along(&cylinder, [4.0, -3.0, -4.0], [-1.0, 3.0, 4.0]), []);
                assert_eq!(spans_along(&cylinder, [3.0, 0.0, 0.0], [-1.0, 3.0, 4.0]), []);
            }

            /// Along the bore's axis, where bore and shaft share both caps: nothing but the four
            /// coincident planes is met.
            #[test]
            fn one_can_look_through_a_flush_hole() {
                let shaft = Cylinder::<S>::along_x(0.0, 0.0, 2.0, -1.0, 1.0).unwrap();
                let hole = Cylinder::<S>::along_x(0.0, 0.0, 1.0, -1.0, 1.0).unwrap();
                assert_eq!(spans_along(&(shaft - hole), [-5.0, 0.5, 0.25], [1.0, 0.0, 0.0]), []);
                assert_eq!(spans_along(&(shaft - hole), [-5.0, 0.5, 0.25], [1.0, 0.0, 0.1]), []);
                let beside = spans_along(&(shaft - hole), [-5.0, 1.5, 0.0], [1.0, 0.0, 0.0]);
                assert_eq!(beside, [(4.0, 6.0)]);
            }

            /// Cylinders by end points meet at a rounded plane: both have to round it alike.
            #[test]
            fn oblique_cylinders_abut_without_a_wall() {
                let [a, b, c] = [0.0, 0.75, 1.5].map(|k: S| vec3(k, k * 2.0, k * -0.5));
                let first = Cylinder::<S>::between(a, b, 0.5).unwrap();
                let second = Cylinder::<S>::between(b, c, 0.5).unwrap();
                for i in 0..100u8 {
                    // Through points of the common disk, at up to half the radius.
                    let [u, v] = [S::from(i % 10) * 0.04 - 0.2, S::from(i / 10) * 0.04 - 0.2];
                    let target = b + vec3(u, 0.0, u * 2.0) + vec3(v, -v * 0.5, 0.0) * 0.5;
                    let from = vec3(3.0 + v, 5.0 - u, -1.0 + u * v);
                    let way = (target - from).to_array();
                    for solid in [[first, second], [second, first]] {
                        let spans = spans_along(&solid, from.to_array(), way);
                        assert_eq!(spans.len(), 1, "through {target:?}: {spans:?}");
                    }
                }
            }
        }
    };
}

laws!(f32);
laws!(f64);
