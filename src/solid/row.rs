//! The stages of a picture: solid, then view, then row, then column.
//!
//! A ray's formulas are applied to their arguments one at a time, and each stage keeps what its
//! argument decided: [`Project::view`] what the camera decides, [`View::row`] what the row
//! decides, so that [`Row::spans`] is left with as little as possible to do for every pixel.

use crate::geom::{Column, Extent};
use crate::scalar::Scalar;
use crate::span::{Face, Span, SpanStack};

use super::Shape;

/// A solid that can be seen along the rays `R` of a camera: [`Parallel`](crate::geom::Parallel)
/// or [`Pencil`](crate::geom::Pencil).
pub trait Project<R>: Shape {
    /// The solid, seen by a camera.
    type View<'a>: View<Scalar = Self::Scalar>
    where
        Self: 'a;

    /// Gets ready for all rows of a picture.
    fn view<'a>(&'a self, rays: &R) -> Self::View<'a>;
}

/// A solid, seen by a camera.
pub trait View {
    /// The number type of the solid.
    type Scalar: Scalar;
    /// One row of it.
    type Row<'a>: Row<Scalar = Self::Scalar>
    where
        Self: 'a;

    /// Gets ready for all columns of the row `y` half pixels below the middle of the picture.
    fn row(&self, y: i32) -> Self::Row<'_>;
}

/// A solid, in one row of a picture.
pub trait Row {
    /// The number type of the solid.
    type Scalar: Scalar;
    /// The number of faces of the solid.
    const FACES: u16;

    /// The columns in which the solid can be seen; may be too many, but never too few.
    fn extent(&self) -> Extent;

    /// Pushes the spans of the pixel's ray with the solid, as
    /// [`Solid::spans`](super::Solid::spans) does for a line.
    fn spans(&self, column: Column, first: Face, stack: &mut SpanStack<'_, Self::Scalar>);
}

/// A convex primitive in one row: at most one span in every column.
pub trait ConvexRow {
    /// As [`Row::Scalar`].
    type Scalar: Scalar;
    /// As [`Row::FACES`].
    const FACES: u16;

    /// The span of the ray `x` half pixels to the right of the middle, if there is one.
    fn span(&self, x: i32) -> Option<Span<Self::Scalar>>;
}

/// A leaf of the tree of rows: a convex primitive, and the columns in which it can be seen.
#[derive(Debug, Clone, Copy)]
pub struct Leaf<R> {
    pub(super) row: R,
    pub(super) extent: Extent,
}

impl<R: ConvexRow> Row for Leaf<R> {
    type Scalar = R::Scalar;
    const FACES: u16 = R::FACES;

    #[inline]
    fn extent(&self) -> Extent {
        self.extent
    }

    #[inline]
    fn spans(&self, column: Column, first: Face, stack: &mut SpanStack<'_, R::Scalar>) {
        if let Some(span) = self.row.span(column.x) {
            stack.put(span.with_faces_from(first));
        }
    }
}
