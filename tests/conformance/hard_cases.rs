//! Cases that break the textbook's formulas, each with a sentence on why. The textbook's cases
//! themselves are in `cylinders`, the laws of boolean algebra in `laws`.

use crate::limits;
use crate::number::{Tested, ball, ray, rod, spans};
use scancsg::solid::RayCast;
use scancsg::span::SpanList;
use testkit::expect::assert_spans;

for_every_number!(
    from_thousands_of_radii,
    grazing_from_both_directions,
    almost_parallel_to_the_axis,
    walls_of_a_few_units_in_the_last_place,
    small_and_large_radii,
    nested_differences_of_the_same_faces,
    from_a_point_on_a_surface,
    a_tangent_has_one_root,
    one_can_look_through_a_flush_hole,
    wall_and_cap_a_unit_apart,
);

/// |o|² − r² loses digits of r with every factor of the distance, and b² − 4ac with it; the
/// distance of the ray from the axis does not depend on where on it one begins.
fn from_thousands_of_radii<S: Tested>() {
    for past in [0.999, 1.001] {
        for far in [1e2, 1e3, 4e3] {
            let level = ray::<S>([0.5, past, far], [0.0, 0.0, -1.0]);
            let count = spans(&rod::<S>(1.0, -2.0, 2.0), &level).len();
            assert_eq!(count, usize::from(past < 1.0), "{past} {far}");
        }
    }
}

/// The discriminant of a grazing ray is smaller than the rounding errors of its terms. Powers of
/// two make the distance exact: inside by one unit is a hit, outside a miss.
fn grazing_from_both_directions<S: Tested>() {
    for sign in [-1.0, 1.0] {
        let graze = |y: f64| {
            spans(&rod::<S>(1.0, -2.0, 2.0), &ray([0.0, y, 5.0 * sign], [0.0, 0.0, -sign]))
        };
        assert_eq!(graze(S::ONE.up().to_f64()).len(), 0);
        assert_eq!(graze(1.0).len(), 0);
        let within = S::ONE.down().to_f64();
        let [(enter, exit)] = graze(within)[..] else { panic!("a miss") };
        let chord = 2.0 * ((1.0 - within) * (1.0 + within)).sqrt();
        let allowed = limits::GRAZING_CHORD.of::<S>();
        assert!((exit - enter - chord).abs() <= allowed, "{enter} {exit}");
    }
}

/// Almost parallel, the roots are large numbers that differ by the length of the tube, and a
/// formula that subtracts them, or 1 − dx², has no digit left.
fn almost_parallel_to_the_axis<S: Tested>() {
    for angle in [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7] {
        let rod = rod::<S>(1.0, -2.0, 2.0);
        let inside = ray::<S>([-5.0, 0.0, 0.25], [1.0, angle, 0.0]);
        assert_eq!(spans(&rod, &inside), [(3.0, 7.0)], "{angle}");
        let outside = ray::<S>([-5.0, 1.5, 0.0], [1.0, angle, 0.0]);
        assert_eq!(spans(&rod, &outside), [], "{angle}");
    }
    met_after_a_long_way::<S>();
}

/// Beside the wall, which is met after a long way: c is a difference of squares that agree in four digits and
/// more, and the other root is up to 10⁷ times as large, so that b and √D agree as well.
fn met_after_a_long_way<S: Tested>() {
    // So long that the smallest slope is a number of every type.
    let (long, end) = (16384.0, 4000.0);
    for (angle, gap) in [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7]
        .into_iter()
        .flat_map(|angle| [1.0, 37.0].map(|units| (angle, units / 4096.0)))
    {
        let slope = S::near(long * angle).to_f64();
        // Points of the wall in whole numbers.
        for [y, z] in [[315.0, 80.0], [204.0, 253.0]] {
            let up_to = |high| rod::<S>(325.0, -end, high);
            let (near, far) = (gap / slope, (2.0 * y - gap) / slope);
            let leaving = ray::<S>([0.0, y - gap, z], [long, slope, 0.0]);
            let want = ((-far).max(-end / long), near.min(end / long));
            assert_spans(&up_to(end), &leaving, &[want]);

            let far = (2.0 * y + gap) / slope;
            let entering = ray::<S>([0.0, y + gap, z], [long, -slope, 0.0]);
            if near * long > end {
                assert_eq!(spans(&up_to(end), &entering), [], "{angle}");
                continue;
            }
            assert_spans(&up_to(end), &entering, &[(near, far.min(end / long))]);
            // With the cap a thousandth before the wall, and as much behind.
            let margin = (1e-3 * near * long).max(2.0 * S::UNIT);
            assert_eq!(spans(&up_to(near * long - margin), &entering), [], "{angle}");
            assert_eq!(spans(&up_to(near * long + margin), &entering).len(), 1, "{angle}");
        }
    }
}

