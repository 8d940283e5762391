//! Chords in fixed point: for few cylinders of few pictures, so that less memory counts for more than time.

use super::super::Cylinder;
use super::chord::{ChordRow, ChordView};
use crate::geom::{Affine, Extent, OrthographicRays, PerspectiveRays, Vec3};
use crate::scalar::{FixedPoint, Scalar};
use crate::scan::planes;

/// The rays, of which each row makes a view.
#[derive(Debug, Clone, Copy)]
pub struct NearView<S: Scalar> {
    center: Vec3<S::Wide>,
    right: Vec3<S::Wide>,
    forward: Vec3<S::Wide>,
    half_pixel: S::Wide,
    distance: S::Wide,
    inverse_distance: S::Wide,
}

/// A [`ChordRow`] without the steps of m, which are those of q times the inverse distance.
#[derive(Debug, Clone, Copy)]
pub struct NearRow<S: Scalar> {
    moment: [Affine<S::Wide>; 2],
    turn: [S::Wide; 2],
    caps: planes::PerspectiveRow<S>,
}

impl<S: FixedPoint> NearView<S> {
    /// And whether the eye is inside of the wall.
    pub(super) fn new(cylinder: &Cylinder<S>, rays: &PerspectiveRays<S>) -> (Self, bool) {
        let PerspectiveRays { plane, distance, inverse_distance } = *rays;
        let OrthographicRays { center, right, forward, half_pixel, .. } = plane;
        let eye_within = ChordView::new(cylinder, rays).eye_within();
        let view = Self { center, right, forward, half_pixel, distance, inverse_distance };
        (view, eye_within)
    }

    pub(super) fn row(&self, cylinder: &Cylinder<S>, y: i32, columns: u32) -> (NearRow<S>, Extent) {
        let Self { center, right, forward, half_pixel, distance, inverse_distance } = *self;
        let down = forward.cross(right);
        let plane = OrthographicRays { center, right, down, forward, half_pixel, columns };
        let view = ChordView::new(cylinder, &PerspectiveRays { plane, distance, inverse_distance });
        let row = view.row(y);
        let extent = view.extent(&row, cylinder.wall.radius, y, columns);
        let ChordRow { moment, turn, caps } = row;
        (NearRow { moment, turn: turn.map(|m| m.middle), caps }, extent)
    }

    /// The row with all of its steps.
    pub(super) fn chords(&self, row: &NearRow<S>) -> ChordRow<S> {
        let NearRow { moment, turn: [m0, m1], caps } = *row;
        let [q0, q1] = moment;
        let turn =
            |middle, of: Affine<S::Wide>| Affine { middle, step: of.step * self.inverse_distance };
        ChordRow { moment, turn: [turn(m0, q0), turn(m1, q1)], caps }
    }
}
