//! Pictures of scaled solids: what each pixel sees is what a single ray meets, which is held against exact
//! arithmetic elsewhere; normals, bounds, nesting, and bad input.

use proptest::prelude::*;
use scancsg::constant;
use scancsg::geom::{
    AffineError, AffineMap, OrthographicRays, PerspectiveRays, Pose, Rays, Vec3, vec3,
};
use scancsg::render::{Camera, Gray8, Orthographic, Perspective, Picture, Size, XRay};
use scancsg::scalar::I16F16;
use scancsg::solid::{
    Bounds, ByLine, Cylinder, Difference, Painted, Placed, RayCast, Rgb, Scaled, Scan, Shape,
    Solid, Sphere,
};
use scancsg::span::{Face, SpanList};
use testkit::number::{Tested, ball, between, coordinates, ray, rod, vector};
use testkit::vector::{V, dot, length, sub};

for_every_number!(
    pictures_show_what_rays_meet,
    scaled_alike_is_a_larger_ball,
    mirrored_twice_is_itself,
    normals_are_at_right_angles_to_the_surface,
    bounds_hold_the_solid,
    nested_with_other_wrappers,
    a_common_face_stays_one,
    what_is_no_map,
);

/// In fixed point, own frames are this much larger than the scene: their units are as much smaller there.
const LARGER: f64 = 8.0;

const SIZE: u16 = 36;

type Spans = Vec<[f64; 2]>;

/// The spans of every pixel.
fn spans<S, T, C>(solid: &T, camera: &C) -> Vec<Spans>
where
    S: Tested,
    C: Camera<Rays: Rays<Scalar = S>>,
    T: Solid<Scalar = S> + Scan<C::Rays>,
{
    let size = Size::new(SIZE, SIZE).unwrap();
    let mut picture = Picture::new(solid, camera, size, XRay::new(S::ONE).unwrap(), Gray8(0));
    let mut all = Vec::new();
    for y in 0..SIZE {
        let mut row = picture.scanline(y).unwrap();
        for x in 0..SIZE {
            let mut list = SpanList::<S, 32>::new();
            let spans = row.spans(x, &mut list).iter();
            all.push(spans.map(|span| [span.enter.t.to_f64(), span.exit.t.to_f64()]).collect());
        }
    }
    all
}

/// About the distance of neighbouring pixels in the pictures here.
const PITCH: f64 = 0.14;

/// The spans without gaps and then without spans shorter than this.
fn without_grazes(spans: &Spans, shortest: f64) -> Spans {
    let mut kept = Spans::new();
    for &[enter, exit] in spans {
        match kept.last_mut() {
            Some(last) if enter - last[1] < shortest => last[1] = exit,
            _ => kept.push([enter, exit]),
        }
    }
    kept.retain(|[enter, exit]| exit - enter >= shortest);
    kept
}

/// Two pictures are the same, but for what rounding moves: an end moves as much more than its ray as the face
/// is steep there, which the neighbours of a pixel tell. Pixels whose neighbours have another number of spans
/// are at an edge: they are left out. Where two pixels differ in their number of spans, one of them grazes a
/// face. Returns how many spans were compared.
fn same<S: Tested>(one: &[Spans], other: &[Spans], within: f64) -> Result<u32, TestCaseError> {
    let side = usize::from(SIZE);
    // The chord at a depth h in a circle of radius r is 2 √(2 r h). Rounding moves a ray by a few units. An
    // ellipsoid is nowhere flatter than a ball of a²/b: 8 at a scale of 0.5 to 2, 16 with shear.
    let grazing = 2.0 * (2.0 * 16.0 * 4.0 * S::UNIT).sqrt();
    let mut count = 0;
    for y in 1..side - 1 {
        for x in 1..side - 1 {
            let at = |x: usize, y: usize| &one[y * side + x];
            let (these, those) = (at(x, y), &other[y * side + x]);
            let around = [at(x - 1, y), at(x + 1, y), at(x, y - 1), at(x, y + 1)];
            if around.iter().any(|spans| spans.len() != these.len()) {
                continue;
            }
            if these.len() != those.len() {
                let [these, those] = [these, those].map(|spans| without_grazes(spans, grazing));
                prop_assert_eq!(these.len(), those.len(), "{}, {}: {:?} {:?}", x, y, these, those);
                continue;
            }
            for (index, (these, those)) in these.iter().zip(those).enumerate() {
                for (end, (this, that)) in these.iter().zip(those).enumerate() {
                    let steps = around.map(|spans| (spans[index][end] - this).abs());
                    let steep = steps.into_iter().fold(0.0, f64::max) / PITCH;
                    let allowed = within * (1.0 + steep);
                    prop_assert!((this - that).abs() <= allowed, "{}, {}: {} {}", x, y, this, that);
                }
                count += 1;
            }
        }
    }
    Ok(count)
}

