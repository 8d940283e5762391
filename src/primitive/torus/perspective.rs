//! The torus, seen from an eye: a pixel's line is asked as any line, where the ball around it can be seen.

use super::Torus;
use crate::geom::{Extent, PerspectiveRays, Rays};
use crate::quadric::ReadyTorus;
use crate::scalar::{Number, Scalar};
use crate::scan::Leaf;
use crate::scan::bounds::{PerspectiveBall, Silhouette};
use crate::span::Span;

impl<S: Scalar> Leaf<PerspectiveRays<S>> for Torus<S> {
    type View = Option<PerspectiveView<S>>;
    type Row = Option<<PerspectiveRays<S> as Rays>::Row>;
    type Spans = [Span<S>; 2];

    fn view(&self, rays: &PerspectiveRays<S>) -> Self::View {
        let center = self.ring.center.wide();
        let reach = self.ring.radius.wide() + self.ring.tube.wide();
        // A line's point and direction are rounded, which is seen as far off as the torus reaches.
        let depth = (center - rays.plane.center).dot(rays.plane.forward).abs() + reach;
        let off = S::ROUNDING.wide() * (S::Wide::ONE + depth);
        let ball = PerspectiveBall::new(center, reach + off, rays);
        Some(PerspectiveView { rays: *rays, torus: self.ready(), ball })
    }

    #[inline]
    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        view.as_ref().is_some_and(|view| view.ball.is_in_rows(rows))
    }

    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        *row = view.as_ref().map(|view| view.rays.row(y));
        view.as_ref().map_or(Extent::EMPTY, |view| view.ball.extent(y, columns))
    }

    fn spans(&self, view: &Self::View, row: &Self::Row, x: i32, spans: &mut [Span<S>; 2]) {
        *spans = super::spans(view.as_ref().map(|view| &view.torus), row.as_ref(), x);
    }
}

/// A torus, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PerspectiveView<S: Scalar> {
    rays: PerspectiveRays<S>,
    torus: ReadyTorus<S>,
    ball: PerspectiveBall<S>,
}
