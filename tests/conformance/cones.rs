//! Cones: bad input, faces and normals by hand, flush caps, and pictures from everywhere.

use crate::caster::{self, Solid as Model};
use crate::limits;
use crate::number::{Tested, coordinates, ray, spans, vector};
use crate::pictures::{
    SIZE, UP, compare, cone, config, direction, orthographic, perspective, point,
};
use proptest::prelude::*;
use scancsg::geom::Vec3;
use scancsg::solid::{Cone, ConeError, Difference, RayCast, Union};
use scancsg::span::{Face, SpanList};
use testkit::expect::assert_spans;

for_every_number!(
    bad_input,
    lines_by_hand,
    steep_lines,
    lines_along_the_side,
    faces_and_their_normals,
    the_tip,
    equal_radii_are_a_cylinder,
    flush_caps_leave_no_film,
    flush_oblique_caps_leave_no_film,
    seen_along_any_direction,
    seen_along_its_axis,
    seen_along_its_side,
    seen_along_the_side_on_a_grid,
    seen_from_anywhere,
    seen_from_within,
);

/// With the tip up, at (1, 2, 7): 3 wide at z = 1, and as long as twice that.
fn pointed<S: Tested>() -> Cone<S> {
    let [x, y, radius, low, high] = [1.0, 2.0, 3.0, 1.0, 7.0].map(S::near);
    S::cone_along(2, [x, y], [radius, S::ZERO], low, high).unwrap()
}

fn bad_input<S: Tested>() {
    use ConeError::{Empty, NotFinite, Radius, TooFar};
    let along = |axis, numbers: [S; 6]| {
        let [a, b, r0, r1, low, high] = numbers;
        S::cone_along(axis, [a, b], [r0, r1], low, high).err()
    };
    let good = [0.5, -0.5, 1.0, 2.0, -1.0, 2.0].map(S::near);
    for axis in 0..3 {
        assert_eq!(along(axis, good), None);
        for (place, &bad) in
            (0..6).flat_map(|place| S::NO_NUMBERS.iter().map(move |bad| (place, bad)))
        {
            let mut input = good;
            input[place] = bad;
            assert_eq!(along(axis, input), Some(NotFinite), "{input:?}");
        }
        let with = |places: &[(usize, S)]| {
            let mut input = good;
            places.iter().for_each(|&(place, x)| input[place] = x);
            along(axis, input)
        };
        let zeros = [S::ZERO, S::ZERO.negated()];
        for zero in zeros {
            assert_eq!(with(&[(2, zero)]), None);
            assert_eq!(with(&[(3, zero)]), None);
            assert_eq!(with(&[(2, zero), (3, S::ZERO)]), Some(Radius));
        }
        let wide = S::MAX_COORDINATE.up();
        for bad in [S::ONE.negated(), S::MIN_RADIUS.negated(), wide] {
            assert_eq!(with(&[(2, bad)]), Some(Radius), "{bad:?}");
            assert_eq!(with(&[(3, bad)]), Some(Radius), "{bad:?}");
        }
        assert_eq!(with(&[(0, wide)]), Some(TooFar));
        assert_eq!(with(&[(5, wide)]), Some(TooFar));
        assert_eq!(with(&[(5, S::ONE.negated())]), Some(Empty));
        assert_eq!(with(&[(5, S::near(-2.0))]), Some(Empty));
    }
    let from: Vec3<S> = vector([0.5, 1.0, 2.0]);
    let radii = [S::ONE, S::ZERO];
    assert_eq!(S::cone_between(from, from, radii).err(), Some(Empty));
    let [far, near] = [vector([0.0, 2.0 * S::MAX_COORDINATE.to_f64(), 0.0]), Vec3::ZERO];
    assert_eq!(S::cone_between(near, far, radii).err(), Some(TooFar));
    assert_eq!(S::cone_between(near, from, [S::ZERO; 2]).err(), Some(Radius));
}

