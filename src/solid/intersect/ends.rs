//! Lines and solid cylinders, in floating point: where a line enters and exits, and through which faces.
//!
//! Ordinary lines are answered here, by plain sums; all others are handed over to functions that
//! return in place of this one, so that nothing is kept for afterwards. On a host, numbers go from
//! function to function in registers, in both directions: a line or a span in memory, written in
//! pieces and then read as a whole, would wait for the writes.

use super::Passage;
use super::aligned::{Aligned, gap};
use super::compensated::{Inside, meet, pass};
use crate::geom::{Line, Vec3};
use crate::scalar::Float;
use crate::solid::cylinder::{Cylinder, Tube, WALL};
use crate::span::{Crossing, Face, Span};

/// What the line has in the cylinder.
#[inline(always)]
pub(super) fn cut<S: Float>(cylinder: &Cylinder<S>, line: &Line<S>) -> Option<Span<S>> {
    let Line { origin: o, direction: d } = *line;
    let mut faces = [WALL; 2];
    // Rare lines get a copy, so that the line itself may stay in registers.
    let copy = &{ *line };
    let (enter, exit) = ends(cylinder, copy, o.x, o.y, o.z, d.x, d.y, d.z, &mut faces);
    let [first, last] = faces;
    Span::new(Crossing { t: enter, face: first }, Crossing { t: exit, face: last })
}

/// Where the line is inside the cylinder, if the first parameter is below the second one; then it
/// passes through these faces.
///
/// Plain sums do for a line that starts outside of the wall, comes nearer, and doesn't come near a
/// tangent. The error of k is that of |q||m|, which s is about as large as; D > k²/8 holds down the
/// k/√D times as much of it that reaches s, and from c > r² on little cancels in c and b.
///
/// The quotients of one plane come early, and those of the other late: side by side, the compiler
/// pairs them in vectors, whose numbers it then has to take apart.
// Where 64 bits make a host, a call costs less than what its callers gain by being small: they are
// inlined in turn. On a Cortex-M4F it costs 13 instructions.
#[cfg_attr(target_pointer_width = "64", inline(never))]
#[cfg_attr(not(target_pointer_width = "64"), inline(always))]
#[expect(clippy::too_many_arguments, reason = "numbers in registers")]
fn ends<S: Float>(
    cylinder: &Cylinder<S>,
    line: &Line<S>,
    ox: S,
    oy: S,
    oz: S,
    dx: S,
    dy: S,
    dz: S,
    faces: &mut [Face; 2],
) -> Inside<S> {
    let Cylinder { tube, caps } = cylinder;
    let same = Line { origin: Vec3::new(ox, oy, oz), direction: Vec3::new(dx, dy, dz) };
    let Some(sums) = Aligned::new(cylinder, &same) else { return carefully(cylinder, line, faces) };
    let Aligned { q, a, b, k, at_zero, speed, .. } = sums;
    let low = (caps.low - at_zero) / speed;
    let radius_squared = tube.radius * tube.radius;
    let (largest, square) = (radius_squared * a, k * k);
    let discriminant = largest - square;
    if discriminant * S::from_int(8) > square {
        let half = discriminant.sqrt();
        let Some(difference) = S::quick_square_less(q[0], radius_squared) else {
            return half_way(cylinder, line, faces);
        };
        let c = difference + q[1] * q[1];
        if !(b > S::ZERO && c > radius_squared) {
            return nearby(cylinder, line, c, half, b, a, low, at_zero, speed, faces);
        }
        let s = half + b;
        let high = (caps.high - at_zero) / speed;
        between_caps(cylinder, line, (c / s, s / a), [low, high], speed, faces)
    } else if sums.is_beside(largest, discriminant) {
        Tube::NOWHERE
    } else {
        carefully(cylinder, line, faces)
    }
}

/// [`ends`] of a line that isn't near a tangent, but starts near the wall or inside, or doesn't come
/// nearer.
///
/// Near the wall c is compensated. Nothing else has to be: √D·s > r²a/2 holds the error of D, a few
/// units of r²a, to a few units of s when it reaches s divided by 2√D.
#[cold]
#[inline(never)]
#[expect(clippy::too_many_arguments, reason = "numbers in registers")]
fn nearby<S: Float>(
    cylinder: &Cylinder<S>,
    line: &Line<S>,
    c: S,
    half: S,
    b: S,
    a: S,
    low: S,
    at_zero: S,
    speed: S,
    faces: &mut [Face; 2],
) -> Inside<S> {
    let Cylinder { tube, caps } = cylinder;
    let radius_squared = tube.radius * tube.radius;
    let c = if c > radius_squared {
        c
    } else if b != S::ZERO && half * (half + b.abs()) > radius_squared * a * S::HALF {
        gap(cylinder, line)
    } else {
        return carefully(cylinder, line, faces);
    };
    let inside = if b > S::ZERO {
        let s = half + b;
        (c / s, s / a)
    } else {
        let s = b - half;
        (s / a, c / s)
    };
    let high = (caps.high - at_zero) / speed;
    between_caps(cylinder, line, inside, [low, high], speed, faces)
}

