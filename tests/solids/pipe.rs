//! Pipes against models in `f64` that have nothing in common with the crate's way: the distance
//! from the parts of a polyline, and from a curve sampled closely.

use fixed::types::I20F12;
use scancsg::constant;
use scancsg::geom::{RayRow, Rays, Vec3, vec3};
use scancsg::render::{Camera, Gray8, Orthographic, Perspective, Picture, Size, XRay};
use scancsg::scalar::I16F16;
use scancsg::solid::{Painted, Pipe, PipeError, RayCast, Rgb, Scan, Shape, Solid};
use scancsg::span::{Face, SpanList};
use scancsg::spline::{Curve, Knots, Outside, SplineScalar};
use testkit::limits;
use testkit::number::{Tested, ball, between, coordinates, ray, spans, vector};
use testkit::random::Random;
use testkit::vector::{V, along, dot, length, sub, unit};

/// The solid as it is meant: cylinders, and in each bend what of a ball is beyond the end of one
/// and before the beginning of the next.
struct Model {
    /// Where each begins, its direction and its length.
    axes: Vec<(V, V, f64)>,
    is_closed: bool,
    radius: f64,
}

impl Model {
    fn new(points: &[V], radius: f64) -> Self {
        let axis = |from: V, to: V| (from, unit(sub(to, from)), length(sub(to, from)));
        let ends = points.windows(2).filter(|ends| ends[0] != ends[1]);
        let axes = ends.map(|ends| axis(ends[0], ends[1])).collect();
        Self { axes, is_closed: points.first() == points.last(), radius }
    }

    /// Whether a point is inside, if all parts are larger by `more` on all sides.
    fn holds(&self, point: V, more: f64) -> bool {
        let radius = self.radius + more;
        let in_cylinder = |&(from, axis, long): &(V, V, f64)| {
            let s = dot(sub(point, from), axis);
            let across = along(sub(point, from), -s, axis);
            -more <= s && s <= long + more && length(across) <= radius
        };
        let in_bend = |before: (V, V, f64), after: (V, V, f64)| {
            let u = sub(point, after.0);
            dot(u, before.1) >= -more && dot(u, after.1) <= more && length(u) <= radius
        };
        self.axes.iter().any(in_cylinder)
            || self.axes.windows(2).any(|pair| in_bend(pair[0], pair[1]))
            || self.is_closed && in_bend(self.axes[self.axes.len() - 1], self.axes[0])
    }
}

/// A number type that curves and pipes are made of.
trait Piped: Tested + SplineScalar {
    /// A clamped cubic.
    fn curve(points: [V; 6]) -> Curve<Vec3<Self>, 4, 6, 10>;
    /// A closed cubic, with the control points on a circle.
    fn ring(radius: f64) -> Curve<Vec3<Self>, 4, 11, 15>;
    fn along_curve<const K: usize, const C: usize, const N: usize, const ROOM: usize>(
        curve: &Curve<Vec3<Self>, K, C, N>,
        radius: Self,
        tolerance: Self,
    ) -> Result<Pipe<Self, ROOM>, PipeError>;
    fn through<const ROOM: usize>(
        points: &[Vec3<Self>],
        radius: Self,
    ) -> Result<Pipe<Self, ROOM>, PipeError>;
}

macro_rules! piped {
    ($($S:ty),+) => {$(
        impl Piped for $S {
            fn curve(points: [V; 6]) -> Curve<Vec3<Self>, 4, 6, 10> {
                let (from, to) = (Self::near(0.0), Self::near(3.0));
                let knots = Knots::<$S, 4, 10>::clamped_uniform(6, from, to).unwrap();
                Curve::<Vec3<$S>, 4, 6, 10>::new(knots, points.map(vector)).unwrap()
            }

            fn ring(radius: f64) -> Curve<Vec3<Self>, 4, 11, 15> {
                let breaks: Vec<Self> = (0..=8).map(|i| Self::near(f64::from(i))).collect();
                let knots = Knots::<$S, 4, 15>::periodic(&breaks).unwrap();
                let points: Vec<Vec3<Self>> = (0..8)
                    .map(|i| (f64::from(i) * std::f64::consts::FRAC_PI_4).sin_cos())
                    .map(|(sin, cos)| vector([radius * cos, 0.25, radius * sin]))
                    .collect();
                Curve::<Vec3<$S>, 4, 11, 15>::closed(knots, &points).unwrap()
            }

            fn along_curve<const K: usize, const C: usize, const N: usize, const ROOM: usize>(
                curve: &Curve<Vec3<Self>, K, C, N>,
                radius: Self,
                tolerance: Self,
            ) -> Result<Pipe<Self, ROOM>, PipeError> {
                Pipe::<$S, ROOM>::along(curve, radius, tolerance)
            }

            fn through<const ROOM: usize>(
                points: &[Vec3<Self>],
                radius: Self,
            ) -> Result<Pipe<Self, ROOM>, PipeError> {
                Pipe::<$S, ROOM>::through(points, radius)
            }
        }
    )+};
}

