//! Where a line is counted from in the frame of a solid that is moved.

use crate::geom::Vec3;
use crate::scalar::{Number, Scalar};
use crate::scan::bounds::{Around, Bounds};

/// A point of a solid's own frame that its lines are counted from: the frame's origin, or the middle of the
/// bounds of a solid that is more than 16 times its size away from there.
///
/// Most solids are made around their frame's origin. They share it, so the faces of two solids with the same
/// pose are crossed at the same bits.
pub(super) fn anchor<S: Scalar>(bounds: &Bounds<S>) -> Vec3<S> {
    let Some(Around { center, half, .. }) = bounds.middle() else { return Vec3::ZERO };
    let is_far = center.max_abs() > half.max_abs() * S::Wide::from_int(16);
    if is_far { center.map(S::from_wide) } else { Vec3::ZERO }
}

/// A parameter that is counted from another one. Infinite ones stay.
pub(super) fn shifted<S: Scalar>(t: S, from: S) -> S {
    if t > S::LOWEST && t < S::HIGHEST { t.plus(from) } else { t }
}
