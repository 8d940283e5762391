//! What tests expect, within the limits of the table.

use crate::limits;
use crate::number::{Tested, spans};
use scancsg::geom::Ray;
use scancsg::solid::Solid;

/// The spans of a line have to be these: in fixed point at the nearest numbers, in floating point within
/// 4 ε of the parameter.
#[track_caller]
pub fn assert_spans<S: Tested, T: Solid<Scalar = S>>(solid: &T, ray: &Ray<S>, want: &[(f64, f64)]) {
    let got = spans(solid, ray);
    let units = limits::SPANS.of::<S>();
    let allowed = |t: f64| if S::IS_FIXED { units + limits::WANTED } else { units * t.abs() };
    let is_near = |got: f64, want: f64| (got - want).abs() <= allowed(want);
    let all_near =
        got.iter().zip(want).all(|(got, want)| is_near(got.0, want.0) && is_near(got.1, want.1));
    assert!(got.len() == want.len() && all_near, "{got:?} is not {want:?}");
}
