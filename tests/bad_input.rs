//! Every way to give the crate something it can't use, and the error that says so.

#![allow(clippy::unwrap_used, clippy::panic)]

use scancsg::constant;
use scancsg::geom::{Ray, RayError, Vec3, vec3};
use scancsg::render::{
    CameraError, Depth, Gray8, Lambert, Orthographic, Perspective, Picture, RowError, Run,
    ShadeError, Size, SizeError, XRay,
};
use scancsg::solid::{
    Cylinder, CylinderError, CylinderWall, Difference, Painted, Rgb, Shape, Slab, SlabError, Solid,
    Sphere, SphereError, Union,
};
use scancsg::span::SpanList;
use std::collections::HashSet;
use std::fmt::Debug;

/// Puts every number that is none at every place of `good`, and wants `error` each time; and
/// wants `good` itself to be taken.
fn at_every_place<S: Copy + Debug, E: Copy + Debug + PartialEq, const N: usize>(
    not_finite: [S; 3],
    error: E,
    good: [S; N],
    make: impl Fn([S; N]) -> Result<(), E>,
) {
    assert_eq!(make(good), Ok(()));
    for (place, bad) in (0..N).flat_map(|place| not_finite.map(|bad| (place, bad))) {
        let mut input = good;
        input[place] = bad;
        assert_eq!(make(input), Err(error), "{input:?}");
    }
}

macro_rules! not_finite {
    ($scalar:ident, $error:expr, $good:expr, |$x:ident| $make:expr) => {
        let not_finite = [$scalar::NAN, $scalar::INFINITY, $scalar::NEG_INFINITY];
        at_every_place(not_finite, $error, $good, |$x| $make.map(|_| ()));
    };
}

fn vector<S: Copy>(x: &[S]) -> Vec3<S> {
    vec3(x[0], x[1], x[2])
}

