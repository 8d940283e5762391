//! The cone, seen from an eye.

use super::pixel::{PixelRow, PixelView};
use super::{Cone, cut};
use crate::geom::{Extent, PerspectiveRays};
use crate::scalar::Scalar;
use crate::scan::bounds::PerspectiveBall;
use crate::scan::{Leaf, planes};
use crate::span::Span;

impl<S: Scalar> Leaf<PerspectiveRays<S>> for Cone<S> {
    type View = Option<PerspectiveView<S>>;
    type Row = Option<PerspectiveRow<S>>;
    type Spans = [Span<S>; 1];

    fn view(&self, rays: &PerspectiveRays<S>) -> Self::View {
        let (center, radius) = self.bounding_ball();
        Some(PerspectiveView {
            wall: PixelView::new(self, &rays.plane, rays.inverse_distance),
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
        *row = None;
        let Some(PerspectiveView { wall, caps, ball }) = view else { return Extent::EMPTY };
        let extent = ball.extent(y, columns);
        if extent != Extent::EMPTY {
            let caps = planes::PerspectiveRow::new(caps, y);
            *row = Some(PerspectiveRow { wall: wall.row(y), caps });
        }
        extent
    }

    #[inline(always)]
    fn spans(&self, _: &Self::View, row: &Self::Row, x: i32, [span]: &mut [Span<S>; 1]) {
        let chord = row.as_ref().and_then(|row| row.wall.chord(x).zip(Some(row)));
        *span = match chord {
            Some((chord, row)) => cut(chord, self.caps.perspective_roots(&row.caps, x).ends()),
            None => Span::NOWHERE,
        };
    }
}

/// A cone, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PerspectiveView<S: Scalar> {
    wall: PixelView<S>,
    caps: planes::PerspectiveView<S>,
    ball: PerspectiveBall<S>,
}

/// A row of a cone, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PerspectiveRow<S: Scalar> {
    wall: PixelRow<S>,
    caps: planes::PerspectiveRow<S>,
}
