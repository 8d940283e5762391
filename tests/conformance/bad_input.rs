//! Every way to give the crate something it can't use, and the error that says so. What is the same
//! for all number types is in `tests/library/errors.rs`.

use crate::number::{Tested, ball, ray, spans, vector};
use scancsg::geom::{Pose, PoseError, Ray, RayError, Vec3};
use scancsg::render::{CameraError, Depth, Lambert, Orthographic, Perspective, ShadeError, XRay};
use scancsg::solid::{CylinderError, SlabError, SphereError, TorusError};
use std::fmt::Debug;

for_every_number!(
    cylinders,
    beyond_the_range_of_the_number_type,
    spheres,
    slabs,
    tori,
    rays,
    poses,
    orthographic_cameras,
    perspective_cameras,
    shaders,
);

/// Puts every number that is none at every place of `good`, and wants `error` each time; and
/// wants `good` itself to be taken.
fn at_every_place<S: Tested, T, E: Copy + Debug + PartialEq, const N: usize>(
    good: [f64; N],
    error: E,
    make: impl Fn([S; N]) -> Result<T, E>,
) {
    let good = good.map(S::near);
    assert_eq!(make(good).err(), None);
    for (place, &bad) in (0..N).flat_map(|place| S::NO_NUMBERS.iter().map(move |bad| (place, bad)))
    {
        let mut input = good;
        input[place] = bad;
        assert_eq!(make(input).err(), Some(error), "{input:?}");
    }
}

fn vec_of<S: Copy>(x: &[S]) -> Vec3<S> {
    Vec3::new(x[0], x[1], x[2])
}

fn cylinders<S: Tested>() {
    use CylinderError::{Empty, NotFinite, Radius};
    for axis in 0..3 {
        at_every_place([0.5, -0.5, 1.0, -1.0, 2.0], NotFinite, |[a, b, r, low, high]: [S; 5]| {
            S::along(axis, [a, b], r, low, high)
        });
    }
    at_every_place([0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 1.0], NotFinite, |x: [S; 7]| {
        S::between(vec_of(&x), vec_of(&x[3..]), x[6])
    });

    let along = |axis, radius: f64, low: f64, high: f64| {
        S::along(axis, [S::ZERO; 2], S::near(radius), S::near(low), S::near(high)).err()
    };
    let between = |from, to, radius| S::between(vector(from), vector(to), S::near(radius)).err();
    for radius in [0.0, -0.0, -1.0, -S::MIN_RADIUS.to_f64()] {
        for axis in 0..3 {
            assert_eq!(along(axis, radius, -1.0, 1.0), Some(Radius), "{radius}");
        }
        assert_eq!(between([0.0; 3], [1.0, 2.0, 2.0], radius), Some(Radius), "{radius}");
    }
    for (low, high) in [(1.0, 1.0), (0.0, -0.0), (1.0, -1.0)] {
        for axis in 0..3 {
            assert_eq!(along(axis, 1.0, low, high), Some(Empty), "{low} {high}");
        }
    }
    for point in [[0.0; 3], [0.1, 4000.0, -3.0]] {
        assert_eq!(between(point, point, 1.0), Some(Empty));
    }
}

