//! Half-spaces and polyhedra along parallel rays.
//!
//! Rays enter at the same faces and exit at the same faces all over the picture. How far an entered face
//! lies before an exited one is affine in the column, which gives the exact silhouette.

use super::Polyhedron;
use crate::geom::{Extent, OrthographicRays};
use crate::quadric::HalfSpace;
use crate::scalar::Scalar;
use crate::scan::bounds::{Outline, Rectangle, Silhouette};
use crate::scan::planes::{OrthographicFace, OrthographicView, common_steps};
use crate::scan::{Empty, Leaf};
use crate::solid::Solid;
use crate::span::{Face, Span};

impl<S: Scalar> Leaf<OrthographicRays<S>> for HalfSpace<S> {
    type View = OrthographicView<S>;
    type Row = OrthographicFace<S>;
    type Spans = [Span<S>; 1];

    fn view(&self, rays: &OrthographicRays<S>) -> OrthographicView<S> {
        OrthographicView::new(&self.normal, rays)
    }

    fn row(
        &self,
        view: &OrthographicView<S>,
        y: i32,
        columns: u32,
        row: &mut OrthographicFace<S>,
    ) -> Extent {
        *row = self.orthographic_face(view, y, columns);
        Extent::all(columns)
    }

    #[inline]
    fn spans(
        &self,
        view: &OrthographicView<S>,
        row: &OrthographicFace<S>,
        x: i32,
        [span]: &mut [Span<S>; 1],
    ) {
        *span = Span::whole_line(Face(0));
        if !self.cut_orthographic(view, row, x, Face(0), span) {
            *span = Span::NOWHERE;
        }
    }
}

/// A polyhedron, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct PolyhedronView<S: Scalar, const N: usize> {
    faces: [OrthographicView<S>; N],
    outline: Option<Rectangle>,
}

impl<S: Scalar, const N: usize> Empty for PolyhedronView<S, N> {
    const EMPTY: Self = Self { faces: [OrthographicView::EMPTY; N], outline: None };
}

impl<S: Scalar, const N: usize, F: AsRef<[HalfSpace<S>]>> Leaf<OrthographicRays<S>>
    for Polyhedron<S, N, F>
{
    type View = PolyhedronView<S, N>;
    type Row = [OrthographicFace<S>; N];
    type Spans = [Span<S>; 1];

    fn view(&self, rays: &OrthographicRays<S>) -> Self::View {
        let mut view =
            PolyhedronView { outline: rays.outline(&self.bounds()), ..Self::View::EMPTY };
        for (view, face) in view.faces.iter_mut().zip(self.faces()) {
            *view = OrthographicView::new(&face.normal, rays);
        }
        view
    }

    #[inline]
    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        view.outline.is_in_rows(rows)
    }

    #[inline(never)]
    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        for ((row, view), face) in row.iter_mut().zip(&view.faces).zip(self.faces()) {
            *row = face.orthographic_face(view, y, columns);
        }
        let ends = || row.iter().zip(&view.faces).take(self.faces().len());
        common_steps(ends, columns).columns(columns).overlap(view.outline.extent(y, columns))
    }

    #[inline]
    fn spans(&self, view: &Self::View, row: &Self::Row, x: i32, [span]: &mut [Span<S>; 1]) {
        *span = Span::whole_line(Face(0));
        for (((face, row), view), index) in self.faces().iter().zip(row).zip(&view.faces).zip(0..) {
            if !face.cut_orthographic(view, row, x, Face(index), span) {
                *span = Span::NOWHERE;
                return;
            }
        }
        if span.enter.t >= span.exit.t {
            *span = Span::NOWHERE;
        }
    }
}
