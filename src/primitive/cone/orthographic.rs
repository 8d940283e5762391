//! The cone along parallel rays.

use super::{Cone, cut, frame, set_common};
use crate::geom::{Extent, OrthographicRays};
use crate::scalar::{Number, Scalar};
use crate::scan::bounds::{Rows, Strip};
use crate::scan::planes::{OrthographicRow as Caps, OrthographicView as CapsView, faces};
use crate::scan::taper::OrthographicView as WallView;
use crate::scan::{Empty, Leaf};
use crate::span::Span;

impl<S: Scalar> Leaf<OrthographicRays<S>> for Cone<S> {
    type View = Option<OrthographicView<S>>;
    type Row = OrthographicRow<S>;
    type Spans = [Span<S>; 1];

    fn view(&self, rays: &OrthographicRays<S>) -> Self::View {
        let Self { taper, caps } = self;
        let (wall, side) = WallView::new(taper, caps, rays, frame(caps.normal.wide())[0]);
        Some(OrthographicView {
            wall,
            along: taper.strip(caps, rays, side.cross(rays.forward)),
            caps: caps.orthographic_view(rays),
            rows: Rows::of(taper.strip(caps, rays, rays.down).rows()),
        })
    }

    #[inline]
    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        view.as_ref().is_some_and(|view| view.rows.meet(rows))
    }

    #[inline(never)]
    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        let Some(OrthographicView { wall, along, caps, .. }) = view else {
            return Extent::EMPTY;
        };
        row.wall = wall.row(y);
        let steps = wall.steps(row.wall, along.size).overlap(along.columns(y));
        if steps.are_beside(columns) {
            return Extent::EMPTY;
        }
        row.caps = self.caps.orthographic_row(caps, y, columns);
        steps.columns(columns)
    }

    #[inline(always)]
    fn spans(&self, view: &Self::View, row: &Self::Row, x: i32, [span]: &mut [Span<S>; 1]) {
        let Some(view) = view else { return };
        let (true, Caps::Across(ends)) = (view.wall.is_crossed_twice(), &row.caps) else {
            return self.set_rare(view, row, x, span);
        };
        match view.wall.chord(&row.wall, x) {
            Some(chord) => {
                set_common(span, chord, ends.at(&view.caps, x), faces(view.caps.high_first()));
            }
            None => *span = Span::NOWHERE,
        }
    }
}

impl<S: Scalar> Cone<S> {
    /// Sets the span of a ray that is steeper than the side, or runs nearly along it or along the caps.
    #[inline(never)]
    fn set_rare(
        &self,
        view: &OrthographicView<S>,
        row: &OrthographicRow<S>,
        x: i32,
        span: &mut Span<S>,
    ) {
        let caps = self.caps.orthographic_span(&view.caps, &row.caps, x);
        *span = Span::NOWHERE;
        if let Some(chord) = view.wall.chord(&row.wall, x) {
            cut(span, chord, caps);
        }
    }
}

/// A cone, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct OrthographicView<S: Scalar> {
    wall: WallView<S>,
    /// At right angles to the wall's sides.
    along: Strip<S>,
    caps: CapsView<S>,
    rows: Rows,
}

/// A row of a cone, seen along parallel rays: the wall's coordinates in its middle.
#[derive(Debug, Clone, Copy)]
pub struct OrthographicRow<S: Scalar> {
    wall: [S::Wide; 3],
    caps: Caps<S>,
}

impl<S: Scalar> Empty for OrthographicRow<S> {
    const EMPTY: Self = Self { wall: [S::Wide::ZERO; 3], caps: Caps::EMPTY };
}
