//! Half-spaces along parallel rays.

use crate::geom::{Extent, OrthographicRays};
use crate::quadric::HalfSpace;
use crate::scalar::Scalar;
use crate::scan::Leaf;
use crate::scan::planes::{OrthographicFace, OrthographicView};
use crate::span::{Face, Span};

impl<S: Scalar> Leaf<OrthographicRays<S>> for HalfSpace<S> {
    type View = OrthographicView<S>;
    type Row = OrthographicFace<S>;
    type Spans = [Span<S>; 1];

    fn view(&self, rays: &OrthographicRays<S>) -> Self::View {
        OrthographicView::new(&self.normal, rays)
    }

    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        *row = self.orthographic_face(view, y, columns);
        Extent::all(columns)
    }

    #[inline]
    fn spans(&self, view: &Self::View, row: &Self::Row, x: i32, [span]: &mut [Span<S>; 1]) {
        *span = Span::whole_line(Face(0));
        if !self.cut_orthographic(view, row, x, Face(0), span) {
            *span = Span::NOWHERE;
        }
    }
}
