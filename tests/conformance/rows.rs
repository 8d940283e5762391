//! Rows of pictures where it is easy to lose or to invent a pixel.

use crate::aim::{direction, from_middle, up};
use crate::number::{Tested, ball, between, rod, vector};
use proptest::prelude::*;
use scancsg::geom::{Rays, Vec3};
use scancsg::render::{Camera, Gray8, Orthographic, Perspective, Picture, Size, XRay};
use scancsg::scan::{Empty, Leaf};
use scancsg::solid::{Scan, Solid};
use scancsg::span::{Crossing, Face, Operation, Span, SpanList, merge};

for_every_number!(
    an_eye_on_the_axis,
    looking_almost_along_the_axis,
    an_x_ray_begins_at_the_eye,
    of_two_faces_in_one_place_the_left_one_counts,
    a_merge_ends_whatever_it_is_given,
    extents_cut_nothing_off,
    a_row_is_its_runs,
);

/// Of every pixel of a picture, whether it sees the solid.
fn seen<S, T, C>(solid: &T, camera: &C, side: u16) -> Vec<Vec<bool>>
where
    S: Tested,
    C: Camera<Rays: Rays<Scalar = S>>,
    T: Solid<Scalar = S> + Scan<C::Rays>,
{
    let size = Size::new(side, side).unwrap();
    let mut picture = Picture::new(solid, camera, size, XRay::new(S::ONE).unwrap(), Gray8(0));
    (0..side)
        .map(|y| {
            let mut line = picture.scanline(y).unwrap();
            (0..side).map(|x| line.seen(x).is_some()).collect()
        })
        .collect()
}

/// In the middle of an odd picture, the ray from an eye on the axis is exactly parallel to it:
/// its quadratic has no square term, and a division by it would give NaN.
fn an_eye_on_the_axis<S: Tested>() {
    let along_z = |x: f64, radius: f64, half: f64| {
        let [x, r, low, high] = [x, radius, -half, half].map(S::near);
        S::along(2, [x, S::ZERO], r, low, high).unwrap()
    };
    let (rod, bore) = (along_z(0.0, 1.0, 3.0), along_z(0.0, 0.5, 4.0));
    let eye = vector([0.0, 0.0, 9.0]);
    let camera = Perspective::look_at(eye, Vec3::ZERO, up(), S::near(0.5)).unwrap();
    let picture = seen(&rod, &camera, 9);
    assert!((3..6).all(|y| (3..6).all(|x| picture[y][x])), "{picture:?}");
    assert!(!seen(&(rod - bore), &camera, 9)[4][4]);
    assert!(!seen(&along_z(3.0, 1.0, 3.0), &camera, 9)[4][4]);
}

/// Between exactly parallel and clearly not, angles have squares that vanish or are subnormal.
fn looking_almost_along_the_axis<S: Tested>() {
    let rod = rod::<S>(1.0, -2.0, 2.0);
    let four = S::near(4.0);
    let along = vector([1.0, 0.0, 0.0]);
    let straight = Orthographic::look_along(along, Vec3::ZERO, up(), four).unwrap();
    let plate = S::slab_along(2, S::near(-0.5), S::near(0.5)).unwrap() & rod;
    let (expected, of_plate) = (seen(&rod, &straight, 9), seen(&plate, &straight, 9));
    assert!(expected[4][4] && !expected[0][0]);
    let smallest = if S::IS_FIXED { 5 } else { 44 };
    // From 10⁻³ on (10⁻⁸ in floating point, whose pixel centres are not on the edges by a hair).
    for exponent in if S::IS_FIXED { 3 } else { 8 }..=smallest {
        let along = [1.0, 0.0, 10f64.powi(-exponent)];
        let camera = Orthographic::look_along(vector(along), Vec3::ZERO, up(), four).unwrap();
        assert_eq!(seen(&rod, &camera, 9), expected, "1e-{exponent} off the axis");
        assert_eq!(seen(&plate, &camera, 9), of_plate, "1e-{exponent} off the plane");
        let eye = vector(along.map(|x| -20.0 * x));
        let camera = Perspective::look_at(eye, Vec3::ZERO, up(), S::near(0.2)).unwrap();
        assert!(seen(&rod, &camera, 9)[4][4], "1e-{exponent} off the axis");
    }
}

