//! The wall of a cone in pictures: the ray of any pixel, in the cone's own frame.

mod orthographic;
mod perspective;

pub use orthographic::OrthographicView;
pub use perspective::{PerspectiveRow, PerspectiveView};

use crate::geom::{OrthographicRays, Vec3};
use crate::quadric::{Conic, Planes, Taper, meet};
use crate::scalar::{Real, Scalar};

/// The coordinates of [`Conic`], which are affine in the pixel. The first one is across the axis along the
/// middle ray, the second one at right angles to both.
#[derive(Debug, Clone, Copy)]
struct Pencil<S: Scalar> {
    /// In the middle of the picture, and the steps to the right and down.
    from: [[S::Wide; 3]; 3],
    /// In the middle of the picture.
    step: [S::Wide; 3],
}

impl<S: Scalar> Pencil<S> {
    /// Rays that reach a wall, and the direction of their second coordinate: `beside`, a unit vector across the
    /// axis, where they run along it.
    fn new(
        taper: &Taper<S>,
        caps: &Planes<S>,
        plane: &OrthographicRays<S>,
        beside: Vec3<S::Wide>,
    ) -> (Self, Vec3<S::Wide>) {
        let (axis, base) = (&caps.normal, taper.base.wide());
        let [cosine, sine] = taper.slant.map(S::wide_unit);
        let m = plane.forward.cross(axis.wide());
        let across = m.max_abs().is_divisor().then(|| m.normalized()).flatten();
        let side = across.unwrap_or(beside);
        let lengths = |v: Vec3<S::Wide>| {
            let place = v.cross(axis.wide()).dot_compensated(side);
            [place * cosine, v.dot_compensated(side) * cosine, axis.dot_wide(v) * sine]
        };
        let [[x, y, above], right, down] = plane.steps(base).map(lengths);
        let at_base = (axis.dot_wide(base) - caps.low.wide()) * sine;
        let radius = taper.radii[0].wide() * cosine + at_base + above;
        (Self { from: [[x, y, radius], right, down], step: lengths(plane.forward) }, side)
    }

    /// The coordinates in the middle of a row.
    fn row(&self, y: i32) -> [S::Wide; 3] {
        after(&self.from[0], &self.from[2], y)
    }

    /// Where a pixel's ray is inside the nappe between the caps, by its coordinates in the row's middle.
    #[inline(always)]
    fn chord(&self, from: &[S::Wide; 3], step: [S::Wide; 3], x: i32) -> Option<[S; 2]> {
        let from = after(from, &self.from[1], x).map(S::from_wide);
        meet::conic(&Conic { from, step: step.map(S::unit) })
    }
}

/// So many steps farther.
#[inline(always)]
fn after<T: Real>([a, b, c]: &[T; 3], [u, v, w]: &[T; 3], count: i32) -> [T; 3] {
    [a.after_steps(*u, count), b.after_steps(*v, count), c.after_steps(*w, count)]
}
