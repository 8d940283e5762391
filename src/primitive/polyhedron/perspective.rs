//! Polyhedra, seen from an eye.

use super::Polyhedron;
use crate::geom::{Extent, PerspectiveRays};
use crate::quadric::HalfSpace;
use crate::query::Solid;
use crate::scalar::Scalar;
use crate::scan::Leaf;
use crate::scan::bounds::{Outline, PerspectiveBall, Silhouette};
use crate::scan::planes::{PerspectiveRow, PerspectiveView};
use crate::span::{Face, Span};

impl<S: Scalar, const N: usize, F: AsRef<[HalfSpace<S>]>> Leaf<PerspectiveRays<S>>
    for Polyhedron<S, N, F>
{
    type View = ([Option<PerspectiveView<S>>; N], Option<PerspectiveBall<S>>);
    type Row = [Option<PerspectiveRow<S>>; N];
    type Spans = [Span<S>; 1];

    fn view(&self, rays: &PerspectiveRays<S>) -> Self::View {
        let mut views = [None; N];
        for (view, face) in views.iter_mut().zip(self.faces()) {
            *view = Some(PerspectiveView::new(&face.normal, rays));
        }
        (views, rays.outline(&self.bounds()))
    }

    #[inline]
    fn is_in_rows(&self, (_, outline): &Self::View, rows: [i32; 2]) -> bool {
        outline.is_in_rows(rows)
    }

    fn row(
        &self,
        (views, outline): &Self::View,
        y: i32,
        columns: u32,
        row: &mut Self::Row,
    ) -> Extent {
        for (row, view) in row.iter_mut().zip(views) {
            *row = view.as_ref().map(|view| PerspectiveRow::new(view, y));
        }
        outline.extent(y, columns)
    }

    #[inline]
    fn spans(&self, _: &Self::View, row: &Self::Row, x: i32, [span]: &mut [Span<S>; 1]) {
        let rows = row.iter().map_while(Option::as_ref);
        *span = common(self.faces().iter().zip(rows.copied()), x);
    }
}

/// What rays have in common with the half-spaces behind all faces.
#[inline(always)]
pub(super) fn common<'f, S: Scalar>(
    faces: impl Iterator<Item = (&'f HalfSpace<S>, PerspectiveRow<S>)>,
    x: i32,
) -> Span<S> {
    let mut span = Span::whole_line(Face(0));
    for ((face, row), index) in faces.zip(0..) {
        if !face.cut_perspective(&row, x, Face(index), &mut span) {
            return Span::NOWHERE;
        }
    }
    if span.enter.t >= span.exit.t { Span::NOWHERE } else { span }
}
