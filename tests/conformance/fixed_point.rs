//! What only fixed point can get wrong: the ends of its range, where sums wrap round or panic, and
//! the size of its unit, which is the same for large numbers and for small ones.

use crate::number::{Tested, ball, between, coordinates, ray, rod, spans, vector};
use fixed::types::{I8F24, I24F8};
use proptest::prelude::*;
use scancsg::constant;
use scancsg::geom::{Ray, RayError, Rays, Vec3, vec3};
use scancsg::render::{
    Camera, CameraError, Depth, Gray8, Lambert, Orthographic, Perspective, Picture, RowError,
    Shader, Size, XRay,
};
use scancsg::scalar::{I16F16, Number, Scalar};
use scancsg::solid::{
    Cylinder, CylinderWall, Difference, Intersection, RayCast, Scan, Slab, Sphere, Union,
};
use scancsg::span::{Span, SpanList};

type S = I16F16;

const UNIT: f64 = 1.0 / 65536.0;

/// In flash, written in decimals, and checked while compiling.
const PIPE: Difference<Cylinder<S>, Cylinder<S>> = Difference::new(
    constant!(Cylinder::<S>::along_x(
        S::lit("0.5"),
        S::lit("0"),
        S::lit("1.3"),
        S::lit("-2"),
        S::lit("2")
    )),
    constant!(Cylinder::<S>::between(
        vec3(S::lit("-3"), S::lit("0.5"), S::lit("0")),
        vec3(S::lit("3"), S::lit("0.5"), S::lit("0")),
        S::lit("0.7")
    )),
);

/// Decimals are rounded to the grid while compiling, not cut off: 1.3 is 85196.8 units.
#[test]
fn solids_are_constants() {
    let walls = spans(&PIPE, &ray([0.0, 5.0, 0.0], [0.0, -1.0, 0.0]));
    let at = |units: f64| 4.5 + units * UNIT;
    let [outer, inner] = [85197.0, 45875.0];
    assert_eq!(walls, [(at(-outer), at(-inner)), (at(inner), at(outer))]);
}

/// A direction of half a unit in its largest coordinate is the shortest that keeps the parameters
/// of everything within reach in the type; squares of the longest just fit 64 bits.
#[test]
fn direction_lengths() {
    fn check<S: Tested>(half: f64, longest: f64) {
        let new = |way: [f64; 3]| Ray::<S>::new(Vec3::ZERO, vector(way)).err();
        let up = |x: f64| S::near(x).up().to_f64();
        let down = |x: f64| S::near(x).down().to_f64();
        for sign in [1.0, -1.0] {
            for axis in 0..3 {
                let along =
                    |x: f64| std::array::from_fn(|i| if i == axis { sign * x } else { 0.0 });
                for good in [half, up(half), 1.0, down(longest), longest] {
                    assert_eq!(new(along(good)), None, "{good}");
                }
                for bad in [down(half), S::UNIT, up(longest)] {
                    assert_eq!(new(along(bad)), Some(RayError::DirectionLength), "{bad}");
                }
            }
        }
        // All coordinates count together with the largest one only.
        let short = down(half);
        assert_eq!(new([short, short, short]), Some(RayError::DirectionLength));
        assert_eq!(new([longest, longest, longest]), None);
        assert_eq!(new([0.0; 3]), Some(RayError::ZeroDirection));
    }
    check::<I16F16>(0.5, 16384.0);
    check::<I8F24>(0.5, 64.0);
    check::<I24F8>(0.5, 4_194_304.0);
    // −2³¹ has no absolute value.
    for axis in 0..3 {
        let lowest = std::array::from_fn(|i| if i == axis { S::MIN } else { S::ONE });
        let [x, y, z] = lowest;
        let lowest = vec3(x, y, z);
        assert_eq!(Ray::new(Vec3::ZERO, lowest).err(), Some(RayError::DirectionLength));
        assert_eq!(Ray::new(lowest, vector([1.0, 0.0, 0.0])).err(), Some(RayError::TooFar));
        assert!(Sphere::<S>::new(lowest, S::ONE).is_err());
        assert!(Cylinder::<S>::between(lowest, Vec3::ZERO, S::ONE).is_err());
    }
    assert!(Sphere::<S>::new(Vec3::ZERO, S::MIN).is_err());
    assert!(Slab::<S>::along_x(S::MIN, S::ONE).is_err());
    assert!(Slab::<S>::along_y(S::ONE, S::MAX).is_err());
    assert!(Cylinder::<S>::along_z(S::ONE, S::MIN, S::ONE, S::ZERO, S::ONE).is_err());
}

