//! Lines and what takes three coordinates, in floating point: cylinders along any axis, and balls.
//!
//! A ball is the same quadratic with q = u, m = d and k² = |u × d|².

use super::aligned::squared_less_square;
use super::compensated::Inside;
use crate::geom::{Axis, Direction, Line, Vec3};
use crate::scalar::{Double, Float};
use crate::solid::cylinder::Tube;

impl<S: Float> Tube<S> {
    /// Where the line is inside the wall, quickly where little cancels.
    #[inline(never)]
    pub(super) fn meet_obliquely(&self, axis: &Direction<S>, line: &Line<S>) -> Inside<S> {
        let u = line.origin - self.base;
        let (m, q) = (line.direction.cross(axis.vector()), u.cross(axis.vector()));
        let k = u.dot_compensated(m);
        let sums =
            Sums { a: m.length_squared(), b: q.dot(m), from_axis: q.length_squared(), k: k * k };
        sums.meet(self.radius, u.length_squared(), || self.gap(axis, line))
            .unwrap_or_else(|| self.meet_closely(axis, line))
    }

    /// c, from twice the working precision.
    #[cold]
    #[inline(never)]
    fn gap(&self, axis: &Direction<S>, line: &Line<S>) -> S {
        let (u, axis) = (difference(line.origin, self.base), widened(axis.vector()));
        let (q, axis) = (cross(u, axis), axis.to_array());
        let size = Double::product(self.radius, self.radius).times(dot(axis, axis));
        dot(q, q).minus(size).round()
    }

    /// Where the line is inside the wall, in twice the working precision throughout.
    ///
    /// A rounded axis A isn't exactly of length 1. This is the wall at r|A| = |q + t·m|.
    #[cold]
    #[inline(never)]
    fn meet_closely(&self, axis: &Direction<S>, line: &Line<S>) -> Inside<S> {
        let u = difference(line.origin, self.base);
        let (d, axis) = (widened(line.direction), widened(axis.vector()));
        let m = cross(d, axis);
        let length_squared = dot(axis.to_array(), axis.to_array());
        let k = dot(u.to_array(), m);
        let size = Double::product(self.radius, self.radius).times(length_squared);
        // |q × m|² = |A|² (u·m)², because q and m are at right angles to A.
        meet_closely(size, cross(u, axis), m, k.times(k).times(length_squared))
    }
}

/// Where the line is inside the ball.
#[inline(always)]
pub(super) fn meet_ball<S: Float>(center: Vec3<S>, radius: S, line: &Line<S>) -> Inside<S> {
    let (u, d) = (line.origin - center, line.direction);
    let sums = Sums {
        a: d.length_squared(),
        b: u.dot_compensated(d),
        from_axis: u.dot_compensated(u),
        k: u.cross(d).length_squared(),
    };
    // Rare lines get a copy, so that the line itself may stay in registers.
    let line = &{ *line };
    let gap = || squared_less_square(difference(line.origin, center).to_array(), radius);
    sums.meet(radius, u.length_squared(), gap)
        .unwrap_or_else(|| meet_ball_closely(center, radius, line))
}

/// Where the line is inside the ball, in twice the working precision throughout.
#[cold]
#[inline(never)]
fn meet_ball_closely<S: Float>(center: Vec3<S>, radius: S, line: &Line<S>) -> Inside<S> {
    let (u, d) = (difference(line.origin, center), widened(line.direction));
    let k = cross(u, d);
    meet_closely(Double::product(radius, radius), u.to_array(), d.to_array(), dot(k, k))
}

/// What plain sums say: |m|², q·m, |q|² and k².
struct Sums<S> {
    a: S,
    b: S,
    from_axis: S,
    k: S,
}

impl<S: Float> Sums<S> {
    /// Where the line is inside, or `None` where that isn't clear, or not precise, from plain sums. Near
    /// the surface, `gap` is asked for c.
    ///
    /// The error of k is a few units of |u||m|, so that of D is as many of k|u||m|. It reaches s divided by
    /// 2√D, and is kept where that quotient is small. Plain sums are good enough for b if it isn't
    /// small beside |q||m| with s small as well, and for c from some way off the surface on.
    #[inline(always)]
    fn meet(&self, radius: S, distance_squared: S, gap: impl FnOnce() -> S) -> Option<Inside<S>> {
        let &Self { a, b, from_axis, k } = self;
        let radius_squared = radius * radius;
        let largest = radius_squared * a;
        let discriminant = largest - k;
        // The square of what k's rounding error is a few units of, times k.
        let of_k = distance_squared * a * k;
        if discriminant < S::ZERO {
            let error = (largest + of_k.sqrt()) * S::EPSILON * S::from_int(8);
            return (discriminant < -error).then_some(Tube::NOWHERE);
        }
        let s = discriminant.sqrt() + b.abs();
        let quotient = discriminant * s * s * S::from_int(2);
        let is_precise = quotient > largest * largest && quotient * S::from_int(4) > of_k;
        if !(is_precise && s * s * S::from_int(4) > from_axis * a) {
            return None;
        }
        let c = from_axis - radius_squared;
        let is_clear = c.abs() + c.abs() >= from_axis + radius_squared;
        let c = if is_clear { c } else { gap() };
        Some(points(s / a, c / s, b, discriminant))
    }
}

