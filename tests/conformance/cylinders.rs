//! The textbook's cases of a ray and a cylinder, one by one, on numbers that make them exact.

use crate::limits;
use crate::number::{Tested, between, coordinates, ray, rod};
use scancsg::geom::Vec3;
use scancsg::solid::{CylinderWall, Hit, RayCast, WallHit};
use scancsg::span::{Face, SpanList};

const INSIDE: bool = true;

/// Radius 5 (so that 3-4-5 triangles are exact), from x = −2 to 2.
fn wall_hit<S: Tested>(origin: [f64; 3], direction: [f64; 3]) -> Option<WallHit<S>> {
    CylinderWall::of(&rod::<S>(5.0, -2.0, 2.0)).hit(&ray(origin, direction))
}

fn spans<S: Tested>(origin: [f64; 3], direction: [f64; 3]) -> Vec<(f64, f64)> {
    crate::number::spans(&rod::<S>(5.0, -2.0, 2.0), &ray(origin, direction))
}

fn hit<S: Tested>(origin: [f64; 3], direction: [f64; 3]) -> Option<Hit<S>> {
    rod::<S>(5.0, -2.0, 2.0).hit(&ray(origin, direction), &mut SpanList::<S, 1>::new())
}

/// All but the normal exactly; 1/r is rounded, so 3/5 may come out one place off.
#[track_caller]
fn assert_wall<S: Tested>(
    seen: Option<WallHit<S>>,
    t: f64,
    point: [f64; 3],
    normal: [f64; 3],
    inner: bool,
) {
    let seen = seen.unwrap();
    assert_eq!((seen.t.to_f64(), coordinates(seen.point), seen.inner), (t, point, inner));
    assert_normal(seen.normal, normal);
}

#[track_caller]
fn assert_normal<S: Tested>(normal: Vec3<S>, want: [f64; 3]) {
    for (got, want) in coordinates(normal).into_iter().zip(want) {
        assert!((got - want).abs() <= limits::NORMAL.of::<S>(), "{normal:?} is not {want:?}");
    }
}

for_every_number!(
    open_wall_both_outside_on_the_same_side,
    open_wall_both_inside_takes_the_smaller,
    open_wall_exactly_one_inside_takes_that_one,
    open_wall_through_the_tube,
    open_wall_from_inside_sees_the_inner_face,
    negative_roots_do_not_count,
    tangent,
    parallel_to_the_axis,
    perpendicular_in_the_plane_of_a_cap,
    a_ray_in_a_common_cap_plane,
    starting_on_the_surface,
    faces_and_their_normals,
    wall_normals_all_around,
    unnormalised_directions_scale_t_only,
    a_rim_hit_counts_once,
    a_touched_rim_is_no_span,
);

/// Both roots lie off the same end: testing each against one bound only would let the ray in.
fn open_wall_both_outside_on_the_same_side<S: Tested>() {
    assert_eq!(wall_hit::<S>([8.0, 10.0, 0.0], [-0.25, -1.0, 0.0]), None);
    assert_eq!(wall_hit::<S>([-8.0, 10.0, 0.0], [0.25, -1.0, 0.0]), None);
}

fn open_wall_both_inside_takes_the_smaller<S: Tested>() {
    let seen = wall_hit::<S>([0.0, 10.0, 3.0], [0.0, -2.0, 0.0]);
    assert_wall(seen, 3.0, [0.0, 4.0, 3.0], [0.0, 0.8, 0.6], false);
}

/// Over the end into the tube: the first root does not count, and what is seen is the inner face
/// behind it, with its normal turned round.
fn open_wall_exactly_one_inside_takes_that_one<S: Tested>() {
    let seen = wall_hit::<S>([6.0, 5.0, 0.0], [-0.5, -1.0, 0.0]);
    assert_wall(seen, 10.0, [1.0, -5.0, 0.0], [0.0, 1.0, 0.0], INSIDE);
    let seen = wall_hit::<S>([1.0, 10.0, 0.0], [0.5, -1.0, 0.0]);
    assert_eq!(seen, None, "3.5 and 8.5 are both beyond the end");
    let seen = wall_hit::<S>([-1.0, 7.0, 0.0], [0.5, -1.0, 0.0]);
    assert_wall(seen, 2.0, [0.0, 5.0, 0.0], [0.0, 1.0, 0.0], false);
}