/// Numbers whose squares would overflow or vanish are errors, and no solid that wraps round, has
/// NaN in it, or can't be hit.
fn beyond_the_range_of_the_number_type<S: Tested>() {
    let (reach, finest) = (S::MAX_COORDINATE.to_f64(), S::MIN_RADIUS.to_f64());
    for far in [
        S::MAX_COORDINATE.up().to_f64(),
        2.0 * reach,
        -2.0 * reach,
        -S::MAX_COORDINATE.up().to_f64(),
    ] {
        let away = [0.0, far, 0.0];
        assert_eq!(S::sphere(vector(away), S::ONE).err(), Some(SphereError::TooFar));
        for axis in 0..3 {
            for middle in [[far, 0.0], [0.0, far]] {
                let cylinder = S::along(axis, middle.map(S::near), S::ONE, S::ZERO, S::ONE);
                assert_eq!(cylinder.err(), Some(CylinderError::TooFar));
            }
        }
        for [from, to] in [[away, [0.0; 3]], [[0.0; 3], away]] {
            let cylinder = S::between(vector(from), vector(to), S::ONE);
            assert_eq!(cylinder.err(), Some(CylinderError::TooFar));
        }
        let x = vector::<S>([1.0, 0.0, 0.0]);
        assert_eq!(Ray::new(vector(away), x).err(), Some(RayError::TooFar));
        let y = vector::<S>([0.0, 1.0, 0.0]);
        let camera = Orthographic::look_along(x, vector(away), y, S::ONE);
        assert_eq!(camera.err(), Some(CameraError::TooFar));
        // A distance is rounded: no telling by one unit.
        let eye = vector([1.001 * far, 0.0, 0.0]);
        let camera = Perspective::look_at(eye, Vec3::ZERO, y, S::ONE);
        assert_eq!(camera.err(), Some(CameraError::TooFar));
    }
    for radius in [S::MAX_COORDINATE.up().to_f64(), 2.0 * reach, S::MIN_RADIUS.down().to_f64()] {
        let sphere = S::sphere(Vec3::ZERO, S::near(radius));
        assert_eq!(sphere.err(), Some(SphereError::Radius), "{radius}");
        let cylinder = S::along(2, [S::ZERO; 2], S::near(radius), S::ZERO, S::ONE);
        assert_eq!(cylinder.err(), Some(CylinderError::Radius), "{radius}");
    }

    // And just inside of the range, everything can be seen.
    for radius in [finest, reach] {
        let ray = ray::<S>([-radius, 0.0, 0.0], [1.0, 0.0, 0.0]);
        let [low, high, r] = [-radius, radius, radius].map(S::near);
        let rod = S::along(2, [S::ZERO; 2], r, low, high).unwrap();
        for ends in [spans(&ball::<S>([0.0; 3], radius), &ray), spans(&rod, &ray)] {
            let [(enter, exit)] = ends[..] else { panic!("missed at {radius}") };
            let off = (enter.abs() + (exit - 2.0 * radius).abs()) / radius;
            assert!(off < 1e-6, "{enter} {exit} for {radius}");
        }
    }
}

fn spheres<S: Tested>() {
    at_every_place([1.0, 2.0, 3.0, 4.0], SphereError::NotFinite, |x: [S; 4]| {
        S::sphere(vec_of(&x), x[3])
    });
    for radius in [0.0, -0.0, -1.0] {
        assert_eq!(S::sphere(Vec3::ZERO, S::near(radius)).err(), Some(SphereError::Radius));
    }
}

fn tori<S: Tested>() {
    use TorusError::{NotFinite, Radius, TooFar, Tube, ZeroAxis};
    at_every_place([1.0, 2.0, 3.0, 0.0, 1.0, 0.5, 2.0, 1.0], NotFinite, |x: [S; 8]| {
        S::torus(vec_of(&x), vec_of(&x[3..]), [x[6], x[7]])
    });
    for axis in 0..3 {
        at_every_place([1.0, 2.0, 3.0, 2.0, 1.0], NotFinite, |x: [S; 5]| {
            S::torus_along(axis, vec_of(&x), [x[3], x[4]])
        });
        let along = |center, radii: [f64; 2]| {
            S::torus_along(axis, vector(center), radii.map(S::near)).err()
        };
        let (least, most) = (S::MIN_RADIUS, S::MAX_COORDINATE);
        let below = least.down().to_f64();
        for radii in [[1.0, 0.0], [1.0, -0.5], [0.0, 0.5], [-1.0, 0.5], [1.0, -0.0], [1.0, below]] {
            assert_eq!(along([0.0; 3], radii), Some(Radius), "{radii:?}");
        }
        assert_eq!(along([0.0; 3], [most.up().to_f64(), 1.0]), Some(Radius));
        for radii in [[1.0, 1.0], [1.0, 1.5], [1.0, S::ONE.up().to_f64()]] {
            assert_eq!(along([0.0; 3], radii), Some(Tube), "{radii:?}");
        }
        assert_eq!(along([0.0, most.up().to_f64(), 0.0], [2.0, 1.0]), Some(TooFar));
        // As wide as may be, and as large.
        assert_eq!(along([0.0; 3], [1.0, S::ONE.down().to_f64()]), None);
        let large = most.to_f64();
        let widest = S::torus_along(axis, Vec3::ZERO, [most, S::near(0.75 * large)]).unwrap();
        let ends = spans(&widest, &ray::<S>([large, large, large], [-1.0, -1.0, -1.0]));
        assert_eq!(ends.len(), 2, "{ends:?}");
        assert!(ends.iter().all(|(enter, exit)| 0.0 < *enter && *exit < 2.0 * large));
    }
    for axis in [[0.0; 3], [-0.0, 0.0, 0.0]] {
        let radii = [2.0, 1.0].map(S::near);
        assert_eq!(S::torus(Vec3::ZERO, vector(axis), radii).err(), Some(ZeroAxis));
    }
}

