//! Data that went through `postcard` is what it was.
#![cfg(feature = "serde")]
#![allow(clippy::unwrap_used)]

use core::fmt::Debug;
use scancsg::geom::{Axis, Extent, Line, Pose, Vec3, vec3};
use scancsg::render::{Bayer, Gray8, Mono, Rgb, Rgb565, Rgb888, RowError, Run, Size};
use scancsg::scalar::{I16F16, Scalar};
use scancsg::solid::{Bounds, CylinderError, Hit, RayCast, Seen, Sphere, WallHit};
use scancsg::span::{Crossing, Face, Span, SpanList, StackFull};
use scancsg::spline::Outside;
use scancsg::{Error, geom::Ray};
use serde::{Serialize, de::DeserializeOwned};

/// Checks that a value comes back, and returns how many bytes it was.
fn round_trip<T: Serialize + DeserializeOwned + PartialEq + Debug>(value: T) -> usize {
    let mut memory = [0; 128];
    let bytes = postcard::to_slice(&value, &mut memory).unwrap();
    let length = bytes.len();
    let (back, rest) = postcard::take_from_bytes::<T>(bytes).unwrap();
    assert_eq!((back, rest.len()), (value, 0));
    assert!(postcard::from_bytes::<T>(&bytes[..length.saturating_sub(1)]).is_err() || length == 0);
    length
}

fn of_scalars<S: Scalar + Serialize + DeserializeOwned>() {
    let n = |tenths| S::from_ratio(tenths, 10);
    let (point, other) = (vec3(n(1), n(-200), n(12_345)), vec3(n(7), n(0), n(-3)));
    round_trip(point);
    round_trip(Line { origin: point, direction: other });
    let [enter, exit] = [(n(5), 0), (n(9), 300)].map(|(t, face)| Crossing { t, face: Face(face) });
    round_trip(Span { enter, exit });
    round_trip(Seen { t: n(-4), face: Face(2), inside: true });
    round_trip(Bounds::Ball { center: point, radius: n(3) });
    round_trip::<Bounds<S>>(Bounds::Unbounded);
    let ball = Sphere::<S>::around(vec3(n(0), n(0), n(0)), n(10)).unwrap();
    let ray = Ray::new(vec3(n(0), n(0), n(50)), vec3(n(0), n(0), n(-10))).unwrap();
    let hit: Hit<S> = ball.hit(&ray, &mut SpanList::<_, 1>::new()).unwrap();
    round_trip(hit);
    let _ = round_trip::<WallHit<S>>;
}

/// The numbers of a pose: its axes, then its shift.
type Parts<S> = ([Vec3<<S as Scalar>::Unit>; 3], Vec3<S>);

fn poses<S: Scalar + Serialize + DeserializeOwned>()
where
    S::Unit: Serialize + DeserializeOwned,
{
    let n = |tenths| S::from_ratio(tenths, 10);
    let step = Pose::about(vec3(n(1), n(-20), n(12)), n(7)).unwrap();
    let step = step.around(vec3(n(31), n(2), n(-7))).unwrap();
    let mut pose = Pose::<S>::IDENTITY;
    for _ in 0..1000 {
        round_trip(pose);
        pose = pose.then(&step).unwrap();
    }
    let mut memory = [0; 128];
    let bytes = postcard::to_slice(&pose, &mut memory).unwrap();
    let (axes, translation): Parts<S> = postcard::from_bytes(bytes).unwrap();
    let is_pose = |parts: Parts<S>| {
        let mut memory = [0; 128];
        let bytes = postcard::to_slice(&parts, &mut memory).unwrap();
        postcard::from_bytes::<Pose<S>>(bytes).is_ok()
    };
    let [x, y, z] = axes;
    assert!(is_pose((axes, translation)));
    assert!(is_pose(([y, z, x], translation)), "another right-handed frame");
    assert!(!is_pose(([y, x, z], translation)), "a mirror");
    assert!(!is_pose(([x, y, y], translation)), "a projection");
    assert!(!is_pose(([Vec3::ZERO; 3], translation)), "nothing");
    assert!(!is_pose(([x + x, y, z], translation)), "stretched");
    assert!(!is_pose((axes, vec3(S::HIGHEST, n(0), n(0)))), "too far");
}

#[test]
fn poses_stay_rigid() {
    poses::<f32>();
    poses::<f64>();
    poses::<I16F16>();
}

#[test]
fn numbers_of_all_types() {
    of_scalars::<f32>();
    of_scalars::<f64>();
    of_scalars::<I16F16>();
}

#[test]
fn pixels_sizes_and_errors() {
    assert_eq!(round_trip(Gray8(200)), 1);
    assert_eq!(round_trip(Mono(true)), 1);
    assert_eq!(round_trip(Rgb888([1, 2, 255])), 3);
    assert_eq!(round_trip(Rgb::new(1, 2, 255)), 3);
    round_trip(Rgb565(0xF00F));
    round_trip(Bayer::Eight);
    round_trip(Axis::Z);
    round_trip(Outside::Wrap);
    round_trip(Extent { start: 3, end: 70_000 });
    round_trip(Run { columns: 3..700, is_background: true });
    round_trip(Size::new(320, 240).unwrap());
    round_trip(CylinderError::Empty);
    round_trip(StackFull);
    round_trip(Error::Row(RowError::Range));
}

#[test]
fn what_can_not_be_is_refused() {
    assert!(postcard::from_bytes::<Size>(&[0, 5]).is_err());
    assert!(postcard::from_bytes::<Size>(&[4, 5]).is_ok());
    assert!(postcard::from_bytes::<CylinderError>(&[200]).is_err());
}