piped!(f32, f64, I16F16, I20F12);

const CURVES: [[V; 6]; 3] = [
    // An S with both ends along x.
    [
        [-2.0, -1.0, 0.0],
        [0.0, -1.0, 0.0],
        [2.0, -1.0, 0.5],
        [-2.0, 1.0, 0.5],
        [0.0, 1.0, 0.0],
        [2.0, 1.0, 0.0],
    ],
    // A turn of a screw.
    [
        [1.5, -1.0, 0.0],
        [1.5, -1.0, 1.5],
        [-1.5, -0.5, 1.5],
        [-1.5, 0.25, -1.5],
        [1.5, 0.75, -1.5],
        [1.5, 1.0, 0.0],
    ],
    // Straight, by way of control points that aren't evenly spaced.
    [
        [-2.0, -2.0, -1.0],
        [-1.0, -1.0, -0.5],
        [0.0, 0.0, 0.0],
        [0.5, 0.5, 0.25],
        [1.0, 1.0, 0.5],
        [2.0, 2.0, 1.0],
    ],
];

/// How far off a surface a single ray's answer may be because of rounding: of points, axes, planes
/// and parameters.
fn blur<S: Tested>() -> f64 {
    limits::PIPE.of::<S>()
}

fn vertices<S: Piped, const K: usize, const C: usize, const N: usize>(
    curve: &Curve<Vec3<S>, K, C, N>,
    tolerance: f64,
) -> Vec<V> {
    curve.flatten(S::near(tolerance)).unwrap().map(|vertex| coordinates(vertex.point)).collect()
}

/// Points on random rays, most of them near the ends of spans: they are inside of the spans if and
/// only if a model says so, wherever it says the same when larger or smaller by a rounding error.
fn agrees<S: Piped, T: Solid<Scalar = S>>(solid: &T, holds: impl Fn(V, f64) -> bool) {
    const { assert!(T::STACK <= 1024) };
    let mut random = Random::seeded(7);
    let mut list = SpanList::<S, 1024>::new();
    let mut counts = [0; 2];
    for _ in 0..if cfg!(debug_assertions) { 500 } else { 50_000 } {
        let (from, to) = (random.point(4.0), random.point(2.0));
        let (from, way) = (vector::<S>(from), vector::<S>(unit(sub(to, from))));
        let (origin, direction) = (coordinates(from), coordinates(way));
        let ray = scancsg::geom::Ray::new(from, way).unwrap();
        let spans: Vec<[f64; 2]> = solid
            .trace(&ray, &mut list)
            .iter()
            .map(|span| [span.enter.t.to_f64(), span.exit.t.to_f64()])
            .collect();
        let mut times: Vec<f64> = spans.iter().flatten().copied().collect();
        let step = 3.0 * blur::<S>();
        times = times.iter().flat_map(|t| [t - step, t + step, t + 0.01]).collect();
        times.extend([(); 12].map(|()| random.between(0.0, 8.0)));
        for t in times {
            let point = along(origin, t, direction);
            let is_inside = spans.iter().any(|[enter, exit]| *enter <= t && t <= *exit);
            let [smaller, larger] = [-1.0, 1.0].map(|sign| holds(point, sign * blur::<S>()));
            if smaller == larger {
                assert_eq!(is_inside, larger, "{origin:?} + {t}·{direction:?}: {spans:?}");
                counts[usize::from(is_inside)] += 1;
            }
        }
    }
    assert!(counts.iter().all(|&count| count > 200), "{counts:?}");
}

