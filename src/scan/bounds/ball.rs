//! The rows and columns in which rays from an eye can meet a ball.

use super::outline::{Bounds, Outline, Silhouette};
use super::quadratic::{constant, extent};
use super::strip::{Rows, Steps};
use crate::geom::{Affine, Extent, PerspectiveRays, Vec3};
use crate::scalar::{Number, Real, Scalar};

/// A ball around a bounded solid, seen from an eye.
///
/// In the camera's own frame, with axes to the right, down and forward, the ray of a pixel is along
/// d = (x, y, 1). It meets the ball around c where `r²|d|² − |c × d|² ≥ 0`, with c as seen from the
/// eye. Both vectors are affine in the column, and the eye's distance cancels out of the second.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PerspectiveBall<S: Scalar> {
    /// As seen from the middle of the picture, in the camera's frame.
    center: Vec3<S::Wide>,
    radius: S::Wide,
    /// The size of half a pixel in the image plane.
    half_pixel: S::Wide,
    /// What half a pixel adds to x or y: that size over the eye's distance.
    slope: S::Wide,
    rows: Rows,
}

impl<S: Scalar> PerspectiveBall<S> {
    pub(crate) fn new(center: Vec3<S::Wide>, radius: S::Wide, rays: &PerspectiveRays<S>) -> Self {
        let plane = &rays.plane;
        let from_middle = center - plane.center;
        let along = |direction: Vec3<S::Wide>| from_middle.dot_compensated(direction);
        let center = Vec3::new(along(plane.right), along(plane.down), along(plane.forward));
        let (half_pixel, slope) = (plane.half_pixel, plane.half_pixel * rays.inverse_distance);
        // Three coordinates, each of which is as large as that.
        let size = center.max_abs() + rays.distance + radius;
        let around = radius + S::uncertainty(size + size + size);
        let rows = Self::rows(center.y, (center.z + rays.distance).around(around), around, slope);
        Self { center, radius, half_pixel, slope, rows }
    }

    /// The rows that can meet a ball around a point (x, y, z) from the eye.
    ///
    /// Row s·z = y meets it where |y − s·z| ≤ r√(1 + s²). The root is at most 1 + |s|, so s lies between
    /// (y − r)/(z ± r) and (y + r)/(z ± r), with the sign that makes that farther away.
    pub(crate) fn rows(
        y: S::Wide,
        [nearest, farthest]: [S::Wide; 2],
        radius: S::Wide,
        slope: S::Wide,
    ) -> Rows {
        // What half a pixel is at the nearest and at the farthest point.
        let [near, far] = [nearest, farthest].map(|depth| depth * slope);
        if nearest <= S::Wide::ZERO || !near.is_divisor() || !farthest.is_finite() {
            return Rows::ALL;
        }
        let (low, high) = (y - radius, y + radius);
        let low = low.ratio(if low < S::Wide::ZERO { near } else { far });
        let high = high.ratio(if high < S::Wide::ZERO { far } else { near });
        Rows::of(Steps::from_to(low, high))
    }

    /// Whether all of the ball, and of one that is half as large again, is before an eye at this distance.
    pub(crate) fn is_before_eye(&self, distance: S::Wide) -> bool {
        self.center.z + distance > self.radius + self.radius * S::Wide::HALF
    }

    /// The rows that can meet the ball.
    pub(crate) fn in_rows(&self) -> Rows {
        self.rows
    }

    /// d in a row.
    pub(crate) fn direction(&self, y: i32) -> [Affine<S::Wide>; 3] {
        let x = Affine { middle: S::Wide::ZERO, step: self.slope };
        [x, constant(S::Wide::ZERO.after_steps(self.slope, y)), constant(S::Wide::ONE)]
    }

    /// p − c in a row, p being where the rays have t = 0.
    pub(crate) fn position(&self, y: i32) -> [Affine<S::Wide>; 3] {
        let Vec3 { x, y: across, z } = self.center;
        let along = Affine { middle: -x, step: self.half_pixel };
        [along, constant((-across).after_steps(self.half_pixel, y)), constant(-z)]
    }

    /// c × d in a row, with c as seen from the eye.
    pub(crate) fn moment(&self, y: i32) -> [Affine<S::Wide>; 3] {
        let Vec3 { x: cx, y: cy, z: cz } = self.center;
        // What half a pixel is at the ball's distance.
        let lever = self.half_pixel + cz * self.slope;
        [
            constant(cy.after_steps(-lever, y)),
            Affine { middle: -cx, step: lever },
            Affine {
                middle: S::Wide::ZERO.after_steps(cx * self.slope, y),
                step: -(cy * self.slope),
            },
        ]
    }
}

impl<S: Scalar> Silhouette for PerspectiveBall<S> {
    fn is_in_rows(&self, rows: [i32; 2]) -> bool {
        self.rows.meet(rows)
    }

    fn extent(&self, y: i32, columns: u32) -> Extent {
        let reach = self.direction(y).map(|part| part.times(self.radius + S::ROUNDING.wide()));
        extent(&reach, &self.moment(y), columns)
    }
}

impl<S: Scalar> Outline for PerspectiveRays<S> {
    type Silhouette = Option<PerspectiveBall<S>>;

    fn outline(&self, bounds: &Bounds<S>) -> Self::Silhouette {
        let around = bounds.middle()?;
        Some(PerspectiveBall::new(around.center, around.radius(), self))
    }
}
