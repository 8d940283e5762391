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

use super::aligned::across;
use super::ends::cut;
use super::oblique::meet_ball;
use super::{Intersect, Passage};
use crate::geom::{Line, Vec3};
use crate::scalar::{Double, Float};
use crate::solid::cylinder::{Cylinder, Tube};
use crate::solid::slab::Slab;
use crate::span::Span;

/// Where a line is inside the wall: from the first parameter to the second one, which are the same
/// for a tangent. For a line beside the wall, the first one is larger.
pub(super) type Inside<S> = (S, S);

impl<S: Float> Tube<S> {
    pub(super) const NOWHERE: Inside<S> = (S::HIGHEST, S::LOWEST);
    const EVERYWHERE: Inside<S> = (S::LOWEST, S::HIGHEST);

    /// Where a line along the axis is inside the wall.
    pub(super) fn parallel(c: S) -> Inside<S> {
        if c < S::ZERO { Self::EVERYWHERE } else { Self::NOWHERE }
    }
}

/// Where a line passes the planes of a slab.
///
/// Along a coordinate axis the line's height is exact. Along others it's subtracted before it's rounded.
#[inline]
pub(super) fn pass<S: Float>(slab: &Slab<S>, line: &Line<S>) -> Passage<S> {
    let normal = &slab.normal;
    let speed = normal.dot(line.direction);
    match normal.along() {
        Some(_) => slab.passage(normal.dot(line.origin), speed),
        None => {
            let (origin, normal) = (line.origin.to_array(), normal.vector().to_array());
            let above = |offset| Double::less_dot(offset, origin, normal);
            slab.passed([slab.low, slab.high].map(above), speed)
        }
    }
}

/// Where a line is inside the wall, wherever it starts and however near to a tangent it is.
#[cold]
#[inline(never)]
pub(super) fn meet<S: Float>(cylinder: &Cylinder<S>, line: &Line<S>) -> Inside<S> {
    let Cylinder { tube, caps } = cylinder;
    let Some(axis) = caps.normal.along() else { return tube.meet_obliquely(&caps.normal, line) };
    let [[o0, o1], [base0, base1], [m0, m1]] =
        [&line.origin, &tube.base, &line.direction].map(|v| across(axis, v));
    tube.meet_carefully([*o0, *o1], [*base0, *base1], [*m0, *m1])
}

/// Where the line crosses the cylinder's wall between the caps.
fn meet_wall<S: Float>(cylinder: &Cylinder<S>, line: &Line<S>) -> [Option<S>; 2] {
    let caps = &cylinder.caps;
    let (enter, exit) = meet(cylinder, line);
    let (at_zero, speed) = (caps.normal.dot(line.origin), caps.normal.dot(line.direction));
    [enter, exit].map(|t| {
        let height = S::add_product(at_zero, t, speed);
        (caps.low <= height && height <= caps.high).then_some(t)
    })
}

macro_rules! intersect {
    ($($Float:ident),+) => {$(
        impl Intersect for $Float {
            #[inline(always)]
            fn cut(cylinder: &Cylinder<Self>, line: &Line<Self>) -> Option<Span<Self>> {
                cut(cylinder, line)
            }

            #[inline]
            fn meet_wall(cylinder: &Cylinder<Self>, line: &Line<Self>) -> [Option<Self>; 2] {
                meet_wall(cylinder, line)
            }

            #[inline]
            fn meet_ball(center: Vec3<Self>, radius: Self, line: &Line<Self>) -> Option<[Self; 2]> {
                let (enter, exit) = meet_ball(center, radius, line);
                (enter < exit).then_some([enter, exit])
            }

            #[inline]
            fn pass(slab: &Slab<Self>, line: &Line<Self>) -> Passage<Self> {
                pass(slab, line)
            }
        }
    )+};
}

intersect!(f32, f64);

#[cfg(test)]
mod tests {
    use super::pass;
    use crate::geom::{Line, Ray, Vec3, vec3};
    use crate::numeric::Fused;
    use crate::solid::intersect::{Passage, units_off};
    use crate::solid::{Cylinder, Slab, Solid};
    use crate::span::SpanList;
    use proptest::prelude::*;
    use std::vec::Vec;

    macro_rules! spans {
        ($Float:ident, $o:expr, $d:expr, $at:expr) => {{
            let ([ox, oy, oz], [dx, dy, dz], [y, z, r]) =
                ($o.map($Float::from), $d.map($Float::from), $at.map($Float::from));
            let solid = Cylinder::<$Float>::along_x(y, z, r, -9.0, 9.0).ok();
            let ray = Ray::<$Float>::new(vec3(ox, oy, oz), vec3(dx, dy, dz)).ok();
            let mut list = SpanList::<$Float, 1>::new();
            let spans = solid.zip(ray).map(|(solid, ray)| {
                solid.trace(&ray, &mut list).iter().map(|s| [s.enter.t, s.exit.t]).collect()
            });
            spans.unwrap_or_else(Vec::<[$Float; 2]>::new)
        }};
    }