/// Also where segments are much shorter than the radius, and the balls of many joints would stand
/// out of the ends.
fn rays_find_the_union_of_all_parts<S: Piped>() {
    for (curve, (radius, tolerance)) in
        CURVES.iter().flat_map(|curve| [(0.3, 0.05), (0.4, 0.005)].map(|how| (curve, how)))
    {
        let curve = S::curve(*curve);
        let points = vertices(&curve, tolerance);
        let tolerance = S::near(tolerance);
        // A coarse type rounds the tolerance, by up to a fortieth, and 48 are enough for all others.
        let pipe = S::along_curve::<4, 6, 10, 50>(&curve, S::near(radius), tolerance).unwrap();
        let is_straight = points.len() == 2;
        assert!(pipe.segments() + 1 == points.len() && (pipe.segments() > 2 || is_straight));
        let model = Model::new(&points, S::near(radius).to_f64());
        agrees(&pipe, |point, more| model.holds(point, more));
    }
}

fn a_closed_curve_has_no_ends<S: Piped>() {
    let curve = S::ring(1.75);
    let points = vertices(&curve, 0.01);
    assert_eq!(points.first(), points.last());
    let pipe = S::along_curve::<4, 11, 15, 40>(&curve, S::near(0.3), S::near(0.01)).unwrap();
    let model = Model::new(&points, S::near(0.3).to_f64());
    agrees(&pipe, |point, more| model.holds(point, more));
}

/// A hollow pipe has what is in the outer and not in the inner one, and nothing is left in front of
/// the bore at the ends.
fn a_hollow_pipe_is_open_at_its_ends<S: Piped>() {
    for curve in CURVES {
        let curve = S::curve(curve);
        let points = vertices(&curve, 0.02);
        let tube = |radius: f64| {
            S::along_curve::<4, 6, 10, 24>(&curve, S::near(radius), S::near(0.02)).unwrap()
        };
        let model = |radius: f64| Model::new(&points, S::near(radius).to_f64());
        let (outside, bore) = (model(0.4), model(0.3));
        let hollow = tube(0.4) - tube(0.3);
        agrees(&hollow, |point, more| outside.holds(point, more) && !bore.holds(point, -more));

        // Straight into the ends, all over the bore.
        let mut random = Random::seeded(11);
        let mut list = SpanList::<S, 1024>::new();
        for ends in [[0, 1], [points.len() - 1, points.len() - 2]] {
            let [end, next] = ends.map(|i| points[i]);
            let inwards = unit(sub(next, end));
            for _ in 0..200 {
                let beside = random.point(0.15);
                let beside = along(beside, -dot(beside, inwards), inwards);
                let from = along(along(end, -0.5, inwards), 1.0, beside);
                let hit = hollow.hit(&ray::<S>(from, inwards), &mut list);
                let depth = |hit: V| dot(sub(hit, end), inwards);
                assert!(hit.is_none_or(|hit| depth(coordinates(hit.point)) > 0.05), "{hit:?}");
            }
        }
    }
}

/// The distance from a curve, which is sampled so closely that chords are within 10⁻⁷ of it; `None`
/// for points that are nearest to an end of it. No chord is longer than `longest`.
fn distance(samples: &[V], longest: f64, point: V) -> Option<f64> {
    let (mut i, mut nearest, mut is_end) = (0, f64::INFINITY, false);
    while let Some(&[from, to]) = samples.get(i..i + 2) {
        let way = sub(to, from);
        let s = dot(sub(point, from), way) / dot(way, way);
        let distance = length(sub(point, along(from, s.clamp(0.0, 1.0), way)));
        if distance < nearest {
            nearest = distance;
            is_end = i == 0 && s < 0.0 || i == samples.len() - 2 && s > 1.0;
        }
        // The n-th chord from here is nearer by n chords at most, so these few aren't the nearest.
        i += 1 + ((distance - nearest) / longest) as usize;
    }
    (!is_end).then_some(nearest)
}

