//! The box, seen from an eye.

use super::Cuboid;
use crate::geom::{Axis, Extent, PerspectiveRays};
use crate::quadric::Corners;
use crate::query::Solid;
use crate::scalar::Scalar;
use crate::scan::Leaf;
use crate::scan::bounds::{Outline, PerspectiveBall, Silhouette};
use crate::scan::planes::{PerspectiveRow, PerspectiveView};
use crate::span::{Face, Span};

impl<S: Scalar> Leaf<PerspectiveRays<S>> for Cuboid<S> {
    type View = Option<([PerspectiveView<S>; 3], Option<PerspectiveBall<S>>)>;
    type Row = Option<[PerspectiveRow<S>; 3]>;
    type Spans = [Span<S>; 1];

    fn view(&self, rays: &PerspectiveRays<S>) -> Self::View {
        let pairs =
            Axis::ALL.map(|axis| PerspectiveView::new(&self.corners.planes(axis).normal, rays));
        Some((pairs, rays.outline(&self.bounds())))
    }

    #[inline]
    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        view.as_ref().is_some_and(|(_, outline)| outline.is_in_rows(rows))
    }

    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        let Some((pairs, outline)) = view else { return Extent::EMPTY };
        *row = Some([&pairs[0], &pairs[1], &pairs[2]].map(|pair| PerspectiveRow::new(pair, y)));
        outline.extent(y, columns)
    }

    #[inline]
    fn spans(&self, _: &Self::View, row: &Self::Row, x: i32, [span]: &mut [Span<S>; 1]) {
        let common = row.as_ref().and_then(|pairs| {
            let mut common = Span::whole_line(Face(0));
            for (pair, axis) in pairs.iter().zip(Axis::ALL) {
                let between = self.corners.planes(axis).perspective_roots(pair, x).span()?;
                common = common.overlap(between.with_faces_from(Corners::<S>::first_face(axis)))?;
            }
            Some(common)
        });
        *span = common.unwrap_or(Span::NOWHERE);
    }
}