/// Squares of such coordinates have 57 bits, discriminants 120, and the farthest crossing is three
/// times the reach away, at twice that parameter.
#[test]
fn coordinates_at_reach() {
    let reach = S::MAX_COORDINATE.to_f64();
    assert_eq!(reach, 4096.0);
    let far = ball::<S>([reach; 3], reach);
    let slow = ray::<S>([-reach, reach, reach], [0.5, 0.0, 0.0]);
    assert_eq!(spans(&far, &slow), [(2.0 * reach, 6.0 * reach)]);
    for axis in 0..3 {
        let [r, low, high] = [reach, -reach, reach].map(S::near);
        let far = S::along(axis, [high; 2], r, low, high).unwrap();
        let (mut origin, mut direction) = ([reach; 3], [0.0; 3]);
        origin[axis] = 0.0;
        (origin[(axis + 1) % 3], direction[(axis + 1) % 3]) = (-reach, 0.5);
        assert_eq!(spans(&far, &ray(origin, direction)), [(2.0 * reach, 6.0 * reach)]);
        // Along the axis, with the longest direction there is: 2 · 4096 / 16384.
        let (mut origin, mut direction) = ([reach; 3], [0.0; 3]);
        (origin[axis], direction[axis]) = (-reach, 16384.0);
        assert_eq!(spans(&far, &ray(origin, direction)), [(0.0, 0.5)]);
    }
}

/// The square of the radius is 2⁵⁶ units and the chord 46 units times 4096: a unit of the distance
/// decides, and a formula that rounds its squares to 32 bits can't see it.
#[test]
fn grazing_the_largest_radius() {
    let reach = S::MAX_COORDINATE.to_f64();
    let solids = (ball::<S>([0.0; 3], reach), rod::<S>(reach, -1.0, 1.0));
    for (past, hits) in [(reach, false), (reach - UNIT, true)] {
        let graze = ray::<S>([0.0, past, -reach], [0.0, 0.0, 1.0]);
        let half = ((reach - past) * (reach + past)).sqrt();
        for ends in [spans(&solids.0, &graze), spans(&solids.1, &graze)] {
            let [(enter, exit)] = ends[..] else {
                assert!(!hits && ends.is_empty(), "{ends:?}");
                continue;
            };
            assert!(hits && (enter - (reach - half)).abs() <= 0.5 * UNIT, "{enter}");
            assert!((exit - (reach + half)).abs() <= 0.5 * UNIT, "{exit}");
        }
    }
}

/// The square of one unit is 2⁻³², which is nothing in the type itself.
#[test]
fn a_radius_of_one_unit() {
    let wire = S::along(0, [S::ONE; 2], S::near(UNIT), S::near(-1.0), S::ONE).unwrap();
    let grain = ball::<S>([0.5, 1.0, 1.0], UNIT);
    for way in [1.0, -1.0] {
        let through = ray::<S>([0.5, 1.0, 1.0 - 4.0 * way], [0.0, 0.0, way]);
        let ends = [(4.0 - UNIT, 4.0 + UNIT)];
        assert_eq!(spans(&wire, &through), ends);
        assert_eq!(spans(&grain, &through), ends);
        // A tangent.
        let beside = ray::<S>([0.5, 1.0 + UNIT, 1.0 - 4.0 * way], [0.0, 0.0, way]);
        assert_eq!(spans(&wire, &beside), []);
        assert_eq!(spans(&grain, &beside), []);
        let along = ray::<S>([-3.0 * way, 1.0, 1.0], [way, 0.0, 0.0]);
        assert_eq!(spans(&wire, &along), [(2.0, 4.0)]);
        let on_the_wall = ray::<S>([-3.0 * way, 1.0 + UNIT, 1.0], [way, 0.0, 0.0]);
        assert_eq!(spans(&wire, &on_the_wall), []);
    }
    // Its normal is made of a vector of one unit, and points out all the same.
    let hit =
        grain.hit(&ray([0.5, 1.0, -3.0], [0.0, 0.0, 1.0]), &mut SpanList::<S, 1>::new()).unwrap();
    assert_eq!(coordinates(hit.normal), [0.0, 0.0, -1.0]);
    assert_eq!(coordinates(hit.point), [0.5, 1.0, 1.0 - UNIT]);
}