/// The promise: what a ray sees of the wall is as far from the curve as the radius, give or take the
/// tolerance.
///
/// Caps are seen at the ends alone. Where the last segment is short, that may be the cap of the one
/// before it: it stands out of the end on the inside of the bend.
fn the_wall_is_within_the_tolerance<S: Piped>() {
    for (curve, tolerance) in [(0, 0.05), (0, 0.02), (1, 0.1), (1, 0.01), (1, 0.002)] {
        let exact = <f64 as Piped>::curve(CURVES[curve]);
        let count = 3000;
        let at = |i: i32| f64::from(i) * 3.0 / f64::from(count);
        let sample = |i| exact.value(at(i), Outside::Error).unwrap().to_array();
        let samples: Vec<V> = (0..=count).map(sample).collect();
        let chords = samples.windows(2).map(|ends| length(sub(ends[1], ends[0])));
        let longest = chords.fold(0.0, f64::max);

        let curve = S::curve(CURVES[curve]);
        let (radius, limit) = (S::near(0.3), S::near(tolerance));
        let pipe = S::along_curve::<4, 6, 10, 96>(&curve, radius, limit).unwrap();
        let points = vertices(&curve, limit.to_f64());
        let ends = [[points[0], points[1]], [points[points.len() - 1], points[points.len() - 2]]];
        // On the plane of an end's cap or beyond it, and within a radius of that end.
        let is_at_end = |point: V| {
            ends.iter().any(|&[end, next]| {
                let from_end = sub(point, end);
                dot(from_end, unit(sub(end, next))) >= -blur::<S>()
                    && length(from_end) <= radius.to_f64() + blur::<S>()
            })
        };
        let is_cap = |face: Face| face.0 < 3 * 96 && face.0 % 3 != 2;
        let mut random = Random::seeded(3);
        let mut list = SpanList::<S, 1024>::new();
        let (mut worst, mut count) = (0f64, 0);
        for _ in 0..1_000 {
            let (from, to) = (random.point(4.0), random.point(1.5));
            let Some(hit) = pipe.hit(&ray::<S>(from, unit(sub(to, from))), &mut list) else {
                continue;
            };
            let point = coordinates(hit.point);
            if hit.inside || is_cap(hit.face) && is_at_end(point) {
                continue;
            }
            let Some(distance) = distance(&samples, longest, point) else { continue };
            worst = worst.max((distance - radius.to_f64()).abs());
            count += 1;
        }
        assert!(worst <= limit.to_f64() + blur::<S>() + 1e-7, "{worst} > {tolerance}");
        // The segments are not many times finer than they have to be.
        assert!(worst > 0.5 * tolerance && count > 200, "{worst} of {tolerance}, {count} rays");
        println!("{tolerance}: {} segments, {worst:.6}, {count} rays", pipe.segments());
    }
}

/// Straight into the end: the cap of the segment before the last one is seen where it stands out.
fn a_short_last_segment_shows_the_cap_before_it<S: Piped>() {
    // sin θ is 0.6 and r·sin θ is 0.3.
    let (axis, across) = ([0.8, 0.6, 0.0], [-0.6, 0.8, 0.0]);
    let mut list = SpanList::<S, 64>::new();
    for (long, seen_before) in [(0.125, 4), (0.25, 1), (0.3125, 0)] {
        let end = axis.map(|x| long * x);
        let points = [[-2.0, 0.0, 0.0], [0.0; 3], end].map(vector);
        let pipe = S::through::<2>(&points, S::near(0.5)).unwrap();
        let mut count = 0;
        for h in (-6..=6).map(|i| f64::from(i) / 16.0) {
            let from = along(along(end, 2.0, axis), h, across);
            let hit = pipe.hit(&ray::<S>(from, axis.map(|x| -x)), &mut list).unwrap();
            let stands_out = 0.75 * h - long;
            assert_eq!(hit.face, if stands_out > 0.0 { Face(1) } else { Face(4) });
            let height = dot(sub(coordinates(hit.point), end), axis);
            assert!((height - stands_out.max(0.0)).abs() <= blur::<S>(), "{height}, {stands_out}");
            count += u32::from(stands_out > 0.0);
        }
        assert_eq!(count, seen_before);
    }
}