/// A geometric tolerance would take these walls for nothing, or for thicker than they are.
fn walls_of_a_few_units_in_the_last_place<S: Tested>() {
    for units in 1..=4 {
        let inner = (0..units).fold(S::ONE, |r, _| r.down()).to_f64();
        let pipe = rod::<S>(1.0, -2.0, 2.0) - rod::<S>(inner, -2.0, 2.0);
        let walls = spans(&pipe, &ray([0.0, 2.0, 0.0], [0.0, -1.0, 0.0]));
        assert_eq!(walls.len(), 2, "{units}");
        // Parameters are near 1 and 3, where a float's unit is one or four times that of the
        // radius.
        let allowed = limits::THIN_WALL.of::<S>();
        for (enter, exit) in walls {
            assert!((exit - enter - (1.0 - inner)).abs() <= allowed, "{enter} {exit}");
        }
    }
}

/// Squares of such radii are far from those of the coordinates beside them: one is lost in the other.
fn small_and_large_radii<S: Tested>() {
    for radius in [1.0 / 64.0, 1024.0] {
        let rod = rod::<S>(radius, -2.0, 2.0);
        let across = ray::<S>([0.0, 3.0 * radius, 0.0], [0.0, -1.0, 0.0]);
        let [(enter, exit)] = spans(&rod, &across)[..] else { panic!("a miss of {radius}") };
        let error = (enter / radius - 2.0).abs().max((exit / radius - 4.0).abs());
        assert!(error <= limits::RADII.of::<S>(), "{radius}: {enter} {exit}");
        let beside = ray::<S>([0.0, 0.0, radius * 1.0001], [0.0, 1.0, 0.0]);
        assert_eq!(spans(&rod, &beside), []);
    }
    thin_from_afar::<S>(1.0 / 4096.0, &[8.0625, 73.5625, 127.875, 250.4375]);
    beside_a_wide_wall::<S>(1.0);
}

/// Past the axis at a distance of 40 units, from `away` times 5 units of length: with radii of 41 and of
/// 39, whose squares are less than what that of the distance is rounded by. Hit and miss come out alike.
pub fn thin_from_afar<S: Tested>(unit: f64, away: &[f64]) {
    let [hit, missed] = [41.0, 39.0].map(|units| rod::<S>(units * unit, -2.0, 2.0));
    for &away in away {
        for [dx, dy, dz] in [[0.25, -3.0, -4.0], [-0.5, 4.0, -3.0]] {
            for side in [8.0 * unit, -8.0 * unit] {
                let start = [-away * dx, side * dz - away * dy, -side * dy - away * dz];
                let ray = ray::<S>(start, [dx, dy, dz]);
                // 9² + 40² = 41².
                let half = 9.0 / 5.0 * unit;
                assert_spans(&hit, &ray, &[(away - half, away + half)]);
                assert_eq!(spans(&missed, &ray), [], "{away}");
            }
        }
    }
}

