//! Half-spaces, seen from an eye.

use crate::geom::{Extent, PerspectiveRays};
use crate::quadric::HalfSpace;
use crate::scalar::Scalar;
use crate::scan::Leaf;
use crate::scan::planes::{PerspectiveRow, PerspectiveView};
use crate::span::{Face, Span};

impl<S: Scalar> Leaf<PerspectiveRays<S>> for HalfSpace<S> {
    type View = Option<PerspectiveView<S>>;
    type Row = Option<PerspectiveRow<S>>;
    type Spans = [Span<S>; 1];

    fn view(&self, rays: &PerspectiveRays<S>) -> Self::View {
        Some(PerspectiveView::new(&self.normal, rays))
    }

    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        *row = view.as_ref().map(|view| PerspectiveRow::new(view, y));
        Extent::all(columns)
    }

    #[inline]
    fn spans(&self, _: &Self::View, row: &Self::Row, x: i32, [span]: &mut [Span<S>; 1]) {
        *span = Span::whole_line(Face(0));
        let is_inside = row.as_ref().is_some_and(|row| self.cut_perspective(row, x, Face(0), span));
        if !is_inside {
            *span = Span::NOWHERE;
        }
    }
}
