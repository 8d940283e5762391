//! Solids that are asked line by line: what their bounds leave out can't be seen, and more than one span
//! is walked like the list says.

use crate::aim::{direction, up};
use crate::number::{Tested, ball, between, vector};
use proptest::prelude::*;
use scancsg::geom::{Rays, Vec3};
use scancsg::render::{Camera, Gray8, Orthographic, Perspective, Picture, Size, XRay};
use scancsg::solid::{Bounds, ByLine, Difference, Many, Placed, Scan, Slab, Solid, Sphere, Union};
use scancsg::span::{Face, Shape, SpanList};
use testkit::says::Says;

for_every_number!(bounds_cut_nothing_off, two_spans_on_either_side, many_is_an_array,);

const SIZE: [u16; 2] = [40, 30];

/// The spans of every pixel.
fn spans<S, T, C>(solid: &T, camera: &C) -> Option<Vec<Vec<[S; 2]>>>
where
    S: Tested,
    C: Camera<Rays: Rays<Scalar = S>>,
    T: Solid<Scalar = S> + Scan<C::Rays>,
{
    let size = Size::new(SIZE[0], SIZE[1]).unwrap();
    let mut picture = Picture::new(solid, camera, size, XRay::new(S::ONE).unwrap(), Gray8(0));
    let mut all = Vec::new();
    for y in 0..SIZE[1] {
        let mut row = picture.scanline(y).ok()?;
        for x in 0..SIZE[0] {
            let mut list = SpanList::<S, 32>::new();
            let spans = row.spans(x, &mut list);
            all.push(spans.iter().map(|span| [span.enter.t, span.exit.t]).collect());
        }
    }
    Some(all)
}

/// The spans of every pixel in a picture of either camera.
fn seen<S, T>(solid: &T, along: [f64; 3], zoom: f64) -> [Option<Vec<Vec<[S; 2]>>>; 2]
where
    S: Tested,
    T: Solid<Scalar = S>,
    T: Scan<scancsg::geom::OrthographicRays<S>> + Scan<scancsg::geom::PerspectiveRays<S>>,
{
    let (target, frame) = (Vec3::ZERO, S::near(zoom));
    let from_far = Orthographic::look_along(vector(along), target, up(), frame);
    let eye = vector(along.map(|way| -way * 3.0));
    let from_eye = Perspective::look_at(eye, target, up(), S::near(0.9));
    [
        from_far.ok().and_then(|camera| spans(solid, &camera)),
        from_eye.ok().and_then(|camera| spans(solid, &camera)),
    ]
}

/// Two solids have the same spans in pictures of both cameras.
fn check<S, A, B>(a: &A, b: &B, along: [f64; 3], zoom: f64) -> Result<(), TestCaseError>
where
    S: Tested,
    A: Solid<Scalar = S>,
    A: Scan<scancsg::geom::OrthographicRays<S>> + Scan<scancsg::geom::PerspectiveRays<S>>,
    B: Solid<Scalar = S>,
    B: Scan<scancsg::geom::OrthographicRays<S>> + Scan<scancsg::geom::PerspectiveRays<S>>,
{
    prop_assert_eq!(seen(a, along, zoom), seen(b, along, zoom));
    Ok(())
}

/// With a ball, with a box, moved, or without bounds: the same pictures.
fn bounds_cut_nothing_off<S: Tested>() {
    let place = || [-1f64..1.0, -1f64..1.0, -1f64..1.0];
    proptest!(ProptestConfig::with_cases(40), |(
        from in place(), way in direction(), r in 0.01..0.8f64, along in direction(), zoom in 0.2..6f64,
    )| {
        let to: [f64; 3] = std::array::from_fn(|i| from[i] + way[i]);
        let rod = between::<S>(from, to, r);
        let everywhere = ByLine::<_, 1>::new(Says(rod, Bounds::Unbounded));
        let want = seen(&everywhere, along, zoom);
        prop_assert_eq!(&seen(&ByLine::<_, 1>::new(rod), along, zoom), &want);
        // A box around both ends, with room for the radius and for rounding.
        let corner = |of: fn(f64, f64) -> f64, room: f64| {
            vector(std::array::from_fn(|i| of(from[i], to[i]) + room))
        };
        let around = Bounds::Box {
            low: corner(f64::min, -r - 0.001),
            high: corner(f64::max, r + 0.001),
        };
        prop_assert_eq!(&seen(&ByLine::<_, 1>::new(Says(rod, around)), along, zoom), &want);
        let pose = S::translation(vector([0.5, -0.25, 0.125])).unwrap();
        let (moved, all) = (Placed::new(rod, pose), Placed::new(Says(rod, Bounds::Unbounded), pose));
        check(&ByLine::<_, 1>::new(moved), &ByLine::<_, 1>::new(all), along, zoom)?;
    });
}

