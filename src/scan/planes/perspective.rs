//! Planes, seen from an eye: height and speed are affine in the column, their quotient is not.

use super::FaceView;
use crate::geom::{Affine, Direction, PerspectiveRays, Vec3};
use crate::quadric::{HalfSpace, PlaneRoots, Planes};
use crate::scalar::{Number, Scalar};
use crate::span::{Face, Span};

impl<S: Scalar> Planes<S> {
    /// Where a ray crosses the planes.
    #[inline]
    pub(crate) fn perspective_roots(&self, row: &PerspectiveRow<S>, x: i32) -> PlaneRoots<S> {
        self.crossed(row.height.at(x), row.speed.at(x))
    }
}

impl<S: Scalar> HalfSpace<S> {
    /// Cuts off the part of a ray that is outside; `false` if all of it is.
    #[inline]
    pub(crate) fn cut_perspective(
        &self,
        row: &PerspectiveRow<S>,
        x: i32,
        face: Face,
        span: &mut Span<S>,
    ) -> bool {
        self.cut(row.height.at(x), row.speed.at(x), face, span)
    }
}

/// Planes, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PerspectiveView<S: Scalar> {
    /// normal·p in the image plane, where the rays have t = 0, and its steps.
    height: [S::Wide; 3],
    /// normal·d in the middle.
    speed: S::Wide,
    pub(crate) inverse_distance: S::Wide,
}

impl<S: Scalar> PerspectiveView<S> {
    pub(crate) fn new(normal: &Direction<S>, rays: &PerspectiveRays<S>) -> Self {
        Self {
            height: rays.plane.steps(Vec3::ZERO).map(|step| normal.dot_wide(step)),
            speed: normal.dot_wide(rays.plane.forward),
            inverse_distance: rays.inverse_distance,
        }
    }

    /// As a pool keeps it: all but the eye's distance, which all faces of a solid share.
    pub(crate) fn keep(&self) -> FaceView<S> {
        let [middle, right, down] = self.height;
        FaceView([middle, right, down, self.speed])
    }

    /// One that a pool has kept.
    pub(crate) fn kept(
        &FaceView([middle, right, down, speed]): &FaceView<S>,
        inverse_distance: S::Wide,
    ) -> Self {
        Self { height: [middle, right, down], speed, inverse_distance }
    }

    /// normal·d in the middle of the picture.
    pub(crate) fn speed(&self) -> S::Wide {
        self.speed
    }

    /// normal·p at the eye, at this distance from the image plane.
    pub(crate) fn at_eye(&self, distance: S::Wide) -> S::Wide {
        let [middle, ..] = self.height;
        middle - distance * self.speed
    }
}

/// A row of planes, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PerspectiveRow<S: Scalar> {
    height: Affine<S::Wide>,
    speed: Affine<S::Wide>,
}

impl<S: Scalar> PerspectiveRow<S> {
    pub(crate) fn new(view: &PerspectiveView<S>, y: i32) -> Self {
        let [height, right, down] = view.height;
        let offset = Affine::row([S::Wide::ZERO, right, down], y);
        let turn = offset.times(view.inverse_distance);
        Self { height: offset.above(height), speed: turn.above(view.speed) }
    }

    /// One of these [lines](Self::lines).
    #[inline(always)]
    pub(crate) fn of([height, speed]: [Affine<S::Wide>; 2]) -> Self {
        Self { height, speed }
    }

    /// normal·p where the rays have t = 0, and normal·d.
    pub(crate) fn lines(&self) -> [Affine<S::Wide>; 2] {
        [self.height, self.speed]
    }
}
