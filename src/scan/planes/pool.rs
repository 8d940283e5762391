//! Faces of several polyhedra in one pool: what a camera and a row decide of them.
//!
//! The memory has one type for all rays, so that programs need not know along which they are seen.

use super::{End, FaceView, OrthographicView, PerspectiveRow, PerspectiveView};
use crate::geom::Affine;
use crate::quadric::HalfSpace;
use crate::scalar::Scalar;
use crate::scan::Empty;

/// A row of a face: where parallel rays cross it; or, seen from an eye, its height and its speed.
#[derive(Debug, Clone, Copy)]
pub struct FaceRows<S: Scalar, const N: usize> {
    ends: [End<S>; N],
    speeds: [Affine<S::Wide>; N],
}

impl<S: Scalar, const N: usize> Empty for FaceRows<S, N> {
    const EMPTY: Self = Self { ends: [End::EMPTY; N], speeds: [<End<S> as Empty>::EMPTY.at; N] };
}

/// The faces of a pool, or those of one solid, in a row.
#[derive(Debug)]
pub struct PoolRow<'a, S: Scalar> {
    faces: &'a [HalfSpace<S>],
    views: &'a [FaceView<S>],
    /// Where a row crosses the faces.
    pub(crate) ends: &'a mut [End<S>],
    speeds: &'a mut [Affine<S::Wide>],
}

impl<'a, S: Scalar> PoolRow<'a, S> {
    #[inline(always)]
    pub(crate) fn new<const N: usize>(
        faces: &'a [HalfSpace<S>; N],
        views: &'a [FaceView<S>; N],
        rows: &'a mut FaceRows<S, N>,
    ) -> Self {
        Self { faces, views, ends: &mut rows.ends, speeds: &mut rows.speeds }
    }

    /// The faces of one solid.
    #[inline(always)]
    pub(crate) fn of(self, [start, end]: [u16; 2]) -> Self {
        let range = usize::from(start)..usize::from(end);
        Self {
            faces: self.faces.get(range.clone()).unwrap_or_default(),
            views: self.views.get(range.clone()).unwrap_or_default(),
            ends: self.ends.get_mut(range.clone()).unwrap_or_default(),
            speeds: self.speeds.get_mut(range).unwrap_or_default(),
        }
    }

    /// Faces and how parallel rays see them.
    #[inline(always)]
    pub(crate) fn orthographic(
        &self,
    ) -> impl Iterator<Item = (&'a HalfSpace<S>, OrthographicView<S>)> + use<'a, S> {
        self.faces.iter().zip(self.views.iter().map(OrthographicView::kept))
    }

    /// Sets a row that is seen from an eye.
    pub(crate) fn set_perspective(&mut self, inverse_distance: S::Wide, y: i32) {
        let rows = self.ends.iter_mut().zip(self.speeds.iter_mut());
        for (view, (end, speed)) in self.views.iter().zip(rows) {
            let row = PerspectiveRow::new(&PerspectiveView::kept(view, inverse_distance), y);
            [end.at, *speed] = row.lines();
        }
    }

    /// Faces and their rows, seen from an eye.
    #[inline(always)]
    pub(crate) fn perspective(&self) -> impl Iterator<Item = (&HalfSpace<S>, PerspectiveRow<S>)> {
        let rows = self.ends.iter().zip(self.speeds.iter());
        let rows = rows.map(|(end, speed)| PerspectiveRow::of([end.at, *speed]));
        self.faces.iter().zip(rows)
    }
}
