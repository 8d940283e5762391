//! Lines in twice the working precision throughout: for those that nothing quicker can answer.

use super::sums::points;
use crate::geom::{Axis, Vec3};
use crate::scalar::{Double, Float, Roots};

/// Where `|q + t·m|²` is below `size`, with `k` = |q × m|².
pub(super) fn meet_closely<S: Float>(
    size: Double<S>,
    q: [Double<S>; 3],
    m: [Double<S>; 3],
    k: Double<S>,
) -> Roots<S> {
    let a = dot(m, m);
    let c = dot(q, q).minus(size).round();
    if a.high <= S::ZERO {
        return parallel(c);
    }
    let discriminant = size.times(a).minus(k).round();
    if discriminant < S::ZERO {
        return Roots::Outside;
    }
    let b = dot(q, m).round();
    let s = discriminant.sqrt() + b.abs();
    let far = s / a.round();
    points(far, c / s, b, discriminant)
}

/// Where a line along the axis is inside the wall.
pub(super) fn parallel<S: Float>(c: S) -> Roots<S> {
    if c < S::ZERO { Roots::Everywhere } else { Roots::Outside }
}

pub(super) fn dot<S: Float, const N: usize>(x: [Double<S>; N], y: [Double<S>; N]) -> Double<S> {
    let zero = Double::from(S::ZERO);
    x.into_iter().zip(y).fold(zero, |sum, (x, y)| sum.plus(x.times(y)))
}

/// The scalar product of one vector with another turned by 90°.
fn turned<S: Float>([x0, x1]: [Double<S>; 2], [y0, y1]: [Double<S>; 2]) -> Double<S> {
    x0.times(y1).minus(x1.times(y0))
}

pub(super) fn cross<S: Float>(x: Vec3<Double<S>>, y: Vec3<Double<S>>) -> [Double<S>; 3] {
    [Axis::X, Axis::Y, Axis::Z].map(|axis| turned(axis.across(x), axis.across(y)))
}

/// `p − q`, exactly.
pub(super) fn difference<S: Float>(p: Vec3<S>, q: Vec3<S>) -> Vec3<Double<S>> {
    Vec3::new(Double::sum(p.x, -q.x), Double::sum(p.y, -q.y), Double::sum(p.z, -q.z))
}

pub(super) fn widened<S: Float>(v: Vec3<S>) -> Vec3<Double<S>> {
    Vec3::new(Double::from(v.x), Double::from(v.y), Double::from(v.z))
}