type Shell<S> = Difference<Sphere<S>, Sphere<S>>;

/// A shell has two spans. It works as either operand, and inside of groups.
fn two_spans_on_either_side<S: Tested>() {
    const STACK: usize = <Shell<scancsg::scalar::I16F16> as Shape>::STACK;
    let shell: Shell<S> = ball::<S>([0.25, 0.0, 0.0], 1.0) - ball([0.25, 0.0, 0.0], 0.75);
    let by_line = ByLine::<_, STACK>::new(shell);
    let slab: Slab<S> = S::slab_along(0, S::near(-0.5), S::near(0.5)).unwrap();
    let rod = between::<S>([-2.0, 0.1, 0.2], [2.0, 0.3, -0.1], 0.4);
    let along = [-1.0, -2.0, -3.0];
    let all = ByLine::<_, 32>::new(Says(shell, Bounds::Unbounded));
    check(&(by_line - slab), &(all - slab), along, 3.0).unwrap();
    check(&(rod - by_line), &(rod - all), along, 3.0).unwrap();
    check(&[by_line, by_line], &[all, all], along, 3.0).unwrap();
    // What the walk says is what the list of the same line says.
    let size = Size::new(SIZE[0], SIZE[1]).unwrap();
    let camera = Orthographic::look_along(vector(along), Vec3::ZERO, up(), S::near(3.0)).unwrap();
    let (rays, union) = (camera.rays(size), Union::new(by_line, rod));
    let got = spans(&ByLine::<_, 32>::new(Says(union, Bounds::Unbounded)), &camera).unwrap();
    let mut several = 0;
    for (index, spans) in got.iter().enumerate() {
        use scancsg::geom::RayRow;
        let (x, y) = (index % usize::from(SIZE[0]), index / usize::from(SIZE[0]));
        let [x, y] = [[x, SIZE[0].into()], [y, SIZE[1].into()]]
            .map(|[at, count]| crate::aim::from_middle(at as u32, count as u32));
        let mut list = SpanList::<S, 32>::new();
        union.spans(&rays.row(y).line(x), Face(0), &mut list.stack());
        let want: Vec<_> = list.iter().map(|span| [span.enter.t, span.exit.t]).collect();
        several += u32::from(want.len() > 1);
        assert_eq!(spans, &want);
    }
    assert!(several > 20, "{several}");
}

/// Room that isn't used shows nothing.
fn many_is_an_array<S: Tested>() {
    let rods = [
        between::<S>([-1.0, 0.0, 0.0], [1.0, 0.0, 0.25], 0.5),
        between::<S>([0.0, -1.0, 0.0], [0.25, 1.0, 0.0], 0.25),
        between::<S>([0.0, 0.0, -1.0], [0.0, 0.25, 1.0], 0.125),
    ];
    let mut many = Many::<_, 8>::new(rods[0]);
    assert!(many.push(rods[1]).is_ok() && many.push(rods[2]).is_ok());
    assert_eq!(many.as_slice(), rods);
    assert_eq!(Many::<_, 8>::from_slice(&rods), Ok(many));
    check(&many, &rods, [-1.0, -2.0, -3.0], 3.0).unwrap();
    let mut full = Many::<_, 3>::from_slice(&rods).unwrap();
    assert!(full.push(rods[0]).is_err());
    assert_eq!(full.as_mut_slice(), rods);
    assert!(Many::<Sphere<S>, 3>::from_slice(&[]).is_err());
}
