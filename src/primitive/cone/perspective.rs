//! The cone, seen from an eye.

use super::{Cone, cut, frame};
use crate::geom::{Extent, PerspectiveRays};
use crate::scalar::Scalar;
use crate::scan::bounds::{PerspectiveBall, Silhouette};
use crate::scan::{Leaf, planes, taper};
use crate::span::Span;

impl<S: Scalar> Leaf<PerspectiveRays<S>> for Cone<S> {
    type View = Option<PerspectiveView<S>>;
    type Row = Option<(taper::PerspectiveRow<S>, planes::PerspectiveRow<S>)>;
    type Spans = [Span<S>; 1];

    fn view(&self, rays: &PerspectiveRays<S>) -> Self::View {
        let Self { taper, caps } = self;
        let (center, radius) = taper.bounding_ball(caps);
        let [beside, _] = frame(caps.normal.wide());
        Some(PerspectiveView {
            wall: taper::PerspectiveView::new(taper, caps, rays, beside),
            caps: planes::PerspectiveView::new(&caps.normal, rays),
            ball: PerspectiveBall::new(center, radius, rays),
        })
    }

    #[inline]
    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        view.as_ref().is_some_and(|view| view.ball.is_in_rows(rows))
    }

    #[inline(never)]
    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        let Some(PerspectiveView { wall, caps, ball }) = view else { return Extent::EMPTY };
        *row = Some((wall.row(y), planes::PerspectiveRow::new(caps, y)));
        ball.extent(y, columns)
    }

    #[inline(always)]
    fn spans(&self, view: &Self::View, row: &Self::Row, x: i32, [span]: &mut [Span<S>; 1]) {
        *span = Span::NOWHERE;
        let (Some(view), Some((wall, caps))) = (view, row) else { return };
        if let Some(chord) = view.wall.chord(wall, x) {
            cut(span, chord, self.caps.perspective_roots(caps, x).ends());
        }
    }
}

/// A cone, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PerspectiveView<S: Scalar> {
    wall: taper::PerspectiveView<S>,
    caps: planes::PerspectiveView<S>,
    ball: PerspectiveBall<S>,
}