fn cameras<S: Tested>(along: V) -> Option<(Orthographic<S>, Perspective<S>)> {
    let (target, up) = (Vec3::ZERO, vector([0.3, 1.0, 0.1]));
    let orthographic = Orthographic::look_along(vector(along), target, up, S::near(5.0)).ok()?;
    let eye = vector(along.map(|way| -6.0 * way));
    Some((orthographic, Perspective::look_at(eye, target, up, S::near(0.8)).ok()?))
}

fn check<S, A, B>(one: &A, other: &B, along: V, within: f64) -> Result<u32, TestCaseError>
where
    S: Tested,
    A: Solid<Scalar = S> + Scan<OrthographicRays<S>> + Scan<PerspectiveRays<S>>,
    B: Solid<Scalar = S> + Scan<OrthographicRays<S>> + Scan<PerspectiveRays<S>>,
{
    let Some((orthographic, perspective)) = cameras::<S>(along) else { return Ok(0) };
    let from_afar = same::<S>(&spans(one, &orthographic), &spans(other, &orthographic), within)?;
    Ok(from_afar + same::<S>(&spans(one, &perspective), &spans(other, &perspective), within)?)
}

fn direction() -> impl Strategy<Value = V> {
    [-1.0..1.0, -1.0..1.0, -1.0..1.0]
        .prop_filter("too short", |v| (0.1..=1.0).contains(&length(*v)))
        .prop_map(|v: V| v.map(|x| x / length(v)))
}

/// A scale of 0.5 to 2 each way, maybe mirrored and sheared, turned and shifted: of solids of the size `size`.
fn map<S: Tested>(size: f64) -> impl Strategy<Value = AffineMap<S>> {
    let factor = || prop_oneof![0.5..2.0, -2.0..-0.5];
    let shear = [-0.4..0.4, -0.4..0.4, -0.4..0.4];
    (factor(), factor(), factor(), shear, direction(), -3.0..3.0, [-0.8..0.8, -0.8..0.8, -0.8..0.8])
        .prop_map(move |(x, y, z, [a, b, c], axis, angle, by)| {
            let columns = [[x, 0.0, a], [b, y, 0.0], [0.0, c, z]];
            let columns = columns.map(|column| vector(column.map(|x| x / size)));
            let pose = Pose::about(vector(axis), S::near(angle)).unwrap();
            let pose = pose.then(&S::translation(vector(by)).unwrap()).unwrap();
            let stretch = AffineMap::with_columns(columns, Vec3::ZERO).unwrap();
            stretch.then(&AffineMap::of_pose(&pose).unwrap()).unwrap()
        })
}

fn size<S: Tested>() -> f64 {
    if S::IS_FIXED { LARGER } else { 1.0 }
}

