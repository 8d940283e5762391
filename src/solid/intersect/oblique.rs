//! Lines and cylinders along any axis, in floating point.

use super::compensated::Inside;
use crate::geom::{Axis, Direction, Line, Vec3};
use crate::scalar::{Double, Float};
use crate::solid::cylinder::Tube;

impl<S: Float> Tube<S> {
    /// Where the line is inside the wall, quickly where little cancels.
    ///
    /// The error of k is a few units of |u||m|, so that of D is as many of k|u||m|. It reaches s divided by
    /// 2√D, and is kept where that quotient is small. Plain sums are good enough for b if it isn't
    /// small beside |q||m| with s small as well, and for c from some way off the wall on.
    #[inline(never)]
    pub(super) fn meet_obliquely(&self, axis: &Direction<S>, line: &Line<S>) -> Inside<S> {
        let u = line.origin - self.base;
        let d = line.direction;
        let radius_squared = Double::product(self.radius, self.radius);
        let (m, q) = (d.cross(axis.vector()), u.cross(axis.vector()));
        let (a, b, k) = (m.length_squared(), q.dot(m), u.dot_compensated(m));
        let largest = radius_squared.high * a;
        let discriminant = largest - k * k;
        // The square of what k's rounding error is a few units of, times k.
        let of_k = u.length_squared() * a * (k * k);
        let is_precise = if discriminant < S::ZERO {
            let error = (largest + of_k.sqrt()) * S::EPSILON * S::from_int(8);
            discriminant < -error
        } else {
            let most = of_k.max(largest * largest * S::from_int(8));
            discriminant * (discriminant + b * b) * S::from_int(8) > most
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::vec3;
    use crate::scalar::Scalar;
    use crate::solid::intersect::units_off;
    use proptest::prelude::*;

    macro_rules! meet {
        ($Float:ident, $base:expr, $radius:expr, $axis:expr, $origin:expr, $direction:expr) => {{
            let vector = |v: [f32; 3]| Vec3::from(v.map($Float::from));
            let (base, radius) = (vector($base), $Float::from($radius));
            let tube = Tube { base, radius, curvature: <$Float as Scalar>::NO_FACTOR };
            let axis = Direction::<$Float>::new($axis.map($Float::from));
            let line = Line { origin: vector($origin), direction: vector($direction) };
            tube.meet_obliquely(&axis, &line)
        }};
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        /// Near a tangent, from both sides of it, and with b and c near zero: what plain sums must leave
        /// to others. The same formulas in `f64` have twice the digits.
        #[test]
        fn in_single_precision_as_in_double(
            axis in prop::array::uniform3(-1f64..1.0), base in prop::array::uniform3(-3f32..3.0),
            r in 0.5f32..1.5, depth in -6f64..-0.5, is_inside: bool, turn in 0f64..6.3,
            back in prop_oneof![2f64..200.0, -0.5f64..0.5, -0.01f64..0.01], tilt in -1.5f64..1.5,
        ) {
            let axis = vec3(axis[0], axis[1], axis[2]);
            prop_assume!(axis.length_squared() > 0.01);
            let axis = axis * (1.0 / axis.length_squared().sqrt());
            let side = axis.cross(vec3(turn.cos(), turn.sin(), 0.5));
            prop_assume!(side.length_squared() > 0.01);
            let side = side * (1.0 / side.length_squared().sqrt());
            let gap = if is_inside { -10f64.powf(depth) } else { 10f64.powf(depth) };
            let nearest = side * (f64::from(r) * (1.0 + gap));
            let way = axis.cross(side) * tilt.cos() + axis * tilt.sin();
            let origin = Vec3::from(base.map(f64::from)) + nearest - way * back;
            let [axis, origin, way] =
                [axis, origin, way].map(|v| v.to_array().map(|x| x as f32));

            let (got, want) =
                (meet!(f32, base, r, axis, origin, way), meet!(f64, base, r, axis, origin, way));
            prop_assert_eq!(got.0 <= got.1, want.0 <= want.1, "{:?} {:?}", got, want);
            if want.0 <= want.1 {
                for (got, want) in [(got.0, want.0), (got.1, want.1)] {
                    // Of an end that the line starts in, no more is known than of its start.
                    prop_assert!(units_off(got, want, 0.01) < 8.0, "{got} not {want}");
                }
            }
        }
    }
}
