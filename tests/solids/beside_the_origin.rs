//! Lines at cylinders beside the origin, against double precision.

use proptest::prelude::*;
use scancsg::geom::{Axis, Ray, Vec3};
use scancsg::scalar::Scalar;
use scancsg::solid::{Cylinder, RayCast};
use scancsg::span::SpanList;

/// How many units in the last place of the true number another one is off.
fn units_off(got: f32, want: f64) -> f64 {
    let size = (want as f32).abs();
    (f64::from(got) - want).abs() / (f64::from(size.next_up()) - f64::from(size))
}

/// Where a line is inside a cylinder along x, beside the origin.
fn spans<S: Scalar + From<f32>>(o: [f32; 3], d: [f32; 3], [y, z, r]: [f32; 3]) -> Vec<[S; 2]> {
    let (origin, direction) = (Vec3::from(o.map(S::from)), Vec3::from(d.map(S::from)));
    let at = [y, z].map(S::from);
    let solid = Cylinder::along(Axis::X, at, r.into(), (-9.0).into(), 9.0.into()).ok();
    let mut list = SpanList::<S, 1>::new();
    let spans = solid.zip(Ray::new(origin, direction).ok()).map(|(solid, ray)| {
        solid.trace(&ray, &mut list).iter().map(|s| [s.enter.t, s.exit.t]).collect()
    });
    spans.unwrap_or_default()
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
        let got = spans::<f32>(o, d, [y, z, r]);
        let want = spans::<f64>(o, d, [y, z, r]);
        prop_assert_eq!(got.len(), want.len());
        for (got, want) in got.iter().flatten().zip(want.iter().flatten()) {
            prop_assert!(units_off(*got, *want) < 6.0, "{got} not {want}");
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
        let got = spans::<f32>(o, d, [y, z, r]);
        let want = spans::<f64>(o, d, [y, z, r]);
        // Near (0, 0, 0), a line is counted from there, and parameters near 0 are rounded as it is.
        prop_assume!((o[1] * d[2] - o[2] * d[1]).abs() > 0.1);
        // A ray that misses by what its own numbers are rounded to may be either.
        prop_assume!(want.len() == 1);
        prop_assert_eq!(got.len(), 1);
        // Nor is more known of an end that the ray starts in than of its start.
        prop_assume!(want[0].iter().all(|t| t.abs() > 1e-4));
        for (got, want) in got.iter().flatten().zip(want.iter().flatten()) {
            prop_assert!(units_off(*got, *want) < 6.0, "{got} not {want}");
        }
    }
}

/// Where the square of the distance ends half-way between two `f32`.
#[test]
fn half_way_between_two_numbers_as_well() {
    let (y, r) = (1.0 + 2f32.powi(-12), 2f32.powi(-7));
    for (z, tilt) in [(0.0, 0.25), (0.5, 0.0), (-3.0, 0.125)] {
        for side in [y, -y] {
            // At the axis, past it by half of the radius, and away from it.
            for aim in [[-side, -z], [-side, r / 2.0 - z], [side, z]] {
                let (o, d) = ([0.0, side, z], [tilt, aim[0], aim[1]]);
                let got = spans::<f32>(o, d, [0.0, 0.0, r]);
                let want = spans::<f64>(o, d, [0.0, 0.0, r]);
                assert_eq!((got.len(), want.len()), (1, 1), "{o:?} {d:?}");
                for (got, want) in got.iter().flatten().zip(want.iter().flatten()) {
                    let error = (f64::from(*got) - want).abs() / want.abs();
                    assert!(error < 4.0 * f64::from(f32::EPSILON), "{got} not {want}");
                }
            }
        }
    }
}
