//! Rows of pictures where it is easy to lose or to invent a pixel.

#![allow(clippy::unwrap_used, clippy::indexing_slicing)]

use proptest::prelude::*;
use scancsg::geom::{Column, Rays, Vec3, vec3};
use scancsg::render::{Camera, Gray8, Orthographic, Perspective, Picture, Size, XRay};
use scancsg::solid::{Cylinder, Project, Row, Slab, Solid, Sphere, View};
use scancsg::span::{Crossing, Face, Operation, Span, SpanList, merge};

const UP: Vec3<f32> = vec3(0.0, 1.0, 0.0);

/// Of every pixel of a picture, whether it sees the solid.
fn seen<T, C>(solid: &T, camera: &C, side: u16) -> Vec<Vec<bool>>
where
    C: Camera<Rays: Rays<Scalar = f32>>,
    T: Solid<Scalar = f32> + Project<C::Rays>,
{
    let size = Size::new(side, side).unwrap();
    let picture = Picture::new(solid, camera, size, XRay::new(1.0).unwrap(), Gray8(0));
    let mut list = SpanList::<f32, 8>::new();
    picture
        .scanlines()
        .map(|line| (0..side).map(|x| line.seen(x, &mut list).is_some()).collect())
        .collect()
}

/// In the middle of an odd picture, the ray from an eye on the axis is exactly parallel to it:
/// its quadratic has no square term, and a division by it would give NaN.
#[test]
fn an_eye_on_the_axis() {
    let rod = Cylinder::<f32>::along_z(0.0, 0.0, 1.0, -3.0, 3.0).unwrap();
    let bore = Cylinder::<f32>::along_z(0.0, 0.0, 0.5, -4.0, 4.0).unwrap();
    let camera = Perspective::look_at(vec3(0.0, 0.0, 9.0), Vec3::ZERO, UP, 0.5).unwrap();
    let picture = seen(&rod, &camera, 9);
    assert!((3..6).all(|y| (3..6).all(|x| picture[y][x])), "{picture:?}");
    assert!(!seen(&(rod - bore), &camera, 9)[4][4]);
    let beside = Cylinder::<f32>::along_z(3.0, 0.0, 1.0, -3.0, 3.0).unwrap();
    assert!(!seen(&beside, &camera, 9)[4][4]);
}

/// Between exactly parallel and clearly not, angles have squares that vanish or are subnormal.
#[test]
fn looking_almost_along_the_axis() {
    let rod = Cylinder::<f32>::along_x(0.0, 0.0, 1.0, -2.0, 2.0).unwrap();
    let straight = Orthographic::look_along(vec3(1.0, 0.0, 0.0), Vec3::ZERO, UP, 4.0).unwrap();
    let expected = seen(&rod, &straight, 9);
    assert!(expected[4][4] && !expected[0][0]);
    for exponent in 8..=44 {
        let along = vec3(1.0, 0.0, 10f32.powi(-exponent));
        let camera = Orthographic::look_along(along, Vec3::ZERO, UP, 4.0).unwrap();
        assert_eq!(seen(&rod, &camera, 9), expected, "1e-{exponent} off the axis");
        let eye = along * -20.0;
        let camera = Perspective::look_at(eye, Vec3::ZERO, UP, 0.2).unwrap();
        assert!(seen(&rod, &camera, 9)[4][4], "1e-{exponent} off the axis");
    }
    // The same for rays that run almost along a slab's planes.
    let plate = Slab::<f32>::along_z(-0.5, 0.5).unwrap() & rod;
    let expected = seen(&plate, &straight, 9);
    for exponent in 8..=44 {
        let along = vec3(1.0, 0.0, 10f32.powi(-exponent));
        let camera = Orthographic::look_along(along, Vec3::ZERO, UP, 4.0).unwrap();
        assert_eq!(seen(&plate, &camera, 9), expected, "1e-{exponent} off the plane");
    }
}

/// An X-ray of what is behind the eye as well would be too bright.
#[test]
fn an_x_ray_begins_at_the_eye() {
    let ball = Sphere::<f32>::new(Vec3::ZERO, 2.0).unwrap();
    let camera = Perspective::look_at(vec3(0.0, 0.0, 1.0), Vec3::ZERO, UP, 0.1).unwrap();
    let size = Size::new(1, 1).unwrap();
    let picture = Picture::new(&ball, &camera, size, XRay::new(10.0).unwrap(), Gray8(0));
    let mut pixel = [Gray8(0)];
    picture.scanline(0).unwrap().render(&mut SpanList::<f32, 1>::new(), &mut pixel).unwrap();
    // 3 of the ball's 4 units are in front of the eye: 0.3 · 255.
    assert_eq!(pixel, [Gray8(77)]);
}