fn pictures_show_what_rays_meet<S: Tested>() {
    let count = std::cell::Cell::new(0);
    let size = size::<S>();
    // A ray that grazes loses more digits than one that doesn't, and so does one along a cylinder.
    let within = if S::IS_FIXED { 40.0 * S::UNIT } else { 400.0 * S::UNIT };
    proptest!(ProptestConfig::with_cases(25), |(map in map::<S>(size), along in direction())| {
        let ball = ball::<S>([0.0; 3], size);
        let drum = rod::<S>(0.6 * size, -size, 0.7 * size);
        let bored = ball - between([-2.0 * size, 0.0, 0.0], [2.0 * size, 0.3 * size, 0.0], 0.4 * size);
        let mut seen = 0;
        let solid = Scaled::new(ball, map);
        seen += check(&solid, &ByLine::<_, 1>::new(solid), along, within)?;
        let solid = Scaled::new(drum, map);
        seen += check(&solid, &ByLine::<_, 1>::new(solid), along, within)?;
        let solid = Scaled::new(&bored, map);
        seen += check(&solid, &ByLine::<_, 8>::new(solid), along, within)?;
        count.set(count.get() + seen);
    });
    assert!(count.get() > 10_000, "{count:?}");
}

fn scaled_alike_is_a_larger_ball<S: Tested>() {
    proptest!(ProptestConfig::with_cases(20), |(along in direction(), center in direction())| {
        let size = size::<S>();
        let own = ball::<S>(center.map(|x| x * size), size);
        let factor = 1.25 / size;
        let solid = Scaled::by(own, [S::near(factor); 3]).unwrap();
        let factor = S::near(factor).to_f64();
        let center = coordinates(vector::<S>(center.map(|x| x * size)));
        let want = ball::<S>(center.map(|x| x * factor), size * factor);
        let within = if S::IS_FIXED { 40.0 * S::UNIT } else { 400.0 * S::UNIT };
        prop_assert!(check(&solid, &want, along, within)? > 50);
    });
}

/// Twice the same mirror: the same solid, and what it shows between is its mirror image.
fn mirrored_twice_is_itself<S: Tested>() {
    let part = between::<S>([-0.9, 0.2, 0.1], [0.8, 0.5, -0.3], 0.4) - ball([0.5, 0.4, 0.3], 0.4);
    let mirror = |part| Scaled::by(part, [S::near(-1.0), S::ONE, S::ONE]).unwrap();
    let once = mirror(part);
    let twice = Scaled::by(once, [S::near(-1.0), S::ONE, S::ONE]).unwrap();
    let mut list = SpanList::<S, 8>::new();
    let mut hits = 0;
    for (y, z) in
        (-20..20).flat_map(|y| (-20..20).map(move |z| (f64::from(y) / 16.0, f64::from(z) / 16.0)))
    {
        let there = ray::<S>([-4.0, y, z], [1.0, 0.0, 0.0]);
        let back = ray::<S>([4.0, y, z], [-1.0, 0.0, 0.0]);
        let want = part.hit(&there, &mut list);
        assert_eq!(twice.hit(&there, &mut list).map(|hit| hit.face), want.map(|hit| hit.face));
        let got = once.hit(&back, &mut list);
        assert_eq!(got.map(|hit| hit.face), want.map(|hit| hit.face), "{y} {z}");
        if let (Some(got), Some(want)) = (got, want) {
            assert!((got.t.to_f64() - want.t.to_f64()).abs() <= 8.0 * S::UNIT, "{got:?} {want:?}");
            let (got, want) = (coordinates(got.normal), coordinates(want.normal));
            assert!(length(sub(got, [-want[0], want[1], want[2]])) <= 64.0 * S::UNIT);
            hits += 1;
        }
    }
    assert!(hits > 200, "{hits}");
}

/// A normal is at right angles to every way between two points of the surface that are near each other.
fn normals_are_at_right_angles_to_the_surface<S: Tested>() {
    let size = size::<S>();
    let hits = std::cell::Cell::new(0);
    proptest!(|(map in map::<S>(size), towards in direction(), beside in direction())| {
        let solid = Scaled::new(ball::<S>([0.0; 3], size), map);
        let middle = coordinates(map.point(Vec3::ZERO));
        let start: V = std::array::from_fn(|i| middle[i] - 6.0 * towards[i]);
        let mut list = SpanList::<S, 1>::new();
        let hit = solid.hit(&ray(start, towards), &mut list).unwrap();
        let normal = coordinates(hit.normal);
        prop_assert!((length(normal) - 1.0).abs() <= 4.0 * S::UNIT, "{normal:?}");
        prop_assert!(dot(normal, towards) < 0.0);
        // The chord's middle is inside by the square of its length.
        let near = 0.02;
        let start: V = std::array::from_fn(|i| start[i] + near * beside[i]);
        if let Some(other) = solid.hit(&ray(start, towards), &mut list) {
            let way = sub(coordinates(other.point), coordinates(hit.point));
            let curved = 20.0 * length(way) * length(way);
            prop_assert!(dot(way, normal).abs() <= curved + 8.0 * S::UNIT, "{way:?} {normal:?}");
            hits.set(hits.get() + 1);
        }
    });
    assert!(hits.get() > 200, "{hits:?}");
}

