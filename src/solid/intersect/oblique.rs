//! Lines and cylinders along any axis, in floating point.

use super::compensated::Inside;
use crate::geom::{Axis, Direction, Line, Vec3};
use crate::scalar::{Double, Float};
use crate::solid::cylinder::Tube;

impl<S: Float> Tube<S> {
    /// Where the line is inside the wall, quickly where little cancels.
    ///
    /// The error of D reaches s divided by 2√D, and is kept where that quotient is small. Plain
    /// sums are good enough for b if it isn't small beside |q||m| with s small as well, and for c
    /// from some way off the wall on.
    #[inline(never)]
    pub(super) fn meet_obliquely(&self, axis: &Direction<S>, line: &Line<S>) -> Inside<S> {
        let u = line.origin - self.base;
        let d = line.direction;
        let radius_squared = Double::product(self.radius, self.radius);
        let (m, q) = (d.cross(axis.vector()), u.cross(axis.vector()));
        let (a, b, k) = (m.length_squared(), q.dot(m), u.dot_compensated(m));
        let largest = radius_squared.high * a;
        let discriminant = largest - k * k;
        let error = largest * S::EPSILON * S::from_int(8);
        let is_precise = if discriminant < S::ZERO {
            discriminant < -error
        } else {
            discriminant * (discriminant + b * b) > largest * largest
        };
        let distance_squared = q.length_squared();
        let c = distance_squared - radius_squared.high;
        if is_precise && discriminant < S::ZERO {
            return Self::NOWHERE;
        }
        let s = discriminant.max(S::ZERO).sqrt() + b.abs();
        let is_clear = c.abs() + c.abs() >= distance_squared + radius_squared.high
            && s * s * S::from_int(4) > distance_squared * a;
        if is_precise && is_clear {
            points(s / a, c / s, b, discriminant)
        } else {
            self.meet_closely(axis, line)
        }
    }

    /// Where the line is inside the wall, in twice the working precision throughout.
    #[cold]
    #[inline(never)]
    fn meet_closely(&self, axis: &Direction<S>, line: &Line<S>) -> Inside<S> {
        let u = difference(line.origin, self.base);
        let (d, axis) = (widened(line.direction), widened(axis.vector()));
        let m = cross(d, axis);
        self.roots_closely(cross(u, axis), m, dot(u.to_array(), m))
    }

    fn roots_closely(&self, q: [Double<S>; 3], m: [Double<S>; 3], k: Double<S>) -> Inside<S> {
        let radius_squared = Double::product(self.radius, self.radius);
        let a = dot(m, m);
        let c = dot(q, q).minus(radius_squared).round();
        if a.high <= S::ZERO {
            return Self::parallel(c);
        }
        let discriminant = radius_squared.times(a).minus(k.times(k)).round();
        if discriminant < S::ZERO {
            return Self::NOWHERE;
        }
        let b = dot(q, m).round();
        let s = discriminant.sqrt() + b.abs();
        let far = s / a.round();
        points(far, c / s, b, discriminant)
    }
}

/// The points from the roots' sizes: `far` = (|b| + √D)/a, and `near` = c/(|b| + √D).
fn points<S: Float>(far: S, near: S, b: S, discriminant: S) -> Inside<S> {
    // A tangent has one root, but c/s would round to another number, or be 0/0.
    let near = if discriminant > S::ZERO { near } else { far };
    // With b = 0 both are ±√D/a: from either end of the line the same.
    let (one, other) = if b == S::ZERO {
        (-far, far)
    } else if b > S::ZERO {
        (-far, -near)
    } else {
        (near, far)
    };
    // Almost tangent, they may come out in the wrong order by a rounding error.
    if one < other { (one, other) } else { (other, one) }
}

fn dot<S: Float, const N: usize>(x: [Double<S>; N], y: [Double<S>; N]) -> Double<S> {
    let zero = Double::from(S::ZERO);
    x.into_iter().zip(y).fold(zero, |sum, (x, y)| sum.plus(x.times(y)))
}

/// The scalar product of one vector with another turned by 90°.
fn turned<S: Float>([x0, x1]: [Double<S>; 2], [y0, y1]: [Double<S>; 2]) -> Double<S> {
    x0.times(y1).minus(x1.times(y0))
}

fn cross<S: Float>(x: Vec3<Double<S>>, y: Vec3<Double<S>>) -> [Double<S>; 3] {
    [Axis::X, Axis::Y, Axis::Z].map(|axis| turned(axis.across(x), axis.across(y)))
}

/// `p − q`, exactly.
fn difference<S: Float>(p: Vec3<S>, q: Vec3<S>) -> Vec3<Double<S>> {
    Vec3::new(Double::sum(p.x, -q.x), Double::sum(p.y, -q.y), Double::sum(p.z, -q.z))
}

fn widened<S: Float>(v: Vec3<S>) -> Vec3<Double<S>> {
    Vec3::new(Double::from(v.x), Double::from(v.y), Double::from(v.z))
}
