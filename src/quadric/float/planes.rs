//! Where a line crosses planes: two parallel ones, those of a box, and those of half-spaces.

use crate::geom::{Axis, Direction, Line};
use crate::quadric::{Corners, HalfSpace, PlaneRoots, Planes};
use crate::scalar::{Double, Float};
use crate::span::{Crossing, Face, Span};

/// How far planes are above a line at t = 0, and how fast the line rises.
///
/// Along a coordinate axis the line's height is exact. Along others it is subtracted before it is rounded.
#[inline]
fn heights<S: Float, const N: usize>(
    normal: &Direction<S>,
    offsets: [S; N],
    line: &Line<S>,
) -> ([S; N], S) {
    let heights = match normal.along() {
        Some(_) => {
            let at_zero = normal.dot(line.origin);
            offsets.map(|offset| offset - at_zero)
        }
        None => {
            let (origin, normal) = (line.origin.to_array(), normal.vector().to_array());
            offsets.map(|offset| Double::less_dot(offset, origin, normal))
        }
    };
    (heights, normal.dot(line.direction))
}

#[inline]
pub(in crate::quadric) fn planes<S: Float>(planes: &Planes<S>, line: &Line<S>) -> PlaneRoots<S> {
    let (heights, speed) = heights(&planes.normal, [planes.low, planes.high], line);
    planes.crossed_above(heights, speed)
}

/// The part of a line inside a box.
#[inline]
pub(in crate::quadric) fn cuboid<S: Float>(cuboid: &Corners<S>, line: &Line<S>) -> Option<Span<S>> {
    let mut common = Span::whole_line(Face(0));
    for axis in Axis::ALL {
        let between = planes(&cuboid.planes(axis), line).ends()?;
        let (enter, exit) =
            common.common_ends(between.with_faces_from(Corners::<S>::first_face(axis)));
        common = Span { enter, exit };
    }
    common.checked()
}

/// The part of a line inside all half-spaces.
pub(in crate::quadric) fn half_spaces<S: Float>(
    faces: &[HalfSpace<S>],
    line: &Line<S>,
) -> Option<Span<S>> {
    let mut common = Span::whole_line(Face(0));
    for (face, index) in faces.iter().zip(0..) {
        let ([height], speed) = heights(&face.normal, [face.offset], line);
        if speed == S::ZERO {
            if !face.has_below(height, S::ZERO) {
                return None;
            }
            continue;
        }
        let crossing = Crossing { t: height / speed, face: Face(index) };
        common.cut(crossing, speed > S::ZERO);
    }
    common.checked()
}

#[cfg(test)]
mod tests {
    use super::planes;
    use crate::geom::{Direction, Line, Vec3};
    use crate::quadric::Planes;
    use crate::quadric::float::units::units_off;
    use crate::scalar::Roots;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        /// Far from the scene's origin and near the plane, the line's height is rounded to more than what is
        /// left of it.
        #[test]
        fn oblique_planes_as_in_double_precision(
            normal in prop::array::uniform3(-1f32..1.0), base in prop::array::uniform3(-100f32..100.0),
            o in prop::array::uniform3(-2f32..2.0), d in prop::array::uniform3(-1f32..1.0),
        ) {
            let normal = Vec3::from(normal);
            prop_assume!(normal.length_squared() > 0.01);
            let base = Vec3::from(base);
            let near = base.dot(normal.normalized().unwrap_or(Vec3::ZERO));
            let Some(normal) = normal.normalized() else {
                return Err(TestCaseError::reject("no direction"));
            };
            let normal = Direction::<f32>::new(normal.to_array());
            let slab = Planes { normal, low: near, high: near + 1.0 };
            let line = Line { origin: base + Vec3::from(o), direction: Vec3::from(d) };
            let wide = |v: Vec3<f32>| v.map(f64::from);
            let (axis, offsets) = (wide(slab.normal.vector()), [slab.low, slab.high].map(f64::from));
            let (at_zero, speed) = (axis.dot(wide(line.origin)), axis.dot(wide(line.direction)));
            // f64 knows these to a few 2⁻⁵² of their terms.
            prop_assume!(speed.abs() > 1e-3);
            let got = planes(&slab, &line);
            let Roots::Between(low, high) = got.roots else {
                return Err(TestCaseError::fail("along the planes"));
            };
            for (got, offset) in [low, high].into_iter().zip(offsets) {
                let want = (offset - at_zero) / speed;
                prop_assert!(units_off(got, want, 1e-5) < 2.5, "{got} not {want}");
            }
        }
    }
}