fn lines_by_hand<S: Tested>() {
    let cone = pointed::<S>();
    // Across it: at half of its height half as wide, in and out at the same distance from the axis.
    assert_spans(&cone, &ray([-9.0, 2.0, 4.0], [1.0, 0.0, 0.0]), &[(8.5, 11.5)]);
    assert_spans(&cone, &ray([1.0, 9.0, 1.0], [0.0, -1.0, 0.0]), &[(4.0, 10.0)]);
    // In through the cap, and out through the wall.
    assert_spans(&cone, &ray([1.0, 2.0, -1.0], [0.0, 0.25, 1.0]), &[(2.0, 16.0 / 3.0)]);
    // Where the other nappe would be, beside the cap, and along the plane of the upper one.
    for from in [[-9.0, 2.0, 8.0], [-9.0, 2.0, 0.5], [-9.0, 2.0, 7.0]] {
        assert_spans(&cone, &ray(from, [1.0, 0.0, 0.0]), &[]);
    }
}

/// Steeper than the side, they meet both nappes.
fn steep_lines<S: Tested>() {
    let cone = pointed::<S>();
    for z in [-20.0, 0.0, 4.0, 7.0, 40.0] {
        assert_spans(&cone, &ray([1.0, 2.0, z], [0.0, 0.0, 1.0]), &[(1.0 - z, 7.0 - z)]);
        assert_spans(&cone, &ray([2.0, 2.0, z], [0.0, 0.0, 1.0]), &[(1.0 - z, 5.0 - z)]);
        assert_spans(
            &cone,
            &ray([2.0, 2.0, z], [0.0, 0.0, -2.0]),
            &[((z - 5.0) / 2.0, (z - 1.0) / 2.0)],
        );
        assert_spans(&cone, &ray([4.0, 2.0, z], [0.0, 0.0, 1.0]), &[]);
    }
    // Through both nappes, and through the tip alone.
    assert_spans(&cone, &ray([1.25, 2.0, 10.0], [0.0, 0.0, -1.0]), &[(3.5, 9.0)]);
    assert_spans(&cone, &ray([1.0, 2.0, 7.0], [0.25, 0.0, -1.0]), &[(0.0, 6.0)]);
}

/// A line along the side has no second point, and a = 0.
fn lines_along_the_side<S: Tested>() {
    let cone = pointed::<S>();
    // Inside by 1, outside by 1, and on it.
    assert_spans(&cone, &ray([3.0, 2.0, 1.0], [-1.0, 0.0, 2.0]), &[(0.0, 2.5)]);
    assert_spans(&cone, &ray([5.0, 2.0, 1.0], [-1.0, 0.0, 2.0]), &[]);
    assert_spans(&cone, &ray([4.0, 2.0, 1.0], [-1.0, 0.0, 2.0]), &[]);
    // Nearly: the other point is far away.
    let tilted = spans(&cone, &ray::<S>([3.0, 2.0, 1.0], [-1.0, 0.0, 2.0 + 64.0 * S::UNIT]));
    let [(enter, exit)] = tilted[..] else { panic!("{tilted:?}") };
    assert!(enter.abs() < 1e-6 && (exit - 2.5).abs() < 1e-3 + 64.0 * S::UNIT, "{tilted:?}");
}

