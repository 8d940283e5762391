//! Where a line is inside a cone's wall, between its caps.
//!
//! With L the distance of the caps and ΔR the difference of the radii, the wall is where `L|q + t·m|` is
//! R + t·R′, which is L times the radius at the line's height. As vectors of four coordinates,
//! Q = (L·q, R) and M = (L·m, R′) give a, b and c as the products ⟨M, M⟩, ⟨Q, M⟩ and ⟨Q, Q⟩ in which the
//! last coordinate counts negative. The discriminant b² − ac is a sum of squares of minors of Q and M.
//!
//! Along a coordinate axis all is exact: L ≤ 2²⁹, |q| and a line's heights are below 2³¹, |m| ≤ 2³¹ and
//! radii are ≤ 2²⁸, so neither vector is longer than 2⁶¹·⁵. Along other axes the coordinates have 28 bits
//! more. There they are rounded by about as many bits as the larger of L and ΔR has, so that Q and M are no
//! longer either. Of that larger one times a length, 2⁻²⁸ units of the grid are left of the rounding: a
//! parameter is off by far less than the half unit that it is rounded by at the end, but where a line grazes
//! the wall by as little as that.
//!
//! So products are below 2¹²³ and the discriminant is below 2²⁴⁶, and so is `a t²` for a fraction t whose
//! parts have 60 bits.
//!
//! In pictures no coordinate has more than 31 bits, M is not longer than 2³¹ and Q not than 2³²: the
//! discriminant, and `a t²` with parameters of 32 bits and a half, are below 2¹²⁷.

use super::between::{cut, overlap};
use super::lines::{bits, cross, dot, is_in_range, unit_bits, way};
use super::planes::Crossings;
use super::quadratic::{Integer, Quadratic};
use crate::geom::{Line, Vec3};
use crate::quadric::{Conic, Planes, Taper, WALL};
use crate::scalar::{FixedPoint, integer};
use crate::span::{Crossing, Span};
use ethnum::I256;

/// ⟨Q + t·M, Q + t·M⟩.
#[inline(always)]
fn quadratic<W: Integer>(q: [i64; 4], m: [i64; 4]) -> Quadratic<W> {
    let product = |x: i64, y: i64| i128::from(x) * i128::from(y);
    let form = |[x0, x1, x2, x3]: [i64; 4], [y0, y1, y2, y3]: [i64; 4]| {
        W::from(product(x0, y0) + product(x1, y1) + product(x2, y2) - product(x3, y3))
    };
    let square = |x: i128| W::from(x) * W::from(x);
    let minor = |q: [i64; 2], m: [i64; 2]| square(product(q[0], m[1]) - product(q[1], m[0]));
    let ([q0, q1, q2, q3], [m0, m1, m2, m3]) = (q, m);
    let outwards =
        minor([q0, q3], [m0, m3]) + minor([q1, q3], [m1, m3]) + minor([q2, q3], [m2, m3]);
    let across = minor([q0, q1], [m0, m1]) + minor([q1, q2], [m1, m2]) + minor([q2, q0], [m2, m0]);
    Quadratic { a: form(m, m), b: form(q, m), c: form(q, q), discriminant: outwards - across }
}

/// Where the quadratic is below zero in the nappe between the caps: from one root to the other, or beyond
/// one of them, where the radius grows.
fn nappe<S: FixedPoint, W: Integer>(
    quadratic: &Quadratic<W>,
    growth: i64,
    fraction: u32,
) -> Option<[S; 2]> {
    let &Quadratic { a, b, c, discriminant } = quadratic;
    let zero = W::from(0);
    if a == zero && b == zero {
        return (c < zero).then_some([S::LOWEST, S::HIGHEST]);
    }
    if a < zero {
        // A line that is steeper than the side meets both nappes.
        let between_nappes = Quadratic { a: -a, b: -b, c: -c, discriminant };
        let [first, last] = between_nappes.roots(fraction).map(S::from_bits);
        return Some(if growth > 0 { [last, S::HIGHEST] } else { [S::LOWEST, first] });
    }
    // Along the side, one of the roots is beyond the grid.
    (discriminant >= zero).then(|| quadratic.roots(fraction).map(S::from_bits))
}

