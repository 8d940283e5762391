//! Parallel rays.

use super::{RayRow, Rays};
use crate::geom::columns::signed;
use crate::geom::pose::Pose;
use crate::geom::ray::Line;
use crate::geom::vec3::Vec3;
use crate::scalar::{Number, Real, Scalar};

/// The rays of an orthographic picture: all parallel to `forward`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OrthographicRays<S: Scalar> {
    /// What the middle of the picture shows.
    pub center: Vec3<S::Wide>,
    /// The direction to the right in the image plane, of length 1.
    pub right: Vec3<S::Wide>,
    /// The direction downwards in the image plane, of length 1.
    pub down: Vec3<S::Wide>,
    /// The viewing direction, of length 1.
    pub forward: Vec3<S::Wide>,
    /// The size of half a pixel.
    pub half_pixel: S::Wide,
    /// The number of columns.
    pub columns: u32,
}

impl<S: Scalar> OrthographicRays<S> {
    /// The middle of the picture as seen from a point, and the steps of half a pixel to the right
    /// and down.
    pub(crate) fn steps(&self, from: Vec3<S::Wide>) -> [Vec3<S::Wide>; 3] {
        [self.center - from, self.right * self.half_pixel, self.down * self.half_pixel]
    }

    /// How many half pixels a picture of so many rows reaches from the middle, to the right and down.
    pub(super) fn half_pixels(&self, rows: u16) -> S::Wide {
        S::Wide::from_int(signed(self.columns) + i32::from(rows))
    }
}

/// A row of the image plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PlaneRow<S: Scalar> {
    pub(super) center: Vec3<S::Wide>,
    /// The way from the centre to the middle of the row.
    down: Vec3<S::Wide>,
    /// The step of half a pixel.
    pub(super) right: Vec3<S::Wide>,
}

impl<S: Scalar> PlaneRow<S> {
    pub(super) fn new(plane: &OrthographicRays<S>, y: i32) -> Self {
        let [center, right, down] = plane.steps(Vec3::ZERO);
        Self { center, down: down.map(|step| S::Wide::ZERO.after_steps(step, y)), right }
    }

    /// The way from the centre to a pixel.
    #[inline]
    pub(super) fn offset(&self, x: i32) -> Vec3<S::Wide> {
        self.down.after_steps(self.right, x)
    }
}

/// A row of parallel rays.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OrthographicRow<S: Scalar> {
    plane: PlaneRow<S>,
    direction: Vec3<S>,
}

impl<S: Scalar> RayRow for OrthographicRow<S> {
    type Scalar = S;

    #[inline]
    fn line(&self, x: i32) -> Line<S> {
        let Self { plane, direction } = self;
        Line { origin: (plane.center + plane.offset(x)).map(S::from_wide), direction: *direction }
    }
}

impl<S: Scalar> Rays for OrthographicRays<S> {
    type Scalar = S;
    type Row = OrthographicRow<S>;

    fn fits(&self, rows: u16) -> bool {
        // More than from the middle to a corner.
        self.half_pixel * self.half_pixels(rows) < S::HIGHEST.wide() * S::Wide::HALF
    }

    fn row(&self, y: i32) -> OrthographicRow<S> {
        OrthographicRow { plane: PlaneRow::new(self, y), direction: self.forward.map(S::from_wide) }
    }

    fn start(&self) -> S {
        S::LOWEST
    }

    fn back_from(&self, pose: &Pose<S>) -> Self {
        Self {
            center: pose.point_back_wide(self.center),
            right: pose.turned_back(self.right),
            down: pose.turned_back(self.down),
            forward: pose.turned_back(self.forward),
            ..*self
        }
    }
}