fn faces_and_their_normals<S: Tested>() {
    let cone = pointed::<S>();
    let hit = |origin, direction| {
        let hit = cone.hit(&ray(origin, direction), &mut SpanList::<S, 1>::new()).unwrap();
        (hit.t.to_f64(), hit.face, coordinates(hit.normal), coordinates(hit.point))
    };
    let (t, face, normal, point) = hit([2.0, 2.0, -1.0], [0.0, 0.0, 1.0]);
    assert_eq!((t, face, normal, point), (2.0, Face(0), [0.0, 0.0, -1.0], [2.0, 2.0, 1.0]));
    let (t, face, normal, point) = hit([9.0, 2.0, 4.0], [-1.0, 0.0, 0.0]);
    assert_eq!((t, face), (6.5, Face(2)));
    let allowed = 4.0 * limits::NORMAL.of::<S>();
    let is_near = |got: [f64; 3], want: [f64; 3]| caster::length(caster::sub(got, want)) < allowed;
    let five = 5f64.sqrt();
    assert!(is_near(normal, [2.0 / five, 0.0, 1.0 / five]), "{normal:?}");
    assert!(is_near(point, [2.5, 2.0, 4.0]), "{point:?}");
    let blunt = S::cone_along(0, [S::ZERO; 2], [S::ONE, S::near(2.0)], S::ZERO, S::ONE).unwrap();
    let high = blunt.hit(&ray([5.0, 0.5, 0.5], [-1.0, 0.0, 0.0]), &mut SpanList::<S, 1>::new());
    let high = high.unwrap();
    assert_eq!((high.face, coordinates(high.normal)), (Face(1), [1.0, 0.0, 0.0]));
    // From within, the side is seen from behind.
    let side = blunt.hit(&ray([0.5, 0.0, 0.0], [0.0, 0.0, -1.0]), &mut SpanList::<S, 1>::new());
    let side = side.unwrap();
    let half = 0.5f64.sqrt();
    assert!(side.inside && is_near(coordinates(side.normal), [half, 0.0, half]), "{side:?}");
}

/// A normal there is of length 1 as well.
fn the_tip<S: Tested>() {
    let hit =
        pointed::<S>().hit(&ray([1.0, 2.0, 9.0], [0.0, 0.0, -1.0]), &mut SpanList::<S, 1>::new());
    let hit = hit.unwrap();
    assert_eq!((hit.t.to_f64(), coordinates(hit.point)), (2.0, [1.0, 2.0, 7.0]));
    assert_eq!(coordinates(hit.normal), [0.0, 0.0, 1.0]);
}

fn equal_radii_are_a_cylinder<S: Tested>() {
    let rod = S::along(1, [S::ONE; 2], S::near(0.75), S::near(-2.0), S::near(3.0)).unwrap();
    let cone =
        S::cone_along(1, [S::ONE; 2], [S::near(0.75); 2], S::near(-2.0), S::near(3.0)).unwrap();
    proptest!(|(from in prop::array::uniform3(-8.0..8.0), to in prop::array::uniform3(-2.0..2.0))| {
        let way = caster::unit(caster::sub(to, from));
        let ray = ray::<S>(from, way);
        let [of_rod, of_cone] = [spans(&rod, &ray), spans(&cone, &ray)];
        // By a hair, either may miss.
        let is_short = |spans: &[(f64, f64)]| spans.iter().all(|(enter, exit)| exit - enter < 0.01);
        prop_assert!(of_rod.len() == of_cone.len() || is_short(&of_rod) && is_short(&of_cone));
        for (a, b) in of_rod.iter().zip(&of_cone) {
            if a.1 - a.0 > 0.01 {
                let allowed = 32.0 * limits::SAME_SOLID.of::<S>();
                prop_assert!((a.0 - b.0).abs().max((a.1 - b.1).abs()) <= allowed * 16.0, "{a:?} {b:?}");
            }
        }
    });
}

