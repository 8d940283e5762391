//! Where a line is inside a ball.

use super::doubles::{cross, difference, dot, meet_closely, widened};
use super::sums::{Sums, squared_less_square};
use crate::geom::Line;
use crate::quadric::Ball;
use crate::scalar::{Double, Float, Roots};

#[inline(always)]
pub(in crate::quadric) fn ball<S: Float>(ball: &Ball<S>, line: &Line<S>) -> Roots<S> {
    let &Ball { center, radius } = ball;
    let (u, d) = (line.origin - center, line.direction);
    let sums = Sums {
        a: d.length_squared(),
        b: u.dot_compensated(d),
        from_axis: u.dot_compensated(u),
        k: u.cross(d).length_squared(),
    };
    let gap = || squared_less_square(difference(line.origin, center).to_array(), radius);
    sums.meet(radius, u.length_squared(), gap).unwrap_or_else(|| closely(ball, line))
}

/// Where the line is inside the ball, in twice the working precision throughout.
#[cold]
#[inline(never)]
fn closely<S: Float>(&Ball { center, radius }: &Ball<S>, line: &Line<S>) -> Roots<S> {
    let (u, d) = (difference(line.origin, center), widened(line.direction));
    let k = cross(u, d);
    meet_closely(Double::product(radius, radius), u.to_array(), d.to_array(), dot(k, k))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::Vec3;
    use crate::quadric::float::units::{check, roots, unit, vector};
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

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
            let got = ball(&Ball { center: Vec3::from(center), radius: r }, &line);
            check(got, roots(r, vector(origin) - vector(center), vector(way)), 5.0, 1e-5)?;
        }
    }
}
