//! Lines as integers.

use crate::geom::{Line, Vec3};
use crate::scalar::FixedPoint;

pub(super) fn dot<const N: usize>(x: [i64; N], y: [i64; N]) -> i64 {
    x.into_iter().zip(y).map(|(x, y)| x * y).sum()
}

pub(super) fn cross([x0, x1, x2]: [i64; 3], [y0, y1, y2]: [i64; 3]) -> [i64; 3] {
    [x1 * y2 - x2 * y1, x2 * y0 - x0 * y2, x0 * y1 - x1 * y0]
}

/// `x·y` of numbers whose products need more than 64 bits.
pub(super) fn wide_dot([x0, x1, x2]: [i64; 3], [y0, y1, y2]: [i64; 3]) -> i128 {
    let product = |x: i64, y: i64| i128::from(x) * i128::from(y);
    product(x0, y0) + product(x1, y1) + product(x2, y2)
}

pub(super) fn bits<S: FixedPoint>(v: Vec3<S>) -> [i64; 3] {
    v.to_array().map(|coordinate| i64::from(coordinate.to_bits()))
}

/// The coordinates of a direction, in units of 2⁻²⁸.
pub(super) fn unit_bits<S: FixedPoint>(v: Vec3<S::Unit>) -> [i64; 3] {
    v.to_array().map(|coordinate| i64::from(S::unit_bits(coordinate)))
}

/// Whether a line is one that this module's integers have room for. All rays are; lines of a
/// caller's own need not be, and they meet nothing.
#[inline]
pub(super) fn is_in_range<S: FixedPoint>(line: &Line<S>) -> bool {
    let all =
        |v: Vec3<S>| v.to_array().into_iter().fold(0, |all, x| all | x.to_bits().unsigned_abs());
    all(line.origin) < 1 << 30 && (all(line.direction) < 1 << 30 || is_short(line.direction))
}

/// Whether |d|² ≤ 2⁶², of a direction that has a longer coordinate than most.
#[cold]
#[inline(never)]
fn is_short<S: FixedPoint>(direction: Vec3<S>) -> bool {
    let squares = bits(direction).map(|x| x.unsigned_abs() * x.unsigned_abs());
    squares.into_iter().sum::<u64>() <= 1 << 62
}

/// The square of a length.
pub(super) fn square<S: FixedPoint>(length: S) -> i64 {
    i64::from(length.to_bits()) * i64::from(length.to_bits())
}

/// The way from one point to another, in units.
pub(super) fn way<S: FixedPoint>(from: Vec3<S>, to: Vec3<S>) -> [i64; 3] {
    let ([x0, y0, z0], [x1, y1, z1]) = (bits(from), bits(to));
    [x1 - x0, y1 - y0, z1 - z0]
}
