//! Convex polyhedra whose faces lie in a pool.

use super::Polyhedron;
use super::orthographic::FacesRow;
use super::perspective::common;
use crate::geom::{Line, OrthographicRays, PerspectiveRays, Vec3};
use crate::quadric::HalfSpace;
use crate::query::Solid;
use crate::scalar::{Number, Scalar};
use crate::scan::bounds::{Bounds, Outline, PerspectiveBall, Rectangle, Silhouette};
use crate::scan::planes::{FaceView, OrthographicView, PerspectiveView, PoolRow};
use crate::scan::{ColumnRun, Empty, Kept as _, LeafRow, Scan};
use crate::span::walk::{Path, Step};
use crate::span::{Face, Shape, Span, SpanStack};

/// A convex polyhedron of up to `N` faces that lie in the pool of a [`Program`](crate::program::Program). Name it
/// in [`leaves!`](crate::leaves) where few of many parts have many faces: it takes no more room there than a
/// box, and each face takes some only where there is one.
///
/// It knows no more than a box around it. [`Program::push_polyhedron`](crate::program::Program::push_polyhedron)
/// has an example. Anywhere but as a part of a program, it is empty.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Pooled<S: Scalar, const N: usize> {
    pub(crate) low: Vec3<S>,
    pub(crate) high: Vec3<S>,
}

impl<S: Scalar, const N: usize> Pooled<S, N> {
    /// What a program's leaf knows of a polyhedron.
    #[must_use]
    pub const fn of<const M: usize, F>(polyhedron: &Polyhedron<S, M, F>) -> Self {
        Self { low: polyhedron.low, high: polyhedron.high }
    }
}

impl<S: Scalar, const N: usize> Shape for Pooled<S, N> {
    type Scalar = S;
    const SPANS: usize = 1;
    const FACES: u16 = N as u16;
}

impl<S: Scalar, const N: usize> Solid for Pooled<S, N> {
    fn spans(&self, _: &Line<S>, _: Face, _: &mut SpanStack<'_, S>) {}

    fn bounds(&self) -> Bounds<S> {
        Bounds::Box { low: self.low, high: self.high }
    }

    fn normal(&self, _: Face, _: Vec3<S>) -> Vec3<S> {
        Vec3::ZERO
    }

    #[inline]
    fn pooled(&self) -> Option<[Vec3<S>; 2]> {
        Some([self.low, self.high])
    }
}

/// Where a pool has the faces, and what a camera decides of them all: `O`.
#[derive(Debug, Clone, Copy)]
pub struct PooledView<O> {
    range: [u16; 2],
    of_all: O,
}

impl<O> PooledView<O> {
    fn has_faces(&self) -> bool {
        let [start, end] = self.range;
        start < end
    }
}

impl<O: Empty> Empty for PooledView<O> {
    const EMPTY: Self = Self { range: [0; 2], of_all: O::EMPTY };
}

/// What an eye decides: the outline, and one over its distance.
#[derive(Debug, Clone, Copy)]
pub struct FromEye<S: Scalar> {
    outline: Option<PerspectiveBall<S>>,
    inverse_distance: S::Wide,
}

impl<S: Scalar> Empty for FromEye<S> {
    const EMPTY: Self = Self { outline: None, inverse_distance: S::Wide::ZERO };
}

/// A row that is seen from an eye has nothing beside its faces.
#[derive(Debug, Clone, Copy)]
pub struct NoMore;

impl Empty for NoMore {
    const EMPTY: Self = Self;
}

/// What is the same along all rays: the row is set by [`Scan::row_faces`] already, and spans are kept by
/// [`Scan::ray_faces`].
macro_rules! kept {
    () => {
        fn row(&self, _: &Self::View, _: i32, _: u32, _: &mut Self::Row) {}

        #[inline]
        fn enter(row: &mut Self::Row, column: u32) -> ColumnRun {
            row.enter(column)
        }

        #[inline(always)]
        fn contains<P: Path>(&self, _: &Self::View, row: &mut Self::Row, _: i32, t: S) -> bool {
            row.kept().contain(t)
        }

        #[inline(always)]
        fn step<P: Path>(
            &self,
            _: &Self::View,
            row: &mut Self::Row,
            _: i32,
            t: S,
            first: Face,
        ) -> Step<S> {
            row.kept().behind(t, first)
        }
    };
}

impl<S: Scalar, const N: usize> Scan<OrthographicRays<S>> for Pooled<S, N> {
    type View = PooledView<Option<Rectangle>>;
    type Row = LeafRow<FacesRow, [Span<S>; 1]>;

