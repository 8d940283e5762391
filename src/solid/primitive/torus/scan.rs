//! The torus in pictures: the pixel's line is asked as any line, where it can be seen.

use super::Torus;
use crate::geom::{Extent, RayRow};
use crate::quadric::meet;
use crate::scalar::Scalar;
use crate::scan::Leaf;
use crate::scan::bounds::{Outline, Silhouette};
use crate::solid::Solid;
use crate::span::Span;

impl<S: Scalar, R: Outline<Scalar = S>> Leaf<R> for Torus<S> {
    type View = Option<(R, R::Silhouette)>;
    type Row = Option<R::Row>;
    type Spans = [Span<S>; 2];

    fn view(&self, rays: &R) -> Self::View {
        Some((*rays, rays.outline(&Solid::bounds(self))))
    }

    #[inline]
    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        view.as_ref().is_some_and(|(_, outline)| outline.is_in_rows(rows))
    }

    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        *row = view.as_ref().map(|(rays, _)| rays.row(y));
        view.as_ref().map_or(Extent::EMPTY, |(_, outline)| outline.extent(y, columns))
    }

    fn spans(&self, _: &Self::View, row: &Self::Row, x: i32, spans: &mut Self::Spans) {
        let found = row.as_ref().map_or([None; 2], |row| meet::torus(&self.ring, &row.line(x)));
        *spans = found.map(|span| span.unwrap_or(Span::NOWHERE));
    }
}
