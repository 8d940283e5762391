//! What is both inside a quadratic and between two planes.

use super::planes::{Crossings, next};
use super::quadratic::{Integer, Quadratic};
use crate::quadric::PlaneRoots;
use crate::scalar::{FixedPoint, Roots};
use crate::span::{Crossing, Span};

/// Where the line is inside the wall, each parameter rounded.
pub(super) fn roots<S: FixedPoint, W: Integer>(quadratic: &Quadratic<W>) -> Roots<S> {
    let zero = W::from(0);
    if quadratic.a == zero {
        return if quadratic.c < zero { Roots::Everywhere } else { Roots::Outside };
    }
    if quadratic.discriminant < zero {
        return Roots::Outside;
    }
    let [enter, exit] = quadratic.roots(S::BITS).map(S::from_bits);
    Roots::Between(enter, exit)
}

/// Whether the line is inside the quadratic and between the planes for some time.
pub(super) fn overlap<W: Integer>(quadratic: &Quadratic<W>, caps: &Crossings) -> bool {
    let [first, last, speed] = caps.fractions();
    if quadratic.is_inside(first, speed) || quadratic.is_inside(last, speed) {
        return true;
    }
    // Both ends are outside. They are on either side of the roots if the vertex −b/a is between
    // them, where the quadratic is smallest.
    let (a, b, d) = (quadratic.a, quadratic.b, W::from(speed));
    let zero = W::from(0);
    quadratic.discriminant > zero
        && a * W::from(first) + b * d < zero
        && a * W::from(last) + b * d > zero
}

/// What is between the caps of a line's part inside a wall.
#[inline]
pub(super) fn cut<S: FixedPoint>(
    in_wall: Span<S>,
    caps: &Crossings,
    overlap: impl FnOnce() -> bool,
) -> Option<Span<S>> {
    cut_at(in_wall, PlaneRoots::across(caps.rounded(), caps.speed > 0), overlap)
}

/// The same with the caps' parameters known.
#[inline]
pub(super) fn cut_at<S: FixedPoint>(
    in_wall: Span<S>,
    between_caps: PlaneRoots<S>,
    overlap: impl FnOnce() -> bool,
) -> Option<Span<S>> {
    let (enter, exit) = between_caps.ends()?.common_ends(in_wall);
    let is_beyond = exit.t == S::LOWEST || enter.t == S::HIGHEST;
    if enter.t != exit.t || is_beyond {
        return Span::new(enter, exit);
    }
    // It is in there for so short a time, if at all, that both ends round to the same parameter.
    overlap().then_some(Span { enter, exit: Crossing { t: next(exit.t), ..exit } })
}