fn bounds_hold_the_solid<S: Tested>() {
    let size = size::<S>();
    proptest!(|(map in map::<S>(size), towards in direction(), at in direction())| {
        let drum = rod::<S>(0.6 * size, -size, 0.7 * size);
        for center in [[0.0; 3], at] {
            let ball = ball::<S>(center, size);
            let Bounds::Box { low, high } = Scaled::new(ball, map).bounds() else {
                return Err(TestCaseError::fail("no box"));
            };
            // The farthest point in a direction is inside, and not by much along the axes.
            let own: V = std::array::from_fn(|i| center[i] + size * towards[i]);
            let (point, [low, high]) = (coordinates(map.point(vector(own))), [low, high].map(coordinates));
            for i in 0..3 {
                prop_assert!(low[i] <= point[i] && point[i] <= high[i]);
            }
        }
        let Bounds::Box { low, high } = Scaled::new(drum, map).bounds() else {
            return Err(TestCaseError::fail("no box"));
        };
        let own = [0.7 * size, 0.6 * size * towards[1], 0.6 * size * towards[2]];
        let (point, [low, high]) = (coordinates(map.point(vector(own))), [low, high].map(coordinates));
        prop_assert!((0..3).all(|i| low[i] <= point[i] && point[i] <= high[i]));
    });
    // Tight: a ball's box touches it.
    let egg = Scaled::by(ball::<S>([0.0; 3], 1.0), [3.0, 1.0, 2.0].map(S::near)).unwrap();
    let Bounds::Box { low, high } = egg.bounds() else { panic!("no box") };
    for (got, want) in [(high, [3.0, 1.0, 2.0]), (low, [-3.0, -1.0, -2.0])] {
        assert!(length(sub(coordinates(got), want)) <= 256.0 * S::UNIT, "{got:?}");
    }
}

/// A colour inside, a pose outside, a pose inside: all say the same.
fn nested_with_other_wrappers<S: Tested>() {
    let count = std::cell::Cell::new(0);
    let size = size::<S>();
    proptest!(ProptestConfig::with_cases(15), |(
        along in direction(), axis in direction(), by in [-0.8..0.8, -0.8..0.8, -0.8..0.8],
    )| {
        let turn = Pose::about(vector(axis), S::near(0.7)).unwrap();
        let pose = turn.then(&S::translation(vector(by)).unwrap()).unwrap();
        let stretch = AffineMap::scaling([1.5, -0.75, 1.0].map(|x| S::near(x / size))).unwrap();
        let drum = rod::<S>(0.8 * size, -size, 0.7 * size);
        let (red, blue) = (Rgb::new(255, 0, 0), Rgb::new(0, 0, 255));
        let placed = Placed::new(Scaled::new(Painted::new(drum, red), stretch), pose);
        let whole = stretch.then(&AffineMap::of_pose(&pose).unwrap()).unwrap();
        let at_once = Painted::new(Scaled::new(&drum, whole), blue);
        prop_assert_eq!(placed.color(Face(2)), Some(red));
        prop_assert_eq!(at_once.color(Face(2)), Some(blue));
        let within = if S::IS_FIXED { 40.0 * S::UNIT } else { 400.0 * S::UNIT };
        let mut seen = check(&placed, &at_once, along, within)?;
        // Turned in its own frame first, and then scaled.
        let turned = Scaled::new(Placed::new(drum, turn), stretch);
        let first = AffineMap::of_pose(&turn).unwrap().then(&stretch).unwrap();
        seen += check(&turned, &Scaled::new(&drum, first), along, within)?;
        // As an operand.
        let slab = S::slab_along(1, S::near(-0.2), S::near(0.3)).unwrap();
        seen += check(&(turned - slab), &(ByLine::<_, 1>::new(turned) - slab), along, within)?;
        seen += check(&(slab & turned), &(slab & ByLine::<_, 1>::new(turned)), along, within)?;
        let union = [turned, turned];
        seen += check(&union, &turned, along, within)?;
        count.set(count.get() + seen);
    });
    assert!(count.get() > 10_000, "{count:?}");
}

