//! The textbook's cases of a ray and a cylinder, one by one, on numbers that make them exact.

#![allow(clippy::unwrap_used)]

use scancsg::geom::{Ray, Vec3, vec3};
use scancsg::solid::{Cylinder, CylinderWall, Hit, Solid, WallHit};
use scancsg::span::{Face, SpanList};

const INSIDE: bool = true;

macro_rules! cases {
    ($scalar:ident) => {
        mod $scalar {
            use super::*;

            type S = $scalar;

            fn ray(origin: [S; 3], direction: [S; 3]) -> Ray<S> {
                let [[ox, oy, oz], [dx, dy, dz]] = [origin, direction];
                Ray::new(vec3(ox, oy, oz), vec3(dx, dy, dz)).unwrap()
            }

            /// Radius 5 (so that 3-4-5 triangles are exact), from x = −2 to 2.
            fn wall_hit(origin: [S; 3], direction: [S; 3]) -> Option<WallHit<S>> {
                let wall =
                    CylinderWall::of(&Cylinder::<S>::along_x(0.0, 0.0, 5.0, -2.0, 2.0).unwrap());
                wall.hit(&ray(origin, direction))
            }

            fn spans(origin: [S; 3], direction: [S; 3]) -> Vec<(S, S)> {
                let solid = Cylinder::<S>::along_x(0.0, 0.0, 5.0, -2.0, 2.0).unwrap();
                let mut list = SpanList::<S, 1>::new();
                let spans = solid.trace(&ray(origin, direction), &mut list).iter();
                spans.map(|span| (span.enter.t, span.exit.t)).collect()
            }

            fn hit(origin: [S; 3], direction: [S; 3]) -> Option<Hit<S>> {
                let solid = Cylinder::<S>::along_x(0.0, 0.0, 5.0, -2.0, 2.0).unwrap();
                solid.hit(&ray(origin, direction), &mut SpanList::<S, 1>::new())
            }

            /// All but the normal exactly; 1/r is rounded, so 3/5 may come out one place off.
            #[track_caller]
            fn assert_wall(
                seen: Option<WallHit<S>>,
                t: S,
                point: [S; 3],
                normal: [S; 3],
                inner: bool,
            ) {
                let seen = seen.unwrap();
                assert_eq!((seen.t, seen.point.to_array(), seen.inner), (t, point, inner));
                assert_normal(seen.normal, normal);
            }

            #[track_caller]
            fn assert_normal(normal: Vec3<S>, want: [S; 3]) {
                for (got, want) in normal.to_array().into_iter().zip(want) {
                    assert!((got - want).abs() <= S::EPSILON, "{normal:?} is not {want:?}");
                }
            }

            /// Both roots lie off the same end: testing each against one bound only would let
            /// the ray in.
            #[test]
            fn open_wall_both_outside_on_the_same_side() {
                assert_eq!(wall_hit([8.0, 10.0, 0.0], [-0.25, -1.0, 0.0]), None);
                assert_eq!(wall_hit([-8.0, 10.0, 0.0], [0.25, -1.0, 0.0]), None);
            }

            #[test]
            fn open_wall_both_inside_takes_the_smaller() {
                let seen = wall_hit([0.0, 10.0, 3.0], [0.0, -2.0, 0.0]);
                assert_wall(seen, 3.0, [0.0, 4.0, 3.0], [0.0, 0.8, 0.6], false);
            }

            /// Over the end into the tube: the first root does not count, and what is seen is the
            /// inner face behind it, with its normal turned round.
            #[test]
            fn open_wall_exactly_one_inside_takes_that_one() {
                let seen = wall_hit([6.0, 5.0, 0.0], [-0.5, -1.0, 0.0]);
                assert_wall(seen, 10.0, [1.0, -5.0, 0.0], [0.0, 1.0, 0.0], INSIDE);
                let seen = wall_hit([1.0, 10.0, 0.0], [0.5, -1.0, 0.0]);
                assert_eq!(seen, None, "3.5 and 8.5 are both beyond the end");
                let seen = wall_hit([-1.0, 7.0, 0.0], [0.5, -1.0, 0.0]);
                assert_wall(seen, 2.0, [0.0, 5.0, 0.0], [0.0, 1.0, 0.0], false);
            }

            /// In at one end and out at the other: the case that textbook lists forget. Neither
            /// root is between the ends, though they are on different sides.
            #[test]
            fn open_wall_through_the_tube() {
                assert_eq!(wall_hit([-10.0, -5.0, 0.0], [2.0, 1.0, 0.0]), None);
                assert_eq!(spans([-10.0, -5.0, 0.0], [2.0, 1.0, 0.0]), [(4.0, 6.0)]);
            }

            /// The root behind the start does not count, and the next one is the inner face.
            #[test]
            fn open_wall_from_inside_sees_the_inner_face() {
                let seen = wall_hit([0.0, 1.0, 0.0], [0.0, 1.0, 0.0]);
                assert_wall(seen, 4.0, [0.0, 5.0, 0.0], [0.0, -1.0, 0.0], INSIDE);
                let seen = wall_hit([1.0, 0.0, 0.0], [0.0, 3.0, -4.0]);
                assert_wall(seen, 1.0, [1.0, 3.0, -4.0], [0.0, -0.6, 0.8], INSIDE);
            }

            #[test]
            fn negative_roots_do_not_count() {
                assert_eq!(wall_hit([0.0, 6.0, 0.0], [0.0, 1.0, 0.0]), None);
                assert_eq!(hit([0.0, 6.0, 0.0], [0.0, 1.0, 0.0]), None);
                // The spans are those of the whole line all the same.
                assert_eq!(spans([0.0, 6.0, 0.0], [0.0, 1.0, 0.0]), [(-11.0, -1.0)]);
            }

            /// A tangent has a double root. The wall is a surface and touched once; the solid
            /// is regularised, and a point of it is nothing.
            #[test]
            fn tangent() {
                let seen = wall_hit([0.0, 5.0, -3.0], [0.0, 0.0, 1.0]);
                assert_wall(seen, 3.0, [0.0, 5.0, 0.0], [0.0, 1.0, 0.0], false);
                assert_eq!(spans([0.0, 5.0, -3.0], [0.0, 0.0, 1.0]), []);
                // At (1, 3, 4), askew.
                let seen = wall_hit([0.0, -1.0, 7.0], [1.0, 4.0, -3.0]);
                assert_wall(seen, 1.0, [1.0, 3.0, 4.0], [0.0, 0.6, 0.8], false);
                assert_eq!(spans([0.0, -1.0, 7.0], [1.0, 4.0, -3.0]), []);
                // Touching the infinite cylinder beyond the end.
                assert_eq!(wall_hit([2.0, -1.0, 7.0], [1.0, 4.0, -3.0]), None);
            }

            /// a = 0: a quadratic formula divides by it.
            #[test]
            fn parallel_to_the_axis() {
                for way in [1.0, -1.0] {
                    let origin = |y, z| [-4.0 * way, y, z];
                    let along = [way, 0.0, 0.0];
                    assert_eq!(spans(origin(1.0, -2.0), along), [(2.0, 6.0)], "inside");
                    assert_eq!(spans(origin(4.0, 4.0), along), [], "outside");
                    assert_eq!(spans(origin(3.0, -4.0), along), [], "on the wall");
                    for (y, z) in [(1.0, -2.0), (4.0, 4.0), (3.0, -4.0)] {
                        assert_eq!(wall_hit(origin(y, z), along), None, "never crosses the wall");
                    }
                    let seen = hit(origin(1.0, -2.0), along).unwrap();
                    assert_eq!((seen.t, seen.inside), (2.0, false));
                    assert_eq!(seen.normal, vec3(-way, 0.0, 0.0));
                }
            }

            /// The ray lies in the plane of a cap (dx = 0 and x = ±h): 0/0 in a slab test that
            /// divides first. Whether a line in a face is inside is a matter of convention; it
            /// is all of the chord or nothing, and next to the face there is no doubt.
            #[test]
            fn perpendicular_in_the_plane_of_a_cap() {
                for x in [2.0, -2.0] {
                    let in_the_plane = spans([x, 9.0, 0.0], [0.0, -1.0, 0.0]);
                    assert!(in_the_plane.is_empty() || in_the_plane == [(4.0, 14.0)]);
                    let inside = x * (1.0 - S::EPSILON);
                    assert_eq!(spans([inside, 9.0, 0.0], [0.0, -1.0, 0.0]), [(4.0, 14.0)]);
                    let outside = x * (1.0 + S::EPSILON);
                    assert_eq!(spans([outside, 9.0, 0.0], [0.0, -1.0, 0.0]), []);
                    // The rim belongs to the wall.
                    let rim = wall_hit([x, 9.0, 0.0], [0.0, -1.0, 0.0]);
                    assert_eq!(rim.map(|hit| hit.t), Some(4.0));
                    assert_eq!(wall_hit([outside, 9.0, 0.0], [0.0, -1.0, 0.0]), None);
                }
            }

            /// Two cylinders that share a cap plane are one rod, and a ray in that plane runs
            /// through the middle of it. If both leave their caps out, there is a slit in the
            /// rod, and in a picture a line of holes; if both count them, a rod minus one half
            /// of it has no face there.
            #[test]
            fn a_ray_in_a_common_cap_plane() {
                let [low, high] = [[-2.0, 0.0], [0.0, 2.0]]
                    .map(|[low, high]| Cylinder::<S>::along_x(0.0, 0.0, 5.0, low, high).unwrap());
                let ray = ray([0.0, 9.0, 0.0], [0.0, -1.0, 0.0]);
                let mut list = SpanList::<S, 6>::new();
                let rod = [low, high];
                let ends: Vec<_> =
                    rod.trace(&ray, &mut list).iter().map(|s| (s.enter.t, s.exit.t)).collect();
                assert_eq!(ends, [(4.0, 14.0)]);
                let nothing = (rod[0] | rod[1]) - rod;
                let mut list = SpanList::<S, 16>::new();
                assert!(nothing.trace(&ray, &mut list).is_empty());
                assert!((low & high).trace(&ray, &mut list).is_empty());

                // Whichever way their axes point.
                let [start, middle, end] = [-2.0, 0.0, 2.0].map(|x| vec3(x, 0.0, 0.0));
                for (from, to) in [(start, middle), (middle, start)] {
                    for (other_from, other_to) in [(middle, end), (end, middle)] {
                        let low = Cylinder::<S>::between(from, to, 5.0).unwrap();
                        let high = Cylinder::<S>::between(other_from, other_to, 5.0).unwrap();
                        assert_eq!((low | high).trace(&ray, &mut list).len(), 1);
                        assert!((low & high).trace(&ray, &mut list).is_empty());
                    }
                }
            }

            /// t = 0 is on the ray: a test for t > 0 would see the far side, or nothing.
            #[test]
            fn starting_on_the_surface() {
                let inwards = hit([1.0, 5.0, 0.0], [0.0, -1.0, 0.0]).unwrap();
                assert_eq!((inwards.t, inwards.face, inwards.inside), (0.0, Face(2), false));
                let outwards = hit([1.0, 5.0, 0.0], [0.0, 1.0, 0.0]).unwrap();
                assert_eq!((outwards.t, outwards.face, outwards.inside), (0.0, Face(2), INSIDE));
                assert_eq!(outwards.normal, vec3(0.0, -1.0, 0.0));
                let into_the_cap = hit([2.0, 1.0, 1.0], [-1.0, 0.0, 0.0]).unwrap();
                assert_eq!((into_the_cap.t, into_the_cap.face), (0.0, Face(1)));
                assert_eq!(wall_hit([1.0, 5.0, 0.0], [0.0, -1.0, 0.0]).unwrap().t, 0.0);
                let outwards = wall_hit([1.0, 5.0, 0.0], [0.0, 1.0, 0.0]).unwrap();
                assert_eq!((outwards.t, outwards.inner), (0.0, INSIDE));
            }

            #[test]
            fn faces_and_their_normals() {
                let low = hit([-9.0, 3.0, 1.0], [1.0, 0.0, 0.0]).unwrap();
                assert_eq!((low.face, low.normal), (Face(0), vec3(-1.0, 0.0, 0.0)));
                let high = hit([9.0, 3.0, 1.0], [-1.0, 0.0, 0.0]).unwrap();
                assert_eq!((high.face, high.normal), (Face(1), vec3(1.0, 0.0, 0.0)));
                let wall = hit([0.0, 6.0, 8.0], [0.0, -3.0, -4.0]).unwrap();
                assert_eq!((wall.face, wall.t), (Face(2), 1.0));
                assert_normal(wall.normal, [0.0, 0.6, 0.8]);
                let from_within = hit([0.0, 3.0, 1.0], [-1.0, 0.0, 0.0]).unwrap();
                assert_eq!((from_within.face, from_within.t), (Face(0), 2.0));
                assert_eq!((from_within.normal, from_within.inside), (vec3(1.0, 0.0, 0.0), INSIDE));
            }

            /// (0, y, z)/r, and (0, −y, −z)/r from within: all the way round, and with length 1.
            #[test]
            fn wall_normals_all_around() {
                let points: [[S; 2]; 8] = [
                    [5.0, 0.0],
                    [4.0, 3.0],
                    [3.0, 4.0],
                    [0.0, 5.0],
                    [-3.0, 4.0],
                    [-5.0, 0.0],
                    [-4.0, -3.0],
                    [3.0, -4.0],
                ];
                for [y, z] in points {
                    let from_outside = wall_hit([1.0, 2.0 * y, 2.0 * z], [0.0, -y, -z]);
                    assert_wall(from_outside, 1.0, [1.0, y, z], [0.0, y / 5.0, z / 5.0], false);
                    let from_inside = wall_hit([1.0, 0.0, 0.0], [0.0, y, z]);
                    assert_wall(from_inside, 1.0, [1.0, y, z], [0.0, -y / 5.0, -z / 5.0], INSIDE);
                }
            }

            /// A direction of another length gives other parameters, and the same everything else.
            #[test]
            fn unnormalised_directions_scale_t_only() {
                let [origin, way]: [[S; 3]; 2] = [[6.0, 3.0, 8.0], [-0.75, 0.125, -1.0]];
                let one = hit(origin, way).unwrap();
                for power in [-60, -20, -3, 1, 20, 60] {
                    let scale = (2.0 as S).powi(power);
                    let scaled = hit(origin, way.map(|k| k * scale)).unwrap();
                    assert_eq!(scaled, Hit { t: one.t / scale, ..one });
                }
                for factor in [1e-30, 3e-4, 7.0, 1e30] {
                    let scaled = hit(origin, way.map(|k| k * factor)).unwrap();
                    assert_eq!((scaled.face, scaled.inside), (one.face, one.inside));
                    let off = (scaled.t * factor - one.t) / one.t;
                    assert!(off.abs() <= 8.0 * S::EPSILON, "{off} at {factor}");
                }
            }
        }
    };
}

cases!(f32);
cases!(f64);
