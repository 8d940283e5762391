//! Where a line is inside a ball.

use super::lines::{bits, cross, dot, is_in_range, square, way, wide_dot};
use super::quadratic::Quadratic;
use crate::geom::Line;
use crate::quadric::Ball;
use crate::scalar::{FixedPoint, Roots};

/// |u + t·d|² − r².
fn quadratic(u: [i64; 3], d: [i64; 3], square: i64) -> Quadratic<i128> {
    let (a, k) = (dot(d, d), cross(u, d));
    Quadratic {
        a: a.into(),
        b: dot(u, d).into(),
        c: (dot(u, u) - square).into(),
        discriminant: i128::from(square) * i128::from(a) - wide_dot(k, k),
    }
}

pub(in crate::quadric) fn ball<S: FixedPoint>(ball: &Ball<S>, line: &Line<S>) -> Roots<S> {
    if !is_in_range(line) {
        return Roots::Outside;
    }
    let (u, d) = (way(ball.center, line.origin), bits(line.direction));
    match quadratic(u, d, square(ball.radius)).chord(S::BITS) {
        Some([enter, exit]) => Roots::Between(S::from_bits(enter), S::from_bits(exit)),
        None => Roots::Outside,
    }
}
