//! Polyhedra along parallel rays.
//!
//! Rays enter at the same faces and exit at the same faces all over the picture. How far an entered face
//! lies before an exited one is affine in the column, which gives the exact silhouette.

use super::Polyhedron;
use crate::geom::{Affine, Extent, OrthographicRays, signed};
use crate::quadric::HalfSpace;
use crate::query::Solid;
use crate::scalar::{Number, Real, Scalar};
use crate::scan::bounds::{Outline, Rectangle, Silhouette, Steps};
use crate::scan::planes::{OrthographicFace, OrthographicView};
use crate::scan::{Empty, Leaf};
use crate::span::{Crossing, Face, Span};

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
    /// Where the faces are crossed: those that rays enter at are the first, those that they exit at the last.
    ends: [End<S>; N],
    entering: u16,
    exiting: u16,
    /// The row, where rays run along some of the faces.
    edge_on: Option<(i32, u32)>,
}

/// Where a face is crossed, in the middle of the row, and what half a column adds to that.
#[derive(Debug, Clone, Copy)]
struct End<S: Scalar> {
    at: Affine<S::Wide>,
    face: Face,
}

impl<S: Scalar, const N: usize> Empty for PolyhedronRow<S, N> {
    const EMPTY: Self = {
        let at = Affine { middle: S::Wide::ZERO, step: S::Wide::ZERO };
        let ends = [End { at, face: Face(0) }; N];
        Self { ends, entering: 0, exiting: 0, edge_on: None }
    };
}

impl<S: Scalar, const N: usize> PolyhedronRow<S, N> {
    /// The faces that rays enter at, and those that they exit at.
    #[inline(always)]
    fn ends(&self) -> [&[End<S>]; 2] {
        let (entering, exiting) = (usize::from(self.entering), usize::from(self.exiting));
        [
            self.ends.get(..entering).unwrap_or_default(),
            self.ends.get(N.saturating_sub(exiting)..).unwrap_or_default(),
        ]
    }

    /// Where rays can be behind every face that they enter at, and before every one that they exit at.
    fn steps(&self, columns: u32) -> Steps {
        let way = |step| S::Wide::ZERO.after_steps(step, signed(columns)).abs();
        let [entering, exiting] = self.ends();
        let mut steps = Steps::ALL;
        for End { at: enter, .. } in entering {
            for End { at: exit, .. } in exiting {
                let apart =
                    Affine { middle: enter.middle - exit.middle, step: enter.step - exit.step };
                let size =
                    enter.middle.abs() + exit.middle.abs() + way(enter.step) + way(exit.step);
                steps = steps.overlap(Steps::below::<S>(apart, size));
            }
        }
        steps
    }
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
        (row.entering, row.exiting, row.edge_on) = (0, 0, None);
        for ((face, view), index) in self.faces().iter().zip(&view.faces).zip(0..) {
            let OrthographicFace::Across(at) = face.orthographic_face(view, y, columns) else {
                row.edge_on = Some((y, columns));
                continue;
            };
            let place = if view.exits() {
                row.exiting += 1;
                N.saturating_sub(row.exiting.into())
            } else {
                row.entering += 1;
                usize::from(row.entering) - 1
            };
            if let Some(end) = row.ends.get_mut(place) {
                *end = End { at: Affine { middle: at, step: view.step() }, face: Face(index) };
            }
        }
        row.steps(columns).columns(columns).overlap(view.outline.extent(y, columns))
    }

    #[inline]
    fn spans(&self, view: &Self::View, row: &Self::Row, x: i32, [span]: &mut [Span<S>; 1]) {
        let [entering, exiting] = row.ends();
        let crossing = |end: &End<S>| Crossing { t: S::from_wide(end.at.at(x)), face: end.face };
        let mut common = Span::whole_line(Face(0));
        for end in entering {
            common.cut(crossing(end), false);
        }
        for end in exiting {
            common.cut(crossing(end), true);
        }
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