/// Where every ray of a picture meets a solid first, and how long it is inside.
fn picture<S, T, C>(solid: &T, camera: &C) -> Vec<Option<f64>>
where
    S: Piped,
    C: Camera<Rays: Rays<Scalar = S>>,
    T: Solid<Scalar = S> + Scan<C::Rays>,
{
    let size = Size::new(64, 48).unwrap();
    let mut picture = Picture::new(solid, camera, size, XRay::new(S::ONE).unwrap(), Gray8(0));
    let mut seen = Vec::new();
    for y in 0..48 {
        let mut line = picture.scanline(y).unwrap();
        seen.extend((0..64).map(|x| line.seen(x).map(|seen| seen.t.to_f64())));
    }
    seen
}

/// In pictures a pipe is the union of its cylinders and whole balls, which is how it would be
/// written with operators, where segments are longer than the radius.
fn pictures_show_the_union_written_with_operators<S: Piped>() {
    let points = [[-1.5, -1.0, 0.25], [0.5, -0.75, 1.0], [0.75, 1.0, 0.0], [-1.0, 0.5, -1.0]];
    let [a, b, c, d] = points;
    let pipe = S::through::<5>(&points.map(vector), S::near(0.4)).unwrap();
    let rods = between::<S>(a, b, 0.4) | between(b, c, 0.4) | between(c, d, 0.4);
    let union = rods | ball(b, 0.4) | ball(c, 0.4);
    let (eye, up) = (vector([4.0, 3.0, 6.0]), vector([0.0, 1.0, 0.0]));
    let camera = Orthographic::look_at(eye, Vec3::ZERO, up, S::near(4.0)).unwrap();
    same_picture(picture(&pipe, &camera), picture(&union, &camera), blur::<S>());
    let camera = Perspective::look_at(eye, Vec3::ZERO, up, S::near(0.6)).unwrap();
    same_picture(picture(&pipe, &camera), picture(&union, &camera), 4.0 * blur::<S>());
}

/// A pixel at the silhouette may fall to either side.
fn same_picture(one: Vec<Option<f64>>, other: Vec<Option<f64>>, blur: f64) {
    assert!(one.iter().flatten().count() > 300);
    for (i, pair) in one.iter().zip(&other).enumerate() {
        match pair {
            (None, None) => {}
            (Some(one), Some(other)) => assert!((one - other).abs() <= blur, "{i}: {pair:?}"),
            _ => panic!("{i}: {pair:?}"),
        }
    }
}

/// Pictures and single rays see the same.
fn pictures_agree_with_rays<S: Piped>() {
    let curve = S::curve(CURVES[1]);
    let tube = |radius: f64| {
        S::along_curve::<4, 6, 10, 48>(&curve, S::near(radius), S::near(0.01)).unwrap()
    };
    let hollow = tube(0.4) - tube(0.3);
    let (eye, up) = (vector([3.0, 2.5, 6.0]), vector([0.0, 1.0, 0.0]));
    let camera = Perspective::look_at(eye, Vec3::ZERO, up, S::near(0.6)).unwrap();
    let size = Size::new(64, 48).unwrap();
    let rays = camera.rays(size);
    let mut list = SpanList::<S, 1024>::new();
    let seen = picture(&hollow, &camera);
    let (mut different, mut hits) = (0, 0);
    let allowed = if S::IS_FIXED { limits::PIPE_DEPTH_FIXED } else { limits::PIPE_DEPTH_FLOAT };
    for (i, seen) in (0..).zip(&seen) {
        let (x, y) = (2 * (i % 64) + 1 - 64, 2 * (i / 64) + 1 - 48);
        let line = rays.row(y).line(x);
        // From the eye, as a ray starts at 0.
        let start = rays.start();
        let ray = scancsg::geom::Ray::new(line.at(start), line.direction).unwrap();
        let hit = hollow.hit(&ray, &mut list).map(|hit| hit.t.to_f64() + start.to_f64());
        hits += u32::from(hit.is_some());
        let is_same = match (seen, hit) {
            (None, None) => true,
            (Some(a), Some(b)) => (a - b).abs() <= allowed,
            _ => false,
        };
        different += u32::from(!is_same);
    }
    assert!(hits > 300 && different <= if S::IS_FIXED { 12 } else { 2 }, "{different} of {hits}");
}