/// From just outside of a wide wall, and from just inside: the root near zero is the difference of two
/// numbers of the radius' size, which has few digits of it or none.
pub fn beside_a_wide_wall<S: Tested>(scale: f64) {
    let rod = rod::<S>(2500.0 * scale, -4000.0, 4000.0);
    let [dx, dy, dz] = [0.25, -1.5, 0.25];
    // Points of the wall in whole numbers.
    for [y, z] in [[700.0, 2400.0], [1500.0, 2000.0], [880.0, 2340.0]] {
        let [y, z] = [y * scale, z * scale];
        for near in [0.0625, -0.0625] {
            let ray = ray::<S>([-near * dx, y - near * dy, z - near * dz], [dx, dy, dz]);
            let far = near - 2.0 * (y * dy + z * dz) / (dy * dy + dz * dz);
            assert_spans(&rod, &ray, &[(near, far)]);
        }
    }
}

/// Each level takes away and adds faces in the same place; one of them left over, or one too many,
/// shows as a wall.
fn nested_differences_of_the_same_faces<S: Tested>() {
    let (a, b) = (rod::<S>(1.0, -2.0, 2.0), rod::<S>(1.0, -2.0, 0.0));
    for [origin, direction] in
        [[[0.0, 0.0, 5.0], [0.25, 0.0, -1.0]], [[-9.0, 0.5, 0.0], [1.0, 0.0, 0.0]]]
    {
        let ray = ray::<S>(origin, direction);
        assert_eq!(spans(&(a - (a - b)), &ray), spans(&b, &ray));
        assert_eq!(spans(&(a - (a - (a - b))), &ray), spans(&(a - b), &ray));
        assert_eq!(spans(&((a - b) | b), &ray), spans(&a, &ray));
        assert_eq!(spans(&((a - b) & b), &ray), []);
        assert_eq!(spans(&((a | b) - (b | a)), &ray), []);
    }
}

/// A test for t > 0 instead of t ≥ 0 sees the far side, or nothing.
fn from_a_point_on_a_surface<S: Tested>() {
    let ball = ball::<S>([0.0; 3], 1.0);
    let mut list = SpanList::<S, 1>::new();
    for (down, inside) in [(-1.0, false), (1.0, true)] {
        let hit = ball.hit(&ray([0.0, 1.0, 0.0], [0.0, down, 0.0]), &mut list).unwrap();
        assert_eq!((hit.t.to_f64(), hit.inside), (0.0, inside));
    }
}

/// The two roots of a tangent come from different quotients, and if they round to different numbers, or
/// a rounded discriminant is not zero but above, the touch becomes a span.
fn a_tangent_has_one_root<S: Tested>() {
    let [x, y, radius, low, high] = [-6.0, 2.0, 2.0, -4000.0, 4000.0].map(S::near);
    let rod = S::along(2, [x, y], radius, low, high).unwrap();
    assert_eq!(spans(&rod, &ray([-15.0, 0.0, -15.0], [11.0, 0.0, 11.0])), []);
    tangents_from_afar::<S>();
}

/// From so far that the squares and products of the coordinates are rounded.
fn tangents_from_afar<S: Tested>() {
    // The radius, the point that is touched, and how far away it is.
    for (radius, [y, z], away) in [
        (5.0, [3.0, 4.0], 51.5625),
        (5.0, [3.0, 4.0], 51.9375),
        (13.0, [5.0, 12.0], 19.6875),
        (13.0, [5.0, 12.0], 22.3125),
        (65.0, [33.0, 56.0], 3.9375),
        (65.0, [33.0, 56.0], 15.1875),
    ] {
        let start = [-0.25 * away, y + away * z, z - away * y];
        let tangent = ray::<S>(start, [0.25, -z, y]);
        assert_eq!(spans(&rod::<S>(radius, -2.0, 2.0), &tangent), [], "{away}");
    }
}

