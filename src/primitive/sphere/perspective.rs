//! The sphere, seen from an eye.

use super::{Sphere, span};
use crate::geom::{Affine, Extent, PerspectiveRays};
use crate::scalar::{Roots, Scalar};
use crate::scan::Leaf;
use crate::scan::bounds::{PerspectiveBall, Silhouette};
use crate::span::Span;

impl<S: Scalar> Leaf<PerspectiveRays<S>> for Sphere<S> {
    type View = Option<PerspectiveBall<S>>;
    type Row = Option<PerspectiveRow<S>>;
    type Spans = [Span<S>; 1];

    fn view(&self, rays: &PerspectiveRays<S>) -> Self::View {
        Some(PerspectiveBall::new(self.ball.center.wide(), self.ball.radius.wide(), rays))
    }

    #[inline]
    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        view.as_ref().is_some_and(|ball| ball.is_in_rows(rows))
    }

    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        *row = None;
        let Some(view) = view else { return Extent::EMPTY };
        *row = Some(PerspectiveRow {
            moment: view.moment(y),
            from_center: view.position(y),
            direction: view.direction(y),
        });
        view.extent(y, columns)
    }

    #[inline]
    fn spans(&self, _: &Self::View, row: &Self::Row, x: i32, [kept]: &mut [Span<S>; 1]) {
        *kept = Span::NOWHERE;
        let Some(row) = row else { return };
        let direction = row.direction.map(|part| S::unit(part.at(x)));
        let (k, q) = (
            row.moment.map(|part| part.at(x)),
            row.from_center.map(|part| S::from_wide(part.at(x))),
        );
        if let Some(Roots::Between(enter, exit)) = S::chord(self.ball.radius, k, q, direction)
            && let Some(span) = span(enter, exit)
        {
            *kept = span;
        }
    }
}

/// A row of a sphere, seen from an eye: in the camera's frame.
#[derive(Debug, Clone, Copy)]
pub struct PerspectiveRow<S: Scalar> {
    /// c × d, p − c and d.
    moment: [Affine<S::Wide>; 3],
    from_center: [Affine<S::Wide>; 3],
    direction: [Affine<S::Wide>; 3],
}
