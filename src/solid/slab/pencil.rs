//! The slab, seen from an eye: height and speed are affine in the column, their quotient is not.

use super::Slab;
use crate::geom::{Affine, Direction, Extent, PerspectiveRays, Vec3};
use crate::scalar::{Number, Scalar};
use crate::solid::intersect::Passage;
use crate::solid::leaf::Leaf;
use crate::span::Span;

impl<S: Scalar> Leaf<PerspectiveRays<S>> for Slab<S> {
    type View = Option<PerspectiveView<S>>;
    type Row = Option<PerspectiveRow<S>>;

    fn seen_along(&self, rays: &PerspectiveRays<S>) -> Self::View {
        Some(PerspectiveView::new(&self.normal, rays))
    }

    fn in_row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        *row = view.as_ref().map(|view| PerspectiveRow::new(view, y));
        Extent::all(columns)
    }

    #[inline]
    fn span(&self, _: &Self::View, row: &Self::Row, x: i32) -> Option<Span<S>> {
        self.perspective_passage(row.as_ref()?, x).span()
    }
}

impl<S: Scalar> Slab<S> {
    #[inline]
    pub(in crate::solid) fn perspective_passage(
        &self,
        row: &PerspectiveRow<S>,
        x: i32,
    ) -> Passage<S> {
        self.passage(row.height.at(x), row.speed.at(x))
    }
}

/// A slab, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PerspectiveView<S: Scalar> {
    /// normal·p in the image plane, where the rays have t = 0, and its steps.
    height: [S::Wide; 3],
    /// normal·d in the middle.
    speed: S::Wide,
    pub(in crate::solid) inverse_distance: S::Wide,
}

impl<S: Scalar> PerspectiveView<S> {
    pub(in crate::solid) fn new(normal: &Direction<S>, rays: &PerspectiveRays<S>) -> Self {
        Self {
            height: rays.plane.steps(Vec3::ZERO).map(|step| normal.dot_wide(step)),
            speed: normal.dot_wide(rays.plane.forward),
            inverse_distance: rays.inverse_distance,
        }
    }
}

/// A row of a slab, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PerspectiveRow<S: Scalar> {
    height: Affine<S::Wide>,
    speed: Affine<S::Wide>,
}

impl<S: Scalar> PerspectiveRow<S> {
    pub(in crate::solid) fn new(view: &PerspectiveView<S>, y: i32) -> Self {
        let [height, right, down] = view.height;
        let offset = Affine::row([S::Wide::ZERO, right, down], y);
        let turn = offset.times(view.inverse_distance);
        let plus = |middle: S::Wide, offset: Affine<S::Wide>| Affine {
            middle: middle + offset.middle,
            ..offset
        };
        Self { height: plus(height, offset), speed: plus(view.speed, turn) }
    }
}
