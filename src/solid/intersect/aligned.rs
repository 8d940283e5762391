//! Lines and cylinders along coordinate axes, in floating point: plain sums for ordinary lines, and
//! careful ones for all others.
//!
//! Here q and m are two coordinates of u and d, turned by 90°.

use super::compensated::Inside;
use crate::geom::{Axis, Line, Vec3};
use crate::scalar::{Double, Float, two_sum};
use crate::solid::cylinder::{Cylinder, Tube};

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
    pub(super) fn new(cylinder: &Cylinder<S>, line: &Line<S>) -> Option<Self> {
        let Cylinder { tube, caps } = cylinder;
        let (normal, o, d, base) = (caps.normal.vector(), line.origin, line.direction, tube.base);
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

/// c = |q|² − r², compensated.
#[inline(always)]
pub(super) fn gap<S: Float>(cylinder: &Cylinder<S>, line: &Line<S>) -> S {
    let Cylinder { tube, caps } = cylinder;
    // Not asked for along other axes than those of coordinates.
    let Some(axis) = caps.normal.along() else { return S::ZERO };
    let [[o0, o1], [base0, base1]] = [&line.origin, &tube.base].map(|v| across(axis, v));
    squared_less_square([Double::sum(*o0, -*base0), Double::sum(*o1, -*base1)], tube.radius)
}

/// The coordinates across an axis, in the order of [`Aligned`]; in their places, because a line that was
/// just written in pieces must be read in the same pieces, or waits for the writes.
#[inline(always)]
pub(super) fn across<S>(axis: Axis, v: &Vec3<S>) -> [&S; 2] {
    let [_, first, second] = axis.turned(Vec3 { x: &v.x, y: &v.y, z: &v.z });
    [first, second]
}

impl<S: Float> Tube<S> {
    /// Where a line is inside the wall, with D in twice the working precision.
    ///
    /// So are b and c, unless the line starts outside: there they don't cancel.
    #[inline]
    pub(super) fn meet_carefully(&self, o: [S; 2], base: [S; 2], m: [S; 2]) -> Inside<S> {
        let q = [Double::sum(o[0], -base[0]), Double::sum(o[1], -base[1])];
        let [q0, q1] = q;
        let radius_squared = Double::product(self.radius, self.radius);
        let c = S::square_less(q0.high, radius_squared.high) + q1.high * q1.high;
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
            return Self::parallel(c);
        }
        let k = Double::product(q0.high, m[1]).minus_roughly(Double::product(q1.high, m[0]));
        let k = Double { low: k.low + (q0.low * m[1] - q1.low * m[0]), ..k };
        let discriminant = Double::product_less_square(radius_squared, a, k);
        if discriminant < S::ZERO {
            return Self::NOWHERE;
        }
        if discriminant == S::ZERO {
            // A tangent has one root, but c/s would round to another number, or be 0/0.
            let t = -b / a.high;
            return (t, t);
        }
        ends(a.high, b, c, discriminant.sqrt())
    }
}

/// The roots s/a and c/s in ascending order, where `half` is √D and s has the sign of −b.
#[inline]
fn ends<S: Float>(a: S, b: S, c: S, half: S) -> Inside<S> {
    let s = if b > S::ZERO { -half - b } else { half - b };
    let far = s / a;
    // With b = 0 both are ±√D/a: from either end of the line the same.
    let near = if b == S::ZERO { -far } else { c / s };
    (near.min(far), near.max(far))
}

/// `|q|² − r²` with the errors of squares and sums added back.
#[inline]
pub(super) fn squared_less_square<S: Float, const N: usize>(q: [Double<S>; N], radius: S) -> S {
    let (square, square_error) = S::two_product(radius, radius);
    let [mut sum, mut errors, mut lost, mut cross] = [S::ZERO; 4];
    for coordinate in q {
        let (product, error) = S::two_product(coordinate.high, coordinate.high);
        let (next, rounded) = two_sum(sum, product);
        (sum, errors, lost) = (next, errors + error, lost + rounded);
        cross = cross + coordinate.high * coordinate.low;
    }
    let (sum, rounded) = two_sum(sum, -square);
    sum + ((errors - square_error) + (lost + rounded) + (cross + cross))
}
