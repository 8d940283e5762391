//! A scaled solid, seen from an eye.

use super::Scaled;
use super::walk::{OwnRay, RowOf};
use crate::geom::{Extent, OrthographicRays, Parameters, PerspectiveRays, Vec3};
use crate::scalar::{Number, Real, Scalar};
use crate::scan::bounds::{Outline, Silhouette};
use crate::scan::{ColumnRun, Empty, Scan};
use crate::solid::Solid;
use crate::span::walk::{Path, Step};
use crate::span::{Face, Shape};

/// A scaled solid, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PerspectiveView<S: Scalar> {
    rays: PerspectiveRays<S>,
    outline: <PerspectiveRays<S> as Outline>::Silhouette,
}

/// A row of a scaled solid, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PerspectiveRow<S: Scalar, D> {
    y: i32,
    extent: [u32; 2],
    /// The pixel that was asked for last, and its ray in the own frame, if that meets the solid.
    x: i32,
    parameters: Option<Parameters<S>>,
    own: D,
}

impl<S: Scalar, D: Empty> Empty for PerspectiveRow<S, D> {
    const EMPTY: Self = Self { y: 0, extent: [0; 2], x: 0, parameters: None, own: D::EMPTY };
}

/// Farther away than any ray of a picture.
const NO_RAY: i32 = i32::MIN;

/// In the own frame, the pencil of rays isn't that of a camera. So each pixel has a camera of its own, which
/// looks along its ray.
impl<S: Scalar, T> Scan<PerspectiveRays<S>> for Scaled<T>
where
    T: Solid<Scalar = S> + Scan<OrthographicRays<S>>,
{
    type View = Option<PerspectiveView<S>>;
    type Row = PerspectiveRow<S, RowOf<T>>;

    fn view(&self, rays: &PerspectiveRays<S>, view: &mut Self::View) {
        *view = Some(PerspectiveView { rays: *rays, outline: rays.outline(&self.bounds()) });
    }

    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        view.as_ref().is_some_and(|view| view.outline.is_in_rows(rows))
    }

    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) {
        let seen = view.as_ref().filter(|view| view.outline.is_in_rows([y; 2]));
        let extent = seen.map_or(Extent::EMPTY, |view| view.outline.extent(y, columns));
        (row.y, row.extent, row.x) = (y, [extent.start, extent.end], NO_RAY);
    }

    fn enter(row: &mut Self::Row, column: u32) -> ColumnRun {
        let [start, end] = row.extent;
        ColumnRun::of(Extent { start, end }, column)
    }

    fn contains<P: Path>(&self, view: &Self::View, row: &mut Self::Row, x: i32, t: S) -> bool {
        let Some(ray) = self.look(view, row, x) else { return false };
        row.own.from::<P, S, T>(&self.solid, ray, t, Face(0)).is_inside()
    }

    fn step<P: Path>(
        &self,
        view: &Self::View,
        row: &mut Self::Row,
        x: i32,
        t: S,
        first: Face,
    ) -> Step<S> {
        let Some(ray) = self.look(view, row, x) else { return Step::OUTSIDE };
        row.own.from::<P, S, T>(&self.solid, ray, t, first).step()
    }
}

impl<T: Shape> Scaled<T> {
    /// Looks along the ray of a pixel, if it isn't done yet.
    #[inline(never)]
    fn look<S: Scalar>(
        &self,
        view: &Option<PerspectiveView<S>>,
        row: &mut PerspectiveRow<S, RowOf<T>>,
        x: i32,
    ) -> Option<OwnRay<S>>
    where
        T: Scan<OrthographicRays<S>, Scalar = S>,
    {
        if row.x != x {
            let PerspectiveRays { plane, inverse_distance, .. } = view.as_ref()?.rays;
            let [center, right, down] = plane.steps(Vec3::ZERO);
            let zero = S::Wide::ZERO;
            let offset = right.map(|step| zero.after_steps(step, x))
                + down.map(|step| zero.after_steps(step, row.y));
            let forward = plane.forward + offset * inverse_distance;
            let rays = OrthographicRays { center: center + offset, forward, columns: 1, ..plane };
            row.x = x;
            row.parameters = self.map.rays_back(&rays).and_then(|back| {
                row.own.set(&self.solid, Some(&back.row(0)));
                row.own.enter::<S, T>(0).is_visible.then(|| back.parameters(0))
            });
        }
        Some(OwnRay { x: 0, parameters: row.parameters? })
    }
}