/// A long direction makes parameters coarse: here one unit of them is a quarter of the scene's, and
/// all of the solid lies within half of that. It is hit, so it has a length.
#[test]
fn spans_shorter_than_a_unit() {
    let (ball, rod) = (ball::<S>([0.0; 3], 0.0625), rod::<S>(0.125, -0.0625, 0.0625));
    let plate = S::slab_along(0, S::ZERO, S::near(UNIT)).unwrap();
    for x in [-1024.25, -4.0, 0.0, 4.0, 777.0] {
        let fast = ray::<S>([x, 0.0, 0.0], [16384.0, 0.0, 0.0]);
        let middle = -x / 16384.0;
        for ends in [spans(&ball, &fast), spans(&rod, &fast), spans(&plate, &fast)] {
            let [(enter, exit)] = ends[..] else { panic!("{ends:?} at {x}") };
            assert_eq!(exit - enter, UNIT);
            assert!((enter - middle).abs() <= 1.5 * UNIT, "{enter} at {x}");
        }
        // Two solids in one unit are still two solids, and one of them twice is nothing.
        assert_eq!(spans(&(ball - ball), &fast), []);
        assert_eq!(spans(&(ball & rod), &fast).len(), 1);
        assert_eq!(spans(&(ball | rod), &fast).len(), 1);
    }
}

/// The planes of a stack of plates of one unit each are crossed at parameters that are the same
/// numbers: whichever is rounded which way, the stack is one plate.
#[test]
fn a_stack_of_plates_of_one_unit() {
    let plate = |k: i32| {
        let at = |k: i32| S::from_bits(1000 + k);
        Slab::<S>::along_x(at(k), at(k + 1)).unwrap()
    };
    let stack: [Slab<S>; 8] = std::array::from_fn(|k| plate(k as i32));
    let reversed: [Slab<S>; 8] = std::array::from_fn(|k| plate(7 - k as i32));
    let whole = Slab::<S>::along_x(S::from_bits(1000), S::from_bits(1008)).unwrap();
    for direction in [[1.0, 0.0, 0.0], [1.0, 3.0, 0.0], [-7.0, 1.0, 2.0], [100.0, 0.0, 0.0]] {
        for start in [-1.0, 0.25, 0.0] {
            let ray = ray::<S>([start, 0.0, 0.0], direction);
            let [(enter, exit)] = spans(&whole, &ray)[..] else { panic!("a miss") };
            for ends in [spans(&stack, &ray), spans(&reversed, &ray)] {
                let [(first, last)] = ends[..] else { panic!("{ends:?} for {direction:?}") };
                // A plate without a length of its own may stand out by a unit.
                let off = (first - enter).abs().max((last - exit).abs());
                assert!(off <= if direction[0] == 1.0 { 0.0 } else { UNIT }, "{ends:?}");
            }
        }
    }
}

