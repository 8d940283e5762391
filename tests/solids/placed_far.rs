//! Rays in fixed point from far away at small solids that are placed: a direction is rounded in the solid's
//! frame, and what that loses must not grow with the way.

use scancsg::geom::Pose;
use scancsg::scalar::{I16F16, Number};
use scancsg::solid::{Bounds, ByLine, Placed, RayCast, Solid};
use scancsg::span::{Face, SpanList};
use testkit::number::{Tested, ball, between, coordinates, ray, vector};
use testkit::says::Says;
use testkit::vector::{V, dot, length, sub};

type S = I16F16;

const RADIUS: f64 = 0.005;

/// Every ray at the middle hits, and sees a normal that points back at it to within 8°.
fn check(turned: impl Fn(Pose<S>) -> Pose<S>, center: V, solid: impl Solid<Scalar = S> + Copy) {
    for k in 0..2000 {
        let turn = Pose::rotation_z(S::near(0.1 + 0.001 * f64::from(k))).unwrap();
        let placed = Placed::new(solid, turned(turn));
        let middle = coordinates(turned(turn).point(vector(center)));
        for (from, way) in
            [([1000.0, 0.0, 0.0], [-1.0, 0.0, 0.0]), ([0.0, 0.0, -1000.0], [0.0, 0.0, 1.0])]
        {
            let start = std::array::from_fn(|i| middle[i] + from[i]);
            let ray = ray::<S>(start, way);
            let hit = placed.hit(&ray, &mut SpanList::<S, 1>::new());
            let hit = hit.unwrap_or_else(|| panic!("{k}: a miss"));
            assert!((hit.t.to_f64() - (1000.0 - RADIUS)).abs() <= 4.0 * S::UNIT, "{k}: {hit:?}");
            let normal = coordinates(hit.normal);
            let cosine = -dot(normal, way) / length(normal);
            assert!(cosine >= 8f64.to_radians().cos(), "{k}: {normal:?}");
            let off = length(sub(coordinates(hit.point), middle)) - RADIUS;
            assert!(off.abs() <= 4.0 * S::UNIT, "{k}: {off}");
        }
    }
}

#[test]
fn balls_are_hit_where_they_are() {
    let shift = |by: V| S::translation(vector(by)).unwrap();
    let (here, there) = ([0.0; 3], [1000.0, 20.0, -300.0]);
    let own = |center: V| {
        let bounds = Bounds::Ball { center: vector(center), radius: S::near(RADIUS) };
        ByLine::<_, 1>::new(Says(ball(center, RADIUS), bounds))
    };
    // In its own frame's middle, turned there; and turned, then moved.
    check(|turn| turn, here, ball::<S>(here, RADIUS));
    check(|turn| turn.then(&shift(there)).unwrap(), here, ball::<S>(here, RADIUS));
    check(|turn| turn, here, own(here));
    // Far from its own frame's middle.
    check(|turn| turn, there, ball::<S>(there, RADIUS));
    check(|turn| turn, there, own(there));
    // In a frame in another one.
    let inner = Placed::new(ball::<S>(here, RADIUS), shift(there));
    check(|turn| turn, there, inner);
}

/// Two solids with one pose share their own frame, and with it the bits at which a common face is crossed.
#[test]
fn a_common_face_stays_one() {
    let (low, high) = ([0.0, 0.0, -0.7], [0.0, 0.0, 0.9]);
    let cup = between::<S>(low, high, 1.0);
    let hollow = between::<S>([0.0, 0.0, -0.4], high, 0.8);
    let shift = S::translation(vector([3.0, -2.0, 1.5])).unwrap();
    for k in 0..200 {
        let turn = Pose::about(vector([1.0, 2.0, -0.5]), S::near(0.03 * f64::from(k))).unwrap();
        let pose = turn.then(&shift).unwrap();
        let cup = Placed::new(cup, pose) - Placed::new(hollow, pose);
        for (x, y) in [(0.0, 0.0), (0.3, -0.4), (-0.6, 0.1)] {
            let from = coordinates(pose.point(vector([x, y, 30.0])));
            let to = coordinates(pose.point(vector([y, x, 0.0])));
            let ray = ray::<S>(from, std::array::from_fn(|i| (to[i] - from[i]) / 10.0));
            let hit = cup.hit(&ray, &mut SpanList::<S, 8>::new()).unwrap();
            // The bottom of the hollow, not a film in its opening.
            assert_eq!(hit.face, Face(3), "{k}: {hit:?}");
        }
    }
}