/// Along the bore's axis, where bore and shaft share both caps: nothing but the four coincident
/// planes is met. Who takes the two solids' crossings there one by one sees a skin.
fn one_can_look_through_a_flush_hole<S: Tested>() {
    let pipe = rod::<S>(2.0, -1.0, 1.0) - rod::<S>(1.0, -1.0, 1.0);
    assert_eq!(spans(&pipe, &ray([-5.0, 0.5, 0.25], [1.0, 0.0, 0.0])), []);
    assert_eq!(spans(&pipe, &ray([-5.0, 0.5, 0.25], [1.0, 0.0, 0.1])), []);
    assert_eq!(spans(&pipe, &ray([-5.0, 1.5, 0.0], [1.0, 0.0, 0.0])), [(4.0, 6.0)]);
}

/// Past the rim by one unit, on either side of it: where wall and cap are tested one by one, each with a
/// rounded point, both may let the ray pass, or both may count.
fn wall_and_cap_a_unit_apart<S: Tested>() {
    let rod = rod::<S>(1.0, -2.0, 2.0);
    for [toward_x, toward_y] in [[1.0, 1.0], [-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]] {
        // Down at 45° through the rim at (±2, ±1), where both t are 1, from points in units of the rim's.
        let way = [-toward_x, -toward_y, 0.0];
        let through = |x: f64| ray::<S>([toward_x * x, toward_y * 2.0, 0.0], way);
        assert_eq!(spans(&rod, &through(3.0)), [(1.0, 3.0)], "through the rim");
        // By the next number farther out or in, the cap or the wall is crossed later, by as much.
        let (out, within) = (S::near(3.0).up().to_f64(), S::near(3.0).down().to_f64());
        assert_eq!(spans(&rod, &through(out)), [(out - 2.0, 3.0)], "through the cap");
        assert_eq!(spans(&rod, &through(within)), [(1.0, 3.0)], "through the wall");
        // Across the corner outside: touches the rim, or is inside for a unit or less.
        let beside = |x: f64| ray::<S>([toward_x * x, 0.0, 0.0], [-toward_x, toward_y, 0.0]);
        assert_eq!(spans(&rod, &beside(3.0)), [], "touches the rim");
        assert_eq!(spans(&rod, &beside(out)), [], "passes it by");
        let [(enter, exit)] = spans(&rod, &beside(within))[..] else { panic!("a miss by a unit") };
        assert_eq!((enter, exit), (within - 2.0, 1.0));
    }
    past_the_rim_from_afar::<S>();
}

/// From a thousand units away, the point that belongs to a rounded parameter is farther off its face than
/// the rim is from the ray: the wall is met beyond its end, and the cap beside its edge.
fn past_the_rim_from_afar<S: Tested>() {
    let (rod, away) = (rod::<S>(5.0, -2.0, 2.0), 1000.0);
    for ([y, z], [dx, dy, dz]) in [
        ([3.0, 4.0], [-1.0, -1.5, -1.0]),
        ([3.0, 4.0], [-1.5, -2.75, -0.25]),
        ([-4.0, 3.0], [-1.0, 2.0, -0.75]),
        ([-4.0, 3.0], [-1.5, -0.5, -1.75]),
    ] {
        let rim = S::near(2.0 - away * dx);
        let far = away - 2.0 * (y * dy + z * dz) / (dy * dy + dz * dz);
        for x in [rim.down(), rim, rim.up(), rim.up().up().up()].map(S::to_f64) {
            let past = ray::<S>([x, y - away * dy, z - away * dz], [dx, dy, dz]);
            let [low, high] = [-2.0, 2.0].map(|cap| (cap - x) / dx);
            assert_spans(&rod, &past, &[(high.max(away), low.min(far))]);
        }
        // Across the corner outside, four units of the parameter within the rim and beside it.
        let by = if S::IS_FIXED { 4.0 * S::UNIT } else { 4.0 * S::UNIT * away };
        let [within, beside] = [-by, by].map(|by| S::near(rim.to_f64() + by).to_f64());
        let across = |x| ray::<S>([x, y + away * dy, z + away * dz], [dx, -dy, -dz]);
        assert_spans(&rod, &across(within), &[((2.0 - within) / dx, away)]);
        assert_eq!(spans(&rod, &across(beside)), [], "beside the rim");
    }
}
