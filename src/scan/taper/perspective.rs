//! The wall of a cone, seen from an eye: also a ray's steps are affine in the pixel.

use super::{Pencil, after};
use crate::geom::{PerspectiveRays, Vec3};
use crate::quadric::{Planes, Taper};
use crate::scalar::Scalar;

/// A cone's wall, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PerspectiveView<S: Scalar> {
    wall: Pencil<S>,
    /// What half a pixel to the right, and down, adds to the wall's `step`.
    turn: [[S::Wide; 3]; 2],
}

/// A row of a cone's wall, seen from an eye: values in its middle.
#[derive(Debug, Clone, Copy)]
pub struct PerspectiveRow<S: Scalar> {
    from: [S::Wide; 3],
    step: [S::Wide; 3],
}

impl<S: Scalar> PerspectiveView<S> {
    /// What a camera decides; `beside` is a unit vector across the axis.
    pub(crate) fn new(
        taper: &Taper<S>,
        caps: &Planes<S>,
        rays: &PerspectiveRays<S>,
        beside: Vec3<S::Wide>,
    ) -> Self {
        let (wall, _) = Pencil::new(taper, caps, &rays.plane, beside);
        let [_, right, down] = wall.from;
        let turn = [right, down].map(|way| way.map(|part| part * rays.inverse_distance));
        Self { wall, turn }
    }

    pub(crate) fn row(&self, y: i32) -> PerspectiveRow<S> {
        PerspectiveRow { from: self.wall.row(y), step: after(&self.wall.step, &self.turn[1], y) }
    }

    /// Where a ray is inside the nappe between the caps.
    #[inline(always)]
    pub(crate) fn chord(&self, row: &PerspectiveRow<S>, x: i32) -> Option<[S; 2]> {
        self.wall.chord(&row.from, after(&row.step, &self.turn[0], x), x)
    }
}
