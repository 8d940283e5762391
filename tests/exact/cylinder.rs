//! Cylinders in whole numbers: axes along coordinates and Pythagorean directions, rays on a grid,
//! and everything about them decided exactly.
//!
//! With v the axis from end to end, the ray p = o + t·d is within r of the axis where
//! `|(u + t·d) × v|² < r²·v·v`, u = o − base, and between the caps where `0 < (u + t·d)·v < v·v`.
//! All coefficients are whole numbers, so the sign of the discriminant and the order of all four
//! crossings are known exactly.
//!
//! What is computed with rounding errors is right for a solid of almost the same size. So the
//! class has to be the exact one wherever it is the same for a solid grown and shrunk by a
//! relative ε, and each crossing has to lie between those of the two. Coordinates are at most 16
//! and lengths at least 1, so a few rounding errors u of a coordinate are less than ε = 128 u.
//!
//! In fixed point the axis is rounded to 2⁻²⁸ and the caps' offsets to half a unit, so ε = 2⁻²² for
//! the wall and 2⁻¹⁶ for the caps; then a parameter is rounded to half a unit. `fixed_exact.rs` has the cylinders whose axis is not rounded.

use dashu_int::IBig;
use proptest::prelude::*;
use scancsg::scalar::I16F16;
use scancsg::solid::CylinderWall;
use testkit::limits;
use testkit::number::{self, Tested, ray, spans};
use testkit::surd::{Surd, square};

type V = [i64; 3];

