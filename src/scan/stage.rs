//! The stages of a picture: solid, then view, then row, then run of columns, then pixel.
//!
//! Stages are plain memory of types that mirror the solid's own, and are filled in place. The solid
//! goes along with every call, so nothing it says is kept twice.

use super::empty::Empty;
use super::planes::{FaceView, PoolRow};
use crate::geom::Extent;
use crate::quadric::HalfSpace;
use crate::span::walk::{Path, Step};
use crate::span::{Face, Shape};

/// Columns in which nothing changes but the ray: from the one that was entered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ColumnRun {
    /// Whether the solid may be seen.
    pub is_visible: bool,
    /// The first column behind the run.
    pub until: u32,
}

impl ColumnRun {
    /// No column shows anything.
    pub const EMPTY: Self = Self { is_visible: false, until: u32::MAX };

    /// The run of a solid that is seen in an extent, from `column` on.
    #[inline]
    #[must_use]
    pub fn of(extent: Extent, column: u32) -> Self {
        let Extent { start, end } = extent;
        match () {
            () if column >= end => Self::EMPTY,
            () if column < start => Self { is_visible: false, until: start },
            () => Self { is_visible: true, until: end },
        }
    }
}

/// A solid that can be seen along the rays `R` of a camera:
/// [`OrthographicRays`](crate::geom::OrthographicRays),
/// [`PerspectiveRays`](crate::geom::PerspectiveRays), or those of your own.
///
/// All solids of the crate implement it. A solid of yours is wrapped in a
/// [`ByLine`](crate::solid::ByLine), which implements it by [`Solid`](crate::solid::Solid).
///
/// [`contains`](Self::contains) and [`step`](Self::step) walk along the ray from crossing to crossing.
/// The crossings are those of the merged list of all leaves' spans, bit for bit.
#[diagnostic::on_unimplemented(
    message = "a camera with the rays `{R}` can't take a picture of `{Self}`",
    label = "no solid that this camera can see",
    note = "a part, its camera, its light and its rays have one number type: all `f32`, say, or all `I16F16`",
    note = "a function that takes any part asks for what pictures need: \
            `part: &(impl Solid<Scalar = f32> + Scan<OrthographicRays<f32>>)`",
    note = "a solid of your own is wrapped: `ByLine::<_, SPANS>::new(solid)`"
)]
pub trait Scan<R>: Shape {
    /// What the camera decides.
    type View: Empty;
    /// What the row decides, which elements of groups matter in the present run of columns, and the
    /// spans of primitives with the last ray that was asked for.
    type Row: Empty;

    /// Gets ready for all rows of a picture.
    fn view(&self, rays: &R, view: &mut Self::View);

    /// Whether the solid may be seen in any row from the first to the last of two, in half pixels
    /// below the middle. May be too often true, never too rarely.
    fn is_in_rows(&self, _: &Self::View, _rows: [i32; 2]) -> bool {
        true
    }

    /// Gets ready for all `columns` of the row `y` half pixels below the middle of the picture.
    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row);

    /// Gets ready for the columns from `column` on, and returns up to where that holds. The run may be
    /// visible where nothing is seen, never the other way round.
    fn enter(row: &mut Self::Row, column: u32) -> ColumnRun;

    /// Whether the ray `x` half pixels to the right of the middle is inside just behind `t`.
    ///
    /// Only in columns that were [entered](Self::enter) and where the solid is visible.
    fn contains<P: Path>(
        &self,
        view: &Self::View,
        row: &mut Self::Row,
        x: i32,
        t: Self::Scalar,
    ) -> bool;

    /// What lies behind `t` on the same ray. Faces are counted from `first` on.
    fn step<P: Path>(
        &self,
        view: &Self::View,
        row: &mut Self::Row,
        x: i32,
        t: Self::Scalar,
        first: Face,
    ) -> Step<Self::Scalar>;

    /// Gets the faces ready that a solid has in a pool, after its [view](Self::view). `range` is where they are
    /// in it. Only the pool of a [`Program`](crate::program::Program) calls this and the two below, and only for
    /// [`Pooled`](crate::solid::Pooled) polyhedra there is anything to do: an enum of solids passes it on.
    #[inline(always)]
    fn view_faces(
        &self,
        _: &R,
        _faces: &[HalfSpace<Self::Scalar>],
        _views: &mut [FaceView<Self::Scalar>],
        _range: [u16; 2],
        _: &mut Self::View,
    ) {
    }

    /// Gets the faces in a pool ready for a row, before [`row`](Self::row).
    #[inline(always)]
    fn row_faces(
        &self,
        _: &Self::View,
        _: PoolRow<'_, Self::Scalar>,
        _y: i32,
        _columns: u32,
        _: &mut Self::Row,
    ) {
    }

    /// Keeps what a ray meets of the faces in a pool, before it is asked for.
    #[inline(always)]
    fn ray_faces(&self, _: &Self::View, _: PoolRow<'_, Self::Scalar>, _x: i32, _: &mut Self::Row) {}
}