/// [`ends`] of a line that isn't near a tangent, where c can't be had quickly: on some targets, and so
/// with the bits of the others. So rare that all is computed anew.
#[cold]
#[inline(never)]
fn half_way<S: Float>(cylinder: &Cylinder<S>, line: &Line<S>, faces: &mut [Face; 2]) -> Inside<S> {
    let Cylinder { tube, caps } = cylinder;
    let Some(sums) = Aligned::new(cylinder, line) else { return carefully(cylinder, line, faces) };
    let Aligned { q, a, b, k, at_zero, speed, .. } = sums;
    let low = (caps.low - at_zero) / speed;
    let radius_squared = tube.radius * tube.radius;
    let half = (radius_squared * a - k * k).sqrt();
    let c = S::square_less(q[0], radius_squared) + q[1] * q[1];
    nearby(cylinder, line, c, half, b, a, low, at_zero, speed, faces)
}

/// [`ends`] of any line.
#[cold]
#[inline(never)]
fn carefully<S: Float>(cylinder: &Cylinder<S>, line: &Line<S>, faces: &mut [Face; 2]) -> Inside<S> {
    between_any_caps(cylinder, line, meet(cylinder, line), faces)
}

/// What is between the caps of any line's part inside the wall.
#[cold]
#[inline(never)]
fn between_any_caps<S: Float>(
    cylinder: &Cylinder<S>,
    line: &Line<S>,
    inside: Inside<S>,
    faces: &mut [Face; 2],
) -> Inside<S> {
    match pass(&cylinder.caps, line) {
        Passage::Across { at, .. } => common(inside, at, faces),
        Passage::Along { inside: true } => common(inside, [S::LOWEST, S::HIGHEST], faces),
        Passage::Along { inside: false } => Tube::NOWHERE,
    }
}

/// What is between the caps of a line's part inside the wall.
///
/// A line along the planes passes them at infinity, or at 0/0. That it has nothing is looked into
/// last, because such lines are rare. Where it meets the wall doesn't depend on the planes, by not a bit:
/// another cylinder may have the same wall, and other caps.
#[inline(always)]
fn between_caps<S: Float>(
    cylinder: &Cylinder<S>,
    line: &Line<S>,
    inside: Inside<S>,
    planes: [S; 2],
    speed: S,
    faces: &mut [Face; 2],
) -> Inside<S> {
    let (enter, exit) = common(inside, planes, faces);
    if enter < exit || speed != S::ZERO {
        (enter, exit)
    } else {
        between_any_caps(cylinder, line, inside, faces)
    }
}

/// What is both inside the wall and between the planes of the caps, which are the low one and the high
/// one. Where both begin or end together, the face is the cap's.
#[inline(always)]
fn common<S: Float>(
    (enter, exit): Inside<S>,
    [low, high]: [S; 2],
    faces: &mut [Face; 2],
) -> Inside<S> {
    let (near, far, caps) =
        if low < high { (low, high, [Face(0), Face(1)]) } else { (high, low, [Face(1), Face(0)]) };
    let (enter, first) = if enter > near { (enter, WALL) } else { (near, caps[0]) };
    let (exit, last) = if exit < far { (exit, WALL) } else { (far, caps[1]) };
    *faces = [first, last];
    (enter, exit)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn ends_of(cylinder: &Cylinder<f32>, line: &Line<f32>) -> (Inside<f32>, [Face; 2]) {
        let Line { origin: o, direction: d } = *line;
        let mut faces = [WALL; 2];
        (ends(cylinder, line, o.x, o.y, o.z, d.x, d.y, d.z, &mut faces), faces)
    }

    proptest! {
        /// Targets that find a fused difference quickly where others don't must not see it in a bit.
        #[test]
        fn a_detour_changes_no_bits(
            axis in 0usize..3, base in [-2f32..2.0, -2f32..2.0], r in 0.1f32..3.0,
            o in [-5f32..5.0, -5f32..5.0, -5f32..5.0], d in [-1f32..1.0, -1f32..1.0, -1f32..1.0],
            along_caps in proptest::bool::weighted(0.1), in_cap in proptest::bool::weighted(0.1),
        ) {
            let [mut o, mut d] = [o, d];
            if along_caps {
                d[axis] = 0.0;
            }
            if in_cap {
                o[axis] = 1.5;
            }
            let [s, t] = base;
            let made = match axis {
                0 => Cylinder::<f32>::along_x(s, t, r, -1.0, 1.5),
                1 => Cylinder::<f32>::along_y(s, t, r, -1.0, 1.5),
                _ => Cylinder::<f32>::along_z(s, t, r, -1.0, 1.5),
            };
            let cylinder = made.map_err(|error| TestCaseError::fail(error.as_str()))?;
            let line = Line { origin: Vec3::from(o), direction: Vec3::from(d) };
            let sums = Aligned::new(&cylinder, &line);
            prop_assume!(sums.is_some_and(|s| (r * r * s.a - s.k * s.k) * 8.0 > s.k * s.k));
            let mut faces = [WALL; 2];
            let (enter, exit) = half_way(&cylinder, &line, &mut faces);
            let ((first, last), same) = ends_of(&cylinder, &line);
            prop_assert_eq!([enter.to_bits(), exit.to_bits()], [first.to_bits(), last.to_bits()]);
            prop_assert_eq!(faces, same);
        }
    }
}
