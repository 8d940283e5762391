//! Where a line crosses two parallel planes.

use super::lines::{bits, dot, is_in_range, unit_bits};
use crate::geom::Line;
use crate::quadric::{PlaneRoots, Planes};
use crate::scalar::{FixedPoint, integer};

/// Where a line crosses two planes: at `heights / speed`, in integers.
pub(super) struct Crossings {
    pub(super) heights: [i64; 2],
    pub(super) speed: i64,
}

impl Crossings {
    pub(super) fn new<S: FixedPoint>(planes: &Planes<S>, line: &Line<S>) -> Self {
        let normal = unit_bits::<S>(planes.normal.vector());
        let at_zero = dot(normal, bits(line.origin));
        let height = |offset: S| (i64::from(offset.to_bits()) << 28) - at_zero;
        let heights = [height(planes.low), height(planes.high)];
        let speed = dot(normal, bits(line.direction));
        match planes.normal.along() {
            // All are multiples of 2^28, and short numbers are divided faster.
            Some(_) => Self { heights: heights.map(|height| height >> 28), speed: speed >> 28 },
            None => Self { heights, speed },
        }
    }

    /// The parameters of the low plane and of the high one, each rounded.
    pub(super) fn rounded<S: FixedPoint>(&self) -> [S; 2] {
        self.heights.map(|height| {
            let t = integer::divide(i128::from(height) << S::BITS, self.speed.into());
            S::from_bits(t.clamp(i32::MIN.into(), i32::MAX.into()) as i32)
        })
    }

    /// The fractions at which the line crosses the planes, in ascending order: their numerators, and
    /// their denominator, which is positive.
    pub(super) fn fractions(&self) -> [i128; 3] {
        let [low, high] = self.heights;
        let [first, last] = if self.speed > 0 { [low, high] } else { [-high, -low] };
        [first, last, self.speed.abs()].map(i128::from)
    }

    /// Whether a line along the planes is between them.
    pub(super) fn is_between<S: FixedPoint>(&self, planes: &Planes<S>) -> bool {
        let [low, high] = self.heights;
        planes.has_between(low, high, 0)
    }

    /// Whether a line along the planes is between them or on one.
    pub(super) fn touches(&self) -> bool {
        let [low, high] = self.heights;
        low <= 0 && 0 <= high
    }
}

pub(in crate::quadric) fn planes<S: FixedPoint>(
    planes: &Planes<S>,
    line: &Line<S>,
) -> PlaneRoots<S> {
    if !is_in_range(line) {
        return PlaneRoots::along(false);
    }
    let crossings = Crossings::new(planes, line);
    if crossings.speed == 0 {
        return PlaneRoots::along(crossings.is_between(planes));
    }
    let (upwards, [low, high]) = (crossings.speed > 0, crossings.rounded::<S>());
    let (first, last) = if upwards { (low, high) } else { (high, low) };
    // The planes are apart, however fast the line passes them: but not beyond the grid.
    let is_beyond = first == S::HIGHEST || first == S::LOWEST;
    let last = if first == last && !is_beyond { next(last) } else { last };
    PlaneRoots::across(if upwards { [first, last] } else { [last, first] }, upwards)
}

/// The next larger number, or the largest.
pub(super) fn next<S: FixedPoint>(t: S) -> S {
    S::from_bits(t.to_bits().saturating_add(1))
}
