//! Rays through an eye.

use super::orthographic::{OrthographicRays, PlaneRow};
use super::{RayRow, Rays};
use crate::geom::pose::Pose;
use crate::geom::ray::Line;
use crate::geom::vec3::Vec3;
use crate::scalar::{Grid, Number, Scalar};

/// The rays of a perspective picture: a pencil through the eye.
///
/// The ray of a pixel has the direction `forward + (X·right + Y·down)/distance`, so t is counted
/// along the viewing direction and the eye lies at t = −`distance`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PerspectiveRays<S: Scalar> {
    /// The steps of the image plane, as for parallel rays.
    pub plane: OrthographicRays<S>,
    /// From the eye to the centre.
    pub distance: S::Wide,
    /// 1/`distance`.
    pub inverse_distance: S::Wide,
}

impl<S: Scalar> PerspectiveRays<S> {
    /// Whether [`Scalar::Unit`] can hold the direction of every pixel that is at most so far to the side
    /// and so far up or down, in sum, at the distance 1. Floating point can.
    pub(crate) fn can_hold(sideways: S::Wide) -> bool {
        // No coordinate is larger than this sum, in any frame, and the length is less than that.
        let largest = S::Wide::ONE + sideways;
        S::SHORTEST <= S::ZERO || largest < S::wide_unit(S::unit(S::HIGHEST.wide()))
    }
}

/// A row of a pencil of rays.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PerspectiveRow<S: Scalar> {
    plane: PlaneRow<S>,
    inverse_distance: S::Wide,
    /// The viewing direction; in fixed point, the direction of a ray in the row's middle, and its step.
    turn: [Vec3<S::Wide>; 2],
}

/// Whether directions are added up from steps: in fixed point, where a step is exact.
const fn has_steps<S: Scalar>() -> bool {
    matches!(S::GRID, Grid::Fixed(_))
}

impl<S: Scalar> RayRow for PerspectiveRow<S> {
    type Scalar = S;

    #[inline]
    fn line(&self, x: i32) -> Line<S> {
        let offset = self.plane.offset(x);
        let [middle, step] = self.turn;
        let direction = if has_steps::<S>() {
            middle.after_steps(step, x)
        } else {
            middle + offset * self.inverse_distance
        };
        Line {
            origin: (self.plane.center + offset).map(S::from_wide),
            direction: direction.map(S::from_wide),
        }
    }
}

impl<S: Scalar> Rays for PerspectiveRays<S> {
    type Scalar = S;
    type Row = PerspectiveRow<S>;

    fn fits(&self, rows: u16) -> bool {
        // What half a pixel adds to a moment about a solid as far from the target as may be, which is less
        // than four times the reach, must be below 2³¹. Floating point has no such range.
        let most = S::Wide::from_int(1 << 29) / S::MAX_COORDINATE.wide();
        let is_near = S::SHORTEST <= S::ZERO || self.plane.half_pixel < most;
        let sideways =
            self.plane.half_pixels(rows) * (self.plane.half_pixel * self.inverse_distance);
        self.plane.fits(rows) && is_near && Self::can_hold(sideways)
    }

    fn row(&self, y: i32) -> PerspectiveRow<S> {
        let Self { plane, inverse_distance, .. } = *self;
        let row = PlaneRow::new(&plane, y);
        let turn = if has_steps::<S>() {
            [plane.forward + row.offset(0) * inverse_distance, row.right * inverse_distance]
        } else {
            [plane.forward; 2]
        };
        PerspectiveRow { plane: row, inverse_distance, turn }
    }

    fn start(&self) -> S {
        S::from_wide(-self.distance)
    }

    fn back_from(&self, pose: &Pose<S>) -> Self {
        Self { plane: self.plane.back_from(pose), ..*self }
    }
}
