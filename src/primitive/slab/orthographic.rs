//! The slab along parallel rays.

use super::Slab;
use crate::geom::{Extent, OrthographicRays};
use crate::scalar::Scalar;
use crate::scan::Leaf;
use crate::scan::planes::{OrthographicRow, OrthographicView};
use crate::span::Span;

impl<S: Scalar> Leaf<OrthographicRays<S>> for Slab<S> {
    type View = OrthographicView<S>;
    type Row = OrthographicRow<S>;
    type Spans = [Span<S>; 1];

    fn view(&self, rays: &OrthographicRays<S>) -> Self::View {
        self.planes.orthographic_view(rays)
    }

    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        *row = self.planes.orthographic_row(view, y, columns);
        match row {
            OrthographicRow::EdgeOn(row) => self.planes.edge_on_steps(row).columns(columns),
            _ => Extent::all(columns),
        }
    }

    #[inline]
    fn spans(&self, view: &Self::View, row: &Self::Row, x: i32, [span]: &mut [Span<S>; 1]) {
        *span = self.planes.orthographic_span(view, row, x).unwrap_or(Span::NOWHERE);
    }
}