fn slabs<S: Tested>() {
    use SlabError::{Empty, NotFinite, ZeroNormal};
    at_every_place([1.0, 2.0, 3.0, -1.0, 1.0], NotFinite, |x: [S; 5]| {
        S::slab(vec_of(&x), x[3], x[4])
    });
    for axis in 0..3 {
        at_every_place([-1.0, 1.0], NotFinite, |[low, high]: [S; 2]| {
            S::slab_along(axis, low, high)
        });
    }
    for (low, high) in [(1.0, 1.0), (0.0, -0.0), (2.0, 1.0)] {
        let (low, high) = (S::near(low), S::near(high));
        for axis in 0..3 {
            assert_eq!(S::slab_along(axis, low, high).err(), Some(Empty));
        }
        assert_eq!(S::slab(vector([1.0, 1.0, 0.0]), low, high).err(), Some(Empty));
    }
    let zero = vector([0.0, -0.0, 0.0]);
    assert_eq!(S::slab(zero, S::ONE.negated(), S::ONE).err(), Some(ZeroNormal));
}

fn rays<S: Tested>() {
    at_every_place([1.0, 2.0, 3.0, 0.0, 1.0, 0.0], RayError::NotFinite, |x: [S; 6]| {
        Ray::new(vec_of(&x), vec_of(&x[3..]))
    });
    let zero = vector::<S>([0.0, -0.0, 0.0]);
    assert_eq!(Ray::new(Vec3::ZERO, zero).err(), Some(RayError::ZeroDirection));
    // The length is no error where it is an ordinary one.
    for length in [0.5, 1.0, 1024.0, 16384.0] {
        for sign in [1.0, -1.0] {
            let ray = Ray::new(Vec3::ZERO, vector::<S>([0.0, sign * length, 0.25]));
            assert_eq!(ray.err(), None, "{length}");
        }
    }
}

/// A pose that shifts beyond the range would put a solid where no ray comes, and a turn by NaN would give
/// it NaN for normals.
fn poses<S: Tested>() {
    at_every_place([1.0, 2.0, 3.0], PoseError::NotFinite, |x: [S; 3]| S::translation(vec_of(&x)));
    for turn in [Pose::rotation_x, Pose::rotation_y, Pose::rotation_z] {
        at_every_place([0.5], PoseError::NotFinite, |[angle]: [S; 1]| turn(angle));
    }
    let reach = S::MAX_COORDINATE.to_f64();
    for far in [S::MAX_COORDINATE.up().to_f64(), 2.0 * reach, -S::MAX_COORDINATE.up().to_f64()] {
        for axis in 0..3 {
            let by = std::array::from_fn(|i| if i == axis { far } else { 0.0 });
            assert_eq!(S::translation(vector(by)).err(), Some(PoseError::TooFar), "{by:?}");
        }
    }
    // Each within reach, together beyond it; and back again.
    let there = S::translation(vector([reach, 0.0, -reach])).unwrap();
    assert_eq!(there.then(&there).err(), Some(PoseError::TooFar));
    let back = S::translation(vector([-reach, 0.0, reach])).unwrap();
    assert_eq!(there.then(&back), Ok(Pose::IDENTITY));
    // A corner at reach is farther away than that once it's turned.
    let eighth = Pose::rotation_y(S::near(std::f64::consts::FRAC_PI_4)).unwrap();
    assert_eq!(there.then(&eighth).err(), Some(PoseError::TooFar));
    assert_eq!(eighth.then(&there).unwrap().inverse().err(), Some(PoseError::TooFar));
    let half = Pose::rotation_y(S::near(std::f64::consts::PI)).unwrap();
    assert_eq!(half.around(vector([-reach, 0.0, reach])).err(), Some(PoseError::TooFar));
    at_every_place([1.0, 2.0, 3.0], PoseError::NotFinite, |x: [S; 3]| eighth.around(vec_of(&x)));
    for axis in [[1.0, 2.0, 3.0], [0.0, -1.0, 0.0]] {
        let [x, y, z] = axis;
        at_every_place([x, y, z, 0.5], PoseError::NotFinite, |x: [S; 4]| {
            Pose::about(vec_of(&x), x[3])
        });
    }
    let zero = vector::<S>([0.0, -0.0, 0.0]);
    assert_eq!(Pose::about(zero, S::ONE).err(), Some(PoseError::ZeroAxis));
}