    kept!();

    fn view(&self, rays: &OrthographicRays<S>, view: &mut Self::View) {
        *view = PooledView { of_all: rays.outline(&self.bounds()), ..PooledView::EMPTY };
    }

    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        view.has_faces() && view.of_all.is_in_rows(rows)
    }

    fn view_faces(
        &self,
        rays: &OrthographicRays<S>,
        faces: &[HalfSpace<S>],
        views: &mut [FaceView<S>],
        range: [u16; 2],
        view: &mut Self::View,
    ) {
        view.range = range;
        for (view, face) in views.iter_mut().zip(faces) {
            *view = OrthographicView::new(&face.normal, rays).keep();
        }
    }

    #[inline(never)]
    fn row_faces(
        &self,
        view: &Self::View,
        pool: PoolRow<'_, S>,
        y: i32,
        columns: u32,
        row: &mut Self::Row,
    ) {
        row.set_by(Scan::<OrthographicRays<S>>::is_in_rows(self, view, [y; 2]), |row| {
            let pool = pool.of(view.range);
            let steps = row.set(pool.orthographic(), pool.ends, (y, columns));
            steps.columns(columns).overlap(view.of_all.extent(y, columns))
        });
    }

    #[inline(always)]
    fn ray_faces(&self, view: &Self::View, pool: PoolRow<'_, S>, x: i32, row: &mut Self::Row) {
        row.keep(x, |row| {
            let pool = pool.of(view.range);
            [row.span(pool.orthographic(), pool.ends, x)]
        });
    }
}

impl<S: Scalar, const N: usize> Scan<PerspectiveRays<S>> for Pooled<S, N> {
    type View = PooledView<FromEye<S>>;
    type Row = LeafRow<NoMore, [Span<S>; 1]>;

    kept!();

    fn view(&self, rays: &PerspectiveRays<S>, view: &mut Self::View) {
        let (outline, inverse_distance) = (rays.outline(&self.bounds()), rays.inverse_distance);
        *view = PooledView { of_all: FromEye { outline, inverse_distance }, ..PooledView::EMPTY };
    }

    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        view.has_faces() && view.of_all.outline.is_in_rows(rows)
    }

    fn view_faces(
        &self,
        rays: &PerspectiveRays<S>,
        faces: &[HalfSpace<S>],
        views: &mut [FaceView<S>],
        range: [u16; 2],
        view: &mut Self::View,
    ) {
        view.range = range;
        for (view, face) in views.iter_mut().zip(faces) {
            *view = PerspectiveView::new(&face.normal, rays).keep();
        }
    }

    fn row_faces(
        &self,
        view: &Self::View,
        pool: PoolRow<'_, S>,
        y: i32,
        columns: u32,
        row: &mut Self::Row,
    ) {
        let FromEye { outline, inverse_distance } = view.of_all;
        row.set_by(Scan::<PerspectiveRays<S>>::is_in_rows(self, view, [y; 2]), |_| {
            pool.of(view.range).set_perspective(inverse_distance, y);
            outline.extent(y, columns)
        });
    }

    #[inline(always)]
    fn ray_faces(&self, view: &Self::View, pool: PoolRow<'_, S>, x: i32, row: &mut Self::Row) {
        row.keep(x, |_| [common(pool.of(view.range).perspective(), x)]);
    }
}
