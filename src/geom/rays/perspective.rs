//! Rays through an eye.

use super::orthographic::{OrthographicRays, PlaneRow};
use super::{RayRow, Rays};
use crate::geom::columns::Affine;
use crate::geom::pose::Pose;
use crate::geom::ray::Line;
use crate::geom::vec3::Vec3;
use crate::scalar::{Real, Scalar};

/// The rays of a perspective picture: a pencil through the eye.
///
/// The ray of a pixel has the direction `forward + (X·right + Y·down)/distance`, so t is counted
/// along the viewing direction and the eye lies at t = −`distance`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PerspectiveRays<S: Scalar> {
    /// The steps of the image plane, as for parallel rays.
    pub plane: OrthographicRays<S>,
    /// From the eye to the centre.
    pub distance: S::Wide,
    /// 1/`distance`.
    pub inverse_distance: S::Wide,
    /// How often directions must be halved to have coordinates that [`Scalar::Unit`] can hold: 0 in
    /// floating point, and for all but very wide pictures.
    pub halvings: u8,
}

impl<S: Scalar> PerspectiveRays<S> {
    /// The parameter along a direction that was halved so often, as one along the direction itself.
    #[inline]
    pub(crate) fn along_whole(t: S, halvings: u8) -> S {
        // Known without looking in floating point, which never halves.
        let is_whole = S::SHORTEST <= S::ZERO || halvings == 0;
        if is_whole || t <= S::LOWEST || t >= S::HIGHEST {
            return t;
        }
        S::from_wide(t.wide() * shortening(halvings))
    }
}

/// The factor of directions that are halved so often.
fn shortening<T: Real>(halvings: u8) -> T {
    (0..halvings).fold(T::ONE, |factor, _| factor * T::HALF)
}

/// Coordinates that are halved as often as directions are.
pub(crate) fn shortened<T: Real, const N: usize>(
    parts: [Affine<T>; N],
    halvings: u8,
) -> [Affine<T>; N] {
    match halvings {
        0 => parts,
        _ => parts.map(|part| part.times(shortening(halvings))),
    }
}

/// A row of a pencil of rays.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PerspectiveRow<S: Scalar> {
    plane: PlaneRow<S>,
    forward: Vec3<S::Wide>,
    inverse_distance: S::Wide,
}

impl<S: Scalar> RayRow for PerspectiveRow<S> {
    type Scalar = S;

    #[inline]
    fn line(&self, x: i32) -> Line<S> {
        let offset = self.plane.offset(x);
        Line {
            origin: (self.plane.center + offset).map(S::from_wide),
            direction: (self.forward + offset * self.inverse_distance).map(S::from_wide),
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
        self.plane.fits(rows) && (S::SHORTEST <= S::ZERO || self.plane.half_pixel < most)
    }

    fn row(&self, y: i32) -> PerspectiveRow<S> {
        PerspectiveRow {
            plane: PlaneRow::new(&self.plane, y),
            forward: self.plane.forward,
            inverse_distance: self.inverse_distance,
        }
    }

    fn start(&self) -> S {
        S::from_wide(-self.distance)
    }

    fn back_from(&self, pose: &Pose<S>) -> Self {
        Self { plane: self.plane.back_from(pose), ..*self }
    }
}