fn there_must_be_room_for_all_segments<S: Piped>() {
    let curve = S::curve(CURVES[1]);
    let (radius, tolerance) = (S::near(0.3), S::near(0.05));
    assert_eq!(vertices(&curve, 0.05).len(), 13);
    let exactly = S::along_curve::<4, 6, 10, 12>(&curve, radius, tolerance);
    assert_eq!(exactly.map(|pipe| pipe.segments()), Ok(12));
    let less = S::along_curve::<4, 6, 10, 11>(&curve, radius, tolerance);
    assert_eq!(less.err(), Some(PipeError::Capacity));
    let finest = S::along_curve::<4, 6, 10, 10>(&curve, radius, S::ZERO.up());
    assert_eq!(finest.err(), Some(PipeError::Capacity));

    let points: Vec<Vec3<S>> = (0..4).map(|i| vector([f64::from(i), 0.0, 1.0])).collect();
    assert_eq!(S::through::<3>(&points, radius).map(|pipe| pipe.segments()), Ok(3));
    assert_eq!(S::through::<2>(&points, radius).err(), Some(PipeError::Capacity));
}

fn what_is_no_pipe_is_an_error<S: Piped>() {
    let curve = S::curve(CURVES[0]);
    let make = |radius, tolerance| S::along_curve::<4, 6, 10, 24>(&curve, radius, tolerance).err();
    let (radius, tolerance) = (S::near(0.3), S::near(0.05));
    assert_eq!(make(radius, tolerance), None);
    for wrong in [S::ZERO, S::near(-0.5)] {
        assert_eq!(make(wrong, tolerance), Some(PipeError::Radius));
        assert_eq!(make(radius, wrong), Some(PipeError::Tolerance));
    }
    assert_eq!(make(S::MAX_COORDINATE, tolerance), Some(PipeError::TooFar));
    for &wrong in S::NO_NUMBERS {
        assert_eq!(make(wrong, tolerance), Some(PipeError::NotFinite));
        assert_eq!(make(radius, wrong), Some(PipeError::Tolerance));
        let points = [vector([0.0; 3]), vec3(S::ZERO, wrong, S::ZERO)];
        assert_eq!(S::through::<4>(&points, radius).err(), Some(PipeError::NotFinite));
    }
    let here = vector([1.0, 2.0, 3.0]);
    for points in [&[][..], &[here], &[here, here, here]] {
        assert_eq!(S::through::<4>(points, radius).err(), Some(PipeError::Empty));
    }
    let far = vec3(S::MAX_COORDINATE, S::ZERO, S::ZERO);
    assert_eq!(S::through::<4>(&[Vec3::ZERO, far], radius).err(), Some(PipeError::TooFar));
    let beyond = vec3(S::MAX_COORDINATE.up(), S::ZERO, S::ZERO);
    assert_eq!(S::through::<4>(&[Vec3::ZERO, beyond], radius).err(), Some(PipeError::TooFar));
    let twice = [here, here, vector([1.0, 2.0, 4.0]), vector([1.0, 2.0, 4.0])];
    assert_eq!(S::through::<4>(&twice, radius).map(|pipe| pipe.segments()), Ok(1));
}

/// Between neighbouring knots there is nothing to follow, and a bad radius is found before that.
#[test]
fn work_is_bounded() {
    let next = 1f32.next_up();
    let knots = Knots::<f32, 3, 6>::new(&[1.0, 1.0, 1.0, next, next, next]).unwrap();
    let points = [vec3(0.0, 0.0, 0.0), vec3(1000.0, 1000.0, 0.0), vec3(0.0, 0.0, 0.0)];
    let curve = Curve::<Vec3<f32>, 3, 3, 6>::new(knots, points).unwrap();
    let along = |radius| Pipe::<f32, 4>::along(&curve, radius, 1e-14).err();
    assert_eq!(along(0.1), Some(PipeError::Empty));
    assert_eq!(along(f32::NAN), Some(PipeError::NotFinite));
    assert_eq!(along(-1.0), Some(PipeError::Radius));
}

