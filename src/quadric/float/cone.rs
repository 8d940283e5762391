//! Where a line is inside a cone's wall, between its caps.
//!
//! With L the distance of the caps and ΔR the difference of the radii, the wall is where `L|q + t·m|` is
//! `|A|(R + t·R′)`: R + t·R′ is L times the radius at the line's height, and affine in t. So a = L²|m|² −
//! |A|²R′², b = L² q·m − |A|²RR′ and c = L²|q|² − |A|²R². The discriminant b² − ac is computed as
//! `L²|A|²(|w|² − L²(u·m)²)` with w = R·m − R′·q: no squares of large distances cancel.
//!
//! Where a > 0, the line meets one of the two nappes, twice. Where a < 0 it is steeper than the side and
//! meets both, once each: between the caps, the one towards which the radius grows.

use super::cylinder::common;
use super::doubles::{cross, difference, dot, widened};
use super::planes::planes;
use super::sums::points;
use crate::geom::Line;
use crate::quadric::{Conic, Planes, Taper};
use crate::scalar::{Double, Float, Roots};
use crate::span::Span;

pub(in crate::quadric) fn cone<S: Float>(
    taper: &Taper<S>,
    caps: &Planes<S>,
    line: &Line<S>,
) -> Option<Span<S>> {
    let [enter, exit] = closely(taper, caps, line)?;
    let Span { enter: near, exit: far } = planes(caps, line).ends()?;
    common((enter, exit), (near.t, far.t), [near.face, far.face])
}

/// Where any line is inside the nappe between the caps, in twice the working precision throughout.
fn closely<S: Float>(taper: &Taper<S>, caps: &Planes<S>, line: &Line<S>) -> Option<[S; 2]> {
    let [low, high] = taper.radii;
    let (length, rise) = (Double::sum(caps.high, -caps.low), Double::sum(high, -low));
    // Only their quotient counts: near 1, nothing overflows.
    let power = length.high.max(rise.high.abs()).normalizing_power();
    let scaled = |x: Double<S>| Double { high: x.high * power, low: x.low * power };
    let (length, rise) = (scaled(length), scaled(rise));

    let (axis, d) = (widened(caps.normal.vector()), widened(line.direction));
    let u = difference(line.origin, taper.base);
    let (q, m) = (cross(u, axis), cross(d, axis));
    let axis = axis.to_array();
    let height = dot(widened(line.origin).to_array(), axis).minus(Double::from(caps.low));
    let radius = Double::from(low).times(length).plus(rise.times(height));
    let growth = rise.times(dot(d.to_array(), axis));

    let (one, square) = (dot(axis, axis), length.times(length));
    let less =
        |across: Double<S>, outwards: Double<S>| square.times(across).minus(one.times(outwards));
    let a = less(dot(m, m), growth.times(growth)).round();
    let b = less(dot(q, m), radius.times(growth)).round();
    let c = less(dot(q, q), radius.times(radius)).round();
    let (of_m, of_q) = (m.map(|part| part.times(radius)), q.map(|part| part.times(growth)));
    let ([m0, m1, m2], [q0, q1, q2]) = (of_m, of_q);
    let w = [m0.minus(q0), m1.minus(q1), m2.minus(q2)];
    let k = dot(u.to_array(), m).times(length);
    let discriminant = dot(w, w).minus(k.times(k)).times(square).times(one).round();
    nappe(a, b, c, discriminant, growth.high)
}

/// Where a pixel's ray is inside the nappe between the caps, from plain sums.
#[inline(always)]
pub(in crate::quadric) fn conic<S: Float>(conic: &Conic<S>) -> Option<[S; 2]> {
    let &Conic { from: [x, y, radius], step: [dx, dy, growth] } = conic;
    let a = dx * dx + dy * dy - growth * growth;
    let b = x * dx + y * dy - radius * growth;
    let c = x * x + y * y - radius * radius;
    let (w0, w1, k) = (radius * dx - growth * x, radius * dy - growth * y, x * dy - y * dx);
    nappe(a, b, c, w0 * w0 + w1 * w1 - k * k, growth)
}

/// Where `a t² + 2 b t + c` is below zero in the nappe between the caps: from one root to the other, or
/// beyond one of them, where the radius grows.
#[inline(always)]
fn nappe<S: Float>(a: S, b: S, c: S, discriminant: S, growth: S) -> Option<[S; 2]> {
    if a >= S::ZERO && discriminant < S::ZERO {
        return None;
    }
    // A line that is steeper meets both nappes: below zero, it was rounded there.
    let discriminant = discriminant.max(S::ZERO);
    let s = discriminant.sqrt() + b.abs();
    if a == S::ZERO && s == S::ZERO {
        // Along the side of a cylinder, or of a cone in its tangent plane.
        return (c < S::ZERO).then_some([S::LOWEST, S::HIGHEST]);
    }
    // Along the side of a cone, one of the points is at infinity.
    let Roots::Between(first, last) = points(s / a, c / s, b, discriminant) else {
        return None;
    };
    Some(if a >= S::ZERO {
        [first, last]
    } else if growth > S::ZERO {
        [last, S::HIGHEST]
    } else {
        [S::LOWEST, first]
    })
}