/// An X-ray of what is behind the eye as well would be too bright.
fn an_x_ray_begins_at_the_eye<S: Tested>() {
    let ball = ball::<S>([0.0; 3], 2.0);
    let eye = vector([0.0, 0.0, 1.0]);
    let camera = Perspective::look_at(eye, Vec3::ZERO, up(), S::near(0.125)).unwrap();
    let size = Size::new(1, 1).unwrap();
    let mut picture =
        Picture::new(&ball, &camera, size, XRay::new(S::near(10.0)).unwrap(), Gray8(0));
    let mut pixel = [Gray8(0)];
    picture.scanline(0).unwrap().render(&mut pixel).unwrap();
    // 3 of the ball's 4 units are in front of the eye: 0.3 · 255 is 76.5, rounded either way in
    // fixed point, whose 1/10 is a little more or less than that.
    assert!(pixel == [Gray8(77)] || S::IS_FIXED && pixel == [Gray8(76)], "{pixel:?}");
}

fn span<S: Tested>(enter: S, exit: S, face: u16) -> Span<S> {
    let at = |t| Crossing { t, face: Face(face) };
    Span { enter: at(enter), exit: at(exit) }
}

/// Which face is seen where two coincide must not depend on anything but the order of operands.
fn of_two_faces_in_one_place_the_left_one_counts<S: Tested>() {
    let (one, two) = (S::ONE, S::near(2.0));
    for operation in [Operation::UNION, Operation::INTERSECTION] {
        let mut list = SpanList::<S, 3>::new();
        let mut stack = list.stack();
        stack.push(span(one, two, 7)).unwrap();
        stack.push(span(one, two, 9)).unwrap();
        merge(operation, &mut stack, 0, 1).unwrap();
        assert_eq!(*list, [span(one, two, 7)]);
    }
}

/// NaN can be ordered before nothing and after nothing: a walk that waits for one to be the
/// smaller never ends. A list without room is an error, and keeps what it had.
fn a_merge_ends_whatever_it_is_given<S: Tested>() {
    let mut odd = vec![S::LOWEST, S::HIGHEST, S::ONE, S::ONE.negated()];
    odd.extend(S::NO_NUMBERS.first());
    let n = odd.len();
    for operation in [Operation::UNION, Operation::INTERSECTION, Operation::DIFFERENCE] {
        for i in 0..n.pow(4) {
            let [a, b, c, d] = [i % n, i / n % n, i / n / n % n, i / n / n / n].map(|i| odd[i]);
            let mut list = SpanList::<S, 4>::new();
            let mut stack = list.stack();
            stack.push(span(a, b, 0)).unwrap();
            stack.push(span(c, d, 0)).unwrap();
            merge(operation, &mut stack, 0, 1).unwrap();
            assert!(list.len() <= 2);
        }
    }
    let of = |a: f64, b: f64| span(S::near(a), S::near(b), 0);
    let mut list = SpanList::<S, 2>::new();
    let mut stack = list.stack();
    stack.push(of(0.0, 1.0)).unwrap();
    stack.push(of(0.5, 3.0)).unwrap();
    assert!(stack.push(of(4.0, 5.0)).is_err());
    assert!(merge(Operation::UNION, &mut stack, 0, 1).is_err());
    assert_eq!(*list, [of(0.0, 1.0), of(0.5, 3.0)]);
}