/// Two solids with one map share their own frame, and with it the bits at which a common face is crossed: no
/// film in the opening of a cup.
fn a_common_face_stays_one<S: Tested>() {
    let pixels = std::cell::Cell::new(0);
    let size = size::<S>();
    proptest!(ProptestConfig::with_cases(20), |(map in map::<S>(size), to in [-0.5..0.5, -0.5..0.5])| {
        let drum = |r: f64, low: f64| rod::<S>(r * size, low * size, size);
        let cup = Scaled::new(drum(1.0, -1.0), map) - Scaled::new(drum(0.8, 0.25), map);
        // From outside of the opening, into it.
        let own = |v: V| coordinates(map.point(vector(v.map(|x| x * size))));
        let (middle, there) = (own([1.0, 0.0, 0.0]), own([5.0, to[0], to[1]]));
        let way = sub(middle, there);
        let film = Face(4);
        for (from, aim) in [([5.0, 0.0, 0.0], to), ([3.0, to[0], to[1]], [0.1, 0.2])] {
            let (start, end) = (own(from), own([1.0, aim[0], aim[1]]));
            let ray = ray::<S>(start, sub(end, start));
            let hit = cup.hit(&ray, &mut SpanList::<S, 8>::new()).unwrap();
            prop_assert!(hit.face != film && hit.face != Face(1), "{:?}", hit);
        }
        let up = vector([0.3, 1.0, 0.1]);
        let Ok(camera) = Orthographic::look_along(vector(way), vector(middle), up, S::near(4.0)) else {
            return Ok(());
        };
        let size = Size::new(SIZE, SIZE).unwrap();
        let mut picture = Picture::new(&cup, &camera, size, XRay::new(S::ONE).unwrap(), Gray8(0));
        for y in 0..SIZE {
            let mut row = picture.scanline(y).unwrap();
            for seen in (0..SIZE).filter_map(|x| row.seen(x)) {
                prop_assert!(seen.face != film);
                pixels.set(pixels.get() + 1);
            }
        }
    });
    assert!(pixels.get() > 2000, "{pixels:?}");
}

fn what_is_no_map<S: Tested>() {
    let scale = |factors: V| AffineMap::scaling(factors.map(S::near)).err();
    assert_eq!(scale([1.0, -1.0, 0.5]), None);
    for singular in [[0.0, 1.0, 1.0], [1.0, 0.0, 1.0], [1.0, 1.0, -0.0], [0.0; 3]] {
        assert_eq!(scale(singular), Some(AffineError::Singular), "{singular:?}");
    }
    for columns in [
        [[1.0, 2.0, 3.0], [2.0, 4.0, 6.0], [0.0, 1.0, 0.0]],
        [[1.25, 2.0, -3.0], [0.5, 0.0, 1.0], [1.75, 2.0, -2.0]],
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [3.0, -2.0, 0.0]],
    ] {
        let map = AffineMap::<S>::with_columns(columns.map(vector), Vec3::ZERO);
        assert_eq!(map.err(), Some(AffineError::Singular), "{columns:?}");
    }
    for &bad in S::NO_NUMBERS {
        for place in 0..3 {
            let mut factors = [S::ONE; 3];
            factors[place] = bad;
            assert_eq!(AffineMap::scaling(factors).err(), Some(AffineError::NotFinite));
            let shift = Vec3::from(std::array::from_fn(|i| if i == place { bad } else { S::ZERO }));
            let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(vector);
            assert_eq!(AffineMap::with_columns(axes, shift).err(), Some(AffineError::NotFinite));
        }
    }
    let far = vector([0.0, S::MAX_COORDINATE.up().to_f64(), 0.0]);
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(vector);
    assert_eq!(AffineMap::<S>::with_columns(axes, far).err(), Some(AffineError::TooFar));
    let there =
        AffineMap::with_columns(axes, vector([S::MAX_COORDINATE.to_f64(), 0.0, 0.0])).unwrap();
    assert_eq!(there.then(&there).err(), Some(AffineError::TooFar));
    // So small that the inverse leaves the range.
    let tiny = AffineMap::scaling([S::ONE, S::MIN_RADIUS, S::ONE]);
    let small = tiny.and_then(|tiny| tiny.then(&tiny)).and_then(|small| small.then(&small));
    assert_eq!(small.err(), Some(AffineError::Singular));
}