/// In at one end and out at the other: the case that textbook lists forget. Neither root is
/// between the ends, though they are on different sides.
fn open_wall_through_the_tube<S: Tested>() {
    assert_eq!(wall_hit::<S>([-10.0, -5.0, 0.0], [2.0, 1.0, 0.0]), None);
    assert_eq!(spans::<S>([-10.0, -5.0, 0.0], [2.0, 1.0, 0.0]), [(4.0, 6.0)]);
}

/// The root behind the start does not count, and the next one is the inner face.
fn open_wall_from_inside_sees_the_inner_face<S: Tested>() {
    let seen = wall_hit::<S>([0.0, 1.0, 0.0], [0.0, 1.0, 0.0]);
    assert_wall(seen, 4.0, [0.0, 5.0, 0.0], [0.0, -1.0, 0.0], INSIDE);
    let seen = wall_hit::<S>([1.0, 0.0, 0.0], [0.0, 3.0, -4.0]);
    assert_wall(seen, 1.0, [1.0, 3.0, -4.0], [0.0, -0.6, 0.8], INSIDE);
}

fn negative_roots_do_not_count<S: Tested>() {
    assert_eq!(wall_hit::<S>([0.0, 6.0, 0.0], [0.0, 1.0, 0.0]), None);
    assert_eq!(hit::<S>([0.0, 6.0, 0.0], [0.0, 1.0, 0.0]), None);
    // The spans are those of the whole line all the same.
    assert_eq!(spans::<S>([0.0, 6.0, 0.0], [0.0, 1.0, 0.0]), [(-11.0, -1.0)]);
}

/// A tangent has a double root. The wall is a surface and touched once; the solid is regularised,
/// and a point of it is nothing.
fn tangent<S: Tested>() {
    let seen = wall_hit::<S>([0.0, 5.0, -3.0], [0.0, 0.0, 1.0]);
    assert_wall(seen, 3.0, [0.0, 5.0, 0.0], [0.0, 1.0, 0.0], false);
    assert_eq!(spans::<S>([0.0, 5.0, -3.0], [0.0, 0.0, 1.0]), []);
    // At (1, 3, 4), askew.
    let seen = wall_hit::<S>([0.0, -1.0, 7.0], [1.0, 4.0, -3.0]);
    assert_wall(seen, 1.0, [1.0, 3.0, 4.0], [0.0, 0.6, 0.8], false);
    assert_eq!(spans::<S>([0.0, -1.0, 7.0], [1.0, 4.0, -3.0]), []);
    // Touching the infinite cylinder beyond the end.
    assert_eq!(wall_hit::<S>([2.0, -1.0, 7.0], [1.0, 4.0, -3.0]), None);
}

/// a = 0: a quadratic formula divides by it.
fn parallel_to_the_axis<S: Tested>() {
    for way in [1.0, -1.0] {
        let origin = |y, z| [-4.0 * way, y, z];
        let along = [way, 0.0, 0.0];
        assert_eq!(spans::<S>(origin(1.0, -2.0), along), [(2.0, 6.0)], "inside");
        assert_eq!(spans::<S>(origin(4.0, 4.0), along), [], "outside");
        assert_eq!(spans::<S>(origin(3.0, -4.0), along), [], "on the wall");
        for (y, z) in [(1.0, -2.0), (4.0, 4.0), (3.0, -4.0)] {
            assert_eq!(wall_hit::<S>(origin(y, z), along), None, "never crosses the wall");
        }
        let seen = hit::<S>(origin(1.0, -2.0), along).unwrap();
        assert_eq!((seen.t.to_f64(), seen.inside), (2.0, false));
        assert_eq!(coordinates(seen.normal), [-way, 0.0, 0.0]);
    }
}

