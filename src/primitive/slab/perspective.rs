//! The slab, seen from an eye.

use super::Slab;
use crate::geom::{Extent, PerspectiveRays};
use crate::scalar::Scalar;
use crate::scan::Leaf;
use crate::scan::planes::{PerspectiveRow, PerspectiveView};
use crate::span::Span;

impl<S: Scalar> Leaf<PerspectiveRays<S>> for Slab<S> {
    type View = Option<PerspectiveView<S>>;
    type Row = Option<PerspectiveRow<S>>;
    type Spans = [Span<S>; 1];

    fn view(&self, rays: &PerspectiveRays<S>) -> Self::View {
        Some(PerspectiveView::new(&self.planes.normal, rays))
    }

    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        *row = view.as_ref().map(|view| PerspectiveRow::new(view, y));
        Extent::all(columns)
    }

    #[inline]
    fn spans(&self, _: &Self::View, row: &Self::Row, x: i32, [span]: &mut [Span<S>; 1]) {
        let crossed = row.as_ref().and_then(|row| self.planes.perspective_roots(row, x).span());
        *span = crossed.unwrap_or(Span::NOWHERE);
    }
}