/// Asks a row in every column, and wants nothing outside of its extent.
fn check_extents<S, T, R>(solid: &T, rays: &R, size: Size) -> Result<(), TestCaseError>
where
    S: Tested,
    R: Rays<Scalar = S>,
    T: Leaf<R, Scalar = S, Spans = [Span<S>; 1]>,
{
    let view = solid.view(rays);
    let (columns, rows) = (size.width().into(), size.height().into());
    for y in 0..rows {
        let y = from_middle(y, rows);
        let mut row = T::Row::EMPTY;
        let extent = solid.row(&view, y, columns, &mut row);
        let is_in_row = solid.is_in_rows(&view, [y; 2]);
        for index in 0..columns {
            if !(is_in_row && extent.contains(index)) {
                let mut spans = [Span::whole_line(Face(0))];
                let x = from_middle(index, columns);
                solid.spans(&view, &row, x, &mut spans);
                prop_assert!(Span::new(spans[0].enter, spans[0].exit).is_none(), "{x}, {y}");
            }
        }
    }
    Ok(())
}

/// A row may be asked in too many columns, never in too few: with solids of any size, near the
/// picture's middle or far from it, in pixels of any size.
fn extents_cut_nothing_off<S: Tested>() {
    let decades = if S::IS_FIXED { -2..=2i32 } else { -9..=9 };
    proptest!(ProptestConfig::with_cases(100), |(
        size in decades, way in direction(), along in direction(), away in direction(),
        far in prop_oneof![Just(0.3f64), Just(1.0), Just(30.0), Just(1e4)],
        radius in 0.01..1.0f64, zoom in prop_oneof![Just(3.0), Just(0.3), Just(0.01)],
    )| {
        let unit = 10f64.powi(size);
        let times = |v: [f64; 3], k: f64| v.map(|x| x * k);
        // Beyond the number type's reach, there is no such picture.
        let far = far.min(0.2 * S::MAX_COORDINATE.to_f64() / unit);
        let target = times(away, far * unit);
        // A coarse grid has no radius that small.
        let radius = (radius * unit).max(S::MIN_RADIUS.to_f64());
        let rod = between::<S>([0.0; 3], times(way, unit), radius);
        let ball = ball::<S>([0.0; 3], radius);
        let frame = S::near(zoom * unit * far.max(1.0));
        let picture = Size::new(64, 24).unwrap();
        let camera = Orthographic::look_along(vector(along), vector(target), up(), frame);
        if let Ok(camera) = camera {
            check_extents(&rod, &camera.rays(picture), picture)?;
            check_extents(&ball, &camera.rays(picture), picture)?;
        }
        let eye: [f64; 3] = std::array::from_fn(|i| target[i] - along[i] * unit * far.max(3.0));
        let camera = Perspective::look_at(vector(eye), vector(target), up(), S::near(0.8));
        if let Ok(camera) = camera {
            check_extents(&rod, &camera.rays(picture), picture)?;
            check_extents(&ball, &camera.rays(picture), picture)?;
        }
    });
}

/// Runs cover each column once, and their pixels are those of the whole row: what is said to be
/// background is background.
fn a_row_is_its_runs<S: Tested>() {
    let part = (rod::<S>(0.5, -1.0, 1.0) | rod(0.25, -1.5, 1.5)) - rod(0.125, -2.0, 2.0);
    let eye = vector([1.0, 2.0, 5.0]);
    let camera = Perspective::look_at(eye, Vec3::ZERO, up(), S::ONE).unwrap();
    let size = Size::new(41, 30).unwrap();
    let mut picture = Picture::new(&part, &camera, size, XRay::new(S::ONE).unwrap(), Gray8(9));
    let (mut has_background, mut has_part) = (false, false);
    for y in 0..30 {
        let mut scanline = picture.scanline(y).unwrap();
        let [mut whole, mut pieces] = [[Gray8(1); 41], [Gray8(2); 41]];
        scanline.render(&mut whole).unwrap();
        let mut next = 0;
        while let Some(run) = scanline.run(next) {
            assert!(run.columns.start == next && run.columns.end > next, "{run:?}");
            next = run.columns.end;
            let columns = usize::from(run.columns.start)..usize::from(run.columns.end);
            has_background |= run.is_background;
            has_part |= !run.is_background;
            scanline.render_run(&run, &mut pieces[columns]).unwrap();
        }
        assert_eq!((whole, next), (pieces, 41));
    }
    assert!(has_background && has_part);
}
