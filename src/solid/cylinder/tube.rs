//! The infinite cylinder: the wall of everything in this module.
//!
//! With u = p − base, m = d × axis and q = u × axis, a line's points at distance r from the axis
//! are the roots of `a t² + 2 b t + c = 0` with a = |m|², b = q·m and c = |q|² − r². The
//! discriminant b² − ac is computed as `r²a − k²`, k = u·m: no squares of large distances cancel.
//! With s = |b| + √D the roots are s/a and c/s, up to a sign: no roots of equal size cancel.
//! (W. Kahan, *On the cost of floating-point computation without extra-precise arithmetic*, 2004.)
//!
//! The axis is never normalised away, and `|d × axis|²` is never 1 − d²: a line along the axis
//! gives m = 0 exactly.

use crate::geom::{Axis, Direction, Line, Vec3};
use crate::scalar::{Double, Scalar};

/// All points within `radius` of a line through `base`; the line's direction, the axis, is that of
/// the slab that cuts the tube.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(in crate::solid) struct Tube<S> {
    pub(in crate::solid) base: Vec3<S>,
    pub(in crate::solid) radius: S,
}

/// Where a line meets the wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::solid) enum Meeting<S> {
    /// Nowhere: the line passes it by.
    Beside,
    /// At two parameters in ascending order, which are the same for a tangent.
    Points(S, S),
    /// Nowhere: the line is parallel to the axis, inside the wall.
    Within,
    /// The line is parallel to the axis, outside the wall or on it.
    Along,
}

impl<S: Scalar> Tube<S> {
    /// Where the line meets the wall: quickly, where little cancels.
    ///
    /// The discriminant is a difference of terms up to r²a, and its error reaches s divided by
    /// 2√D. Along a coordinate axis it comes cheaply in twice the working precision; along others
    /// it is kept where that quotient is small. Plain sums are good enough for b if it isn't small
    /// beside |q||m| with s small as well, and for c from some way off the wall on.
    pub(in crate::solid) fn meet(&self, axis: &Direction<S>, line: &Line<S>) -> Meeting<S> {
        let u = line.origin - self.base;
        let d = line.direction;
        let radius_squared = Double::product(self.radius, self.radius);
        let (a, b, c, discriminant, distance_squared, is_precise) = match axis.along() {
            // q and m are two coordinates of u and d, turned by 90°.
            Some(along) => {
                let ([q0, q1], [m0, m1]) = (along.across(u), along.across(d));
                let a = Double::product(m0, m0).plus_roughly(Double::product(m1, m1));
                let k = Double::product(q0, m1).minus_roughly(Double::product(q1, m0));
                let discriminant = Double::product_less_square(radius_squared, a, k);
                let squared = Double::product(q0, q0).plus_roughly(Double::product(q1, q1));
                let c = squared.minus_roughly(radius_squared).round();
                (a.high, q0 * m0 + q1 * m1, c, discriminant, squared.high, true)
            }
            None => {
                let (m, q) = (d.cross(axis.vector()), u.cross(axis.vector()));
                let (a, b, k) = (m.length_squared(), q.dot(m), u.dot_compensated(m));
                let largest = radius_squared.high * a;
                let discriminant = largest - k * k;
                let error = largest * S::EPSILON * S::from_halves(2 * 8);
                let is_precise = if discriminant < S::ZERO {
                    discriminant < -error
                } else {
                    discriminant * (discriminant + b * b) > largest * largest
                };
                let squared = q.length_squared();
                (a, b, squared - radius_squared.high, discriminant, squared, is_precise)
            }
        };
        if is_precise && discriminant < S::ZERO {
            return Meeting::Beside;
        }
        let s = discriminant.max(S::ZERO).sqrt() + b.abs();
        let is_clear = c.abs() + c.abs() >= distance_squared + radius_squared.high
            && s * s * S::from_halves(2 * 4) > distance_squared * a;
        if is_precise && is_clear {
            Meeting::roots(s / a, c / s, b, discriminant)
        } else {
            self.meet_closely(axis, line)
        }
    }