/// Which face is seen where two coincide must not depend on anything but the order of operands.
#[test]
fn of_two_faces_in_one_place_the_left_one_counts() {
    let span = |enter: f32, exit: f32, face| {
        let at = |t| Crossing { t, face: Face(face) };
        Span { enter: at(enter), exit: at(exit) }
    };
    for operation in [Operation::UNION, Operation::INTERSECTION] {
        let mut list = SpanList::<f32, 3>::new();
        let mut stack = list.stack();
        stack.push(span(1.0, 2.0, 7)).unwrap();
        stack.push(span(1.0, 2.0, 9)).unwrap();
        merge(operation, &mut stack, 0, 1).unwrap();
        assert_eq!(*list, [span(1.0, 2.0, 7)]);
    }
}

/// NaN can be ordered before nothing and after nothing: a walk that waits for one to be the
/// smaller never ends. A list without room is an error, and keeps what it had.
#[test]
fn a_merge_ends_whatever_it_is_given() {
    let span = |enter: f32, exit: f32| {
        let at = |t| Crossing { t, face: Face(0) };
        Span { enter: at(enter), exit: at(exit) }
    };
    let odd = [f32::NAN, f32::NEG_INFINITY, f32::INFINITY, 1.0, -1.0];
    for operation in [Operation::UNION, Operation::INTERSECTION, Operation::DIFFERENCE] {
        for numbers in (0..625).map(|i| [i % 5, i / 5 % 5, i / 25 % 5, i / 125].map(|i| odd[i])) {
            let [a, b, c, d] = numbers;
            let mut list = SpanList::<f32, 4>::new();
            let mut stack = list.stack();
            stack.push(span(a, b)).unwrap();
            stack.push(span(c, d)).unwrap();
            merge(operation, &mut stack, 0, 1).unwrap();
            assert!(list.len() <= 2);
        }
    }
    let mut list = SpanList::<f32, 2>::new();
    let mut stack = list.stack();
    stack.push(span(0.0, 1.0)).unwrap();
    stack.push(span(0.5, 3.0)).unwrap();
    assert!(stack.push(span(4.0, 5.0)).is_err());
    assert!(merge(Operation::UNION, &mut stack, 0, 1).is_err());
    assert_eq!(*list, [span(0.0, 1.0), span(0.5, 3.0)]);
}

/// Asks a row in every column, and wants nothing outside of its extent.
fn check_extents<T, R>(solid: &T, rays: &R, height: u16) -> Result<(), TestCaseError>
where
    R: Rays<Scalar = f32>,
    T: Solid<Scalar = f32> + Project<R>,
{
    let view = solid.view(rays);
    let mut list = SpanList::<f32, 1>::new();
    for y in 0..height {
        let row = view.row(2 * i32::from(y) + 1 - i32::from(height));
        let extent = row.extent();
        for index in (0..rays.columns()).filter(|index| !extent.contains(*index)) {
            let x = 2 * index as i32 + 1 - rays.columns() as i32;
            row.spans(Column { index, x }, Face(0), &mut list.stack());
            prop_assert!(list.is_empty(), "column {} of row {}, {:?}", index, y, extent);
        }
    }
    Ok(())
}

fn vector(length: f32) -> impl Strategy<Value = Vec3<f32>> {
    [-1f32..1.0, -1f32..1.0, -1f32..1.0]
        .prop_map(move |[x, y, z]| vec3(x * length, y * length, z * length))
        .prop_filter("a direction", move |v| v.length_squared() > 0.01 * length * length)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    /// A row may be asked in too many columns, never in too few: with solids of any size, near the
    /// picture's middle or far from it, in pixels of any size.
    #[test]
    fn extents_cut_nothing_off(
        size in -9i32..10, way in vector(1.0), along in vector(1.0), away in vector(1.0),
        far in prop_oneof![Just(0.3f32), Just(1.0), Just(30.0), Just(1e4)],
        radius in 0.01f32..1.0, zoom in prop_oneof![Just(3f32), Just(0.3), Just(0.01)],
    ) {
        let unit = 10f32.powi(size);
        let target = away * (far * unit);
        let rod = Cylinder::<f32>::between(Vec3::ZERO, way * unit, radius * unit).unwrap();
        let ball = Sphere::<f32>::new(Vec3::ZERO, radius * unit).unwrap();
        let frame = zoom * unit * far.max(1.0);
        let picture = Size::new(64, 24).unwrap();
        if let Ok(camera) = Orthographic::look_along(along, target, UP, frame) {
            check_extents(&rod, &camera.rays(picture), 24)?;
            check_extents(&ball, &camera.rays(picture), 24)?;
        }
        let eye = target - along * (unit * far.max(3.0));
        if let Ok(camera) = Perspective::look_at(eye, target, UP, 0.8) {
            check_extents(&rod, &camera.rays(picture), 24)?;
            check_extents(&ball, &camera.rays(picture), 24)?;
        }
    }
}
