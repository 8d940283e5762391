//! Two discs across an axis and all between them: what holds a cone, and where parallel rays see it.

use super::strip::Steps;
use crate::geom::{Affine, OrthographicRays, Vec3};
use crate::quadric::{Planes, Taper};
use crate::scalar::{Number, Real, Scalar};

impl<S: Scalar> Taper<S> {
    /// A ball that holds all of it: both rims lie on it, or the larger one is its equator.
    pub(crate) fn bounding_ball(&self, caps: &Planes<S>) -> (Vec3<S::Wide>, S::Wide) {
        let [low, high] = [caps.low, caps.high].map(S::wide);
        let [first, last] = self.radii.map(S::wide);
        let half = (high - low) * S::Wide::HALF;
        let towards_larger = (last - first) / (high - low) * ((first + last) * S::Wide::HALF);
        let shift = towards_larger.max(-half).min(half);
        let middle = low + half + shift - caps.normal.dot_wide(self.base.wide());
        let to_rim = |along, radius| Vec3::new(along, radius, S::Wide::ZERO).length();
        let radius = to_rim(half + shift, first).max(to_rim(half - shift, last));
        let center = self.base.wide() + caps.normal.wide() * middle;
        // Rounded to the number type, both may be off; and a ray that passes a tip may meet it.
        (center, radius + S::uncertainty(center.max_abs() + radius) + S::ROUNDING.wide())
    }

    /// Where it is along a direction, as seen from its base.
    pub(crate) fn strip(
        &self,
        caps: &Planes<S>,
        rays: &OrthographicRays<S>,
        way: Vec3<S::Wide>,
    ) -> Strip<S> {
        let (axis, base) = (&caps.normal, self.base.wide());
        let (slope, at_base) = (axis.dot_wide(way), axis.dot_wide(base));
        // How much of a radius a cap's disc has along the direction; what squares lose is added.
        let lost = S::Wide::QUANTUM * S::Wide::from_int(8);
        let part = (axis.wide().cross(way).length_squared() + lost).sqrt();
        let ends = [(caps.low, self.radii[0]), (caps.high, self.radii[1])];
        let [[low, from], [high, to]] = ends.map(|(offset, radius)| {
            ((offset.wide() - at_base) * slope).around(radius.wide() * part)
        });
        let reach = caps.low.wide().abs() + caps.high.wide().abs() + self.widest();
        let size = (rays.center - base).max_abs() + at_base.abs() + reach;
        Strip {
            at: rays.steps(base).map(|step| step.dot_compensated(way)),
            ends: [low.min(high), from.max(to)],
            // Three coordinates, each of which is as large as that.
            size: size + size + size,
        }
    }
}

/// A length along a direction in the middle of a picture and its steps to the right and down, and from
/// where to where a solid is.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Strip<S: Scalar> {
    at: [S::Wide; 3],
    ends: [S::Wide; 2],
    /// How large the terms are that the length is computed from.
    pub(crate) size: S::Wide,
}

impl<S: Scalar> Strip<S> {
    /// The rows in which the solid can be, if the direction is the picture's down.
    pub(crate) fn rows(&self) -> Steps {
        let [middle, _, down] = self.at;
        self.steps(Affine { middle, step: down })
    }

    /// The columns of a row in which the solid can be.
    pub(crate) fn columns(&self, y: i32) -> Steps {
        self.steps(Affine::row(self.at, y))
    }

    fn steps(&self, length: Affine<S::Wide>) -> Steps {
        let [low, high] = self.ends;
        Steps::between::<S>(length, low, high, self.size)
    }
}