const STRETCH: AffineMap<f32> = constant!(AffineMap::<f32>::scale([3.0, 1.0, -2.0]));
static EGG: Scaled<Sphere<f32>> =
    Scaled::new(constant!(Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)), STRETCH);

/// What constants have, a type parameter has, too.
macro_rules! same_map {
    ($S:ty, $numbers:expr) => {{
        let [a, b, c, d, e, f, g, h, i] = $numbers.map(<$S as Tested>::near);
        let columns = [vec3(a, b, c), vec3(d, e, f), vec3(g, h, i)];
        let shift = vec3(b, a, i);
        let constant = AffineMap::<$S>::new(columns, shift);
        prop_assert_eq!(AffineMap::with_columns(columns, shift), constant);
        prop_assert_eq!(AffineMap::scaling([a, b, c]), AffineMap::<$S>::scale([a, b, c]));
    }};
}

proptest! {
    #[test]
    fn constants_and_generic_code_agree(numbers in prop::array::uniform9(-8.0..8.0)) {
        same_map!(f32, numbers);
        same_map!(f64, numbers);
        same_map!(I16F16, numbers);
    }

    /// There and back again is where it was, within the unit of the number type times the matrix's condition.
    #[test]
    fn maps_are_inverted(numbers in prop::array::uniform9(-4.0..4.0), own in [-3.0..3.0, -3.0..3.0, -3.0..3.0]) {
        let [a, b, c, d, e, f, g, h, i] = numbers;
        let columns = [[a, b, c], [d, e, f], [g, h, i]];
        let volume = dot(columns[0], testkit::vector::cross(columns[1], columns[2]));
        prop_assume!(volume.abs() > 4.0);
        fn off<S: Tested>(columns: [V; 3], own: V) -> f64 {
            let map = AffineMap::<S>::with_columns(columns.map(vector), vector([1.0, 2.0, 3.0])).unwrap();
            let own = vector::<S>(own);
            length(sub(coordinates(map.point_back(map.point(own))), coordinates(own))) / S::UNIT
        }
        let offs = [off::<f32>(columns, own), off::<f64>(columns, own), off::<I16F16>(columns, own)];
        // The scene's point is rounded at a size of up to 40, and taken back by an inverse of up to 16.
        prop_assert!(offs.iter().all(|off| *off <= 400.0), "{offs:?}");
    }
}

#[test]
fn a_scaled_solid_is_a_constant() {
    let mut list = SpanList::<f32, 1>::new();
    for (origin, direction, t) in
        [([9.0, 0.0, 0.0], [-1.0, 0.0, 0.0], 6.0), ([0.0, 0.0, 9.0], [0.0, 0.0, -1.0], 7.0)]
    {
        let hit = EGG.hit(&ray(origin, direction), &mut list).unwrap();
        assert_eq!((hit.t, coordinates(hit.normal)), (t, direction.map(|x: f64| -x)));
    }
    type Tree = Scaled<Difference<Sphere<f32>, Cylinder<f32>>>;
    assert_eq!((Tree::SPANS, Tree::FACES), (2, 4));
}
