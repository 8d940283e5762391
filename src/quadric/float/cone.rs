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
    let [enter, exit] = match plainly(taper, caps, line) {
        Some(inside) => inside?,
        None => closely(taper, caps, line)?,
    };
    let Span { enter: near, exit: far } = planes(caps, line).ends()?;
    common((enter, exit), (near.t, far.t), [near.face, far.face])
}

/// Where a line is inside the wall, from plain sums; `None` where these may not be precise, or where the line
/// is as steep as the side or steeper.
///
/// With ε for a rounding, u, w and k are off by some ε of what they are summed from: `across`, `wide` and
/// `deep`. So D is off by ε(|w|·wide + |k|·deep), which reaches s divided by 2√D. A quotient of s is kept
/// where both that and the error of b are small beside s, and where little cancels in a and in c.
#[inline(always)]
fn plainly<S: Float>(taper: &Taper<S>, caps: &Planes<S>, line: &Line<S>) -> Option<Option<[S; 2]>> {
    let axis = caps.normal.vector();
    let [low, high] = taper.radii;
    let slope = (high - low) / (caps.high - caps.low);
    let (u, d) = (line.origin - taper.base, line.direction);
    let (q, m) = (u.cross(axis), d.cross(axis));
    let height = caps.normal.dot(line.origin);
    let radius = low + slope * (height - caps.low);
    let growth = slope * caps.normal.dot(d);
    let (of_m, of_q) = (m.length_squared(), q.length_squared());
    let a = of_m - growth * growth;
    let b = q.dot(m) - radius * growth;
    let c = of_q - radius * radius;
    let w = m * radius - q * growth;
    let k = u.dot_compensated(m);
    let (of_w, of_k) = (w.length_squared(), k * k);
    let discriminant = of_w - of_k;

    let size = low.max(high) + slope.abs() * (height.abs() + caps.low.abs());
    let (across, speed) = (u.length_squared(), d.length_squared());
    let [half, eight] = [S::HALF, S::from_int(8)];
    let is_clear = a > half * of_m && eight * c.abs() > across + size * size;
    // Squares: of |w|·wide + |k|·deep, but for a factor of 2.
    let wide = size * size * speed + slope * slope * speed * across;
    let blur = of_w * wide + of_k * across * speed;
    if !is_clear {
        return None;
    }
    if discriminant < S::ZERO {
        let error = (blur.sqrt() + of_k) * S::EPSILON * S::from_int(32);
        return (discriminant < -error).then_some(None);
    }
    let s = discriminant.sqrt() + b.abs();
    let square = s * s;
    let is_precise =
        blur < (eight + eight) * discriminant * square && across * speed < eight * square;
    if !is_precise {
        return None;
    }
    match points(s / a, c / s, b, discriminant) {
        Roots::Between(first, last) => Some(Some([first, last])),
        Roots::Outside | Roots::Everywhere => None,
    }
}

/// Where any line is inside the nappe between the caps, in twice the working precision throughout.
#[cold]
#[inline(never)]
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
///
/// Along the side, a and the discriminant are what rounding leaves of them. Two roots come of them only
/// if they fit together: so there the discriminant is that of the rounded a.
#[inline(always)]
pub(in crate::quadric) fn conic<S: Float>(conic: &Conic<S>) -> Option<[S; 2]> {
    let &Conic { from: [x, y, radius], step: [dx, dy, growth] } = conic;
    let (of_m, of_growth) = (dx * dx + dy * dy, growth * growth);
    let a = of_m - of_growth;
    let b = x * dx + y * dy - radius * growth;
    let c = x * x + y * y - radius * radius;
    let discriminant = if a.abs() <= of_growth * S::EPSILON * S::from_int(16) {
        b * b - a * c
    } else {
        let (w0, w1, k) = (radius * dx - growth * x, radius * dy - growth * y, x * dy - y * dx);
        w0 * w0 + w1 * w1 - k * k
    };
    nappe(a, b, c, discriminant, growth)
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
