//! For tests: errors in units in the last place, and the same roots in double precision.

use crate::geom::Vec3;
use crate::scalar::Roots;
use proptest::prelude::*;

/// How many units in the last place of the true number, or of `least` if that is larger, another one
/// is off.
pub(super) fn units_off(got: f32, want: f64, least: f32) -> f64 {
    let size = (want as f32).abs().max(least);
    (f64::from(got) - want).abs() / (f64::from(size.next_up()) - f64::from(size))
}

pub(super) fn vector(v: [f32; 3]) -> Vec3<f64> {
    Vec3::from(v.map(f64::from))
}

/// What `f64` says of the same numbers: the roots of |q + t·m|² = r², with all but a pair of terms from
/// other formulas than those above.
pub(super) fn roots(radius: f32, q: Vec3<f64>, m: Vec3<f64>) -> Option<[f64; 2]> {
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

pub(super) fn check(
    got: Roots<f32>,
    want: Option<[f64; 2]>,
    most: f64,
    least: f32,
) -> Result<(), TestCaseError> {
    let ends = got.ends().map(|(enter, exit)| [enter, exit]);
    prop_assert_eq!(ends.is_some(), want.is_some(), "{:?} {:?}", got, want);
    for (got, want) in ends.into_iter().flatten().zip(want.into_iter().flatten()) {
        prop_assert!(units_off(got, want, least) < most, "{got} not {want}");
    }
    Ok(())
}

pub(super) fn unit(v: Vec3<f64>) -> Option<Vec3<f64>> {
    let square = v.length_squared();
    (square > 0.01).then(|| v * (1.0 / square.sqrt()))
}