    proptest! {
        /// The distance from the axis isn't a number of the type then: its rounding would show.
        #[test]
        fn beside_the_origin_as_well(
            [y, z] in [-3f32..3.0, -3f32..3.0], r in 0.5f32..1.5, gap in -1.5f32..-0.001,
            back in -8f32..8.0, angle in 0f32..6.3, tilt in -0.5f32..0.5,
        ) {
            let (sin, cos) = (angle.sin(), angle.cos());
            let distance = r * (1.0 + gap);
            let o = [0.0, y + distance * cos - back * sin, z + distance * sin + back * cos];
            let d = [tilt, -sin, cos];
            let got = spans!(f32, o, d, [y, z, r]);
            let want = spans!(f64, o, d, [y, z, r]);
            prop_assert_eq!(got.len(), want.len());
            for (got, want) in got.iter().flatten().zip(want.iter().flatten()) {
                prop_assert!(units_off(*got, *want, 0.0) < 6.0, "{got} not {want}");
            }
        }

        /// Near a tangent, k and D lose what the rounded distance from the axis has lost.
        #[test]
        fn grazing_beside_the_origin_as_well(
            [y, z] in [-3f32..3.0, -3f32..3.0], r in 0.5f32..1.5, depth in -6f32..-2.0,
            back in prop_oneof![2f32..8.0, -0.5f32..0.5, -0.01f32..0.01], angle in 0f32..6.3, tilt in -0.5f32..0.5,
        ) {
            let (sin, cos) = (angle.sin(), angle.cos());
            let distance = r * (1.0 - 10f32.powf(depth));
            let o = [0.0, y + distance * cos - back * sin, z + distance * sin + back * cos];
            let d = [tilt, sin, -cos];
            let got = spans!(f32, o, d, [y, z, r]);
            let want = spans!(f64, o, d, [y, z, r]);
            // Near (0, 0, 0), a line is counted from there, and parameters near 0 are rounded as it is.
            prop_assume!((o[1] * d[2] - o[2] * d[1]).abs() > 0.1);
            // A ray that misses by what its own numbers are rounded to may be either.
            prop_assume!(want.len() == 1);
            prop_assert_eq!(got.len(), 1);
            // Nor is more known of an end that the ray starts in than of its start.
            prop_assume!(want[0].iter().all(|t| t.abs() > 1e-4));
            for (got, want) in got.iter().flatten().zip(want.iter().flatten()) {
                prop_assert!(units_off(*got, *want, 0.0) < 6.0, "{got} not {want}");
            }
        }
    }

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
            let slab = Slab::<f32>::new(normal, near, near + 1.0);
            let slab = slab.map_err(|error| TestCaseError::fail(error.as_str()))?;
            let line = Line { origin: base + Vec3::from(o), direction: Vec3::from(d) };
            let wide = |v: Vec3<f32>| v.map(f64::from);
            let (axis, offsets) = (wide(slab.normal.vector()), [slab.low, slab.high].map(f64::from));
            let (at_zero, speed) = (axis.dot(wide(line.origin)), axis.dot(wide(line.direction)));
            // f64 knows these to a few 2⁻⁵² of their terms.
            prop_assume!(speed.abs() > 1e-3);
            let Passage::Across { at, .. } = pass(&slab, &line) else {
                return Err(TestCaseError::fail("along the planes"));
            };
            for (got, offset) in at.into_iter().zip(offsets) {
                let want = (offset - at_zero) / speed;
                prop_assert!(units_off(got, want, 1e-5) < 2.5, "{got} not {want}");
            }
        }
    }

    /// Where `f64` shows the difference in c half-way between two `f32`, it's rounded in another way.
    #[test]
    fn half_way_between_two_numbers_as_well() {
        let (y, r) = (1.0 + 2f32.powi(-12), 2f32.powi(-7));
        assert_eq!(f32::quick_square_less(y, r * r), None);
        for (z, tilt) in [(0.0, 0.25), (0.5, 0.0), (-3.0, 0.125)] {
            for side in [y, -y] {
                // At the axis, past it by half of the radius, and away from it.
                for aim in [[-side, -z], [-side, r / 2.0 - z], [side, z]] {
                    let (o, d) = ([0.0, side, z], [tilt, aim[0], aim[1]]);
                    let got = spans!(f32, o, d, [0.0, 0.0, r]);
                    let want = spans!(f64, o, d, [0.0, 0.0, r]);
                    assert_eq!((got.len(), want.len()), (1, 1), "{o:?} {d:?}");
                    for (got, want) in got.iter().flatten().zip(want.iter().flatten()) {
                        let error = (f64::from(*got) - want).abs() / want.abs();
                        assert!(error < 4.0 * f64::from(f32::EPSILON), "{got} not {want}");
                    }
                }
            }
        }
    }
}