/// A plane that is met beyond the type's range is met nowhere: the span goes on to the end of the
/// range, which is no surface, and nothing wraps round to the other side.
#[test]
fn parameters_beyond_the_range() {
    let plate = S::slab_along(0, S::near(-1.0), S::ONE).unwrap();
    let mut list = SpanList::<S, 6>::new();
    for way in [1.0, -1.0] {
        // One unit in x for each unit of length in y: the planes are at t = ±65536.
        let slow = ray::<S>([0.0, 0.0, 0.0], [way * UNIT, 1.0, 0.0]);
        let ends = |spans: &[Span<S>]| -> Vec<_> {
            spans.iter().map(|span| (span.enter.t, span.exit.t)).collect()
        };
        assert_eq!(ends(plate.trace(&slow, &mut list)), [(S::LOWEST, S::HIGHEST)]);
        assert_eq!(plate.hit(&slow, &mut list), None);
        // From beside one plane: that one is met, the other isn't.
        let near = ray::<S>([1.0 - 8.0 * UNIT, 0.0, 0.0], [way * UNIT, 1.0, 0.0]);
        let [span] = plate.trace(&near, &mut list) else { panic!("a miss") };
        let (met, not_met, at, end) = if way > 0.0 {
            (span.exit.t, span.enter.t, 8.0, S::LOWEST)
        } else {
            (span.enter.t, span.exit.t, -8.0, S::HIGHEST)
        };
        assert_eq!((met.to_f64(), not_met), (at, end));
        // What is left of it beside a ball ends at the ball, and at nothing else.
        let ball = ball::<S>([0.0, 2.0, 0.0], 1.0);
        let rest = Difference::new(plate, ball);
        let [before, after] = ends(rest.trace(&slow, &mut list))[..] else { panic!("not two") };
        assert_eq!((before.0, after.1), (S::LOWEST, S::HIGHEST));
        assert_eq!((before.1.to_f64(), after.0.to_f64()), (1.0, 3.0));
        assert_eq!(spans(&(plate - plate), &slow), []);
        let hit = rest.hit(&slow, &mut list).unwrap();
        assert_eq!((hit.t.to_f64(), hit.inside), (1.0, true));
    }
}

/// As a plate, a wall and a ball at the end of the reach: every level takes away and adds faces in
/// the same place, whose parameters have no bit to spare.
#[test]
fn nested_differences_at_reach() {
    let reach = S::MAX_COORDINATE.to_f64();
    let (a, b) = (rod::<S>(1.0, reach - 4.0, reach), rod::<S>(1.0, reach - 4.0, reach - 2.0));
    for [origin, direction] in [
        [[reach - 3.0, 0.25, reach], [0.0, 0.0, -0.5]],
        [[-reach, 0.5, 0.0], [0.5, 0.0, 0.0]],
        [[-reach, 0.5, 0.0], [1.0, 0.0, UNIT]],
        [[reach, reach, 0.0], [-0.5 * UNIT, -0.5, 0.0]],
    ] {
        let ray = ray::<S>(origin, direction);
        assert_eq!(spans(&a, &ray).len(), 1, "{origin:?}");
        assert_eq!(spans(&(a - (a - b)), &ray), spans(&(a & b), &ray));
        assert_eq!(spans(&(a - (a - (a - b))), &ray), spans(&(a - b), &ray));
        assert_eq!(spans(&((a - b) | b), &ray), spans(&a, &ray));
        assert_eq!(spans(&((a - b) & b), &ray), []);
        assert_eq!(spans(&((a | b) - (b | a)), &ray), []);
    }
}

/// An axis between two points is known to 2⁻²⁸, and a cylinder of 6,000 units of length has its far
/// end where it should be: an axis rounded to 2⁻¹⁶ would miss it by a twentieth of a unit.
#[test]
fn a_long_oblique_cylinder() {
    let (from, to) = ([-2400.0, -1800.0, 600.0], [2400.0, 2100.0, -900.0]);
    let needle = between::<S>(from, to, 0.01);
    // Across the axis near its far end, through a point of it.
    for part in [0.0001, 0.3, 0.5, 0.9, 0.9999] {
        let on_axis: [f64; 3] = std::array::from_fn(|i| from[i] + part * (to[i] - from[i]));
        let origin = [on_axis[0], on_axis[1], on_axis[2] + 50.0];
        let hits = spans(&needle, &ray(origin, [0.0, 0.0, -1.0]));
        let [(enter, exit)] = hits[..] else { panic!("a miss at {part}") };
        assert!((0.5 * (enter + exit) - 50.0).abs() < 1e-3, "{enter} {exit} at {part}");
    }
}

/// Other formats have other units, and the same pictures.
#[test]
fn other_formats_see_the_same_part() {
    crate::pictures::check_tee_in::<I8F24>();
    crate::pictures::check_tee_in::<I24F8>();
}

// Nothing wraps, and nothing panics: any numbers of the type go in.