/// A rod and a cone that end in one plane: where either is, nothing is left between them.
fn flush_caps_leave_no_film<S: Tested>() {
    let [low, middle, high] = [-1.0, 0.3, 2.0].map(S::near);
    let rod = S::along(0, [S::ZERO; 2], S::near(0.5), low, middle).unwrap();
    let cone = S::cone_along(0, [S::ZERO; 2], [S::ONE, S::ZERO], middle, high).unwrap();
    check_flush(&(rod | cone), &[&rod], &cone, [[-1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]);
}

fn check_flush<S: Tested, T: RayCast<Scalar = S>>(
    both: &T,
    rods: &[&scancsg::solid::Cylinder<S>],
    cone: &Cone<S>,
    [from, to]: [[f64; 3]; 2],
) {
    proptest!(|(a in prop::array::uniform3(-0.2..0.2), b in prop::array::uniform3(-0.2..0.2))| {
        let start = caster::add(caster::add(from, caster::times(caster::sub(from, to), 0.5)), a);
        let way = caster::unit(caster::sub(caster::add(to, b), start));
        let ray = ray::<S>(start, way);
        let of_both = spans(both, &ray);
        let of_rod = spans(rods[0], &ray);
        let of_cone = spans(cone, &ray);
        // Along the axis, the line leaves one where it enters the other.
        if let ([rod], [cone]) = (&of_rod[..], &of_cone[..])
            && (rod.1 - cone.0).abs() < 1e-3
        {
            prop_assert_eq!(rod.1, cone.0);
            prop_assert_eq!(&of_both, &[(rod.0, cone.1)]);
        }
    });
}

/// The same along any axis, with both between the same two points: what is cut out of a cone by a wider
/// rod leaves nothing.
fn flush_oblique_caps_leave_no_film<S: Tested>() {
    let ends = || prop::array::uniform3(-2.0..2.0);
    proptest!(|(from in ends(), to in ends(), aim in prop::array::uniform3(-0.5..0.5), eye in prop::array::uniform3(-9.0..9.0))| {
        prop_assume!(caster::length(caster::sub(to, from)) > 0.3);
        let cone = S::cone_between(vector(from), vector(to), [S::near(0.5), S::near(0.25)]).unwrap();
        let rod = S::between(vector(from), vector(to), S::near(0.75)).unwrap();
        let way = caster::sub(caster::add(caster::times(caster::add(from, to), 0.5), aim), eye);
        prop_assume!(caster::length(way) > 1.0);
        let ray = ray::<S>(eye, caster::unit(way));
        prop_assert_eq!(spans(&Difference::new(cone, rod), &ray), vec![]);
        prop_assert_eq!(spans(&Union::new(cone, rod), &ray), spans(&rod, &ray));
    });
}

type Subject<S> = (Cone<S>, Model);

fn along<S: Tested>(subject: &Subject<S>, way: caster::V) -> Result<(), TestCaseError> {
    let up = if way[1].abs() > 0.9 * caster::length(way) { [1.0, 0.0, 0.0] } else { UP };
    let (camera, view) = orthographic::<S>(way, [0.25, -0.125, 0.5], up, 6.0);
    compare((&subject.0, &subject.1), (&camera, &view), SIZE).map(|_| ())
}

fn from<S: Tested>(
    subject: &Subject<S>,
    ends: [caster::V; 2],
    field: f64,
) -> Result<(), TestCaseError> {
    let way = caster::sub(ends[1], ends[0]);
    prop_assume!(way[0].abs() + way[2].abs() > 0.1);
    let (camera, view) = perspective::<S>(ends, UP, field);
    compare((&subject.0, &subject.1), (&camera, &view), SIZE).map(|_| ())
}

fn cases<S: Tested>() -> ProptestConfig {
    ProptestConfig::with_cases(4 * config::<S>().cases)
}

fn seen_along_any_direction<S: Tested>() {
    proptest!(cases::<S>(), |(subject in cone::<S>(), way in direction::<S>())| {
        along(&subject, way)?;
    });
}

/// Or nearly so, and at right angles to it.
fn seen_along_its_axis<S: Tested>() {
    let off = (prop::array::uniform3(-1.0..1.0), 1..7i32, prop::bool::ANY);
    proptest!(cases::<S>(), |(subject in cone::<S>(), (off, power, across) in off, back: bool)| {
        let Model::Cone { from, to, .. } = subject.1 else { unreachable!() };
        let axis = caster::unit(caster::sub(to, from));
        let axis = caster::times(axis, if back { -1.0 } else { 1.0 });
        let off: caster::V = off.map(|k: f64| k * 10f64.powi(-power));
        let side = caster::cross(axis, [0.3, 0.5, -0.8]);
        let way = if across { side } else { axis };
        prop_assume!(caster::length(way) > 0.1);
        along(&subject, caster::add(way, off))?;
    });
}

/// Or nearly so: the paths for flatter and for steeper rays end there.
fn seen_along_its_side<S: Tested>() {
    let off = (prop::array::uniform3(-1.0..1.0), 1..7i32);
    proptest!(cases::<S>(), |(subject in cone::<S>(), (off, power) in off, turn in 0.0..6.3, back: bool)| {
        let Model::Cone { from, to, radii: [low, high] } = subject.1 else { unreachable!() };
        let axis = caster::sub(to, from);
        let first = caster::cross(axis, [0.3, 0.5, -0.8]);
        prop_assume!(caster::length(first) > 0.1);
        let first = caster::unit(first);
        let second = caster::cross(caster::unit(axis), first);
        let (sin, cos) = f64::sin_cos(turn);
        let outwards = caster::add(caster::times(first, cos), caster::times(second, sin));
        let side = caster::unit(caster::add(axis, caster::times(outwards, high - low)));
        let off: caster::V = off.map(|k: f64| k * 10f64.powi(-power));
        along(&subject, caster::add(caster::times(side, if back { -1.0 } else { 1.0 }), off))?;
    });
}

/// With sides of 45 degrees, and a column of pixels in the plane that touches the side: there, only
/// rounding tells flatter rays from steeper ones.
fn seen_along_the_side_on_a_grid<S: Tested>() {
    let cones = (0..3usize)
        .flat_map(|axis| [[-0.5, 1.0], [0.0, 0.0], [1.0, -0.5]].map(|at| (axis, at)).into_iter());
    let turns =
        [1, 2].map(|turn| [-1.0, 1.0].map(|along| [-1.0, 1.0].map(|aside| (turn, along, aside))));
    for ((axis, [u, v]), radii) in
        cones.flat_map(|cone| [[0.0, 1.0], [1.0, 0.0]].map(|r| (cone, r)))
    {
        let [x, y, low, high] = [u, v, -0.5, 0.5].map(S::near);
        let cone = S::cone_along(axis, [x, y], radii.map(S::near), low, high).unwrap();
        let [from, to] = [-0.5, 0.5].map(|along| {
            let mut end = [u, v, along];
            end[axis..].rotate_right(1);
            end
        });
        let model = Model::Cone { from, to, radii };
        let tip = if radii[0] == 0.0 { from } else { to };
        for (turn, along, aside) in turns.concat().concat() {
            let mut way = [0.0; 3];
            (way[axis], way[(axis + turn) % 3]) = (along, aside);
            let up = if way[1] == 0.0 { UP } else { [1.0, 0.25, 0.5] };
            for target in [tip, [0.0; 3]] {
                let (camera, view) = orthographic::<S>(way, target, up, 5.0);
                compare((&cone, &model), (&camera, &view), [9, 9]).unwrap();
            }
        }
    }
}

fn seen_from_anywhere<S: Tested>() {
    proptest!(cases::<S>(), |(
        subject in cone::<S>(), way in direction::<S>(), distance in 1.0..12.0, field in 0.2..1.5,
    )| {
        let to = [0.25, -0.125, 0.5];
        let eye = caster::sub(to, caster::times(way, distance / caster::length(way)));
        from(&subject, [eye, to], field)?;
    });
}

/// Or from beside it: but not from so near that the digits of an eye's rays are all that is seen.
fn seen_from_within<S: Tested>() {
    let from_axis = prop_oneof![2 => 0.0..0.8, 1 => 1.25..2.0];
    let eye = (0.0..1.0, from_axis, 0.0..6.3);
    proptest!(cases::<S>(), |(subject in cone::<S>(), (part, share, turn) in eye, to in point::<S>())| {
        let Model::Cone { from: low, to: high, radii: [r0, r1] } = subject.1 else { unreachable!() };
        let axis: caster::V = caster::sub(high, low);
        let first = caster::cross(axis, [0.3, 0.5, -0.8]);
        prop_assume!(caster::length(first) > 0.1);
        let first = caster::unit(first);
        let second = caster::cross(caster::unit(axis), first);
        let wide: f64 = r0 + (r1 - r0) * part;
        let share: f64 = share;
        prop_assume!((share - 1.0).abs() * wide > 0.05);
        let radius = share * wide;
        let (sin, cos) = f64::sin_cos(turn);
        let across = caster::add(caster::times(first, radius * cos), caster::times(second, radius * sin));
        let eye = caster::add(caster::add(low, caster::times(axis, part)), across);
        from(&subject, [eye, to], 1.2)?;
    });
}
