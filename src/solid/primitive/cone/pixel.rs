//! What both cameras have in common: the ray of any pixel, in the cone's own frame.

use super::Cone;
use crate::geom::{Affine, OrthographicRays};
use crate::quadric::{Conic, meet};
use crate::scalar::{Number, Scalar};
use crate::solid::primitive::cylinder::frame;

/// A cone in a picture: values in the middle, and their steps to the right and down.
#[derive(Debug, Clone, Copy)]
pub struct PixelView<S: Scalar> {
    from: [[S::Wide; 3]; 3],
    /// In the middle; its steps are those of `from` times the convergence.
    step: [S::Wide; 3],
    convergence: S::Wide,
}

/// A row of a cone in a picture: the coordinates of [`Conic`].
#[derive(Debug, Clone, Copy)]
pub struct PixelRow<S: Scalar> {
    from: [Affine<S::Wide>; 3],
    step: [Affine<S::Wide>; 3],
}

impl<S: Scalar> PixelView<S> {
    pub(super) const EMPTY: Self = Self {
        from: [[S::Wide::ZERO; 3]; 3],
        step: [S::Wide::ZERO; 3],
        convergence: S::Wide::ZERO,
    };

    /// Along rays whose directions change by `convergence` times the way in the image plane.
    pub(super) fn new(cone: &Cone<S>, plane: &OrthographicRays<S>, convergence: S::Wide) -> Self {
        let Cone { taper, caps } = cone;
        let (axis, base) = (&caps.normal, taper.base.wide());
        let [along, outward] = taper.slant.map(S::wide_unit);
        let across = frame(axis.wide());
        let lengths = |way: crate::geom::Vec3<S::Wide>| {
            let moment = way.cross(axis.wide());
            let [x, y] = across.map(|side| side.dot(moment) * along);
            [x, y, axis.dot_wide(way) * outward]
        };
        let [middle, right, down] = plane.steps(base).map(lengths);
        let [x, y, above] = middle;
        let radius = taper.radii[0].wide() * along
            + (axis.dot_wide(base) - caps.low.wide()) * outward
            + above;
        let steps = |i: usize, middle: S::Wide| {
            let of = |v: [S::Wide; 3]| v.get(i).copied().unwrap_or(S::Wide::ZERO);
            [middle, of(right), of(down)]
        };
        Self {
            from: [steps(0, x), steps(1, y), steps(2, radius)],
            step: lengths(plane.forward),
            convergence,
        }
    }

    pub(super) fn row(&self, y: i32) -> PixelRow<S> {
        let from = self.from.map(|of| Affine::row(of, y));
        let [x, across, radius] = self.from;
        let turn = |[_, right, down]: [S::Wide; 3], middle: S::Wide| {
            let way = Affine::row([S::Wide::ZERO, right, down], y).times(self.convergence);
            Affine { middle: middle + way.middle, ..way }
        };
        let [to_x, to_across, growth] = self.step;
        PixelRow { from, step: [turn(x, to_x), turn(across, to_across), turn(radius, growth)] }
    }
}

impl<S: Scalar> PixelRow<S> {
    /// Where the ray of a pixel is inside the nappe between the caps.
    #[inline(always)]
    pub(super) fn chord(&self, x: i32) -> Option<[S; 2]> {
        meet::conic(&Conic {
            from: self.from.map(|part| S::from_wide(part.at(x))),
            step: self.step.map(|part| S::unit(part.at(x))),
        })
    }
}
