//! Cases that break the textbook's formulas, each with a sentence on why. The textbook's cases
//! themselves are in `cylinder_cases.rs`, the laws of boolean algebra in `properties.rs`.

#![allow(clippy::unwrap_used, clippy::indexing_slicing)]

use scancsg::geom::{Ray, Vec3, vec3};
use scancsg::solid::{Cylinder, Shape, Solid, Sphere};
use scancsg::span::SpanList;

macro_rules! hard_cases {
    ($S:ident) => {
        mod $S {
            use super::*;
            type S = $S;

            fn spans<T: Solid<Scalar = S>>(solid: &T, ray: Ray<S>) -> Vec<(S, S)> {
                let mut list = SpanList::<S, 32>::new();
                solid.trace(&ray, &mut list).iter().map(|s| (s.enter.t, s.exit.t)).collect()
            }

            fn ray(origin: [S; 3], direction: [S; 3]) -> Ray<S> {
                let vector = |[x, y, z]: [S; 3]| vec3(x, y, z);
                Ray::new(vector(origin), vector(direction)).unwrap()
            }

            fn rod(radius: S) -> Cylinder<S> {
                Cylinder::<S>::along_x(0.0, 0.0, radius, -2.0, 2.0).unwrap()
            }

            /// |o|² − r² loses r altogether from 10⁵ radii away, and b² − 4ac with it; the distance
            /// of the ray from the axis does not depend on where on it one begins.
            #[test]
            fn from_a_hundred_thousand_radii() {
                for past in [0.999, 1.001] {
                    let hits = past < 1.0;
                    for far in [1e3, 1e4, 1e5, 1e6] {
                        let level = ray([0.5, past, far], [0.0, 0.0, -1.0]);
                        assert_eq!(
                            spans(&rod(1.0), level).len(),
                            usize::from(hits),
                            "{past} {far}"
                        );
                    }
                }
            }

            /// The discriminant of a grazing ray is smaller than the rounding errors of its terms.
            /// Powers of two make the distance exact: inside by one unit is a hit, outside a miss.
            #[test]
            fn grazing_from_both_directions() {
                for sign in [-1.0, 1.0] {
                    let graze =
                        |y: S| spans(&rod(1.0), ray([0.0, y, 5.0 * sign], [0.0, 0.0, -sign]));
                    assert_eq!(graze((1.0 as S).next_up()).len(), 0);
                    assert_eq!(graze(1.0).len(), 0);
                    let within = (1.0 as S).next_down();
                    let [(enter, exit)] = graze(within)[..] else { panic!("a miss") };
                    // The chord is 2√(1 − y²), and 1 − y² is within rounding of S::EPSILON.
                    let half = S::EPSILON.sqrt();
                    assert!(
                        (exit - enter - 2.0 * half).abs() <= 8.0 * S::EPSILON,
                        "{enter} {exit}"
                    );
                }
            }

            /// Almost parallel, the roots are large numbers that differ by the length of the tube,
            /// and a formula that subtracts them, or 1 − dx², has no digit left.
            #[test]
            fn almost_parallel_to_the_axis() {
                for angle in [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7] {
                    let [(enter, exit)] =
                        spans(&rod(1.0), ray([-5.0, 0.0, 0.25], [1.0, angle, 0.0]))[..]
                    else {
                        panic!("a miss at {angle}")
                    };
                    assert_eq!((enter, exit), (3.0, 7.0), "{angle}");
                    let outside = ray([-5.0, 1.5, 0.0], [1.0, angle, 0.0]);
                    assert!(spans(&rod(1.0), outside).is_empty(), "{angle}");
                }
            }

            /// A geometric tolerance would take these walls for nothing, or for thicker than they
            /// are.
            #[test]
            fn walls_of_a_few_units_in_the_last_place() {
                for ulps in 1..=4 {
                    let inner = (0..ulps).fold(1.0 as S, |r, _| r.next_down());
                    let pipe = rod(1.0) - rod(inner);
                    let walls = spans(&pipe, ray([0.0, 2.0, 0.0], [0.0, -1.0, 0.0]));
                    assert_eq!(walls.len(), 2, "{ulps}");
                    // Parameters are near 1 and 3, where a unit is one or four times that of the radius.
                    let thickness = 1.0 - inner;
                    assert!((walls[0].1 - walls[0].0 - thickness).abs() <= 2.0 * S::EPSILON);
                }
            }

            /// Squares of such radii are 10⁻⁸ and 10⁸ times those of the coordinates beside them.
            #[test]
            fn very_small_and_very_large_radii() {
                for radius in [1e-4, 1e4] {
                    let [(enter, exit)] =
                        spans(&rod(radius), ray([0.0, 3.0 * radius, 0.0], [0.0, -1.0, 0.0]))[..]
                    else {
                        panic!("a miss of {radius}")
                    };
                    let error = (enter / radius - 2.0).abs().max((exit / radius - 4.0).abs());
                    assert!(error <= 2.0 * S::EPSILON, "{radius}: {enter} {exit}");
                    assert!(
                        spans(&rod(radius), ray([0.0, 0.0, radius * 1.0001], [0.0, 1.0, 0.0]))
                            .is_empty()
                    );
                }
            }

            /// Directions whose squares are zero or infinite, and coordinates that are subnormal.
            #[test]
            fn subnormal_and_enormous_directions() {
                for length in [S::MIN_POSITIVE / 1024.0, S::MIN_POSITIVE, S::MAX / 2.0] {
                    let [(enter, exit)] =
                        spans(&rod(1.0), ray([0.0, 0.0, 5.0], [0.0, 0.0, -length]))[..]
                    else {
                        panic!("a miss at {length}")
                    };
                    // The smallest directions have parameters beyond the type's range.
                    if (4.0 / length).is_finite() {
                        assert!((enter * length - 4.0).abs() < 1e-5, "{length}: {enter}");
                        assert!((exit * length - 6.0).abs() < 1e-5, "{length}: {exit}");
                    }
                }
                let tiny = S::from_bits(1);
                let beside = ray([tiny, tiny, 5.0], [tiny, 0.0, -1.0]);
                assert_eq!(spans(&rod(1.0), beside), [(4.0, 6.0)]);
            }

            /// Each level takes away and adds faces in the same place; one of them left over, or
            /// one too many, shows as a wall.
            #[test]
            fn nested_differences_of_the_same_faces() {
                let (a, b) = (rod(1.0), Cylinder::<S>::along_x(0.0, 0.0, 1.0, -2.0, 0.0).unwrap());
                for [origin, direction] in
                    [[[0.0, 0.0, 5.0], [0.25, 0.0, -1.0]], [[-9.0, 0.5, 0.0], [1.0, 0.0, 0.0]]]
                {
                    let ray = ray(origin, direction);
                    assert_eq!(spans(&(a - (a - b)), ray), spans(&b, ray));
                    assert_eq!(spans(&(a - (a - (a - b))), ray), spans(&(a - b), ray));
                    assert_eq!(spans(&((a - b) | b), ray), spans(&a, ray));
                    assert!(spans(&((a - b) & b), ray).is_empty());
                    assert!(spans(&((a | b) - (b | a)), ray).is_empty());
                }
            }

            /// A test for t > 0 instead of t ≥ 0 sees the far side, or nothing.
            #[test]
            fn from_a_point_on_a_surface() {
                let ball = Sphere::<S>::new(Vec3::ZERO, 1.0).unwrap();
                let mut list = SpanList::<S, { Sphere::<S>::STACK }>::new();
                let inwards = ball.hit(&ray([0.0, 1.0, 0.0], [0.0, -1.0, 0.0]), &mut list).unwrap();
                assert_eq!((inwards.t, inwards.inside), (0.0, false));
                let outwards = ball.hit(&ray([0.0, 1.0, 0.0], [0.0, 1.0, 0.0]), &mut list).unwrap();
                assert_eq!((outwards.t, outwards.inside), (0.0, true));
            }
        }
    };
}

hard_cases!(f32);
hard_cases!(f64);

/// The two roots of a tangent come from different quotients, and if they round to different
/// numbers, the touch becomes a span.
#[test]
fn a_tangent_has_one_root() {
    let rod = Cylinder::<f64>::along_z(-6.0, 2.0, 2.0, -1e6, 1e6).unwrap();
    let ray = Ray::new(vec3(-15.0, 0.0, -15.0), vec3(11.0, 0.0, 11.0)).unwrap();
    assert!(rod.trace(&ray, &mut SpanList::<f64, 1>::new()).is_empty());
}
