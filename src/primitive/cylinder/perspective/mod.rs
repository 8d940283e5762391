//! The cylinder, seen from an eye.
//!
//! Floating point computes each pixel's chord (`chord.rs`). Fixed point computes inverse depths between the
//! two planes that touch the wall (`tangents.rs`), and chords for eyes that are too near for that (`near.rs`).

mod chord;
mod measure;
mod near;
mod tangents;

use super::Cylinder;
use crate::geom::{Extent, PerspectiveRays};
use crate::scalar::{ByKind, FixedPoint, Float, Formula, Grid, Scalar};
use crate::scan::Leaf;
use crate::span::Span;
use chord::{ChordRow, ChordView};
use tangents::{TangentRow, TangentView};

type View<S> = <S as Scalar>::OfKind<ChordView<S>, TangentView<S>>;
type Row<S> = <S as Scalar>::OfKind<ChordRow<S>, TangentRow<S>>;

impl<S: Scalar> Leaf<PerspectiveRays<S>> for Cylinder<S> {
    type View = Option<View<S>>;
    type Row = Option<Row<S>>;
    type Spans = [Span<S>; 1];

    const CLOSES_LATER: bool = matches!(S::GRID, Grid::Fixed(_));

    fn view(&self, rays: &PerspectiveRays<S>) -> Self::View {
        S::compute(Seen { cylinder: self, rays })
    }

    #[inline]
    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        view.as_ref().is_some_and(|view| S::compute(InRows { view, rows }))
    }

    #[inline(never)]
    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        *row = None;
        let Some(view) = view else { return Extent::EMPTY };
        S::compute(InRow { cylinder: self, view, y, columns, row })
    }

    #[inline(always)]
    fn spans(&self, view: &Self::View, row: &Self::Row, x: i32, [span]: &mut [Span<S>; 1]) {
        *span = Span::NOWHERE;
        if let (Some(view), Some(row)) = (view, row) {
            S::compute(OnRay { cylinder: self, view, row, x, span });
        }
    }

    #[inline(never)]
    fn close(&self, view: &Self::View, row: &Self::Row, x: i32, [span]: &mut [Span<S>; 1]) {
        if let (Some(view), Some(row)) = (view, row) {
            S::compute(Closed { view, row, x, span });
        }
    }
}

/// What the camera decides.
struct Seen<'a, S: Scalar> {
    cylinder: &'a Cylinder<S>,
    rays: &'a PerspectiveRays<S>,
}

impl<S: Scalar> Formula<S> for Seen<'_, S> {
    type Output = Option<View<S>>;

    fn float(self) -> Self::Output
    where
        S: Float,
    {
        View::<S>::of_float(ChordView::new(self.cylinder, self.rays))
    }

    fn fixed(self) -> Self::Output
    where
        S: FixedPoint,
    {
        View::<S>::of_fixed(TangentView::new(self.cylinder, self.rays))
    }
}

/// Whether a row of several can meet the cylinder.
struct InRows<'a, S: Scalar> {
    view: &'a View<S>,
    rows: [i32; 2],
}

impl<S: Scalar> Formula<S> for InRows<'_, S> {
    type Output = bool;

    #[inline(always)]
    fn float(self) -> bool
    where
        S: Float,
    {
        self.view.float().is_some_and(|view| view.is_in_rows(self.rows))
    }

    fn fixed(self) -> bool
    where
        S: FixedPoint,
    {
        self.view.fixed().is_some_and(|view| view.is_in_rows(self.rows))
    }
}

/// What a row decides, and its columns.
struct InRow<'a, S: Scalar> {
    cylinder: &'a Cylinder<S>,
    view: &'a View<S>,
    y: i32,
    columns: u32,
    row: &'a mut Option<Row<S>>,
}

impl<S: Scalar> Formula<S> for InRow<'_, S> {
    type Output = Extent;

    #[inline(always)]
    fn float(self) -> Extent
    where
        S: Float,
    {
        let Some(view) = self.view.float() else { return Extent::EMPTY };
        let row = view.row(self.y);
        *self.row = Row::<S>::of_float(row);
        view.extent(&row, self.cylinder.wall.radius, self.y, self.columns)
    }

    fn fixed(self) -> Extent
    where
        S: FixedPoint,
    {
        let Some(view) = self.view.fixed() else { return Extent::EMPTY };
        let (row, extent) = view.row(self.cylinder, self.y, self.columns);
        *self.row = Row::<S>::of_fixed(row);
        extent
    }
}

/// Sets a ray's span.
struct OnRay<'a, S: Scalar> {
    cylinder: &'a Cylinder<S>,
    view: &'a View<S>,
    row: &'a Row<S>,
    x: i32,
    span: &'a mut Span<S>,
}

impl<S: Scalar> Formula<S> for OnRay<'_, S> {
    type Output = ();

    #[inline(always)]
    fn float(self)
    where
        S: Float,
    {
        if let (Some(view), Some(row)) = (self.view.float(), self.row.float()) {
            row.set_span(self.cylinder, view.eye_within(), self.x, self.span);
        }
    }

    #[inline(always)]
    fn fixed(self)
    where
        S: FixedPoint,
    {
        if let (Some(view), Some(row)) = (self.view.fixed(), self.row.fixed()) {
            row.set_span(self.cylinder, view, self.x, self.span);
        }
    }
}

/// Sets the end of a ray's span.
struct Closed<'a, S: Scalar> {
    view: &'a View<S>,
    row: &'a Row<S>,
    x: i32,
    span: &'a mut Span<S>,
}

impl<S: Scalar> Formula<S> for Closed<'_, S> {
    type Output = ();

    fn float(self)
    where
        S: Float,
    {
    }

    fn fixed(self)
    where
        S: FixedPoint,
    {
        if let (Some(view), Some(row)) = (self.view.fixed(), self.row.fixed()) {
            row.close(view, self.x, self.span);
        }
    }
}