/// The ray lies in the plane of a cap (dx = 0 and x = ±h): 0/0 in a slab test that divides first.
/// The lower plane belongs to the solid and the upper one doesn't; next to a face there is no doubt.
fn perpendicular_in_the_plane_of_a_cap<S: Tested>() {
    for x in [2.0, -2.0] {
        let in_the_plane = spans::<S>([x, 9.0, 0.0], [0.0, -1.0, 0.0]);
        assert_eq!(in_the_plane, if x < 0.0 { vec![(4.0, 14.0)] } else { vec![] });
        let inside = x * (1.0 - S::UNIT);
        assert_eq!(spans::<S>([inside, 9.0, 0.0], [0.0, -1.0, 0.0]), [(4.0, 14.0)]);
        let outside = x * (1.0 + S::UNIT);
        assert_eq!(spans::<S>([outside, 9.0, 0.0], [0.0, -1.0, 0.0]), []);
        // The rim belongs to the wall.
        let rim = wall_hit::<S>([x, 9.0, 0.0], [0.0, -1.0, 0.0]);
        assert_eq!(rim.map(|hit| hit.t.to_f64()), Some(4.0));
        assert_eq!(wall_hit::<S>([outside, 9.0, 0.0], [0.0, -1.0, 0.0]), None);
    }
}

/// Two cylinders that share a cap plane are one rod, and a ray in that plane runs through the
/// middle of it. If both leave their caps out, there is a slit in the rod, and in a picture a line
/// of holes; if both count them, a rod minus one half of it has no face there.
fn a_ray_in_a_common_cap_plane<S: Tested>() {
    let (low, high) = (rod::<S>(5.0, -2.0, 0.0), rod::<S>(5.0, 0.0, 2.0));
    let ray = ray::<S>([0.0, 9.0, 0.0], [0.0, -1.0, 0.0]);
    assert_eq!(crate::number::spans(&[low, high], &ray), [(4.0, 14.0)]);
    assert_eq!(crate::number::spans(&((low | high) - [low, high]), &ray), []);
    assert_eq!(crate::number::spans(&(low & high), &ray), []);

    // Whichever way their axes point.
    let [start, middle, end] = [-2.0, 0.0, 2.0].map(|x| [x, 0.0, 0.0]);
    for (from, to) in [(start, middle), (middle, start)] {
        for (other_from, other_to) in [(middle, end), (end, middle)] {
            let low = between::<S>(from, to, 5.0);
            let high = between::<S>(other_from, other_to, 5.0);
            assert_eq!(crate::number::spans(&(low | high), &ray), [(4.0, 14.0)]);
            assert_eq!(crate::number::spans(&(low & high), &ray), []);
        }
    }
}

/// t = 0 is on the ray: a test for t > 0 would see the far side, or nothing.
fn starting_on_the_surface<S: Tested>() {
    let inwards = hit::<S>([1.0, 5.0, 0.0], [0.0, -1.0, 0.0]).unwrap();
    assert_eq!((inwards.t.to_f64(), inwards.face, inwards.inside), (0.0, Face(2), false));
    let outwards = hit::<S>([1.0, 5.0, 0.0], [0.0, 1.0, 0.0]).unwrap();
    assert_eq!((outwards.t.to_f64(), outwards.face, outwards.inside), (0.0, Face(2), INSIDE));
    assert_eq!(coordinates(outwards.normal), [0.0, -1.0, 0.0]);
    let into_the_cap = hit::<S>([2.0, 1.0, 1.0], [-1.0, 0.0, 0.0]).unwrap();
    assert_eq!((into_the_cap.t.to_f64(), into_the_cap.face), (0.0, Face(1)));
    assert_eq!(wall_hit::<S>([1.0, 5.0, 0.0], [0.0, -1.0, 0.0]).unwrap().t.to_f64(), 0.0);
    let outwards = wall_hit::<S>([1.0, 5.0, 0.0], [0.0, 1.0, 0.0]).unwrap();
    assert_eq!((outwards.t.to_f64(), outwards.inner), (0.0, INSIDE));
}

