//! The torus along parallel rays: a pixel's line is asked as any line, where the torus can be seen.

use super::Torus;
use crate::geom::{Affine, Extent, OrthographicRays, Rays, Vec3};
use crate::quadric::ReadyTorus;
use crate::scalar::{Number, Real, Scalar};
use crate::scan::Leaf;
use crate::scan::bounds::{Rows, Steps};
use crate::span::Span;

impl<S: Scalar> Leaf<OrthographicRays<S>> for Torus<S> {
    type View = Option<OrthographicView<S>>;
    type Row = Option<<OrthographicRays<S> as Rays>::Row>;
    type Spans = [Span<S>; 2];

    fn view(&self, rays: &OrthographicRays<S>) -> Self::View {
        let center = self.ring.center.wide() - rays.center;
        let [ring, tube] = [self.ring.radius.wide(), self.ring.tube.wide()];
        let reach = ring + tube;
        // A line's point and direction are rounded, which is seen as far off as the torus reaches.
        let off = S::ROUNDING.wide() * (S::Wide::ONE + center.dot(rays.forward).abs() + reach);
        let size = center.max_abs() + reach;
        // Three coordinates, each of which is as large as that.
        let size = size + size + size;
        let from_middle = Affine { middle: S::Wide::ZERO, step: rays.half_pixel };
        let steps = |direction: Vec3<S::Wide>| {
            let at = center.dot_compensated(direction);
            // As far as the ring reaches, and the tube around it.
            let across = direction.cross(self.ring.axis.wide());
            let half = ring * across.length_squared().sqrt() + tube + off;
            Steps::between::<S>(from_middle, at - half, at + half, size)
        };
        Some(OrthographicView {
            rays: *rays,
            torus: self.ready(),
            rows: Rows::of(steps(rays.down)),
            columns: steps(rays.right),
            right: center.dot_compensated(rays.right),
            down: center.dot_compensated(rays.down),
            reach: S::from_wide(reach + off + S::uncertainty(size)),
        })
    }

    #[inline]
    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        view.as_ref().is_some_and(|view| view.rows.meet(rows))
    }

    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        *row = view.as_ref().map(|view| view.rays.row(y));
        let Some(view) = view else { return Extent::EMPTY };
        // The row cuts a chord out of the ball around the torus.
        let across = S::from_wide((-view.down).after_steps(view.rays.half_pixel, y));
        let Some(half) = S::leg(view.reach, across) else { return Extent::EMPTY };
        let along = Affine { middle: -view.right, step: view.rays.half_pixel };
        Steps::within::<S>(along, half.wide()).overlap(view.columns).columns(columns)
    }

    fn spans(&self, view: &Self::View, row: &Self::Row, x: i32, spans: &mut [Span<S>; 2]) {
        *spans = super::spans(view.as_ref().map(|view| &view.torus), row.as_ref(), x);
    }
}

/// A torus, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct OrthographicView<S: Scalar> {
    rays: OrthographicRays<S>,
    torus: ReadyTorus<S>,
    /// Where it can be seen.
    rows: Rows,
    columns: Steps,
    /// Its centre, seen from the middle of the picture.
    right: S::Wide,
    down: S::Wide,
    /// The radius of the ball around it.
    reach: S,
}