/// The most spans that there can be are found: a ray through a pipe that goes to and fro.
fn a_ray_may_cross_every_segment<S: Piped>() {
    let corner = |i: u8| vector([f64::from(i), if i % 4 < 2 { -8.0 } else { 8.0 }, 0.0]);
    let points: Vec<Vec3<S>> = (0..16).map(corner).collect();
    let pipe = S::through::<15>(&points, S::near(0.25)).unwrap();
    let found = spans(&pipe, &ray::<S>([-3.0, 0.0, 0.0], [1.0, 0.0, 0.0]));
    assert_eq!(found.len(), 7);
    let found = spans(&pipe, &ray::<S>([-3.0, 8.0, 0.0], [1.0, 0.0, 0.0]));
    assert_eq!(found.len(), 4);
}

/// A segment straight on has no seam: it is one cylinder.
fn collinear_segments_are_one_cylinder<S: Piped>() {
    let points = [-2.0, -1.5, -0.25, 1.0, 2.0].map(|x| vector([x, 0.5, 0.5]));
    let pipe = S::through::<4>(&points, S::near(0.5)).unwrap();
    let rod = between::<S>([-2.0, 0.5, 0.5], [2.0, 0.5, 0.5], 0.5);
    let mut random = Random::seeded(5);
    for _ in 0..500 {
        let (from, to) = (random.point(4.0), random.point(1.5));
        let ray = ray::<S>(from, unit(sub(to, from)));
        assert_eq!(spans(&pipe, &ray), spans(&rod, &ray));
    }
}

fn faces_have_normals_and_colours<S: Piped>() {
    let points = [[-1.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(vector);
    let pipe = S::through::<2>(&points, S::near(0.5)).unwrap();
    let painted = Painted::new(pipe, Rgb::new(1, 2, 3));
    let mut list = SpanList::<S, 64>::new();
    let mut look = |from: V, way: V| {
        let hit = painted.hit(&ray::<S>(from, way), &mut list).unwrap();
        assert_eq!(painted.color(hit.face), Some(Rgb::new(1, 2, 3)));
        (hit.face, coordinates(hit.normal))
    };
    assert_eq!(look([-3.0, 0.0, 0.0], [1.0, 0.0, 0.0]), (Face(0), [-1.0, 0.0, 0.0]));
    assert_eq!(look([-0.5, 0.0, 3.0], [0.0, 0.0, -1.0]), (Face(2), [0.0, 0.0, 1.0]));
    assert_eq!(look([0.0, 3.0, 0.0], [0.0, -1.0, 0.0]), (Face(4), [0.0, 1.0, 0.0]));
    assert_eq!(look([0.0, 0.5, 3.0], [0.0, 0.0, -1.0]), (Face(5), [0.0, 0.0, 1.0]));
    // The ball in the bend, from outside of it.
    let (face, normal) = look([1.0, -1.0, 0.0], [-1.0, 1.0, 0.0]);
    assert_eq!(face, Face(6 + 5));
    let half = std::f64::consts::FRAC_1_SQRT_2;
    assert!(length(sub(normal, [half, -half, 0.0])) < 1e-4f64.max(S::UNIT), "{normal:?}");
    assert_eq!(Pipe::<S, 2>::FACES, 16);
}

/// A pipe along points is a constant, checked while compiling.
static ELBOW: Pipe<f32, 2> = constant!(Pipe::<f32, 2>::through(
    &[vec3(-1.0, 0.0, 0.0), vec3(0.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0)],
    0.25
));

#[test]
fn a_pipe_can_live_in_flash() {
    assert_eq!(ELBOW.segments(), 2);
    assert_eq!(spans(&ELBOW, &ray::<f32>([-2.0, 0.0, 0.0], [1.0, 0.0, 0.0])), [(1.0, 2.25)]);
}

for_every_number!(
    rays_find_the_union_of_all_parts,
    a_closed_curve_has_no_ends,
    a_hollow_pipe_is_open_at_its_ends,
    the_wall_is_within_the_tolerance,
    a_short_last_segment_shows_the_cap_before_it,
    pictures_show_the_union_written_with_operators,
    pictures_agree_with_rays,
    there_must_be_room_for_all_segments,
    what_is_no_pipe_is_an_error,
    a_ray_may_cross_every_segment,
    collinear_segments_are_one_cylinder,
    faces_have_normals_and_colours,
);