fn faces_and_their_normals<S: Tested>() {
    let low = hit::<S>([-9.0, 3.0, 1.0], [1.0, 0.0, 0.0]).unwrap();
    assert_eq!((low.face, coordinates(low.normal)), (Face(0), [-1.0, 0.0, 0.0]));
    let high = hit::<S>([9.0, 3.0, 1.0], [-1.0, 0.0, 0.0]).unwrap();
    assert_eq!((high.face, coordinates(high.normal)), (Face(1), [1.0, 0.0, 0.0]));
    let wall = hit::<S>([0.0, 6.0, 8.0], [0.0, -3.0, -4.0]).unwrap();
    assert_eq!((wall.face, wall.t.to_f64()), (Face(2), 1.0));
    assert_normal(wall.normal, [0.0, 0.6, 0.8]);
    let from_within = hit::<S>([0.0, 3.0, 1.0], [-1.0, 0.0, 0.0]).unwrap();
    assert_eq!((from_within.face, from_within.t.to_f64()), (Face(0), 2.0));
    assert_eq!((coordinates(from_within.normal), from_within.inside), ([1.0, 0.0, 0.0], INSIDE));
}

/// (0, y, z)/r, and (0, −y, −z)/r from within: all the way round, and with length 1.
fn wall_normals_all_around<S: Tested>() {
    let points: [[f64; 2]; 8] = [
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
        let from_outside = wall_hit::<S>([1.0, 2.0 * y, 2.0 * z], [0.0, -y, -z]);
        assert_wall(from_outside, 1.0, [1.0, y, z], [0.0, y / 5.0, z / 5.0], false);
        let from_inside = wall_hit::<S>([1.0, 0.0, 0.0], [0.0, y, z]);
        assert_wall(from_inside, 1.0, [1.0, y, z], [0.0, -y / 5.0, -z / 5.0], INSIDE);
    }
}

/// A formula that takes |d| for 1, as 1 − dx² for |d × axis|² does, is wrong by |d|². A direction of another
/// length gives other parameters, and the same everything else.
fn unnormalised_directions_scale_t_only<S: Tested>() {
    let [origin, way]: [[f64; 3]; 2] = [[6.0, 3.0, 8.0], [-0.75, 0.125, -1.0]];
    let one = hit::<S>(origin, way).unwrap();
    for factor in [0.5, 2.0, 3.0, 7.0, 16.0, 1000.0] {
        let scaled = hit::<S>(origin, way.map(|k| k * factor)).unwrap();
        assert_eq!((scaled.face, scaled.inside), (one.face, one.inside));
        let off = (scaled.t.to_f64() * factor - one.t.to_f64()).abs();
        let allowed = if S::IS_FIXED {
            // Half a unit each.
            (1.0 + factor) * limits::SCALED_DIRECTION.of::<S>()
        } else {
            one.t.to_f64() * limits::SCALED_DIRECTION.of::<S>()
        };
        assert!(off <= allowed, "{off} at {factor}");
    }
}

/// A rim point lies on the wall and on a cap. Code that tests the three surfaces one by one counts
/// it never or twice; here it is one end of one span.
fn a_rim_hit_counts_once<S: Tested>() {
    // Through the rim point (2, 3, 4) and the middle, then through two rims.
    assert_eq!(spans::<S>([4.0, 6.0, 8.0], [-2.0, -3.0, -4.0]), [(1.0, 3.0)]);
    assert_eq!(spans::<S>([6.0, 9.0, 12.0], [-4.0, -6.0, -8.0]), [(1.0, 2.0)]);
    // In at the rim, out through the opposite cap.
    assert_eq!(spans::<S>([4.0, 6.0, 8.0], [-1.0, -1.5, -2.0]), [(2.0, 6.0)]);
    // In at the rim, along the cap's plane it would leave again at once.
    let skew = spans::<S>([3.0, 3.0, 4.0], [-1.0, 0.0, 0.0]);
    assert_eq!(skew.len(), 0, "a ray on the wall has no length inside");
}

/// This line meets wall and cap in the rim point only, from outside: an intersection of closed
/// intervals would report a span of no length.
fn a_touched_rim_is_no_span<S: Tested>() {
    assert_eq!(spans::<S>([4.0, -3.0, -4.0], [-1.0, 3.0, 4.0]), []);
    assert_eq!(spans::<S>([3.0, 0.0, 0.0], [-1.0, 3.0, 4.0]), []);
}
