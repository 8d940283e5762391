//! Lines and cylinders along coordinate axes, in floating point: plain sums for ordinary lines, and
//! careful ones for all others.
//!
//! Here q and m are two coordinates of u and d, turned by 90°.

use super::doubles::parallel;
use super::sums::{square_less, squared_less_square};
use crate::geom::{Axis, Line, Vec3};
use crate::quadric::{Planes, Wall};
use crate::scalar::{Double, Float, Roots};

/// What plain sums say about a line and a cylinder along a coordinate axis.
///
/// Here u leads from the line's origin to the axis, so b is positive where the line comes nearer.
pub(super) struct Aligned<S> {
    pub(super) q: [S; 2],
    pub(super) m: [S; 2],
    pub(super) a: S,
    pub(super) b: S,
    pub(super) k: S,
    /// How high the line is above the plane through the scene's origin at t = 0, and how it rises.
    pub(super) at_zero: S,
    pub(super) speed: S,
}

impl<S: Float> Aligned<S> {
    /// `None` for a cylinder along another axis.
    ///
    /// Each axis has sums of its own: moving the coordinates to common places first costs more.
    #[inline(always)]
    pub(super) fn new(wall: &Wall<S>, caps: &Planes<S>, line: &Line<S>) -> Option<Self> {
        let (normal, o, d, base) = (caps.normal.vector(), line.origin, line.direction, wall.base);
        Some(match caps.normal.along()? {
            Axis::X => Self::of(normal.x, o.x, d.x, [o.y, o.z], [d.y, d.z], [base.y, base.z]),
            Axis::Y => Self::of(normal.y, o.y, d.y, [o.x, o.z], [d.x, d.z], [base.x, base.z]),
            Axis::Z => Self::of(normal.z, o.z, d.z, [o.y, o.x], [d.y, d.x], [base.y, base.x]),
        })
    }

    #[inline(always)]
    fn of(normal: S, height: S, rise: S, origin: [S; 2], m: [S; 2], base: [S; 2]) -> Self {
        let q = [base[0] - origin[0], base[1] - origin[1]];
        Self {
            q,
            m,
            a: m[0] * m[0] + m[1] * m[1],
            b: q[0] * m[0] + q[1] * m[1],
            k: q[0] * m[1] - q[1] * m[0],
            at_zero: normal * height,
            speed: normal * rise,
        }
    }

    /// Whether the line clearly misses the wall: D is negative by several times what it can be wrong
    /// by, k's error included.
    #[inline(always)]
    pub(super) fn is_beside(&self, largest: S, discriminant: S) -> bool {
        let [q, m] = [self.q, self.m].map(|[x, y]| x.abs() + y.abs());
        let error = (largest + self.k.abs() * (q * m)) * S::from_int(4) * S::EPSILON;
        discriminant < -error && self.a > S::EPSILON
    }
}

/// The coordinates across an axis, in the order of [`Aligned`].
fn across<S: Copy>(axis: Axis, v: Vec3<S>) -> [S; 2] {
    let [_, first, second] = axis.turned(v);
    [first, second]
}

impl<S: Float> Wall<S> {
    /// The vector from the axis to the line's origin, exactly.
    fn axis_to_origin(&self, axis: Axis, line: &Line<S>) -> [Double<S>; 2] {
        let [o, base] = [line.origin, self.base].map(|v| across(axis, v));
        [Double::sum(o[0], -base[0]), Double::sum(o[1], -base[1])]
    }

    /// c = |q|² − r² for a wall along a coordinate axis, compensated.
    pub(super) fn aligned_gap(&self, axis: Axis, line: &Line<S>) -> S {
        squared_less_square(self.axis_to_origin(axis, line), self.radius)
    }

    /// Where a line is inside a wall along a coordinate axis, with D in twice the working precision.
    ///
    /// So are b and c, unless the line starts outside: there they don't cancel.
    pub(super) fn meet_aligned(&self, axis: Axis, line: &Line<S>) -> Roots<S> {
        let (q, m) = (self.axis_to_origin(axis, line), across(axis, line.direction));
        let [q0, q1] = q;
        let radius_squared = Double::product(self.radius, self.radius);
        let c = square_less(q0.high, radius_squared.high) + q1.high * q1.high;
        let c = if c > radius_squared.high {
            let cross = q0.high * q0.low + q1.high * q1.low;
            c + (cross + cross)
        } else {
            squared_less_square(q, self.radius)
        };
        let b = Double::product(q0.high, m[0]).plus_roughly(Double::product(q1.high, m[1]));
        let b = b.high + (b.low + (q0.low * m[0] + q1.low * m[1]));
        let a = Double::product(m[0], m[0]).plus_roughly(Double::product(m[1], m[1]));
        if a.high <= S::ZERO {
            return parallel(c);
        }
        let k = Double::product(q0.high, m[1]).minus_roughly(Double::product(q1.high, m[0]));
        let k = Double { low: k.low + (q0.low * m[1] - q1.low * m[0]), ..k };
        let discriminant = Double::product_less_square(radius_squared, a, k);
        if discriminant < S::ZERO {
            return Roots::Outside;
        }
        if discriminant == S::ZERO {
            // A tangent has one root, but c/s would round to another number, or be 0/0.
            let t = -b / a.high;
            return Roots::Between(t, t);
        }
        roots(a.high, b, c, discriminant.sqrt())
    }
}

/// The roots s/a and c/s in ascending order, where `half` is √D and s has the sign of −b.
#[inline]
fn roots<S: Float>(a: S, b: S, c: S, half: S) -> Roots<S> {
    let s = if b > S::ZERO { -half - b } else { half - b };
    let far = s / a;
    // With b = 0 both are ±√D/a: from either end of the line the same.
    let near = if b == S::ZERO { -far } else { c / s };
    Roots::Between(near.min(far), near.max(far))
}
