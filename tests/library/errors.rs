//! Errors, constants and slices: what does not depend on the number type. Every way to give the crate
//! a number that it can't use is in `conformance/bad_input.rs`.

#![allow(clippy::unwrap_used, clippy::panic)]

use embedded_io::ErrorKind;
use scancsg::constant;
use scancsg::geom::{Ray, RayError, Vec3, vec3};
use scancsg::program::{BytesError, LineError, ProgramError};
use scancsg::render::{
    CameraError, Gray8, Orthographic, Picture, RowError, Run, ShadeError, Size, SizeError, XRay,
};
use scancsg::solid::{
    Cone, ConeError, Cylinder, CylinderError, CylinderWall, Difference, Painted, PipeError,
    RayCast, Rgb, Shape, Slab, SlabError, Sphere, SphereError, Union,
};
use scancsg::span::SpanList;
use scancsg::stream::{EncodeError, PacketError, ReceiveError, Refusal, ServeError, UnpackError};
use std::collections::HashSet;

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
const CONES: [Cone<f64>; 2] = [
    constant!(Cone::<f64>::along_z(0.0, 0.0, [1.0, 0.0], -1.0, 1.0)),
    constant!(Cone::<f64>::between(vec3(0.0, 0.0, -1.0), vec3(0.0, 0.0, 1.0), [1.0, 0.0])),
];

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
    let along_axis = Ray::new(vec3(0.0, 0.0, 9.0), vec3(0.0, 0.0, -1.0)).unwrap();
    let ends = CONES.map(|cone| cone.trace(&along_axis, &mut SpanList::<f64, 1>::new()).to_vec());
    assert!(ends.iter().all(|ends| (ends[0].enter.t, ends[0].exit.t) == (8.0, 10.0)), "{ends:?}");
    let [span] = SLAB.trace(&along, &mut list) else { panic!("the slab is missed") };
    assert!((span.enter.t - 0.8).abs() < 1e-15 && (span.exit.t - 1.2).abs() < 1e-15, "{span:?}");
}

