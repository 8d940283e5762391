//! The cone, seen from an eye.

use super::pixel::{PixelView, after};
use super::{Cone, cut};
use crate::geom::{Extent, PerspectiveRays};
use crate::scalar::Scalar;
use crate::scan::bounds::{PerspectiveBall, Silhouette};
use crate::scan::{Leaf, planes};
use crate::span::Span;

impl<S: Scalar> Leaf<PerspectiveRays<S>> for Cone<S> {
    type View = Option<PerspectiveView<S>>;
    type Row = Option<PerspectiveRow<S>>;
    type Spans = [Span<S>; 1];

    fn view(&self, rays: &PerspectiveRays<S>) -> Self::View {
        let (center, radius) = self.bounding_ball();
        let (wall, _) = PixelView::new(self, &rays.plane);
        let [_, right, down] = wall.from;
        Some(PerspectiveView {
            wall,
            turn: [right, down].map(|way| way.map(|part| part * rays.inverse_distance)),
            caps: planes::PerspectiveView::new(&self.caps.normal, rays),
            ball: PerspectiveBall::new(center, radius, rays),
        })
    }

    #[inline]
    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        view.as_ref().is_some_and(|view| view.ball.is_in_rows(rows))
    }

    #[inline(never)]
    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        *row = view.as_ref().map(|PerspectiveView { wall, turn, caps, .. }| PerspectiveRow {
            from: after(&wall.from[0], &wall.from[2], y),
            step: after(&wall.step, &turn[1], y),
            caps: planes::PerspectiveRow::new(caps, y),
        });
        view.as_ref().map_or(Extent::EMPTY, |view| view.ball.extent(y, columns))
    }

    #[inline(always)]
    fn spans(&self, view: &Self::View, row: &Self::Row, x: i32, [span]: &mut [Span<S>; 1]) {
        *span = Span::NOWHERE;
        let (Some(view), Some(row)) = (view, row) else { return };
        if let Some(chord) = view.wall.chord(&row.from, after(&row.step, &view.turn[0], x), x) {
            cut(span, chord, self.caps.perspective_roots(&row.caps, x).ends());
        }
    }
}

/// A cone, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PerspectiveView<S: Scalar> {
    wall: PixelView<S>,
    /// What half a pixel to the right, and down, adds to the wall's `step`.
    turn: [[S::Wide; 3]; 2],
    caps: planes::PerspectiveView<S>,
    ball: PerspectiveBall<S>,
}

/// A row of a cone, seen from an eye: values in its middle.
#[derive(Debug, Clone, Copy)]
pub struct PerspectiveRow<S: Scalar> {
    from: [S::Wide; 3],
    step: [S::Wide; 3],
    caps: planes::PerspectiveRow<S>,
}