macro_rules! bad_input {
    ($scalar:ident) => {
        mod $scalar {
            use super::*;

            type S = $scalar;

            #[test]
            fn cylinders() {
                use CylinderError::{Empty, NotFinite, Radius};
                let good: [S; 5] = [0.5, -0.5, 1.0, -1.0, 2.0];
                not_finite!(S, NotFinite, good, |x| Cylinder::<S>::along_x(
                    x[0], x[1], x[2], x[3], x[4]
                ));
                not_finite!(S, NotFinite, good, |x| Cylinder::<S>::along_y(
                    x[0], x[1], x[2], x[3], x[4]
                ));
                not_finite!(S, NotFinite, good, |x| Cylinder::<S>::along_z(
                    x[0], x[1], x[2], x[3], x[4]
                ));
                let good: [S; 7] = [0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 1.0];
                not_finite!(S, NotFinite, good, |x| {
                    Cylinder::<S>::between(vector(&x), vector(&x[3..]), x[6])
                });

                for radius in [0.0, -0.0, -1.0, -S::MIN_POSITIVE] {
                    assert_eq!(Cylinder::<S>::along_x(0.0, 0.0, radius, -1.0, 1.0), Err(Radius));
                    assert_eq!(Cylinder::<S>::along_y(0.0, 0.0, radius, -1.0, 1.0), Err(Radius));
                    assert_eq!(Cylinder::<S>::along_z(0.0, 0.0, radius, -1.0, 1.0), Err(Radius));
                    let (from, to) = (Vec3::ZERO, vec3(1.0, 2.0, 2.0));
                    assert_eq!(Cylinder::<S>::between(from, to, radius), Err(Radius));
                }
                for (low, high) in [(1.0, 1.0), (0.0, -0.0), (1.0, -1.0)] {
                    assert_eq!(Cylinder::<S>::along_x(0.0, 0.0, 1.0, low, high), Err(Empty));
                    assert_eq!(Cylinder::<S>::along_y(0.0, 0.0, 1.0, low, high), Err(Empty));
                    assert_eq!(Cylinder::<S>::along_z(0.0, 0.0, 1.0, low, high), Err(Empty));
                }
                for point in [vec3(0.0, 0.0, 0.0), vec3(0.1, 1e10, -3.0)] {
                    assert_eq!(Cylinder::<S>::between(point, point, 1.0), Err(Empty));
                }
            }

            /// Numbers whose squares would overflow or vanish are errors, and no solid of NaNs or one
            /// that no ray can hit.
            #[test]
            fn beyond_the_range_of_the_number_type() {
                use scancsg::scalar::Scalar;
                let end = vec3(S::MAX, S::MAX, S::MAX);
                assert_eq!(Cylinder::<S>::between(-end, end, 1.0), Err(CylinderError::TooFar));
                let (far, huge, tiny) = (S::REACH * 2.0, S::REACH * 2.0, S::FINEST * 0.5);
                let away = vec3(0.0, far, 0.0);
                assert_eq!(Sphere::<S>::new(away, 1.0), Err(SphereError::TooFar));
                assert_eq!(
                    Cylinder::<S>::along_x(far, 0.0, 1.0, 0.0, 1.0),
                    Err(CylinderError::TooFar)
                );
                for radius in [huge, tiny] {
                    assert_eq!(Sphere::<S>::new(Vec3::ZERO, radius), Err(SphereError::Radius));
                    let cylinder = Cylinder::<S>::along_z(0.0, 0.0, radius, 0.0, 1.0);
                    assert_eq!(cylinder, Err(CylinderError::Radius));
                }
                let (x, y) = (vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
                assert_eq!(Ray::<S>::new(away, x), Err(RayError::TooFar));
                let tiny_frame =
                    Orthographic::<S>::look_along(x, Vec3::ZERO, y, S::MIN_POSITIVE / 64.0);
                assert_eq!(tiny_frame, Err(CameraError::FrameHeight));
                let far_target = Orthographic::<S>::look_along(x, away, y, 1.0);
                assert_eq!(far_target, Err(CameraError::TooFar));
                let at = |distance| Perspective::<S>::look_at(x * distance, Vec3::ZERO, y, 1.0);
                assert_eq!(at(far), Err(CameraError::TooFar));
                assert_eq!(at(S::MIN_POSITIVE / 64.0), Err(CameraError::ZeroDirection));

                // And just inside of the range, everything can be seen.
                for radius in [S::FINEST, S::REACH] {
                    let ball = Sphere::<S>::new(Vec3::ZERO, radius).unwrap();
                    let rod = Cylinder::<S>::along_z(0.0, 0.0, radius, -radius, radius).unwrap();
                    let ray = Ray::<S>::new(-x * radius, x).unwrap();
                    for end in [
                        ball.trace(&ray, &mut SpanList::<S, 1>::new())[0].exit.t,
                        rod.trace(&ray, &mut SpanList::<S, 1>::new())[0].exit.t,
                    ] {
                        assert!((end / radius - 2.0).abs() < 1e-6, "{end} for {radius}");
                    }
                }
            }

            #[test]
            fn spheres() {
                let good: [S; 4] = [1.0, 2.0, 3.0, 4.0];
                not_finite!(S, SphereError::NotFinite, good, |x| Sphere::<S>::new(
                    vector(&x),
                    x[3]
                ));
                for radius in [0.0, -0.0, -1.0] {
                    let sphere = Sphere::<S>::new(Vec3::ZERO, radius);
                    assert_eq!(sphere, Err(SphereError::Radius));
                }
            }

            #[test]
            fn slabs() {
                use SlabError::{Empty, NotFinite, ZeroNormal};
                let good: [S; 5] = [1.0, 2.0, 3.0, -1.0, 1.0];
                not_finite!(S, NotFinite, good, |x| Slab::<S>::new(vector(&x), x[3], x[4]));
                let good: [S; 2] = [-1.0, 1.0];
                not_finite!(S, NotFinite, good, |x| Slab::<S>::along_x(x[0], x[1]));
                not_finite!(S, NotFinite, good, |x| Slab::<S>::along_y(x[0], x[1]));
                not_finite!(S, NotFinite, good, |x| Slab::<S>::along_z(x[0], x[1]));
                for (low, high) in [(1.0, 1.0), (0.0, -0.0), (2.0, 1.0)] {
                    assert_eq!(Slab::<S>::along_x(low, high), Err(Empty));
                    assert_eq!(Slab::<S>::along_y(low, high), Err(Empty));
                    assert_eq!(Slab::<S>::along_z(low, high), Err(Empty));
                    assert_eq!(Slab::<S>::new(vec3(1.0, 1.0, 0.0), low, high), Err(Empty));
                }
                let zero = vec3(0.0, -0.0, 0.0);
                assert_eq!(Slab::<S>::new(zero, -1.0, 1.0), Err(ZeroNormal));
            }

            #[test]
            fn rays() {
                let good: [S; 6] = [1.0, 2.0, 3.0, 0.0, 1.0, 0.0];
                not_finite!(S, RayError::NotFinite, good, |x| Ray::new(
                    vector(&x),
                    vector(&x[3..])
                ));
                let zero = vec3(0.0, -0.0, 0.0);
                assert_eq!(Ray::<S>::new(Vec3::ZERO, zero), Err(RayError::ZeroDirection));
                // The shortest and the longest direction there are: no errors, no NaNs.
                for length in [S::from_bits(1), S::MIN_POSITIVE, S::MAX] {
                    let ray = Ray::new(Vec3::ZERO, vec3(length, -length, length)).unwrap();
                    let ball = Sphere::<S>::new(Vec3::ZERO, 1.0).unwrap();
                    let mut list = SpanList::<S, 1>::new();
                    let [span] = ball.trace(&ray, &mut list) else { panic!("missed") };
                    assert!(span.enter.t < 0.0 && span.exit.t > 0.0, "{span:?}");
                }
            }

            #[test]
            fn orthographic_cameras() {
                use CameraError::{FrameHeight, NotFinite, UpAlongView, ZeroDirection};
                let good: [S; 9] = [1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0];
                not_finite!(S, NotFinite, good, |x| {
                    Orthographic::look_at(vector(&x), vector(&x[3..]), vector(&x[6..]), 4.0)
                });
                not_finite!(S, NotFinite, good, |x| {
                    Orthographic::look_along(vector(&x), vector(&x[3..]), vector(&x[6..]), 4.0)
                });
                let [eye, target, up]: [Vec3<S>; 3] =
                    [vec3(1.0, 2.0, 3.0), vec3(-1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0)];
                for height in [0.0, -0.0, -1.0, S::NAN, S::INFINITY, S::NEG_INFINITY] {
                    let camera = Orthographic::look_at(eye, target, up, height);
                    assert_eq!(camera, Err(FrameHeight), "{height}");
                    let camera = Orthographic::look_along(eye, target, up, height);
                    assert_eq!(camera, Err(FrameHeight), "{height}");
                }
                assert_eq!(Orthographic::look_at(eye, eye, up, 4.0), Err(ZeroDirection));
                let camera = Orthographic::look_along(Vec3::ZERO, target, up, 4.0);
                assert_eq!(camera, Err(ZeroDirection));
                // Multiples that are exact in both number types, so they are parallel exactly.
                for factor in [1.0, -1.0, 0.5, 3.0, -5.0, 7.0, 11.0, 25.0, 99.0, -1001.0] {
                    let along = (eye - target) * factor;
                    let camera = Orthographic::look_at(eye, target, along, 4.0);
                    assert_eq!(camera, Err(UpAlongView), "{along:?}");
                }
                assert_eq!(Orthographic::look_at(eye, target, Vec3::ZERO, 4.0), Err(UpAlongView));
            }

            #[test]
            fn perspective_cameras() {
                use CameraError::{FieldOfView, NotFinite, UpAlongView, ZeroDirection};
                let good: [S; 9] = [1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0];
                not_finite!(S, NotFinite, good, |x| {
                    Perspective::look_at(vector(&x), vector(&x[3..]), vector(&x[6..]), 1.0)
                });
                let [eye, target, up]: [Vec3<S>; 3] =
                    [vec3(0.0, 0.0, 5.0), vec3(0.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0)];
                let pi = <S as scancsg::scalar::Real>::PI;
                for field in [0.0, -0.0, -1.0, pi, 4.0, S::NAN, S::INFINITY, S::NEG_INFINITY] {
                    let camera = Perspective::look_at(eye, target, up, field);
                    assert_eq!(camera, Err(FieldOfView), "{field}");
                }
                assert_eq!(Perspective::look_at(eye, eye, up, 1.0), Err(ZeroDirection));
                assert_eq!(Perspective::look_at(eye, target, eye, 1.0), Err(UpAlongView));
                assert_eq!(Perspective::look_at(eye, target, -eye, 1.0), Err(UpAlongView));
                assert_eq!(Perspective::look_at(eye, target, Vec3::ZERO, 1.0), Err(UpAlongView));
            }

            #[test]
            fn shaders() {
                use ShadeError::{Ambient, DepthRange, LightDirection, Thickness};
                let light: [S; 3] = [0.0, 1.0, 0.0];
                not_finite!(S, LightDirection, light, |x| Lambert::new(vector(&x), 0.1));
                assert_eq!(Lambert::<S>::new(Vec3::ZERO, 0.1), Err(LightDirection));
                for ambient in [-0.1, 1.1, S::NAN, S::INFINITY, S::NEG_INFINITY] {
                    let shader = Lambert::new(vector(&light), ambient);
                    assert_eq!(shader, Err(Ambient), "{ambient}");
                }
                for ambient in [0.0, 1.0] {
                    assert!(Lambert::new(vector(&light), ambient).is_ok(), "{ambient}");
                }
                not_finite!(S, DepthRange, [-1.0, 1.0], |x| Depth::new(x[0], x[1]));
                assert_eq!(Depth::<S>::new(1.0, 1.0), Err(DepthRange));
                assert_eq!(Depth::<S>::new(1.0, -1.0), Err(DepthRange));
                not_finite!(S, Thickness, [1.0], |x| XRay::new(x[0]));
                assert_eq!(XRay::<S>::new(0.0), Err(Thickness));
                assert_eq!(XRay::<S>::new(-1.0), Err(Thickness));
            }
        }
    };
}

bad_input!(f32);
bad_input!(f64);

#[test]
fn sizes() {
    for (width, height) in [(0, 0), (0, 5), (5, 0)] {
        assert_eq!(Size::new(width, height), Err(SizeError::Zero));
    }
    let size = Size::new(1, u16::MAX).unwrap();
    assert_eq!((size.width(), size.height()), (1, u16::MAX));
}

type Ring = Difference<Cylinder<f32>, Cylinder<f32>>;
type Part = Painted<Union<Ring, [Sphere<f32>; 2]>>;

/// A composed solid is a constant: it costs flash and no RAM, and is checked while compiling.
const RING: Ring = Ring::new(
    constant!(Cylinder::<f32>::along_x(0.0, 0.0, 1.0, -1.0, 1.0)),
    constant!(Cylinder::<f32>::between(vec3(-2.0, 0.0, 0.0), vec3(2.0, 0.0, 0.0), 0.5)),
);
const BALLS: [Sphere<f32>; 2] = [
    constant!(Sphere::<f32>::new(vec3(0.0, 2.0, 0.0), 0.25)),
    constant!(Sphere::<f32>::new(vec3(0.0, -2.0, 0.0), 0.25)),
];
static PART: Part = Part::new(Union::new(RING, BALLS), Rgb::new(1, 2, 3));
const WALL: CylinderWall<f64> =
    CylinderWall::of(&constant!(Cylinder::<f64>::along_x(0.0, 0.0, 1.0, -1.0, 1.0)));
const SLAB: Slab<f64> = constant!(Slab::<f64>::new(vec3(0.0, 3.0, 4.0), -1.0, 1.0));
const SIZE: Size = constant!(Size::new(7, 5));

#[test]
fn solids_are_constants() {
    let down = Ray::new(vec3(0.0, 5.0, 0.0), vec3(0.0, -1.0, 0.0)).unwrap();
    let mut list = SpanList::<f32, { Part::STACK }>::new();
    let ends: Vec<_> = PART.trace(&down, &mut list).iter().map(|s| (s.enter.t, s.exit.t)).collect();
    assert_eq!(ends, [(2.75, 3.25), (4.0, 4.5), (5.5, 6.0), (6.75, 7.25)]);
    let down = Ray::new(vec3(0.0, 5.0, 0.0), vec3(0.0, -1.0, 0.0)).unwrap();
    assert_eq!(WALL.hit(&down).map(|hit| hit.t), Some(4.0));
    let along = Ray::new(vec3(0.0, 3.0, 4.0), vec3(0.0, -3.0, -4.0)).unwrap();
    let mut list = SpanList::<f64, 1>::new();
    let [span] = SLAB.trace(&along, &mut list) else { panic!("the slab is missed") };
    assert!((span.enter.t - 0.8).abs() < 1e-15 && (span.exit.t - 1.2).abs() < 1e-15, "{span:?}");
}

#[test]
fn rows_that_are_not_there_and_slices_that_do_not_fit() {
    let camera =
        Orthographic::look_along(vec3(0.0f32, 0.0, -1.0), Vec3::ZERO, vec3(0.0, 1.0, 0.0), 6.0);
    let shader = XRay::new(1.0).unwrap();
    let picture = Picture::new(&PART, &camera.unwrap(), SIZE, shader, Gray8(17));
    for y in [5, 6, u16::MAX] {
        assert_eq!(picture.scanline(y).err(), Some(RowError::Index), "{y}");
    }
    let mut list = SpanList::<f32, { Part::STACK }>::new();
    for scanline in (0..5).map(|y| picture.scanline(y).unwrap()) {
        for length in [0, 1, 6, 8, 100] {
            let mut pixels = vec![Gray8(99); length];
            assert_eq!(scanline.render(&mut list, &mut pixels), Err(RowError::Length));
            assert!(pixels.iter().all(|&pixel| pixel == Gray8(99)), "{length} were written to");
        }
        let mut pixels = [Gray8(99); 7];
        assert_eq!(scanline.render(&mut list, &mut pixels), Ok(()));
        assert!(pixels.iter().all(|&pixel| pixel != Gray8(99)));

        for run in scanline.runs() {
            for length in [0, run.columns.len() - 1, run.columns.len() + 1] {
                let mut pixels = vec![Gray8(99); length];
                let result = scanline.render_run(&run, &mut list, &mut pixels);
                assert_eq!(result, Err(RowError::Length));
                assert!(pixels.iter().all(|&pixel| pixel == Gray8(99)), "{length} were written to");
            }
        }
    }
}

/// A run's fields are public: one that no row has handed out must do no harm.
#[test]
fn a_run_from_elsewhere() {
    let camera =
        Orthographic::look_along(vec3(0.0f32, 0.0, -1.0), Vec3::ZERO, vec3(0.0, 1.0, 0.0), 6.0);
    let shader = XRay::new(1.0).unwrap();
    let picture = Picture::new(&PART, &camera.unwrap(), SIZE, shader, Gray8(17));
    let scanline = picture.scanline(2).unwrap();
    let mut list = SpanList::<f32, { Part::STACK }>::new();
    let beyond = Run { columns: 65_530..u16::MAX, is_background: false };
    let mut pixels = [Gray8(99); 5];
    assert_eq!(scanline.render_run(&beyond, &mut list, &mut pixels), Err(RowError::Index));
    assert_eq!(pixels, [Gray8(99); 5]);
    assert!(scanline.spans(u16::MAX, &mut list).is_empty());
}

#[test]
fn every_error_has_a_text_of_its_own() {
    let errors: Vec<Box<dyn std::error::Error>> = vec![
        Box::new(CylinderError::NotFinite),
        Box::new(CylinderError::Radius),
        Box::new(CylinderError::Empty),
        Box::new(SphereError::NotFinite),
        Box::new(SphereError::Radius),
        Box::new(SlabError::NotFinite),
        Box::new(SlabError::ZeroNormal),
        Box::new(SlabError::Empty),
        Box::new(RayError::NotFinite),
        Box::new(RayError::ZeroDirection),
        Box::new(CameraError::NotFinite),
        Box::new(CameraError::ZeroDirection),
        Box::new(CameraError::UpAlongView),
        Box::new(CameraError::FrameHeight),
        Box::new(CameraError::FieldOfView),
        Box::new(ShadeError::LightDirection),
        Box::new(ShadeError::Ambient),
        Box::new(ShadeError::DepthRange),
        Box::new(ShadeError::Thickness),
        Box::new(SizeError::Zero),
        Box::new(RowError::Index),
        Box::new(RowError::Length),
    ];
    let texts: HashSet<String> = errors.iter().map(ToString::to_string).collect();
    assert_eq!(texts.len(), errors.len(), "{texts:?}");
    assert!(texts.iter().all(|text| text.len() > 20 && !text.ends_with('.')), "{texts:?}");
}

/// Errors are handed up through firmware: small, and copied at will.
#[test]
fn errors_are_small_copies() {
    fn is_copy<T: Copy>() -> usize {
        size_of::<T>()
    }
    let sizes = [
        is_copy::<CylinderError>(),
        is_copy::<SphereError>(),
        is_copy::<SlabError>(),
        is_copy::<RayError>(),
        is_copy::<CameraError>(),
        is_copy::<ShadeError>(),
        is_copy::<SizeError>(),
        is_copy::<RowError>(),
    ];
    assert!(sizes.iter().all(|&size| size <= 1), "{sizes:?}");
}
