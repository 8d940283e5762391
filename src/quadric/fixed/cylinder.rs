//! Where a line is inside a cylinder's wall, between its caps.

use super::aligned::{Section, aligned_cylinder};
use super::between::{cut, overlap, roots};
use super::lines::{bits, cross, dot, is_in_range, square, unit_bits, way, wide_dot};
use super::planes::Crossings;
use super::quadratic::{Integer, Quadratic, Root};
use crate::geom::{Direction, Line};
use crate::quadric::{Planes, WALL, Wall};
use crate::scalar::{FixedPoint, Roots};
use crate::span::{Crossing, Span};
use ethnum::I256;

/// |(u + t·d) × A|² − r²|A|² for an axis A.
fn oblique<S: FixedPoint>(wall: &Wall<S>, axis: &Direction<S>, line: &Line<S>) -> Quadratic<I256> {
    let (u, axis) = (way(wall.base, line.origin), unit_bits::<S>(axis.vector()));
    let (q, m) = (cross(u, axis), cross(bits(line.direction), axis));
    let square = I256::from(square(wall.radius));
    let length_squared = I256::from(dot(axis, axis));
    let [a, b, c, k] = [wide_dot(m, m), wide_dot(q, m), wide_dot(q, q), wide_dot(u, m)];
    let [a, b, c, k] = [a, b, c, k].map(I256::from);
    Quadratic {
        a,
        b,
        c: c - square * length_squared,
        // |q × m|² = |A|² (u·m)², because q and m are at right angles to A.
        discriminant: length_squared * (square * a - k * k),
    }
}

/// Where a line enters a wall and exits it, as far as these points are between the planes, or on one.
fn on_wall<S: FixedPoint, W: Integer>(
    quadratic: &Quadratic<W>,
    caps: &Crossings,
) -> [Option<S>; 2] {
    let Roots::Between(enter, exit) = roots(quadratic) else { return [None; 2] };
    let [first, last, speed] = caps.fractions();
    [(Root::Enter, enter), (Root::Exit, exit)].map(|(root, t)| {
        let is_between = if speed == 0 {
            caps.touches()
        } else {
            quadratic.is_at_or_above(root, first, speed)
                && quadratic.is_at_or_below(root, last, speed)
        };
        is_between.then_some(t)
    })
}

pub(in crate::quadric) fn cylinder<S: FixedPoint>(
    wall: &Wall<S>,
    caps: &Planes<S>,
    line: &Line<S>,
) -> Option<Span<S>> {
    match caps.normal.along() {
        Some(_) => aligned_cylinder(wall, caps, line),
        None => oblique_cylinder(wall, caps, line),
    }
}

#[inline(never)]
fn oblique_cylinder<S: FixedPoint>(
    wall: &Wall<S>,
    caps: &Planes<S>,
    line: &Line<S>,
) -> Option<Span<S>> {
    if !is_in_range(line) {
        return None;
    }
    let quadratic = oblique(wall, &caps.normal, line);
    let (enter, exit) = roots::<S, _>(&quadratic).ends()?;
    let at = |t| Crossing { t, face: WALL };
    let crossings = Crossings::new(caps, line);
    if crossings.speed == 0 {
        // Parallel to the caps, it is between them all along the wall, or nowhere.
        let [enter, exit] = quadratic.chord(S::BITS)?;
        let span = Span { enter: at(S::from_bits(enter)), exit: at(S::from_bits(exit)) };
        return crossings.is_between(caps).then_some(span)?.checked();
    }
    let in_wall = Span { enter: at(enter), exit: at(exit) };
    cut(in_wall, &crossings, || overlap(&quadratic, &crossings))
}

pub(in crate::quadric) fn open_cylinder<S: FixedPoint>(
    wall: &Wall<S>,
    caps: &Planes<S>,
    line: &Line<S>,
) -> [Option<S>; 2] {
    if !is_in_range(line) {
        return [None; 2];
    }
    let crossings = Crossings::new(caps, line);
    match caps.normal.along() {
        Some(along) => on_wall(&Section::new(along, wall, line).quadratic(), &crossings),
        None => on_wall(&oblique(wall, &caps.normal, line), &crossings),
    }
}