fn orthographic_cameras<S: Tested>() {
    use CameraError::{FrameHeight, NotFinite, UpAlongView, ZeroDirection};
    let good = [1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    let four = S::near(4.0);
    at_every_place(good, NotFinite, |x: [S; 9]| {
        Orthographic::look_at(vec_of(&x), vec_of(&x[3..]), vec_of(&x[6..]), four)
    });
    at_every_place(good, NotFinite, |x: [S; 9]| {
        Orthographic::look_along(vec_of(&x), vec_of(&x[3..]), vec_of(&x[6..]), four)
    });
    let [eye, target, up] = [[1.0, 2.0, 3.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(vector::<S>);
    let heights = [0.0, -0.0, -1.0].map(S::near);
    for &height in heights.iter().chain(S::NO_NUMBERS) {
        let camera = Orthographic::look_at(eye, target, up, height);
        assert_eq!(camera.err(), Some(FrameHeight), "{height:?}");
        let camera = Orthographic::look_along(eye, target, up, height);
        assert_eq!(camera.err(), Some(FrameHeight), "{height:?}");
    }
    assert_eq!(Orthographic::look_at(eye, eye, up, four).err(), Some(ZeroDirection));
    let camera = Orthographic::look_along(Vec3::ZERO, target, up, four);
    assert_eq!(camera.err(), Some(ZeroDirection));
    // Multiples that are exact in all number types, so they are parallel exactly.
    for factor in [1.0, -1.0, 0.5, 3.0, -5.0, 7.0, 11.0, 25.0, 99.0, -1001.0] {
        let along = vector([2.0, 2.0, 3.0].map(|x| x * factor));
        let camera = Orthographic::look_at(eye, target, along, four);
        assert_eq!(camera.err(), Some(UpAlongView), "{along:?}");
    }
    let camera = Orthographic::look_at(eye, target, Vec3::ZERO, four);
    assert_eq!(camera.err(), Some(UpAlongView));
}

fn perspective_cameras<S: Tested>() {
    use CameraError::{FieldOfView, NotFinite, UpAlongView, ZeroDirection};
    let good = [1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    at_every_place(good, NotFinite, |x: [S; 9]| {
        Perspective::look_at(vec_of(&x), vec_of(&x[3..]), vec_of(&x[6..]), S::ONE)
    });
    let [eye, target, up] = [[0.0, 0.0, 5.0], [0.0; 3], [0.0, 1.0, 0.0]].map(vector::<S>);
    let above_pi = S::near(std::f64::consts::PI).up().to_f64();
    let fields = [0.0, -0.0, -1.0, above_pi, 4.0].map(S::near);
    for &field in fields.iter().chain(S::NO_NUMBERS) {
        let camera = Perspective::look_at(eye, target, up, field);
        assert_eq!(camera.err(), Some(FieldOfView), "{field:?}");
    }
    let look = |eye, up| Perspective::look_at(eye, target, up, S::ONE).err();
    assert_eq!(look(target, up), Some(ZeroDirection));
    for up in [eye, vector([0.0, 0.0, -5.0]), Vec3::ZERO] {
        assert_eq!(look(eye, up), Some(UpAlongView));
    }
}

fn shaders<S: Tested>() {
    use ShadeError::{Ambient, DepthRange, LightDirection, Thickness};
    let light = vector::<S>([0.0, 1.0, 0.0]);
    let little = S::near(0.125);
    at_every_place([0.0, 1.0, 0.0], LightDirection, |x: [S; 3]| Lambert::new(vec_of(&x), little));
    assert_eq!(Lambert::new(Vec3::ZERO, little).err(), Some(LightDirection));
    let ambients = [-0.1, 1.1, -S::UNIT, 1.0 + S::UNIT].map(S::near);
    for &ambient in ambients.iter().chain(S::NO_NUMBERS) {
        assert_eq!(Lambert::new(light, ambient).err(), Some(Ambient), "{ambient:?}");
    }
    for ambient in [S::ZERO, S::ONE] {
        assert_eq!(Lambert::new(light, ambient).err(), None, "{ambient:?}");
    }
    at_every_place([-1.0, 1.0], DepthRange, |[near, far]: [S; 2]| Depth::new(near, far));
    assert_eq!(Depth::new(S::ONE, S::ONE).err(), Some(DepthRange));
    assert_eq!(Depth::new(S::ONE, S::ONE.negated()).err(), Some(DepthRange));
    at_every_place([1.0], Thickness, |[thickness]: [S; 1]| XRay::new(thickness));
    assert_eq!(XRay::new(S::ZERO).err(), Some(Thickness));
    assert_eq!(XRay::new(S::ONE.negated()).err(), Some(Thickness));
}