    /// Where the line meets the wall: in twice the working precision throughout.
    #[cold]
    #[inline(never)]
    fn meet_closely(&self, axis: &Direction<S>, line: &Line<S>) -> Meeting<S> {
        let u = difference(line.origin, self.base);
        let d = widened(line.direction);
        match axis.along() {
            Some(along) => {
                let (q, m) = (along.across(u), along.across(d));
                self.roots_closely(q, m, turned(q, m))
            }
            None => {
                let axis = widened(axis.vector());
                let m = cross(d, axis);
                self.roots_closely(cross(u, axis), m, dot(u.to_array(), m))
            }
        }
    }

    fn roots_closely<const N: usize>(
        &self,
        q: [Double<S>; N],
        m: [Double<S>; N],
        k: Double<S>,
    ) -> Meeting<S> {
        let radius_squared = Double::product(self.radius, self.radius);
        let a = dot(m, m);
        let c = dot(q, q).minus(radius_squared).round();
        if a.high <= S::ZERO {
            return if c < S::ZERO { Meeting::Within } else { Meeting::Along };
        }
        let discriminant = radius_squared.times(a).minus(k.times(k)).round();
        if discriminant < S::ZERO {
            return Meeting::Beside;
        }
        let b = dot(q, m).round();
        let s = discriminant.sqrt() + b.abs();
        let far = s / a.round();
        Meeting::roots(far, c / s, b, discriminant)
    }

    /// The point of the wall nearest to a point beside it.
    pub(in crate::solid) fn onto(&self, axis: &Direction<S>, near: Vec3<S>) -> Vec3<S> {
        let (axis, u) = (axis.vector(), near - self.base);
        let along = axis * axis.dot(u);
        let across = u - along;
        let length = across.length_squared().sqrt();
        self.base + (along + across * (self.radius / length))
    }

    /// The outward normal at a point of the wall: (0, y, z)/r in the cylinder's own frame.
    pub(in crate::solid) fn normal(&self, axis: &Direction<S>, at: Vec3<S>) -> Vec3<S> {
        let u = at - self.base;
        (u - axis.vector() * u.dot(axis.vector())) * (S::ONE / self.radius)
    }
}

impl<S: Scalar> Meeting<S> {
    /// The points from the roots' sizes: `far` = (|b| + √D)/a, and `near` = c/(|b| + √D).
    fn roots(far: S, near: S, b: S, discriminant: S) -> Self {
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
        if one < other { Self::Points(one, other) } else { Self::Points(other, one) }
    }
}

fn dot<S: Scalar, const N: usize>(x: [Double<S>; N], y: [Double<S>; N]) -> Double<S> {
    let zero = Double::from(S::ZERO);
    x.into_iter().zip(y).fold(zero, |sum, (x, y)| sum.plus(x.times(y)))
}

/// The scalar product of one vector with another turned by 90°.
fn turned<S: Scalar>([x0, x1]: [Double<S>; 2], [y0, y1]: [Double<S>; 2]) -> Double<S> {
    x0.times(y1).minus(x1.times(y0))
}

fn cross<S: Scalar>(x: Vec3<Double<S>>, y: Vec3<Double<S>>) -> [Double<S>; 3] {
    [Axis::X, Axis::Y, Axis::Z].map(|axis| turned(axis.across(x), axis.across(y)))
}

/// `p − q`, exactly.
fn difference<S: Scalar>(p: Vec3<S>, q: Vec3<S>) -> Vec3<Double<S>> {
    Vec3::new(Double::sum(p.x, -q.x), Double::sum(p.y, -q.y), Double::sum(p.z, -q.z))
}

fn widened<S: Scalar>(v: Vec3<S>) -> Vec3<Double<S>> {
    Vec3::new(Double::from(v.x), Double::from(v.y), Double::from(v.z))
}
