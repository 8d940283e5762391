//! Poses: turns about any axis, inverses, and frames that stay orthonormal however often they are composed.
//! The model is a matrix in `f64`.

use proptest::prelude::*;
use scancsg::geom::{Pose, PoseError, Vec3};
use scancsg::scalar::I16F16;
use scancsg::solid::{Placed, RayCast, Sphere};
use scancsg::span::SpanList;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use testkit::limits;
use testkit::number::{Tested, ball, coordinates, ray, vector};
use testkit::turn;
use testkit::vector::{V, add, cross, dot, length, sub, times, unit};

for_every_number!(
    composed_poses_stay_orthonormal,
    turns_about_any_axis,
    turns_about_coordinate_axes_are_exact,
    inverses,
    joints_move,
    three_axes_are_a_pose,
);

/// Fixed point shows a frame's digits only if its axes are as long as the range allows.
fn long<S: Tested>() -> f64 {
    if S::IS_FIXED { S::MAX_COORDINATE.to_f64() } else { 1.0 }
}

/// The images of the three axes. In fixed point they are rounded to half a unit of [`long`].
fn frame<S: Tested>(pose: &Pose<S>) -> [V; 3] {
    let long = long::<S>();
    [0, 1, 2].map(|i| {
        let axis = std::array::from_fn(|j| if i == j { long } else { 0.0 });
        times(coordinates(pose.direction(vector(axis))), 1.0 / long)
    })
}

/// By how much a frame's axes miss the length 1 and right angles.
fn defect(frame: &[V; 3]) -> f64 {
    let [x, y, z] = frame;
    let lengths = [x, y, z].map(|axis| length(*axis) - 1.0);
    let angles = [dot(*x, *y), dot(*y, *z), dot(*z, *x)];
    lengths.iter().chain(&angles).fold(0.0, |most: f64, off| most.max(off.abs()))
}

/// A unit of a frame's numbers, as [`frame`] shows them.
fn unit_of_frame<S: Tested>() -> f64 {
    S::UNIT / long::<S>()
}

fn composed_poses_stay_orthonormal<S: Tested>() {
    let step = Pose::rotation_z(S::near(0.01)).unwrap();
    let step = step.then(&Pose::rotation_x(S::near(0.013)).unwrap()).unwrap();
    let mut pose = Pose::<S>::IDENTITY;
    for turn in 1..=1_000_000u32 {
        pose = pose.then(&step).unwrap();
        if turn.is_power_of_two() || [100_000, 1_000_000].contains(&turn) {
            let off = defect(&frame(&pose)) / unit_of_frame::<S>();
            assert!(off <= 3.0, "{off} units after {turn} turns");
        }
    }
}

/// What Rodrigues' formula says, in `f64`.
fn turned(axis: V, angle: f64, p: V) -> V {
    let k = unit(axis);
    let (sin, cos) = angle.sin_cos();
    let across = add(times(p, cos), times(cross(k, p), sin));
    add(across, times(k, dot(k, p) * (1.0 - cos)))
}

fn turns_about_any_axis<S: Tested>() {
    let vectors = || [-3.0..3.0, -3.0..3.0, -3.0..3.0];
    proptest!(|(axis in vectors(), angle in -7.0..7.0, point in vectors(), own in vectors())| {
        prop_assume!(length(axis) > 0.1);
        let [axis, point, own] = [axis, point, own].map(vector::<S>);
        let angle = S::near(angle);
        let pose = Pose::about(axis, angle).unwrap();
        prop_assert!(defect(&frame(&pose)) <= 3.0 * unit_of_frame::<S>());
        let off = |center: V, pose: &Pose<S>| {
            let at = [center, coordinates(axis)];
            turn::miss(at, angle.to_f64(), coordinates(own), coordinates(pose.point(own)))
        };
        let at_origin = off([0.0; 3], &pose);
        prop_assert!(at_origin <= limits::TURN.of::<S>(), "{at_origin}");
        // Around a point, that point stays.
        let joint = pose.around(point).unwrap();
        let at_point = off(coordinates(point), &joint);
        prop_assert!(at_point <= limits::JOINT.of::<S>(), "{at_point}");
    });
}

/// They have the bits of the axis's own turn, and whatever has zeros and ones only keeps them.
fn turns_about_coordinate_axes_are_exact<S: Tested>() {
    let turns = [Pose::rotation_x, Pose::rotation_y, Pose::rotation_z];
    for (i, turn) in turns.into_iter().enumerate() {
        for (angle, sign) in [(0.3, 1.0), (-2.0, 0.5), (FRAC_PI_2, -1.0), (4.0, -3.0)] {
            let axis = std::array::from_fn(|j| if i == j { sign } else { 0.0 });
            let signed = S::near(angle * f64::signum(sign));
            assert_eq!(Pose::about(vector(axis), S::near(angle)), turn(signed));
        }
        let none = turn(S::ZERO).unwrap();
        assert_eq!(none, Pose::IDENTITY);
        let some = turn(S::near(0.7)).unwrap();
        assert_eq!(some.then(&none), Ok(some));
        // A quarter turn's angle is rounded, and so are its axes.
        let quarter = turn(S::near(FRAC_PI_2)).unwrap();
        let half = quarter.then(&quarter).unwrap();
        let whole = half.then(&half).unwrap();
        for (pose, angle) in [(quarter, FRAC_PI_2), (half, PI), (whole, TAU)] {
            let axis = std::array::from_fn(|j| if i == j { 1.0 } else { 0.0 });
            for own in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
                let off = sub(coordinates(pose.point(vector(own))), turned(axis, angle, own));
                assert!(length(off) <= 2.0 * S::UNIT, "{off:?}");
            }
        }
    }
    let shift = |by: V| S::translation(vector(by)).unwrap();
    let both = shift([1.0, 2.5, -3.0]).then(&shift([0.5, 0.25, 7.0])).unwrap();
    assert_eq!(both, shift([1.5, 2.75, 4.0]));
}

