//! A scaled solid along parallel rays: they are parallel in its own frame, too.

use super::Scaled;
use super::walk::{OwnRay, RowOf};
use crate::geom::{OrthographicRays, RaysBack};
use crate::scalar::Scalar;
use crate::scan::bounds::{Outline, Silhouette};
use crate::scan::{ColumnRun, Scan};
use crate::solid::Solid;
use crate::span::Face;
use crate::span::walk::{Path, Step};

/// A scaled solid, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct OrthographicView<S: Scalar> {
    back: RaysBack<S>,
    outline: <OrthographicRays<S> as Outline>::Silhouette,
}

/// In the own frame, the steps to the right and down aren't at right angles. So each row has a camera of its
/// own, which looks along the same rays with its columns at right angles to them: what solids want.
impl<S: Scalar, T> Scan<OrthographicRays<S>> for Scaled<T>
where
    T: Solid<Scalar = S> + Scan<OrthographicRays<S>>,
{
    type View = Option<OrthographicView<S>>;
    type Row = RowOf<T>;

    fn view(&self, rays: &OrthographicRays<S>, view: &mut Self::View) {
        let outline = rays.outline(&self.bounds());
        *view = self.map.rays_back(rays).map(|back| OrthographicView { back, outline });
    }

    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        view.as_ref().is_some_and(|view| view.outline.is_in_rows(rows))
    }

    fn row(&self, view: &Self::View, y: i32, _: u32, row: &mut Self::Row) {
        let seen = view.as_ref().filter(|view| view.outline.is_in_rows([y; 2]));
        row.set(&self.solid, seen.map(|view| view.back.row(y)).as_ref());
    }

    fn enter(row: &mut Self::Row, column: u32) -> ColumnRun {
        row.enter::<S, T>(column)
    }

    #[inline]
    fn contains<P: Path>(&self, view: &Self::View, row: &mut Self::Row, x: i32, t: S) -> bool {
        let Some(view) = view else { return false };
        let ray = OwnRay { x, parameters: view.back.parameters(x) };
        row.from::<P, S, T>(&self.solid, ray, t, Face(0)).is_inside()
    }

    #[inline]
    fn step<P: Path>(
        &self,
        view: &Self::View,
        row: &mut Self::Row,
        x: i32,
        t: S,
        first: Face,
    ) -> Step<S> {
        let Some(view) = view else { return Step::OUTSIDE };
        let ray = OwnRay { x, parameters: view.back.parameters(x) };
        row.from::<P, S, T>(&self.solid, ray, t, first).step()
    }
}
