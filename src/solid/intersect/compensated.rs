//! Lines in floating point: error-free sums and products where something cancels.
//!
//! With u = p − base, m = d × axis and q = u × axis, a line's points at distance r from the axis
//! are the roots of `a t² + 2 b t + c = 0` with a = |m|², b = q·m and c = |q|² − r². The
//! discriminant b² − ac is computed as `r²a − k²`, k = u·m: no squares of large distances cancel.
//! With s = |b| + √D the roots are s/a and c/s, up to a sign: no roots of equal size cancel.
//! (W. Kahan, *On the cost of floating-point computation without extra-precise arithmetic*, 2004.)
//!
//! The axis is never normalised away, and `|d × axis|²` is never 1 − d²: a line along the axis
//! gives m = 0 exactly.

use super::{Intersect, Meeting, Passage};
use crate::geom::{Axis, Direction, Line, Vec3};
use crate::scalar::{Double, Float};
use crate::solid::cylinder::Tube;
use crate::solid::slab::Slab;

impl<S: Float> Tube<S> {
    /// Where the line meets the wall: quickly, where little cancels.
    ///
    /// The discriminant is a difference of terms up to r²a, and its error reaches s divided by
    /// 2√D. Along a coordinate axis it comes cheaply in twice the working precision; along others
    /// it is kept where that quotient is small. Plain sums are good enough for b if it isn't small
    /// beside |q||m| with s small as well, and for c from some way off the wall on.
    fn meet(&self, axis: &Direction<S>, line: &Line<S>) -> Meeting<S> {
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
                let error = largest * S::EPSILON * S::from_int(8);
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
            && s * s * S::from_int(4) > distance_squared * a;
        if is_precise && is_clear {
            points(s / a, c / s, b, discriminant)
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
        points(far, c / s, b, discriminant)
    }
}

/// The points from the roots' sizes: `far` = (|b| + √D)/a, and `near` = c/(|b| + √D).
fn points<S: Float>(far: S, near: S, b: S, discriminant: S) -> Meeting<S> {
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
    if one < other { Meeting::Points(one, other) } else { Meeting::Points(other, one) }
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

/// Where the line is within `radius` of `center`, from `|u + t·d|² = r²` with the discriminant
/// `r²|d|² − |u × d|²`: no large squares cancel.
fn meet_ball<S: Float>(center: Vec3<S>, radius: S, line: &Line<S>) -> Option<[S; 2]> {
    let u = line.origin - center;
    let inverse = S::ONE / line.direction.length_squared();
    let middle = -(u.dot_compensated(line.direction)) * inverse;
    let moment = u.cross(line.direction).length_squared();
    let discriminant = radius * radius * line.direction.length_squared() - moment;
    let half = discriminant.positive()?.sqrt() * inverse;
    Some([middle - half, middle + half])
}

macro_rules! intersect {
    ($($Float:ident),+) => {$(
        impl Intersect for $Float {
            #[inline]
            fn meet_tube(tube: &Tube<Self>, axis: &Direction<Self>, line: &Line<Self>) -> Meeting<Self> {
                tube.meet(axis, line)
            }

            #[inline]
            fn meet_ball(center: Vec3<Self>, radius: Self, line: &Line<Self>) -> Option<[Self; 2]> {
                meet_ball(center, radius, line)
            }

            #[inline]
            fn pass(slab: &Slab<Self>, line: &Line<Self>) -> Passage<Self> {
                let (at_zero, speed) = (slab.normal.dot(line.origin), slab.normal.dot(line.direction));
                slab.passage(at_zero, speed)
            }

            #[inline]
            fn is_between(slab: &Slab<Self>, line: &Line<Self>, t: Self) -> bool {
                let (at_zero, speed) = (slab.normal.dot(line.origin), slab.normal.dot(line.direction));
                let height = Self::add_product(at_zero, t, speed);
                slab.low <= height && height <= slab.high
            }

            #[inline]
            fn shortest(_: &Tube<Self>, _: &Slab<Self>, _: &Line<Self>, _: Self) -> Option<[Self; 2]> {
                None
            }
        }
    )+};
}

intersect!(f32, f64);