#[test]
fn rows_that_are_not_there_and_slices_that_do_not_fit() {
    let camera =
        Orthographic::look_along(vec3(0.0f32, 0.0, -1.0), Vec3::ZERO, vec3(0.0, 1.0, 0.0), 6.0);
    let shader = XRay::new(1.0).unwrap();
    let mut picture = Picture::new(&PART, &camera.unwrap(), SIZE, shader, Gray8(17));
    for y in [5, 6, u16::MAX] {
        assert_eq!(picture.scanline(y).err(), Some(RowError::Index), "{y}");
    }
    for y in 0..5 {
        let mut scanline = picture.scanline(y).unwrap();
        for length in [0, 1, 6, 8, 100] {
            let mut pixels = vec![Gray8(99); length];
            assert_eq!(scanline.render(&mut pixels), Err(RowError::Length));
            assert!(pixels.iter().all(|&pixel| pixel == Gray8(99)), "{length} were written to");
        }
        let mut pixels = [Gray8(99); 7];
        assert_eq!(scanline.render(&mut pixels), Ok(()));
        assert!(pixels.iter().all(|&pixel| pixel != Gray8(99)));

        let mut start = 0;
        while let Some(run) = scanline.run(start) {
            start = run.columns.end;
            for length in [0, run.columns.len() - 1, run.columns.len() + 1] {
                let mut pixels = vec![Gray8(99); length];
                let result = scanline.render_run(&run, &mut pixels);
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
    let mut picture = Picture::new(&PART, &camera.unwrap(), SIZE, shader, Gray8(17));
    let mut scanline = picture.scanline(2).unwrap();
    let mut list = SpanList::<f32, { Part::STACK }>::new();
    let beyond = Run { columns: 65_530..u16::MAX, is_background: false };
    let mut pixels = [Gray8(99); 5];
    assert_eq!(scanline.render_run(&beyond, &mut pixels), Err(RowError::Index));
    assert_eq!(pixels, [Gray8(99); 5]);
    assert!(scanline.spans(u16::MAX, &mut list).is_empty());
}

#[test]
fn every_error_has_a_text_of_its_own() {
    let errors: Vec<Box<dyn std::error::Error>> = vec![
        Box::new(CylinderError::NotFinite),
        Box::new(CylinderError::Radius),
        Box::new(CylinderError::Empty),
        Box::new(ConeError::NotFinite),
        Box::new(ConeError::Radius),
        Box::new(ConeError::TooFar),
        Box::new(ConeError::Empty),
        Box::new(SphereError::NotFinite),
        Box::new(SphereError::Radius),
        Box::new(SlabError::NotFinite),
        Box::new(SlabError::ZeroNormal),
        Box::new(SlabError::Empty),
        Box::new(PipeError::NotFinite),
        Box::new(PipeError::Radius),
        Box::new(PipeError::Empty),
        Box::new(PipeError::Tolerance),
        Box::new(PipeError::Capacity),
        Box::new(RayError::NotFinite),
        Box::new(RayError::ZeroDirection),
        Box::new(CameraError::NotFinite),
        Box::new(CameraError::ZeroDirection),
        Box::new(CameraError::TooNear),
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
        Box::new(ProgramError::Parts),
        Box::new(ProgramError::Operands),
        Box::new(ProgramError::CutInto),
        Box::new(BytesError::Length),
        Box::new(BytesError::Kind),
        Box::new(BytesError::Tree),
        Box::new(LineError::Spans),
    ];
    let texts: HashSet<String> = errors.iter().map(ToString::to_string).collect();
    assert_eq!(texts.len(), errors.len(), "{texts:?}");
    assert!(texts.iter().all(|text| text.len() > 20 && !text.ends_with('.')), "{texts:?}");
}

/// Those of the link: other ends show some of them to people, so the words of each kind tell them apart.
#[test]
fn every_error_of_the_link_has_a_text_of_its_own() {
    fn check<E: std::error::Error + Copy>(errors: &[E]) {
        let texts: HashSet<String> = errors.iter().map(ToString::to_string).collect();
        assert_eq!(texts.len(), errors.len(), "{texts:?}");
        assert!(texts.iter().all(|text| text.len() > 15 && !text.ends_with('.')), "{texts:?}");
        assert!(size_of::<E>() <= 2, "{}", size_of::<E>());
    }
    check(&[
        EncodeError::BufferTooSmall,
        EncodeError::Size,
        EncodeError::NoFrame,
        EncodeError::Format,
        EncodeError::Width,
        EncodeError::Order,
    ]);
    check(&[
        PacketError::Framing,
        PacketError::TooLong,
        PacketError::Crc,
        PacketError::Kind,
        PacketError::Length,
        PacketError::Version,
        PacketError::Format,
        PacketError::Size,
        PacketError::Encoding,
        PacketError::Part,
    ]);
    let unpack = [
        UnpackError::Truncated,
        UnpackError::TooLong,
        UnpackError::TooShort,
        UnpackError::NoMemory,
    ];
    check(&unpack);
    check(&[
        ReceiveError::Size,
        ReceiveError::TooLarge,
        ReceiveError::UnknownFrame,
        ReceiveError::Row,
        ReceiveError::Payload(UnpackError::Truncated),
    ]);
    check(&[
        ServeError::Write(ErrorKind::TimedOut),
        ServeError::Read(ErrorKind::TimedOut),
        ServeError::Closed,
        ServeError::Encode(EncodeError::Width),
        ServeError::Render(RowError::Length),
    ]);
    check(&[Refusal::TooLong, Refusal::Number, Refusal::Kind, Refusal::TooLarge, Refusal::Invalid]);
    // What is inside another error says its own words.
    for error in unpack {
        assert_eq!(ReceiveError::Payload(error).as_str(), error.as_str());
    }
}

/// Errors are handed up through firmware: small, and copied at will.
#[test]
fn errors_are_small_copies() {
    fn is_copy<T: Copy>() -> usize {
        size_of::<T>()
    }
    let sizes = [
        is_copy::<CylinderError>(),
        is_copy::<ConeError>(),
        is_copy::<SphereError>(),
        is_copy::<SlabError>(),
        is_copy::<PipeError>(),
        is_copy::<RayError>(),
        is_copy::<CameraError>(),
        is_copy::<ShadeError>(),
        is_copy::<SizeError>(),
        is_copy::<RowError>(),
        is_copy::<ProgramError>(),
        is_copy::<BytesError>(),
        is_copy::<LineError>(),
    ];
    assert!(sizes.iter().all(|&size| size <= 1), "{sizes:?}");
}