fn any_number() -> BoxedStrategy<S> {
    prop_oneof![
        2 => -8..=8i32,
        3 => (0..31u32, any::<i32>()).prop_map(|(cut, x)| x >> cut),
        2 => any::<i32>(),
        1 => prop::sample::select(vec![
            i32::MIN, i32::MIN + 1, i32::MAX, 1 << 28, -(1 << 28), 1 << 30, -(1 << 30), 1 << 16, 1 << 15,
        ]),
    ]
    .prop_map(S::from_bits)
    .boxed()
}

/// Mostly those that constructors take.
fn in_reach() -> BoxedStrategy<S> {
    let reach = S::MAX_COORDINATE;
    any_number().prop_map(move |x| if x > reach || x < -reach { x >> 4u32 } else { x }).boxed()
}

fn any_vector() -> BoxedStrategy<Vec3<S>> {
    [any_number(), any_number(), any_number()].prop_map(|[x, y, z]| vec3(x, y, z)).boxed()
}

fn point_in_reach() -> BoxedStrategy<Vec3<S>> {
    [in_reach(), in_reach(), in_reach()].prop_map(|[x, y, z]| vec3(x, y, z)).boxed()
}

fn any_cylinder() -> BoxedStrategy<Cylinder<S>> {
    let along = (0..3usize, [in_reach(), in_reach()], in_reach(), in_reach(), in_reach())
        .prop_filter_map("not one", |(axis, middle, radius, low, high)| {
            S::along(axis, middle, radius, low, high).ok()
        });
    let between = (point_in_reach(), point_in_reach(), in_reach())
        .prop_filter_map("not one", |(from, to, radius)| S::between(from, to, radius).ok());
    prop_oneof![along, between].boxed()
}

type Anything = Union<Difference<[Cylinder<S>; 2], Sphere<S>>, Intersection<Slab<S>, Cylinder<S>>>;

fn anything() -> BoxedStrategy<Anything> {
    let sphere = (point_in_reach(), in_reach())
        .prop_filter_map("not one", |(center, radius)| S::sphere(center, radius).ok());
    let slab = (any_vector(), in_reach(), in_reach())
        .prop_filter_map("not one", |(normal, low, high)| S::slab(normal, low, high).ok());
    ([any_cylinder(), any_cylinder()], sphere, slab, any_cylinder())
        .prop_map(|(two, sphere, slab, third)| {
            Union::new(Difference::new(two, sphere), Intersection::new(slab, third))
        })
        .boxed()
}

fn is_regular(spans: &[Span<S>]) -> bool {
    spans.iter().all(|span| span.enter.t < span.exit.t)
        && spans.windows(2).all(|pair| pair[0].exit.t < pair[1].enter.t)
}

#[test]
fn any_ray_gets_an_answer() {
    let solids = (anything(), any_cylinder());
    proptest!(|((solid, cylinder) in solids, origin in point_in_reach(), way in any_vector())| {
        let Ok(ray) = Ray::new(origin, way) else {
            return Err(TestCaseError::reject("no ray"));
        };
        let mut list = SpanList::<S, 16>::new();
        prop_assert!(is_regular(solid.trace(&ray, &mut list)), "{list:?}");
        if let Some(hit) = solid.hit(&ray, &mut list) {
            prop_assert!(hit.t >= 0 && hit.t < S::HIGHEST, "{hit:?}");
        }
        if let Some(hit) = CylinderWall::of(&cylinder).hit(&ray) {
            prop_assert!(hit.t >= 0 && hit.t < S::HIGHEST, "{hit:?}");
        }
    });
}