/// Where `|q + t·m|²` is below `size`, with `k` = |q × m|².
fn meet_closely<S: Float>(
    size: Double<S>,
    q: [Double<S>; 3],
    m: [Double<S>; 3],
    k: Double<S>,
) -> Inside<S> {
    let a = dot(m, m);
    let c = dot(q, q).minus(size).round();
    if a.high <= S::ZERO {
        return Tube::parallel(c);
    }
    let discriminant = size.times(a).minus(k).round();
    if discriminant < S::ZERO {
        return Tube::NOWHERE;
    }
    let b = dot(q, m).round();
    let s = discriminant.sqrt() + b.abs();
    let far = s / a.round();
    points(far, c / s, b, discriminant)
}

/// The points from the roots' sizes: `far` = (|b| + √D)/a, and `near` = c/(|b| + √D).
#[inline(always)]
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

    fn vector(v: [f32; 3]) -> Vec3<f64> {
        Vec3::from(v.map(f64::from))
    }

    /// What `f64` says of the same numbers: the roots of |q + t·m|² = r², with all but a pair of terms from
    /// other formulas than those above.
    fn roots(radius: f32, q: Vec3<f64>, m: Vec3<f64>) -> Option<[f64; 2]> {
        let (a, b) = (m.length_squared(), q.dot(m));
        let nearest = q - m * (b / a);
        let half_squared = f64::from(radius).powi(2) - nearest.length_squared();
        let half = (half_squared >= 0.0).then(|| (half_squared / a).sqrt())?;
        // Newton's step takes what the difference has lost of an end near zero.
        Some([-half, half].map(|half| {
            let t = half - b / a;
            let at = q + m * t;
            let off = at.length_squared() - f64::from(radius).powi(2);
            let slope = 2.0 * at.dot(m);
            if slope.abs() > 1e-9 { t - off / slope } else { t }
        }))
    }

    fn check(
        got: Inside<f32>,
        want: Option<[f64; 2]>,
        most: f64,
        least: f32,
    ) -> Result<(), TestCaseError> {
        prop_assert_eq!(got.0 <= got.1, want.is_some(), "{:?} {:?}", got, want);
        for (got, want) in [got.0, got.1].into_iter().zip(want.into_iter().flatten()) {
            prop_assert!(units_off(got, want, least) < most, "{got} not {want}");
        }
        Ok(())
    }

    fn unit(v: Vec3<f64>) -> Option<Vec3<f64>> {
        let square = v.length_squared();
        (square > 0.01).then(|| v * (1.0 / square.sqrt()))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        /// Near a tangent, from both sides of it, and with b and c near zero: what plain sums must leave
        /// to others. The axis is rounded, and so not exactly of length 1.
        #[test]
        fn cylinders_as_in_double_precision(
            axis in prop::array::uniform3(-1f64..1.0), base in prop::array::uniform3(-3f32..3.0),
            r in 0.5f32..1.5, depth in -6f64..-0.5, is_inside: bool, turn in 0f64..6.3,
            back in prop_oneof![2f64..200.0, -0.5f64..0.5, -0.01f64..0.01], tilt in -1.5f64..1.5,
        ) {
            let axis = unit(Vec3::from(axis));
            let side = axis.and_then(|axis| unit(axis.cross(vec3(turn.cos(), turn.sin(), 0.5))));
            let (Some(axis), Some(side)) = (axis, side) else { return Err(TestCaseError::reject("short")) };
            let gap = if is_inside { -10f64.powf(depth) } else { 10f64.powf(depth) };
            let nearest = side * (f64::from(r) * (1.0 + gap));
            let way = axis.cross(side) * tilt.cos() + axis * tilt.sin();
            let origin = vector(base) + nearest - way * back;
            let [axis, origin, way] =
                [axis, origin, way].map(|v| v.to_array().map(|x| x as f32));

            let tube = Tube { base: Vec3::from(base), radius: r, curvature: f32::NO_SCALE };
            let line = Line { origin: Vec3::from(origin), direction: Vec3::from(way) };
            let got = tube.meet_obliquely(&Direction::<f32>::new(axis), &line);
            let axis = vector(axis) * (1.0 / vector(axis).length_squared().sqrt());
            let across = |v: Vec3<f64>| v - axis * v.dot(axis);
            let want = roots(r, across(vector(origin) - vector(base)), across(vector(way)));
            // c is known to 2⁻⁴⁷ of |q|², and t near zero is c divided by small numbers here.
            check(got, want, 8.0, 1e-4)?;
        }

        /// Grazing or not, from outside and inside, and from just beside the surface.
        #[test]
        fn balls_as_in_double_precision(
            center in prop::array::uniform3(-3f32..3.0), r in 0.3f32..1.5, depth in -6f64..0.0,
            is_inside: bool, side in prop::array::uniform3(-1f64..1.0),
            way in prop::array::uniform3(-1f64..1.0), near in -6f64..1.0, is_before: bool,
        ) {
            let side = unit(Vec3::from(side));
            let way = side.and_then(|side| unit(side.cross(Vec3::from(way))));
            let (Some(side), Some(way)) = (side, way) else { return Err(TestCaseError::reject("short")) };
            // How near to the middle the line passes, and how far from the surface it starts.
            let past = f64::from(r) * if is_inside { 1.0 - 10f64.powf(depth) } else { 1.0 + 10f64.powf(depth) };
            let half = (f64::from(r).powi(2) - past.powi(2)).max(0.0).sqrt();
            let back = if is_before { half + 10f64.powf(near) } else { half - 10f64.powf(near) };
            let origin = vector(center) + side * past - way * back;
            let [origin, way] = [origin, way].map(|v| v.to_array().map(|x| x as f32));

            let line = Line { origin: Vec3::from(origin), direction: Vec3::from(way) };
            let got = meet_ball(Vec3::from(center), r, &line);
            check(got, roots(r, vector(origin) - vector(center), vector(way)), 5.0, 1e-5)?;
        }
    }
}
