//! The slab, seen from an eye: height and speed are affine in the column, their quotient is not.

use super::Slab;
use crate::geom::{Affine, Direction, Extent, Pencil, Vec3};
use crate::scalar::{Number, Scalar};
use crate::solid::intersect::Passage;
use crate::solid::leaf::Leaf;
use crate::span::Span;

impl<S: Scalar> Leaf<Pencil<S>> for Slab<S> {
    type View = Option<PencilView<S>>;
    type Row = Option<PencilRow<S>>;

    fn seen_along(&self, rays: &Pencil<S>) -> Self::View {
        Some(PencilView::new(&self.normal, rays))
    }

    fn in_row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        *row = view.as_ref().map(|view| PencilRow::new(view, y));
        Extent::all(columns)
    }

    #[inline]
    fn span(&self, _: &Self::View, row: &Self::Row, x: i32) -> Option<Span<S>> {
        self.pencil_passage(row.as_ref()?, x).span()
    }
}

impl<S: Scalar> Slab<S> {
    #[inline]
    pub(in crate::solid) fn pencil_passage(&self, row: &PencilRow<S>, x: i32) -> Passage<S> {
        self.passage(row.height.at(x), row.speed.at(x))
    }
}

/// A slab, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PencilView<S: Scalar> {
    /// normal·p in the image plane, where the rays have t = 0, and its steps.
    height: [S::Fine; 3],
    /// normal·d in the middle.
    speed: S::Fine,
    pub(in crate::solid) convergence: S::Fine,
}

impl<S: Scalar> PencilView<S> {
    pub(in crate::solid) fn new(normal: &Direction<S>, rays: &Pencil<S>) -> Self {
        Self {
            height: rays.plane.steps(Vec3::ZERO).map(|step| normal.dot_fine(step)),
            speed: normal.dot_fine(rays.plane.forward),
            convergence: rays.convergence,
        }
    }
}

/// A row of a slab, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PencilRow<S: Scalar> {
    height: Affine<S::Fine>,
    speed: Affine<S::Fine>,
}

impl<S: Scalar> PencilRow<S> {
    pub(in crate::solid) fn new(view: &PencilView<S>, y: i32) -> Self {
        let [height, right, down] = view.height;
        let offset = Affine::row([S::Fine::ZERO, right, down], y);
        let turn = offset.times(view.convergence);
        let plus = |middle: S::Fine, offset: Affine<S::Fine>| Affine {
            middle: middle + offset.middle,
            ..offset
        };
        Self { height: plus(height, offset), speed: plus(view.speed, turn) }
    }
}