fn dot(a: V, b: V) -> i64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: V, b: V) -> V {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[derive(Debug, Clone, Copy)]
struct Scene {
    base: V,
    axis: V,
    radius: i64,
    origin: V,
    direction: V,
}

/// 0 for the solid as it is, 1 for one grown and −1 for one shrunk by 2^−ε at all sides.
type Growth = (i64, u32);

/// Where the line meets the infinite cylinder, or whether it is inside (`Ok`) everywhere.
fn wall(scene: &Scene, (sign, epsilon): Growth) -> Result<bool, [Surd; 2]> {
    let u: V = std::array::from_fn(|i| scene.origin[i] - scene.base[i]);
    let (q, m) = (cross(u, scene.axis), cross(scene.direction, scene.axis));
    let [a, b, c] = [dot(m, m), dot(q, m), dot(q, q)].map(IBig::from);
    // r·(1 + sign/2^ε) as a fraction with the denominator 2^ε.
    let one = IBig::ONE << epsilon as usize;
    let radius = IBig::from(scene.radius) * (&one + IBig::from(sign));
    let c = c * square(&one) - square(&radius) * IBig::from(dot(scene.axis, scene.axis));
    if a == IBig::ZERO {
        return Ok(c < IBig::ZERO);
    }
    let discriminant = square(&(&b * &one)) - &a * c;
    if discriminant < IBig::ZERO {
        return Ok(false);
    }
    let at = |s| Surd { p: -(&b * &one), s, q: discriminant.clone(), d: &a * &one };
    Err([at(-1), at(1)])
}

/// Where the line is between the caps: everywhere (`Ok(true)`), nowhere, or from … to.
fn caps(scene: &Scene, (sign, epsilon): Growth) -> Result<bool, [Surd; 2]> {
    let u: V = std::array::from_fn(|i| scene.origin[i] - scene.base[i]);
    let [height, speed] = [dot(u, scene.axis), dot(scene.direction, scene.axis)].map(IBig::from);
    let one = IBig::ONE << epsilon as usize;
    let length = IBig::from(dot(scene.axis, scene.axis));
    let [low, high] = [-(IBig::from(sign) * &length), &length * (&one + IBig::from(sign))];
    let (to_low, to_high) = (low - &height * &one, high - height * &one);
    if speed == IBig::ZERO {
        return Ok(to_low < IBig::ZERO && IBig::ZERO < to_high);
    }
    let is_forwards = speed > IBig::ZERO;
    let at = [to_low, to_high].map(|way| Surd::ratio(way, &speed * &one));
    let [low, high] = at;
    Err(if is_forwards { [low, high] } else { [high, low] })
}

/// The line's span with the solid, if it has a length, for the ε of its wall and its caps.
fn span(scene: &Scene, sign: i64, [of_wall, of_caps]: [u32; 2]) -> Option<[Surd; 2]> {
    let (wall, caps) = (wall(scene, (sign, of_wall)), caps(scene, (sign, of_caps)));
    if wall.as_ref().is_ok_and(|inside| !inside) || caps.as_ref().is_ok_and(|inside| !inside) {
        return None;
    }
    let [enter, exit] = match (wall, caps) {
        (Err(wall), Err([low, high])) => {
            let [mut enter, mut exit] = wall;
            if exit.order(&low).is_le() || enter.order(&high).is_ge() {
                return None;
            }
            if enter.order(&low).is_lt() {
                enter = low;
            }
            if exit.order(&high).is_gt() {
                exit = high;
            }
            [enter, exit]
        }
        (Err(only), Ok(_)) | (Ok(_), Err(only)) => only,
        (Ok(_), Ok(_)) => unreachable!("no line is parallel and at right angles to the axis"),
    };
    // A tangent's span has no length.
    if enter.s != 0 && enter.q == IBig::ZERO {
        return None;
    }
    Some([enter, exit])
}

/// The first crossing of the open wall at t ≥ 0, the rim included.
fn tube(scene: &Scene, growth: Growth, of_caps: Growth) -> Option<Surd> {
    let Err(roots) = wall(scene, growth) else { return None };
    let caps = caps(scene, of_caps);
    let zero = Surd::ratio(IBig::ZERO, IBig::ONE);
    roots.into_iter().find(|root| {
        let between = match &caps {
            Ok(inside) => *inside,
            Err([low, high]) => root.order(low).is_ge() && root.order(high).is_le(),
        };
        between && root.order(&zero).is_ge()
    })
}

/// Whole directions of whole length, in all octants.
const AXES: [V; 9] = [
    [1, 0, 0],
    [0, 2, 0],
    [0, 0, -3],
    [1, 2, 2],
    [2, -1, 2],
    [-2, 3, 6],
    [4, 4, -7],
    [3, 0, -4],
    [-4, -8, 1],
];

fn scenes() -> impl Strategy<Value = Scene> {
    let grid = |limit: i64| prop::array::uniform3(-limit..=limit);
    let axis = prop::sample::select(AXES.to_vec());
    // Aimed at a grid point near the solid, or anywhere.
    (grid(8), axis, 1..=6i64, grid(16), grid(4), prop::bool::weighted(0.8))
        .prop_map(|(base, axis, radius, origin, way, is_aimed)| {
            let aimed = std::array::from_fn(|i| base[i] + way[i] - origin[i]);
            let direction = if is_aimed { aimed } else { way };
            Scene { base, axis, radius, origin, direction }
        })
        .prop_filter("no direction", |scene| scene.direction != [0; 3])
}

trait Exact: Tested {
    /// ε for the wall and for the caps is 2 to the minus this.
    const EPSILON: [u32; 2];
}

impl Exact for f32 {
    const EPSILON: [u32; 2] = limits::GROWN_F32;
}

impl Exact for f64 {
    const EPSILON: [u32; 2] = limits::GROWN_F64;
}

impl Exact for I16F16 {
    const EPSILON: [u32; 2] = limits::GROWN_I16F16;
}

fn numbers(v: V) -> [f64; 3] {
    v.map(|x| x as f64)
}

/// From where to where a parameter may have been rounded to this one.
fn rounded_to<S: Exact>(t: f64) -> [Surd; 2] {
    let room = if S::IS_FIXED { 0.5 * S::UNIT } else { 0.0 };
    [t - room, t + room].map(Surd::float)
}

fn check<S: Exact>(scene: &Scene) -> Result<(), TestCaseError> {
    let top: V = std::array::from_fn(|i| scene.base[i] + scene.axis[i]);
    let solid = number::between::<S>(numbers(scene.base), numbers(top), scene.radius as f64);
    let ray = ray(numbers(scene.origin), numbers(scene.direction));

    let got = spans(&solid, &ray);
    match (span(scene, 1, S::EPSILON), span(scene, -1, S::EPSILON)) {
        (None, None) => prop_assert!(got.is_empty(), "hit: {:?}", got),
        (Some(outer), Some(inner)) => {
            prop_assert!(!got.is_empty(), "missed");
            let [from, to] = rounded_to::<S>(got[0].0);
            prop_assert!(outer[0].order(&to).is_le(), "enters early: {:?}", got);
            prop_assert!(inner[0].order(&from).is_ge(), "enters late: {:?}", got);
            let [from, to] = rounded_to::<S>(got[0].1);
            prop_assert!(inner[1].order(&to).is_le(), "exits early: {:?}", got);
            prop_assert!(outer[1].order(&from).is_ge(), "exits late: {:?}", got);
        }
        _ => {}
    }

    let got = CylinderWall::of(&solid).hit(&ray);
    // Which root counts depends on radius, caps and start, and growing is not always for the
    // better: a start on the wall gets inside. So all ways are tried.
    let tubes: Vec<Option<Surd>> = (0..9)
        .map(|i| tube(scene, (i % 3 - 1, S::EPSILON[0]), (i / 3 - 1, S::EPSILON[1])))
        .collect();
    let roots = |s: i64| tubes.iter().flatten().filter(move |t| t.s == s).count();
    if tubes.iter().all(Option::is_none) {
        prop_assert!(got.is_none(), "wall hit: {:?}", got);
    } else if roots(-1) == 9 || roots(1) == 9 {
        prop_assert!(got.is_some(), "missed the wall");
        let got = got.unwrap();
        let [from, to] = rounded_to::<S>(got.t.to_f64());
        let [of_grown, of_shrunk] =
            [1, -1].map(|sign| tube(scene, (sign, S::EPSILON[0]), (0, 0)).unwrap());
        let first = roots(-1) == 9;
        let [early, late] = if first { [of_grown, of_shrunk] } else { [of_shrunk, of_grown] };
        prop_assert!(early.order(&to).is_le(), "early: {:?}", got);
        prop_assert!(late.order(&from).is_ge(), "late: {:?}", got);
    }
    Ok(())
}

/// On whole numbers nothing that decides about a wall along a coordinate axis is rounded: tangents
/// are misses, and the next grid line is a hit.
fn check_tangent<S: Exact>(scene: &Scene, axis: usize) -> Result<(), TestCaseError> {
    let mut along = Scene { axis: [0; 3], ..*scene };
    along.axis[axis] = 64;
    along.base[axis] = -32;
    let exact = wall(&along, (0, 0));
    let touches = matches!(&exact, Err([root, _]) if root.q == IBig::ZERO);
    let misses = touches || matches!(exact, Ok(false));
    let [x, y, z] = numbers(along.base).map(S::near);
    let middle = [[y, z], [x, z], [x, y]][axis];
    let [radius, low, high] = [along.radius as f64, -4000.0, 4000.0].map(S::near);
    let solid = S::along(axis, middle, radius, low, high).unwrap();
    let ray = ray(numbers(along.origin), numbers(along.direction));
    prop_assert_eq!(spans(&solid, &ray).is_empty(), misses);
    Ok(())
}

macro_rules! exact {
    ($($name:ident $S:ty),+) => {$(
        mod $name {
            use super::*;

            proptest! {
                #![proptest_config(ProptestConfig::with_cases(1000))]

                #[test]
                fn spans_and_walls(scene in scenes()) {
                    check::<$S>(&scene)?;
                }

                #[test]
                fn tangents_are_decided_exactly(scene in scenes(), axis in 0..3usize) {
                    check_tangent::<$S>(&scene, axis)?;
                }
            }
        }
    )+};
}

exact!(f32 f32, f64 f64, i16f16 I16F16);

/// The model would prove nothing if its scenes were all misses, or all hung by a hair.
#[test]
fn the_scenes_are_worth_it() {
    use proptest::strategy::ValueTree;
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let mut counts = [0; 4];
    for _ in 0..2000 {
        let scene = scenes().new_tree(&mut runner).unwrap().current();
        let classes = [1, -1].map(|sign| span(&scene, sign, [17; 2]).is_some());
        let tubes = [1, -1].map(|sign| tube(&scene, (sign, 17), (0, 0)).is_some());
        counts[0] += usize::from(classes == [true; 2]);
        counts[1] += usize::from(classes == [false; 2]);
        counts[2] += usize::from(tubes == [true; 2]);
        counts[3] += usize::from(tubes == [false; 2]);
    }
    assert!(counts.iter().all(|&count| count > 500), "{counts:?}");
    assert!(counts[0] + counts[1] > 1900, "{counts:?}");
}
