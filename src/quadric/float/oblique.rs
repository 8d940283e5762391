//! Lines and walls along any axis, in floating point.

use super::doubles::{cross, difference, dot, meet_closely, widened};
use super::sums::Sums;
use crate::geom::{Direction, Line};
use crate::quadric::Wall;
use crate::scalar::{Double, Float, Roots};

impl<S: Float> Wall<S> {
    /// Where the line is inside the wall, quickly where little cancels.
    #[inline(never)]
    pub(super) fn meet_obliquely(&self, axis: &Direction<S>, line: &Line<S>) -> Roots<S> {
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
    fn meet_closely(&self, axis: &Direction<S>, line: &Line<S>) -> Roots<S> {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::{Vec3, vec3};
    use crate::quadric::float::units::{check, roots, unit, vector};
    use crate::scalar::Scalar;
    use proptest::prelude::*;

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

            let tube = Wall { base: Vec3::from(base), radius: r, curvature: f32::NO_SCALE };
            let line = Line { origin: Vec3::from(origin), direction: Vec3::from(way) };
            let got = tube.meet_obliquely(&Direction::<f32>::new(axis), &line);
            let axis = vector(axis) * (1.0 / vector(axis).length_squared().sqrt());
            let across = |v: Vec3<f64>| v - axis * v.dot(axis);
            let want = roots(r, across(vector(origin) - vector(base)), across(vector(way)));
            // c is known to 2⁻⁴⁷ of |q|², and t near zero is c divided by small numbers here.
            check(got, want, 8.0, 1e-4)?;
        }
    }
}
