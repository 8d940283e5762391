//! Polyhedra along parallel rays.

use super::Polyhedron;
use crate::geom::{Affine, Extent, OrthographicRays};
use crate::quadric::HalfSpace;
use crate::query::Solid;
use crate::scalar::Scalar;
use crate::scan::bounds::{Outline, Rectangle, Silhouette};
use crate::scan::planes::{Crossings, OrthographicFace, OrthographicView};
use crate::scan::{Empty, Leaf};
use crate::span::{Face, Span};

/// A polyhedron, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct PolyhedronView<S: Scalar, const N: usize> {
    faces: [OrthographicView<S>; N],
    outline: Option<Rectangle>,
}

impl<S: Scalar, const N: usize> Empty for PolyhedronView<S, N> {
    const EMPTY: Self = Self { faces: [OrthographicView::EMPTY; N], outline: None };
}

/// A row of a polyhedron, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct PolyhedronRow<S: Scalar, const N: usize> {
    crossings: Crossings<S, N>,
    /// The row, where rays run along some of the faces.
    edge_on: Option<(i32, u32)>,
}

impl<S: Scalar, const N: usize> Empty for PolyhedronRow<S, N> {
    const EMPTY: Self = Self { crossings: Crossings::EMPTY, edge_on: None };
}

impl<S: Scalar, const N: usize, F: AsRef<[HalfSpace<S>]>> Leaf<OrthographicRays<S>>
    for Polyhedron<S, N, F>
{
    type View = PolyhedronView<S, N>;
    type Row = PolyhedronRow<S, N>;
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
        row.crossings.clear();
        row.edge_on = None;
        for ((face, view), index) in self.faces().iter().zip(&view.faces).zip(0..) {
            match face.orthographic_face(view, y, columns) {
                OrthographicFace::Across(middle) => {
                    let at = Affine { middle, step: view.step() };
                    row.crossings.put(at, Face(index), view.exits());
                }
                _ => row.edge_on = Some((y, columns)),
            }
        }
        row.crossings.steps(columns).columns(columns).overlap(view.outline.extent(y, columns))
    }

    #[inline]
    fn spans(&self, view: &Self::View, row: &Self::Row, x: i32, [span]: &mut [Span<S>; 1]) {
        let mut common = row.crossings.between(x);
        if let Some(place) = row.edge_on
            && !self.cut_edge_on(view, place, x, &mut common)
        {
            common = Span::NOWHERE;
        }
        *span = if common.enter.t < common.exit.t { common } else { Span::NOWHERE };
    }
}

impl<S: Scalar, const N: usize, F: AsRef<[HalfSpace<S>]>> Polyhedron<S, N, F> {
    /// Cuts off what is beyond the faces that rays run along, or almost; `false` if all is.
    #[inline(never)]
    fn cut_edge_on(
        &self,
        view: &PolyhedronView<S, N>,
        (y, columns): (i32, u32),
        x: i32,
        span: &mut Span<S>,
    ) -> bool {
        self.faces().iter().zip(&view.faces).zip(0..).all(|((face, view), index)| {
            match face.orthographic_face(view, y, columns) {
                OrthographicFace::Across(_) => true,
                row => face.cut_orthographic(view, &row, x, Face(index), span),
            }
        })
    }
}
