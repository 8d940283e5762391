//! What a view in fixed point measures of a cylinder, in numbers of 31 bits.

use super::super::{Cylinder, frame};
use crate::geom::{Axis, Direction, PerspectiveRays, Vec3};
use crate::numeric::product;
use crate::scalar::integer::{leading_zeros, normalized, shift_right, sqrt};
use crate::scalar::{FixedPoint, Number, Real, Scalar, Wide};
use crate::scan::bounds::{PerspectiveBall, Rows};
use crate::scan::planes;

/// Two numbers as `numbers · 2^exponent`, the larger of which has 30 bits.
pub(super) fn block([a, b]: [Wide; 2]) -> ([i32; 2], i32) {
    let (a, b) = (a.to_bits(), b.to_bits());
    let exponent = 34 - leading_zeros(a.unsigned_abs() | b.unsigned_abs()) as i32;
    ([a, b].map(|x| shift_right(x, exponent) as i32), exponent)
}

/// A positive number as one of 31 bits times a power of two.
pub(super) fn mantissa(number: Wide) -> (i32, i32) {
    let (bits, exponent) = normalized(number.to_bits().unsigned_abs());
    ((bits >> 1).cast_signed(), exponent + 1)
}

/// The number of bits of a positive number.
pub(super) fn bits(number: i64) -> i32 {
    64 - leading_zeros(number.unsigned_abs()) as i32
}

pub(super) fn dot([a, b]: [i32; 2], [x, y]: [i32; 2]) -> i64 {
    product(a, x) + product(b, y)
}

/// The two coordinates of a vector across an axis.
pub(super) fn across<S: Scalar>(axis: &Direction<S>) -> impl Fn(Vec3<S::Wide>) -> [S::Wide; 2] {
    let along = axis.along();
    let sides = if along.is_none() { Some(frame(axis.wide())) } else { None };
    move |v| match sides {
        Some(sides) => sides.map(|side| side.dot(v)),
        None => along.unwrap_or(Axis::X).across(v),
    }
}

/// How deep the nearest and the farthest point of a ball around a cylinder are, and the ball's rows.
pub(super) fn ball<S: FixedPoint>(
    Cylinder { wall, caps }: &Cylinder<S>,
    rays: &PerspectiveRays<S>,
    view: &planes::PerspectiveView<S>,
) -> ([Wide; 2], Rows) {
    let PerspectiveRays { plane, distance, inverse_distance } = rays;
    let [low, high] = [caps.low.wide(), caps.high.wide()];
    let (base, half) = (wall.base.wide(), Wide::HALF);
    let along = (low + high) * half - caps.normal.dot_wide(base);
    let from_middle = base - plane.center;
    let at = |way: Vec3<Wide>, speed| from_middle.dot_compensated(way) + along * speed;
    let depth = at(plane.forward, view.speed()) + *distance;
    let across = at(plane.down, caps.normal.dot_wide(plane.down));
    let (sides, exponent) = block([wall.radius.wide(), (high - low) * half]);
    // A unit for the root, and what rounding of lengths may add.
    let radius = i64::from(sqrt(dot(sides, sides).unsigned_abs())) + 2;
    let size = from_middle.max_abs() + along.abs() + *distance;
    let radius = Wide::from_bits(shift_right(radius, -exponent)) + S::uncertainty(size);
    let depths = depth.around(radius);
    let slope = plane.half_pixel * *inverse_distance;
    (depths, PerspectiveBall::<S>::rows(across, depths, radius, slope))
}
