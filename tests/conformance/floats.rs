//! What only floating point can get wrong: subnormal numbers, numbers beyond any scene, distances
//! of a million radii. Infinities and NaN are in `bad_input` and `rows`.

use crate::hard_cases::{beside_a_wide_wall, thin_from_afar};
use crate::limits;
use crate::number::{Tested, ball, ray, rod, spans, vector};
use proptest::prelude::*;
use scancsg::geom::{Ray, Vec3, vec3};
use scancsg::render::{CameraError, Orthographic, Perspective};
use scancsg::solid::{CylinderError, CylinderWall, Hit, RayCast};
use scancsg::span::{Face, SpanList};

macro_rules! for_every_float {
    ($($test:ident),+ $(,)?) => {
        mod f32 {
            $(#[test] fn $test() { super::$test::<f32>(); })+
        }
        mod f64 {
            $(#[test] fn $test() { super::$test::<f64>(); })+
        }
    };
}

for_every_float!(
    from_a_million_radii,
    aimed_at_the_origin_by_chance,
    near_the_eye_and_far_away_at_once,
    hits_are_traced_from_afar,
    small_solids_before_an_eye_that_looks_away,
    very_small_and_very_large_radii,
    powers_of_two_scale_t_exactly,
    enormous_and_minute_factors,
    subnormal_and_enormous_directions,
    along_the_caps_by_either_zero,
    the_ends_of_the_range,
);

/// What a float has and other numbers have not.
trait Float: Tested {
    const SMALLEST: Self;
    const SMALLEST_NORMAL: Self;
    const LARGEST: Self;
}

impl Float for f32 {
    const SMALLEST: Self = f32::from_bits(1);
    const SMALLEST_NORMAL: Self = f32::MIN_POSITIVE;
    const LARGEST: Self = f32::MAX;
}

impl Float for f64 {
    const SMALLEST: Self = f64::from_bits(1);
    const SMALLEST_NORMAL: Self = f64::MIN_POSITIVE;
    const LARGEST: Self = f64::MAX;
}

/// |o|² − r² loses r altogether from 10⁵ radii away in `f32`.
fn from_a_million_radii<S: Float>() {
    for past in [0.999, 1.001] {
        for far in [1e4, 1e5, 1e6] {
            let level = ray::<S>([0.5, past, far], [0.0, 0.0, -1.0]);
            let count = spans(&rod::<S>(1.0, -2.0, 2.0), &level).len();
            assert_eq!(count, usize::from(past < 1.0), "{past} {far}");
        }
    }
}

/// A ray that comes near (0, 0, 0) may be counted from there, and then the sum of two parameters of the
/// distance's size is what is left of one near its start: 65 ulps at a hundredth, and a ray that starts on
/// a face may begin behind it.
fn aimed_at_the_origin_by_chance<S: Float>() {
    let mut list = SpanList::<S, 1>::new();
    for step in 0..1000 {
        let [x, y, z] = [2.0 + 0.001 * f64::from(step), -0.2, 0.3].map(|x| S::near(x).to_f64());
        let ray = ray::<S>([x, y, z], [-x, -y + 1e-4, -z]);
        for gap in [0.0, 1e-5, 1e-3, 0.1, 0.9] {
            let top = S::near(x - gap);
            let rod = S::along(0, [S::ZERO; 2], S::near(0.5), S::near(-3.0), top).unwrap();
            let hit = rod.hit(&ray, &mut list).unwrap();
            let want = (x - top.to_f64()) / x;
            assert!(
                (hit.t.to_f64() - want).abs() <= want * limits::NEAR_CAP.of::<S>(),
                "{:?} not {want}",
                hit.t
            );
            assert_eq!((hit.face, hit.inside), (Face(1), false), "{x} {gap}");
            let spans = spans(&rod, &ray);
            assert_eq!((spans.len(), spans[0].0), (1, hit.t.to_f64()), "{x} {gap}");
        }
        // The wall from inside, and from a point on it.
        for gap in [0.0, 1e-5, 1e-3] {
            let radius = S::near(x + gap).up();
            let rod =
                S::along(1, [S::ZERO, S::near(z)], radius, S::near(-3.0), S::near(3.0)).unwrap();
            let outwards = self::ray::<S>([x, y, z], [x, y, z]);
            let hit = CylinderWall::of(&rod).hit(&outwards).unwrap();
            // (x + tx)² + (tz)² = r², with r near to x, by Newton's steps.
            let r = radius.to_f64();
            let mut want = 0.0;
            for _ in 0..60 {
                let value = (x - r) * (x + r) + want * (2.0 * x * x + want * (x * x + z * z));
                want -= value / (2.0 * (x * x + want * (x * x + z * z)));
            }
            assert!(
                (hit.t.to_f64() / want - 1.0).abs() <= limits::NEAR_WALL.of::<S>(),
                "{:?} not {want}",
                hit.t
            );
            assert!(hit.inner);
        }
    }
}

/// Counted from the scene's origin, what is near the eye has few digits, and counted from the eye, a thin
/// wall far away has no thickness: neither may cost the other.
fn near_the_eye_and_far_away_at_once<S: Float>() {
    let far = 1.0 / (8.0 * S::UNIT);
    let pipe = rod::<S>(1.0, -2.0, 2.0) - rod::<S>(0.99, -2.0, 2.0);
    let down = ray::<S>([0.0, 0.0, far], [0.0, 0.0, -1.0]);
    let away = ray::<S>([0.0, 0.0, -far], [0.0, 0.0, -1.0]);
    let walls = spans(&pipe, &down);
    assert_eq!((walls.len(), walls[0].0), (2, far - 1.0));
    let mut list = SpanList::<S, 6>::new();
    let first = pipe.hit(&down, &mut list).unwrap();
    for (gap, is_seen) in [(-9.0, false), (-0.125, false), (0.0, true), (0.125, true), (9.0, true)]
    {
        // Behind the eye, or before it; its near side at this distance.
        let low = if is_seen { far - gap - 1.0 } else { far - gap };
        let lid = S::slab_along(2, S::near(low), S::near(low + 1.0)).unwrap();
        let both = lid | pipe;
        let got = spans(&both, &down);
        assert_eq!(got.len(), 3, "{gap}");
        assert_eq!(got[1..], walls, "{gap}");
        let hit = both.hit(&down, &mut list).unwrap();
        let near = far - S::near(far - gap).to_f64();
        if is_seen {
            assert_eq!((hit.t.to_f64(), got[0].0, hit.inside), (near, near, false));
        } else {
            assert_eq!(
                (hit.t, hit.point, hit.normal),
                (first.t, first.point, first.normal),
                "{gap}"
            );
        }
    }
    // The other way round: all is behind the eye, the lid with a face a little before it.
    let lid = S::slab_along(2, S::near(-far - 0.125), S::ONE).unwrap();
    let hit = (lid | pipe).hit(&away, &mut list).unwrap();
    assert_eq!((hit.t.to_f64(), hit.inside), (0.125, true));
}

/// Whatever is asked twice, and from wherever it's taken: a hit is the first crossing of the trace.
fn hits_are_traced_from_afar<S: Float>() {
    proptest!(ProptestConfig::with_cases(4_000), |(
        eye in prop::array::uniform3(-1f64..1.0), far in 2f64..6.0, past in prop::array::uniform3(-1f64..1.0),
        place in -0.6f64..1.2, size in -8.5f64..-1.0, off in prop::array::uniform3(-1f64..1.0), away: bool,
        low in -1.5f64..1.5, behind: bool,
    )| {
        let far = 10f64.powf(far);
        let eye = eye.map(|x| S::near(x * far).to_f64());
        let length = eye.iter().map(|x| x * x).sum::<f64>().sqrt();
        prop_assume!(length > 0.1 * far);
        let sign = if away { 1.0 } else { -1.0 };
        let way: [f64; 3] = std::array::from_fn(|i| sign * (eye[i] + 1e-3 * past[i]) / length);
        // A ball on or beside the line, from behind the eye to behind the scene's origin.
        let radius = length * 10f64.powf(size);
        let center = std::array::from_fn(|i| eye[i] + place * length * way[i] + radius * off[i]);
        let reach = if behind { 2.0 * length } else { 1e-3 * length };
        let slab = S::slab(vector(way), S::near(low * length), S::near(low * length + reach)).unwrap();
        let (ray, ball) = (ray::<S>(eye, way), ball::<S>(center, radius));
        let mut list = SpanList::<S, 4>::new();
        let first = |traced: Vec<(f64, f64)>| {
            let mut crossings = traced.into_iter().flat_map(|(enter, exit)| [enter, exit]);
            crossings.find(|&t| t >= 0.0 && t.is_finite())
        };
        let traced = spans(&(ball | slab), &ray);
        let crossings = traced.iter().flat_map(|&(enter, exit)| [enter, exit]);
        prop_assert!(crossings.is_sorted(), "{traced:?}");
        let seen = |hit: Hit<S>| hit.t.to_f64();
        prop_assert_eq!((ball | slab).hit(&ray, &mut list).map(seen), first(traced));
        prop_assert_eq!((ball - slab).hit(&ray, &mut list).map(seen), first(spans(&(ball - slab), &ray)));
        prop_assert_eq!(ball.hit(&ray, &mut list).map(seen), first(spans(&ball, &ray)));
    });
}

/// Away from the origin, all that is before the eye is nearer to there, however small.
fn small_solids_before_an_eye_that_looks_away<S: Float>() {
    let far = 1.0 / (128.0 * S::UNIT);
    let away = ray::<S>([0.0, 0.0, far], [0.0, 0.0, 1.0]);
    let rod = S::along(0, [S::ZERO, S::near(far + 5.0)], S::near(0.001), S::near(-1.0), S::ONE);
    let hit = rod.unwrap().hit(&away, &mut SpanList::<S, 1>::new()).unwrap();
    assert!((hit.t.to_f64() - 4.999).abs() < 1e-5, "{hit:?}");
    assert_eq!(spans(&rod.unwrap(), &away)[0].0, hit.t.to_f64());
}

/// Squares of such radii are 10⁻⁸ and 10⁸ times those of the coordinates beside them, and one of the two
/// is lost in the other's rounding errors.
fn very_small_and_very_large_radii<S: Float>() {
    for radius in [1e-4, 1e4].map(|r| S::near(r).to_f64()) {
        let rod = rod::<S>(radius, -2.0, 2.0);
        let across = ray::<S>([0.0, 3.0 * radius, 0.0], [0.0, -1.0, 0.0]);
        let [(enter, exit)] = spans(&rod, &across)[..] else { panic!("a miss of {radius}") };
        let error = (enter / radius - 2.0).abs().max((exit / radius - 4.0).abs());
        assert!(error <= limits::RADII.of::<S>(), "{radius}: {enter} {exit}");
        let beside = ray::<S>([0.0, 0.0, radius * 1.0001], [0.0, 1.0, 0.0]);
        assert_eq!(spans(&rod, &beside), []);
    }
    // Radii of 0.8 · 10⁻⁴, from 4,000 to four million of them away, and of 10⁴.
    thin_from_afar::<S>(0.5f64.powi(19), &[0.06640625, 5.08203125, 18.5546875, 62.15234375]);
    beside_a_wide_wall::<S>(4.0);
}

const ORIGIN: [f64; 3] = [6.0, 3.0, 8.0];
const WAY: [f64; 3] = [-0.75, 0.125, -1.0];

fn hit<S: Float>(way: [f64; 3]) -> Hit<S> {
    let solid = rod::<S>(5.0, -2.0, 2.0);
    solid.hit(&ray(ORIGIN, way), &mut SpanList::<S, 1>::new()).unwrap()
}

/// A power of two changes no digit of a direction, and none of anything that depends on it.
fn powers_of_two_scale_t_exactly<S: Float>() {
    let one = hit::<S>(WAY);
    for power in [-60, -20, -3, 1, 20, 60] {
        let scale = 2f64.powi(power);
        let scaled = hit::<S>(WAY.map(|k| k * scale));
        assert_eq!(scaled, Hit { t: S::near(one.t.to_f64() / scale), ..one });
    }
}

/// The squares of such directions overflow, or vanish.
fn enormous_and_minute_factors<S: Float>() {
    let one = hit::<S>(WAY);
    for factor in [1e-30, 3e-4, 7.0, 1e30] {
        let scaled = hit::<S>(WAY.map(|k| k * factor));
        assert_eq!((scaled.face, scaled.inside), (one.face, one.inside));
        let off = scaled.t.to_f64() * factor / one.t.to_f64() - 1.0;
        assert!(off.abs() <= limits::SCALED_DIRECTION.of::<S>(), "{off} at {factor}");
    }
}

/// Directions whose squares are zero or infinite, and coordinates that are subnormal.
fn subnormal_and_enormous_directions<S: Float>() {
    let rod = rod::<S>(1.0, -2.0, 2.0);
    let subnormal = S::near(S::SMALLEST_NORMAL.to_f64() / 1024.0);
    for length in [subnormal, S::SMALLEST_NORMAL, S::near(S::LARGEST.to_f64() / 2.0)] {
        let down =
            Ray::new(vector([0.0, 0.0, 5.0]), vec3(S::ZERO, S::ZERO, length.negated())).unwrap();
        let [(enter, exit)] = spans(&rod, &down)[..] else { panic!("a miss at {length:?}") };
        // The smallest directions have parameters beyond the type's range.
        let length = length.to_f64();
        if S::near(4.0 / length).is_finite() {
            assert!((enter * length - 4.0).abs() < 1e-5, "{length}: {enter}");
            assert!((exit * length - 6.0).abs() < 1e-5, "{length}: {exit}");
        }
    }
    let ball = ball::<S>([0.0; 3], 1.0);
    for length in [S::SMALLEST, S::SMALLEST_NORMAL, S::LARGEST] {
        let ray = Ray::new(Vec3::ZERO, vec3(length, length.negated(), length)).unwrap();
        let [(enter, exit)] = spans(&ball, &ray)[..] else { panic!("a miss at {length:?}") };
        assert!(enter < 0.0 && exit > 0.0, "{enter} {exit}");
    }
    let tiny = S::SMALLEST;
    let beside =
        Ray::new(vec3(tiny, tiny, S::near(5.0)), vec3(tiny, S::ZERO, S::ONE.negated())).unwrap();
    assert_eq!(spans(&rod, &beside), [(4.0, 6.0)]);
}

/// A quotient by −0 has the other sign than one by 0, and both are infinite, or no number in a cap's
/// plane: the ends of a slab come in the wrong order, or not at all.
fn along_the_caps_by_either_zero<S: Float>() {
    let rods = [
        rod::<S>(5.0, -2.0, 2.0),
        S::between(vector([-2.0, 0.0, 0.0]), vector([2.0, 0.0, 0.0]), S::near(5.0)).unwrap(),
        S::between(vector([2.0, 0.0, 0.0]), vector([-2.0, 0.0, 0.0]), S::near(5.0)).unwrap(),
    ];
    for (x, is_inside) in [
        (-3.0, false),
        (-2.0, true),
        (-1.0, true),
        (0.0, true),
        (1.0, true),
        (2.0, false),
        (3.0, false),
    ] {
        for zero in [S::ZERO, S::ZERO.negated()] {
            let down = Ray::new(vector([x, 9.0, 0.0]), vec3(zero, S::ONE.negated(), zero)).unwrap();
            let want = if is_inside { vec![(4.0, 14.0)] } else { vec![] };
            for rod in &rods {
                assert_eq!(spans(rod, &down), want, "{x} {zero:?}");
            }
        }
    }
}

/// Numbers whose squares or inverses would overflow.
fn the_ends_of_the_range<S: Float>() {
    let end = vec3(S::LARGEST, S::LARGEST, S::LARGEST);
    assert_eq!(S::between(Vec3::ZERO, end, S::ONE), Err(CylinderError::TooFar));
    let (x, y) = (vector::<S>([1.0, 0.0, 0.0]), vector::<S>([0.0, 1.0, 0.0]));
    let minute = S::near(S::SMALLEST_NORMAL.to_f64() / 64.0);
    let camera = Orthographic::look_along(x, Vec3::ZERO, y, minute);
    assert_eq!(camera, Err(CameraError::FrameHeight));
    let eye = vec3(minute, S::ZERO, S::ZERO);
    let camera = Perspective::look_at(eye, Vec3::ZERO, y, S::ONE);
    assert_eq!(camera, Err(CameraError::ZeroDirection));
    let camera = Perspective::look_at(x, Vec3::ZERO, y, S::near(std::f64::consts::PI));
    assert_eq!(camera, Err(CameraError::FieldOfView));
    for radius in [S::SMALLEST_NORMAL.negated(), S::SMALLEST.negated(), S::SMALLEST] {
        assert_eq!(S::sphere(Vec3::ZERO, radius), Err(scancsg::solid::SphereError::Radius));
    }
}