/// Some pixels of a picture, with every shader.
fn check_picture<C>(
    solid: &Anything,
    camera: &C,
    size: [u16; 2],
    [a, b, c]: [S; 3],
    light: Vec3<S>,
) -> Result<(), TestCaseError>
where
    C: Camera<Rays: Rays<Scalar = S>>,
    Anything: Scan<C::Rays, Scalar = S>,
{
    fn check<C, H: Shader<S>>(
        solid: &Anything,
        camera: &C,
        [width, height]: [u16; 2],
        shader: H,
    ) -> Result<(), TestCaseError>
    where
        C: Camera<Rays: Rays<Scalar = S>>,
        Anything: Scan<C::Rays, Scalar = S>,
    {
        let size = Size::new(width, height).unwrap();
        let mut picture = Picture::new(solid, camera, size, shader, Gray8(7));
        let mut list = SpanList::<S, 16>::new();
        for y in [0, height / 2, height - 1] {
            let mut scanline = match picture.scanline(y) {
                Err(RowError::Range) => return Ok(()),
                scanline => scanline.unwrap(),
            };
            let mut row = vec![Gray8(0); width.into()];
            scanline.render(&mut row).unwrap();
            for x in [0, 1, width / 3, width / 2, width - 1] {
                let x = x.min(width - 1);
                let spans = scanline.spans(x, &mut list);
                prop_assert!(is_regular(spans), "{spans:?}");
                let is_seen = scanline.seen(x).is_some();
                prop_assert!(is_seen || row[usize::from(x)] == Gray8(7));
            }
        }
        Ok(())
    }
    if let Ok(shader) = Lambert::new(light, a) {
        check(solid, camera, size, shader)?;
    }
    if let Ok(shader) = Depth::new(b, c) {
        check(solid, camera, size, shader)?;
    }
    if let Ok(shader) = XRay::new(b) {
        check(solid, camera, size, shader)?;
    }
    Ok(())
}

#[test]
fn any_picture_can_be_taken() {
    let views = (point_in_reach(), point_in_reach(), any_vector(), any_vector());
    let sizes = prop_oneof![
        4 => Just([9, 5]),
        1 => Just([1, 1]),
        1 => Just([4000, 1]),
        1 => Just([1, u16::MAX]),
    ];
    // Of any size, since most of the largest ones show more than the range.
    let frame = (any_number(), 0..24u32).prop_map(|(x, drop)| S::from_bits(x.to_bits() >> drop));
    proptest!(ProptestConfig::with_cases(300), |(
        solid in anything(), (eye, target, way, up) in views, frame in frame,
        numbers in [any_number(), any_number(), any_number()], light in any_vector(), size in sizes,
    )| {
        if let Ok(camera) = Orthographic::look_along(way, target, up, frame) {
            check_picture(&solid, &camera, size, numbers, light)?;
        }
        if let Ok(camera) = Orthographic::look_at(eye, target, up, frame) {
            check_picture(&solid, &camera, size, numbers, light)?;
        }
        let field = S::from_bits(frame.to_bits() & 0x3_ffff);
        if let Ok(camera) = Perspective::look_at(eye, target, up, field) {
            check_picture(&solid, &camera, size, numbers, light)?;
        }
    });
}

/// A unit of the parameter past an oblique axis, what is left of the way from there is rounding errors, along
/// the axis for the most part.
#[test]
fn a_point_near_an_oblique_axis() {
    let at = |bits: [i32; 3]| Vec3::from(bits.map(S::from_bits));
    let rod = Cylinder::<S>::between(Vec3::ZERO, at([-3, -5, 11]), S::from_bits(17)).unwrap();
    let ray =
        Ray::new(at([-4_988_369, 5_665_011, -4_961_162]), at([1_662_788, -1_888_340, 1_653_727]));
    let hit = rod.hit(&ray.unwrap(), &mut SpanList::<S, 1>::new()).unwrap();
    let length = coordinates(hit.normal).iter().map(|x| x * x).sum::<f64>().sqrt();
    assert!((length - 1.0).abs() < 0.1, "{hit:?}");
}

