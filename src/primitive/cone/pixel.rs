//! What both cameras have in common: the ray of any pixel, in the cone's own frame.

use super::{Cone, frame};
use crate::geom::{OrthographicRays, Vec3};
use crate::quadric::{Conic, meet};
use crate::scalar::{Real, Scalar};

/// A cone in a picture: the coordinates of [`Conic`], which are affine in the pixel. The first one is
/// across the axis along the middle ray, the second one at right angles to both.
#[derive(Debug, Clone, Copy)]
pub struct PixelView<S: Scalar> {
    /// In the middle of the picture, and the steps to the right and down.
    pub(super) from: [[S::Wide; 3]; 3],
    /// In the middle of the picture.
    pub(super) step: [S::Wide; 3],
}

impl<S: Scalar> PixelView<S> {
    /// The view, and the direction of its second coordinate.
    pub(super) fn new(cone: &Cone<S>, plane: &OrthographicRays<S>) -> (Self, Vec3<S::Wide>) {
        let Cone { taper, caps } = cone;
        let (axis, base) = (&caps.normal, taper.base.wide());
        let [cosine, sine] = taper.slant.map(S::wide_unit);
        let m = plane.forward.cross(axis.wide());
        let across = m.max_abs().is_divisor().then(|| m.normalized()).flatten();
        let side = across.unwrap_or_else(|| frame(axis.wide())[0]);
        let lengths = |v: Vec3<S::Wide>| {
            let place = v.cross(axis.wide()).dot_compensated(side);
            [place * cosine, v.dot_compensated(side) * cosine, axis.dot_wide(v) * sine]
        };
        let [[x, y, above], right, down] = plane.steps(base).map(lengths);
        let at_base = (axis.dot_wide(base) - caps.low.wide()) * sine;
        let radius = taper.radii[0].wide() * cosine + at_base + above;
        (Self { from: [[x, y, radius], right, down], step: lengths(plane.forward) }, side)
    }

    /// Where a pixel's ray is inside the nappe between the caps, by its values in the row's middle.
    #[inline(always)]
    pub(super) fn chord(&self, from: &[S::Wide; 3], step: [S::Wide; 3], x: i32) -> Option<[S; 2]> {
        let from = after(from, &self.from[1], x).map(S::from_wide);
        meet::conic(&Conic { from, step: step.map(S::unit) })
    }
}

/// So many steps farther.
#[inline(always)]
pub(super) fn after<T: Real>([a, b, c]: &[T; 3], [u, v, w]: &[T; 3], count: i32) -> [T; 3] {
    [a.after_steps(*u, count), b.after_steps(*v, count), c.after_steps(*w, count)]
}