/// Q and M.
fn vectors<S: FixedPoint>(
    taper: &Taper<S>,
    caps: &Planes<S>,
    line: &Line<S>,
    crossings: &Crossings,
) -> [[i64; 4]; 2] {
    let (u, d) = (way(taper.base, line.origin), bits(line.direction));
    let [low, high, r0, r1] =
        [caps.low, caps.high, taper.radii[0], taper.radii[1]].map(|x| i64::from(x.to_bits()));
    let (length, rise) = (high - low, r1 - r0);
    // R = r₀(high − h) + r₁(h − low)
    let &Crossings { heights: [to_low, to_high], speed } = crossings;
    if let Some(along) = caps.normal.along() {
        let across = |[x, y, z]: [i64; 3]| along.across(Vec3 { x, y, z }).map(|x| length * x);
        let ([q0, q1], [m0, m1]) = (across(u), across(d));
        return [[q0, q1, 0, r0 * to_high - r1 * to_low], [m0, m1, 0, rise * speed]];
    }
    let axis = unit_bits::<S>(caps.normal.vector());
    let product = |x: i64, y: i64| i128::from(x) * i128::from(y);
    let drop = 63 - (length | rise.abs()).leading_zeros().min(62);
    let rounded = |x: i128| integer::shift_right_wide(x, drop);
    let across = |v: [i64; 3]| cross(v, axis).map(|x| rounded(product(length, x)));
    // Times |A| = √(1 + (|A|² − 1)), of a rounded axis A.
    let excess = i128::from(dot(axis, axis) - (1 << 56));
    let outwards = |x: i128| rounded(x + ((x * excess) >> 57));
    let ([q0, q1, q2], [m0, m1, m2]) = (across(u), across(d));
    let radius = product(r0, to_high) - product(r1, to_low);
    [[q0, q1, q2, outwards(radius)], [m0, m1, m2, outwards(product(rise, speed))]]
}

pub(in crate::quadric) fn cone<S: FixedPoint>(
    taper: &Taper<S>,
    caps: &Planes<S>,
    line: &Line<S>,
) -> Option<Span<S>> {
    if !is_in_range(line) {
        return None;
    }
    let crossings = Crossings::new(caps, line);
    let [q, m] = vectors(taper, caps, line, &crossings);
    let (quadratic, [.., growth]) = (quadratic::<I256>(q, m), m);
    let at = |t| Crossing { t, face: WALL };
    if crossings.speed == 0 {
        // Parallel to the caps, it is between them all along the wall, or nowhere.
        let [enter, exit] = quadratic.chord(S::BITS)?.map(S::from_bits);
        let span = Span { enter: at(enter), exit: at(exit) };
        return crossings.is_between(caps).then_some(span)?.checked();
    }
    let [enter, exit] = nappe(&quadratic, growth, S::BITS)?;
    let in_wall = Span { enter: at(enter), exit: at(exit) };
    cut(in_wall, &crossings, || overlap(&quadratic, &crossings))
}

pub(in crate::quadric) fn conic<S: FixedPoint>(conic: &Conic<S>) -> Option<[S; 2]> {
    let ([x, y, radius], [dx, dy, growth]) =
        (conic.from.map(S::to_bits), conic.step.map(S::unit_bits));
    let [q, m] = [[x, y, 0, radius], [dx, dy, 0, growth]].map(|v| v.map(i64::from));
    // No picture that fits the number type has longer ones.
    if m.into_iter().map(|part| part.unsigned_abs().pow(2)).sum::<u64>() > 1 << 62 {
        return None;
    }
    // Q is in units of the grid and M in those of directions, so a root is, too.
    nappe(&quadratic::<i128>(q, m), m[3], 28)
}
