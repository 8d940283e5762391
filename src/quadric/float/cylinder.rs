//! Where a line is inside a cylinder's wall, between its caps.
//!
//! Plain sums answer ordinary lines. All others are handed over to cold paths.

use super::aligned::Aligned;
use super::planes::planes;
use super::sums::square_less;
use crate::geom::Line;
use crate::quadric::{Planes, WALL, Wall};
use crate::scalar::{Float, Roots};
use crate::span::{Crossing, Face, Span};

/// Plain sums do for a line that starts outside of the wall, comes nearer, and doesn't come near a
/// tangent. The error of k is that of |q||m|, which s is about as large as. D > k²/8 holds down the
/// k/√D times as much of it that reaches s. From c > r² on little cancels in c and b.
#[inline(always)]
pub(in crate::quadric) fn cylinder<S: Float>(
    wall: &Wall<S>,
    caps: &Planes<S>,
    line: &Line<S>,
) -> Option<Span<S>> {
    let Some(sums) = Aligned::new(wall, caps, line) else { return carefully(wall, caps, line) };
    let Aligned { q, a, b, k, at_zero, speed, .. } = sums;
    let radius_squared = wall.radius * wall.radius;
    let (largest, square) = (radius_squared * a, k * k);
    let discriminant = largest - square;
    if discriminant * S::from_int(8) > square {
        let half = discriminant.sqrt();
        let c = square_less(q[0], radius_squared) + q[1] * q[1];
        if !(b > S::ZERO && c > radius_squared) {
            return nearby(wall, caps, line, c, half);
        }
        let s = half + b;
        between_caps(caps, line, (c / s, s / a), at_zero, speed)
    } else if sums.is_beside(largest, discriminant) {
        None
    } else {
        carefully(wall, caps, line)
    }
}

/// A line that isn't near a tangent, but starts near the wall or inside, or doesn't come nearer.
///
/// Near the wall c is compensated. Nothing else has to be: √D·s > r²a/2 holds the error of D, a few
/// units of r²a, to a few units of s when it reaches s divided by 2√D.
#[cold]
#[inline(never)]
fn nearby<S: Float>(
    wall: &Wall<S>,
    caps: &Planes<S>,
    line: &Line<S>,
    c: S,
    half: S,
) -> Option<Span<S>> {
    let (axis, sums) = (caps.normal.along()?, Aligned::new(wall, caps, line)?);
    let Aligned { a, b, at_zero, speed, .. } = sums;
    let radius_squared = wall.radius * wall.radius;
    let c = if c > radius_squared {
        c
    } else if b != S::ZERO && half * (half + b.abs()) > radius_squared * a * S::HALF {
        wall.aligned_gap(axis, line)
    } else {
        return carefully(wall, caps, line);
    };
    let inside = if b > S::ZERO {
        let s = half + b;
        (c / s, s / a)
    } else {
        let s = b - half;
        (s / a, c / s)
    };
    between_caps(caps, line, inside, at_zero, speed)
}

/// Any line.
#[cold]
#[inline(never)]
fn carefully<S: Float>(wall: &Wall<S>, caps: &Planes<S>, line: &Line<S>) -> Option<Span<S>> {
    between_any_caps(caps, line, meet(wall, caps, line).ends()?)
}

/// Where any line is inside the wall, however near to a tangent it is.
fn meet<S: Float>(wall: &Wall<S>, caps: &Planes<S>, line: &Line<S>) -> Roots<S> {
    match caps.normal.along() {
        Some(axis) => wall.meet_aligned(axis, line),
        None => wall.meet_obliquely(&caps.normal, line),
    }
}

/// What is between the caps of any line's part inside the wall.
#[cold]
#[inline(never)]
fn between_any_caps<S: Float>(caps: &Planes<S>, line: &Line<S>, inside: (S, S)) -> Option<Span<S>> {
    let Span { enter, exit } = planes(caps, line).ends()?;
    common(inside, (enter.t, exit.t), [enter.face, exit.face])
}

/// What is between the caps of a line's part inside the wall.
///
/// A line along the planes passes them at infinity, or at 0/0. Such lines are rare, so they are looked
/// for last. Where a line meets the wall doesn't depend on the planes, by not a bit: another cylinder
/// may have the same wall and other caps.
#[inline(always)]
fn between_caps<S: Float>(
    caps: &Planes<S>,
    line: &Line<S>,
    inside: (S, S),
    at_zero: S,
    speed: S,
) -> Option<Span<S>> {
    let [low, high] = [caps.low, caps.high].map(|offset| (offset - at_zero) / speed);
    let span = if low < high {
        common(inside, (low, high), [Face(0), Face(1)])
    } else {
        common(inside, (high, low), [Face(1), Face(0)])
    };
    if span.is_some() || speed != S::ZERO { span } else { between_any_caps(caps, line, inside) }
}

/// What is both inside the wall and between the planes of the caps.
#[inline(always)]
pub(super) fn common<S: Float>(
    (enter, exit): (S, S),
    (near, far): (S, S),
    [near_face, far_face]: [Face; 2],
) -> Option<Span<S>> {
    let pick = |is_wall, wall, cap, face| Crossing {
        t: if is_wall { wall } else { cap },
        face: if is_wall { WALL } else { face },
    };
    Span::new(pick(enter > near, enter, near, near_face), pick(exit < far, exit, far, far_face))
}

/// Where the line crosses the wall between the caps.
pub(in crate::quadric) fn open_cylinder<S: Float>(
    wall: &Wall<S>,
    caps: &Planes<S>,
    line: &Line<S>,
) -> [Option<S>; 2] {
    // `None` is a line beside the wall, or along it: it crosses nothing.
    let Some((enter, exit)) = meet(wall, caps, line).ends() else { return [None; 2] };
    let (at_zero, speed) = (caps.normal.dot(line.origin), caps.normal.dot(line.direction));
    [enter, exit].map(|t| {
        let height = S::add_product(at_zero, t, speed);
        (caps.low <= height && height <= caps.high).then_some(t)
    })
}