/// Directions of pixels far to the side are as exact as any, up to where the type of their coordinates
/// ends; wider pictures are errors.
#[test]
fn very_wide_pictures() {
    fn seen<S: Tested>(width: u16) -> Result<Vec<Option<f64>>, RowError> {
        let rod = S::along(1, [-4.0, 0.75].map(S::near), S::near(0.5), S::near(-1.0), S::ONE);
        let part = rod.unwrap() | ball::<S>([4.0, 0.0, 0.5], 1.0);
        let [eye, target] = [[0.0, 0.0, 1.0], [0.0; 3]].map(vector);
        let camera =
            Perspective::look_at(eye, target, vector([0.0, 1.0, 0.0]), S::near(0.5)).unwrap();
        let size = Size::new(width, 1).unwrap();
        let mut picture = Picture::new(&part, &camera, size, XRay::new(S::ONE).unwrap(), Gray8(0));
        let mut row = picture.scanline(0)?;
        Ok((0..width).map(|x| row.seen(x).map(|seen| seen.t.to_f64())).collect())
    }
    // A pixel is 0.51 wide at distance 1, so that 27 of them and the height are just beyond 7 together.
    for width in [25, 26] {
        let (fixed, exact) = (seen::<I16F16>(width).unwrap(), seen::<f64>(width).unwrap());
        let mut far = 0;
        for (column, (fixed, exact)) in fixed.iter().zip(&exact).enumerate() {
            let sideways = (column as f64 + 0.5 - f64::from(width) / 2.0).abs() * 0.51;
            let (Some(fixed), Some(exact)) = (fixed, exact) else {
                assert_eq!(fixed.is_some(), exact.is_some(), "column {column} of {width}");
                continue;
            };
            let off = (fixed - exact).abs();
            assert!(off <= 2.0 * UNIT, "column {column} of {width}: {fixed} not {exact}");
            far += u32::from(sideways > 4.0);
        }
        assert!(far > 4, "only {far} of {width} to the side");
    }
    for width in [27, 28, 30, 32, 34, 60, 64, 126, 128, 256, 260, u16::MAX] {
        assert_eq!(seen::<I16F16>(width), Err(RowError::Range), "{width}");
        assert!(seen::<f64>(width).is_ok() && seen::<f32>(width).is_ok(), "{width}");
    }
}

/// A square picture of so large a field of view would be too wide.
#[test]
fn very_wide_fields_of_view() {
    fn look<S: Tested>(field_of_view: f64) -> Option<CameraError> {
        let [eye, target, up] = [[0.0, 0.0, 1.0], [0.0; 3], [0.0, 1.0, 0.0]].map(vector);
        Perspective::<S>::look_at(eye, target, up, S::near(field_of_view)).err()
    }
    let widest = 2.0 * 3.5f64.atan();
    assert_eq!(look::<I16F16>(widest - 1e-4), None);
    for field_of_view in [widest + 1e-4, 2.8, 3.0] {
        assert_eq!(look::<I16F16>(field_of_view), Some(CameraError::FieldOfView));
        assert_eq!((look::<f32>(field_of_view), look::<f64>(field_of_view)), (None, None));
    }
}

/// Coordinates in the image plane would stop at the end of the range, and rays be others than their pixels'.
#[test]
fn pictures_wider_than_the_range() {
    fn first_row<S: Tested>(width: u16, height: u16) -> Option<RowError> {
        let part = ball::<S>([0.0; 3], 1.0);
        // So far away that directions to the side are short.
        let (eye, target, up) = ([0.0, 0.0, 3000.0], [0.0; 3], [0.0, 1.0, 0.0]);
        let size = Size::new(width, height).unwrap();
        let shader = XRay::new(S::ONE).unwrap();
        let angle = S::near(2.0 * (50.0f64 / 3000.0).atan());
        let eyes = Perspective::look_at(vector(eye), vector(target), vector(up), angle).unwrap();
        let seen = Picture::new(&part, &eyes, size, shader, Gray8(0)).scanline(0).err();
        let along = Orthographic::look_at(vector(eye), vector(target), vector(up), S::near(100.0));
        let mut picture = Picture::new(&part, &along.unwrap(), size, shader, Gray8(0));
        picture.prepare();
        assert_eq!(picture.scanline(0).err(), seen);
        seen
    }
    // 100 units high, and 32,500 or 33,000 wide.
    assert_eq!(first_row::<I16F16>(650, 2), None);
    assert_eq!(first_row::<I16F16>(660, 2), Some(RowError::Range));
    assert_eq!(first_row::<I16F16>(u16::MAX, 1), Some(RowError::Range));
    assert_eq!(first_row::<I24F8>(660, 2), None);
    assert_eq!(first_row::<f32>(u16::MAX, 1), None);
}
