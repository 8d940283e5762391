//! Polyhedra along parallel rays.

use super::Polyhedron;
use crate::geom::{Affine, Extent, OrthographicRays};
use crate::quadric::HalfSpace;
use crate::query::Solid;
use crate::scalar::Scalar;
use crate::scan::bounds::{Outline, Rectangle, Silhouette, Steps};
use crate::scan::planes::{Crossed, End, OrthographicFace, OrthographicView};
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
    ends: [End<S>; N],
    faces: FacesRow,
}

impl<S: Scalar, const N: usize> Empty for PolyhedronRow<S, N> {
    const EMPTY: Self = Self { ends: [End::EMPTY; N], faces: FacesRow::EMPTY };
}

/// What there is of a row beside its crossings, wherever these are.
#[derive(Debug, Clone, Copy)]
pub struct FacesRow {
    crossed: Crossed,
    /// The row, where rays run along some of the faces.
    edge_on: Option<(i32, u32)>,
}

impl Empty for FacesRow {
    const EMPTY: Self = Self { crossed: Crossed::NONE, edge_on: None };
}

impl FacesRow {
    /// Sets another row, and returns where rays can be between the faces.
    #[inline(always)]
    pub(super) fn set<'f, S: Scalar>(
        &mut self,
        faces: impl Iterator<Item = (&'f HalfSpace<S>, OrthographicView<S>)>,
        ends: &mut [End<S>],
        (y, columns): (i32, u32),
    ) -> Steps {
        *self = Self::EMPTY;
        for ((face, view), index) in faces.zip(0..) {
            match face.orthographic_face(&view, y, columns) {
                OrthographicFace::Across(middle) => {
                    let at = Affine { middle, step: view.step() };
                    self.crossed.put(ends, at, Face(index), view.exits());
                }
                _ => self.edge_on = Some((y, columns)),
            }
        }
        self.crossed.steps(ends, columns)
    }

    /// The span of a ray.
    #[inline(always)]
    pub(super) fn span<'f, S: Scalar>(
        &self,
        faces: impl Iterator<Item = (&'f HalfSpace<S>, OrthographicView<S>)>,
        ends: &[End<S>],
        x: i32,
    ) -> Span<S> {
        let mut common = self.crossed.between(ends, x);
        if let Some(place) = self.edge_on
            && !cut_edge_on(faces, place, x, &mut common)
        {
            return Span::NOWHERE;
        }
        if common.enter.t < common.exit.t { common } else { Span::NOWHERE }
    }
}

/// Cuts off what is beyond the faces that rays run along, or almost; `false` if all is.
#[inline(never)]
fn cut_edge_on<'f, S: Scalar>(
    faces: impl Iterator<Item = (&'f HalfSpace<S>, OrthographicView<S>)>,
    (y, columns): (i32, u32),
    x: i32,
    span: &mut Span<S>,
) -> bool {
    faces.zip(0..).all(|((face, view), index)| match face.orthographic_face(&view, y, columns) {
        OrthographicFace::Across(_) => true,
        row => face.cut_orthographic(&view, &row, x, Face(index), span),
    })
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
        let faces = self.faces().iter().zip(view.faces);
        let steps = row.faces.set(faces, &mut row.ends, (y, columns));
        steps.columns(columns).overlap(view.outline.extent(y, columns))
    }

    #[inline]
    fn spans(&self, view: &Self::View, row: &Self::Row, x: i32, [span]: &mut [Span<S>; 1]) {
        let faces = self.faces().iter().zip(view.faces.iter().copied());
        *span = row.faces.span(faces, &row.ends, x);
    }
}