fn inverses<S: Tested>() {
    let vectors = || [-3.0..3.0, -3.0..3.0, -3.0..3.0];
    proptest!(|(axis in vectors(), angle in -7.0..7.0, by in vectors(), own in vectors())| {
        prop_assume!(length(axis) > 0.1);
        let turn = Pose::about(vector(axis), S::near(angle)).unwrap();
        let pose = turn.then(&S::translation(vector(by)).unwrap()).unwrap();
        let back = pose.inverse().unwrap();
        let own = vector::<S>(own);
        for there in [back.point(pose.point(own)), pose.point(back.point(own)), pose.point_back(pose.point(own))] {
            prop_assert!(length(sub(coordinates(there), coordinates(own))) <= 16.0 * S::UNIT);
        }
        let nothing = pose.then(&back).unwrap();
        prop_assert!(length(coordinates(nothing.point(Vec3::ZERO))) <= 16.0 * S::UNIT);
        prop_assert!(defect(&frame(&back)) <= 3.0 * unit_of_frame::<S>());
    });
}

/// A placed solid goes where its pose says, whether it is owned or borrowed.
fn joints_move<S: Tested>() {
    let part: Sphere<S> = ball([0.0; 3], 0.5);
    let mut owned = Placed::new(part, Pose::IDENTITY);
    let mut borrowed = Placed::new(&part, Pose::IDENTITY);
    for x in [1.0, -2.0, 3.5] {
        let pose = S::translation(vector([x, 0.0, 0.0])).unwrap();
        owned.set_pose(pose);
        borrowed.set_pose(pose);
        let down = ray::<S>([x, 0.0, 4.0], [0.0, 0.0, -1.0]);
        let mut list = SpanList::<S, 1>::new();
        for hit in [owned.hit(&down, &mut list), borrowed.hit(&down, &mut list)] {
            assert_eq!(hit.map(|hit| hit.t.to_f64()), Some(3.5));
        }
    }
}

/// In fixed point an axis is known to 2⁻²⁸, whatever the format: the sum of two squares is 1.
#[test]
fn quarters_in_fixed_point() {
    let quarter = Pose::rotation_z(I16F16::from_num(FRAC_PI_2)).unwrap();
    let [x, y, z] = frame(&quarter);
    assert_eq!((x[1], y[0], z), (1.0, -1.0, [0.0, 0.0, 1.0]));
}

/// A frame of any lengths that is nearly at right angles becomes the orthonormal one next to it.
fn three_axes_are_a_pose<S: Tested>() {
    let vectors = || [-3.0..3.0, -3.0..3.0, -3.0..3.0];
    let lengths = || [0.25..9.0, 0.25..9.0, 0.25..9.0];
    proptest!(|(axis in vectors(), angle in -7.0..7.0, lengths in lengths(), at in vectors(), off in 0.0..9e-4)| {
        prop_assume!(length(axis) > 0.1);
        let exact = [0, 1, 2].map(|i| {
            turned(axis, angle, std::array::from_fn(|j| if i == j { 1.0 } else { 0.0 }))
        });
        let [x, y, z] = exact;
        let skew = [x, add(y, times(x, off)), z];
        let skew = [0, 1, 2].map(|i| vector::<S>(times(skew[i], 100.0 * lengths[i])));
        let pose = Pose::with_axes(skew, vector::<S>(at)).unwrap();
        let frame = frame(&pose);
        prop_assert!(defect(&frame) <= 3.0 * unit_of_frame::<S>());
        // What the axes are off by is shared by two of them.
        let most = 0.6 * off + 8.0 * S::UNIT / 25.0 + 8.0 * unit_of_frame::<S>();
        for (axis, exact) in frame.iter().zip(exact) {
            prop_assert!(length(sub(*axis, exact)) <= most, "{axis:?}, {exact:?}");
        }
        prop_assert_eq!(pose.point(Vec3::ZERO), vector::<S>(at));
    });
    let [x, y, z] = [[2.0, 0.0, 0.0], [0.0, 0.0, -0.5], [0.0, 3.0, 0.0]].map(vector::<S>);
    let pose = |axes| Pose::with_axes(axes, Vec3::ZERO).err();
    assert_eq!(
        Pose::with_axes([x, y, z], x).unwrap().point(vector([1.0, 2.0, 3.0])),
        vector([3.0, 3.0, -2.0])
    );
    assert_eq!(pose([x, z, y]), Some(PoseError::NotRigid), "a mirror");
    assert_eq!(pose([x, y, vector([0.0, 3.0, 0.004])]), Some(PoseError::NotRigid));
    assert_eq!(pose([x, y, vector([0.0, 3.0, 0.002])]), None);
    assert_eq!(pose([x, y, y]), Some(PoseError::NotRigid));
    assert_eq!(pose([x, Vec3::ZERO, z]), Some(PoseError::ZeroAxis));
    let far = Vec3::new(S::MAX_COORDINATE.up(), S::ZERO, S::ZERO);
    assert_eq!(Pose::with_axes([x, y, z], far).err(), Some(PoseError::TooFar));
    if !S::IS_FIXED {
        let nan = Vec3::new(S::near(f64::NAN), S::ZERO, S::ZERO);
        assert_eq!(pose([x, nan, z]), Some(PoseError::NotFinite));
        assert_eq!(Pose::with_axes([x, y, z], nan).err(), Some(PoseError::NotFinite));
    }
}
