//! The cone along parallel rays.

use super::pixel::{PixelRow, PixelView};
use super::{Cone, cut};
use crate::geom::{Extent, OrthographicRays};
use crate::scalar::{Number, Scalar};
use crate::scan::bounds::{Outline, Silhouette};
use crate::scan::{Empty, Leaf, planes};
use crate::solid::Solid;
use crate::span::Span;

impl<S: Scalar> Leaf<OrthographicRays<S>> for Cone<S> {
    type View = OrthographicView<S>;
    type Row = Option<OrthographicRow<S>>;
    type Spans = [Span<S>; 1];

    fn view(&self, rays: &OrthographicRays<S>) -> Self::View {
        OrthographicView {
            wall: PixelView::new(self, rays, S::Wide::ZERO),
            caps: self.caps.orthographic_view(rays),
            outline: rays.outline(&self.bounds()),
        }
    }

    #[inline]
    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        view.outline.is_in_rows(rows)
    }

    #[inline(never)]
    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        let caps = self.caps.orthographic_row(&view.caps, y, columns);
        *row = Some(OrthographicRow { wall: view.wall.row(y), caps });
        view.outline.extent(y, columns)
    }

    #[inline(always)]
    fn spans(&self, view: &Self::View, row: &Self::Row, x: i32, [span]: &mut [Span<S>; 1]) {
        *span = Span::NOWHERE;
        let Some(row) = row else { return };
        let Some(chord) = row.wall.chord(x) else { return };
        *span = cut(
            chord,
            match &row.caps {
                planes::OrthographicRow::Across(ends) => ends.span(&view.caps, x),
                planes::OrthographicRow::EdgeOn(caps) => self.caps.edge_on_span(caps, x),
                planes::OrthographicRow::Nowhere => None,
            },
        );
    }
}

/// A cone, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct OrthographicView<S: Scalar> {
    wall: PixelView<S>,
    caps: planes::OrthographicView<S>,
    outline: <OrthographicRays<S> as Outline>::Silhouette,
}

impl<S: Scalar> Empty for OrthographicView<S> {
    const EMPTY: Self =
        Self { wall: PixelView::EMPTY, caps: planes::OrthographicView::EMPTY, outline: None };
}

/// A row of a cone, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct OrthographicRow<S: Scalar> {
    wall: PixelRow<S>,
    caps: planes::OrthographicRow<S>,
}
