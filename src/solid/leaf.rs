//! Convex primitives in pictures: what each has to say, and the span of a ray that is kept of it.

use super::Shape;
use super::row::{Empty, Look, Outlook};
use crate::geom::Extent;
use crate::scalar::Scalar;
use crate::span::{Crossing, Face, Span};

/// A convex primitive, seen along the rays `R`: at most one span in every column.
pub trait Leaf<R>: Shape {
    /// As [`Scan::View`](super::Scan::View).
    type View: Empty;
    /// As [`Scan::Row`](super::Scan::Row).
    type Row: Empty;

    /// What the camera decides.
    fn seen_along(&self, rays: &R) -> Self::View;

    /// As [`Scan::is_in_rows`](super::Scan::is_in_rows).
    #[inline]
    fn is_in_rows(&self, _: &Self::View, _rows: [i32; 2]) -> bool {
        true
    }

    /// Sets what such a row decides, and returns the columns in which the primitive can be seen.
    fn in_row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent;

    /// The span of the ray `x` half pixels to the right of the middle, if there is one.
    fn span(&self, view: &Self::View, row: &Self::Row, x: i32) -> Option<Span<Self::Scalar>>;

    /// Sets that span where it is kept: to [`Span::NOWHERE`] if there is none.
    #[inline]
    fn set_span(&self, view: &Self::View, row: &Self::Row, x: i32, span: &mut Span<Self::Scalar>) {
        *span = self.span(view, row, x).unwrap_or(Span::NOWHERE);
    }

    /// Whether the span of that ray may hold `t`, if that takes less work than the span.
    #[inline(always)]
    fn may_hold(&self, _: &Self::View, _: &Self::Row, _x: i32, _t: Self::Scalar) -> bool {
        true
    }
}

/// A row of a primitive.
#[derive(Debug, Clone, Copy)]
pub struct LeafRow<S, D> {
    row: D,
    /// The columns from the first to before the last.
    extent: [u16; 2],
    /// The ray that was asked for last, and its span.
    x: i32,
    span: Span<S>,
}

impl<S: Scalar, D: Empty> Empty for LeafRow<S, D> {
    const EMPTY: Self = Self { row: D::EMPTY, extent: [0; 2], x: 0, span: Span::EMPTY };
}

/// Farther away than any ray of a picture.
const NO_RAY: i32 = i32::MIN;

impl<S: Scalar, D> LeafRow<S, D> {
    /// A row in which nothing can be seen.
    #[inline]
    pub(super) fn skip(&mut self) {
        self.extent = [0; 2];
    }

    /// Another row.
    #[inline]
    pub(super) fn set(&mut self, fill: impl FnOnce(&mut D) -> Extent) {
        let column = |index: u32| u16::try_from(index).unwrap_or(u16::MAX);
        let extent = fill(&mut self.row);
        self.extent = [column(extent.start), column(extent.end)];
        self.x = NO_RAY;
    }

    #[inline]
    pub(super) fn outlook(&self, column: u32) -> Outlook {
        let [start, end] = self.extent.map(u32::from);
        Outlook::of(Extent { start, end }, column)
    }

    #[inline]
    pub(super) fn row(&self) -> &D {
        &self.row
    }

    /// Whether a ray is inside just behind `t`, and where that changes.
    #[inline(always)]
    pub(super) fn look<R, T>(
        &mut self,
        solid: &T,
        view: &T::View,
        x: i32,
        t: S,
        first: Face,
    ) -> Look<S>
    where
        T: Leaf<R, Scalar = S, Row = D>,
    {
        if self.x != x {
            self.compute::<R, T>(solid, view, x);
        }
        self.behind(t, first)
    }

    /// As [`look`](Self::look), where it is seldom.
    #[inline]
    pub(super) fn look_apart<R, T>(
        &mut self,
        solid: &T,
        view: &T::View,
        x: i32,
        t: S,
        first: Face,
    ) -> Look<S>
    where
        T: Leaf<R, Scalar = S, Row = D>,
    {
        if self.x != x {
            self.compute_apart::<R, T>(solid, view, x);
        }
        self.behind(t, first)
    }

    /// What is behind `t` on the ray that was asked for last.
    #[inline(always)]
    fn behind(&self, t: S, first: Face) -> Look<S> {
        let Span { enter, exit } = self.span;
        let (inside, next) = match () {
            () if t < enter.t => (false, enter),
            () if t < exit.t => (true, exit),
            () => (false, Crossing::NEVER),
        };
        Look { inside, next: Crossing { face: first.offset(next.face.0), ..next } }
    }

    /// Whether the span of a ray holds `t`.
    #[inline(always)]
    pub(super) fn holds<R, T>(&mut self, solid: &T, view: &T::View, x: i32, t: S) -> bool
    where
        T: Leaf<R, Scalar = S, Row = D>,
    {
        if self.x != x {
            if !solid.may_hold(view, &self.row, x, t) {
                return false;
            }
            self.compute_apart::<R, T>(solid, view, x);
        }
        self.span.holds(t)
    }

    /// Keeps the span of another ray.
    #[inline(always)]
    fn compute<R, T>(&mut self, solid: &T, view: &T::View, x: i32)
    where
        T: Leaf<R, Scalar = S, Row = D>,
    {
        self.x = x;
        solid.set_span(view, &self.row, x, &mut self.span);
    }

    /// As [`compute`](Self::compute), where it is seldom.
    #[inline(never)]
    fn compute_apart<R, T>(&mut self, solid: &T, view: &T::View, x: i32)
    where
        T: Leaf<R, Scalar = S, Row = D>,
    {
        self.compute::<R, T>(solid, view, x);
    }
}

/// Every [`Leaf`] can be seen.
macro_rules! leaf {
    ([$($generics:tt)*] $Solid:ty) => {
        impl<$($generics)*, R> $crate::solid::Scan<R> for $Solid
        where
            Self: $crate::solid::leaf::Leaf<R>,
        {
            type View = <Self as $crate::solid::leaf::Leaf<R>>::View;
            type Row =
                $crate::solid::leaf::LeafRow<Self::Scalar, <Self as $crate::solid::leaf::Leaf<R>>::Row>;

            fn view(&self, rays: &R, view: &mut Self::View) {
                *view = $crate::solid::leaf::Leaf::seen_along(self, rays);
            }

            #[inline]
            fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
                $crate::solid::leaf::Leaf::is_in_rows(self, view, rows)
            }

            fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) {
                if $crate::solid::leaf::Leaf::is_in_rows(self, view, [y; 2]) {
                    row.set(|row| $crate::solid::leaf::Leaf::in_row(self, view, y, columns, row));
                } else {
                    row.skip();
                }
            }

            #[inline]
            fn outlook(row: &Self::Row, column: u32) -> $crate::solid::row::Outlook {
                row.outlook(column)
            }

            #[inline]
            fn enter(row: &mut Self::Row, column: u32) -> $crate::solid::row::Outlook {
                row.outlook(column)
            }

            #[inline]
            fn spans_at(
                &self,
                view: &Self::View,
                row: &Self::Row,
                column: $crate::geom::Column,
                first: $crate::span::Face,
                stack: &mut $crate::span::SpanStack<'_, Self::Scalar>,
            ) {
                let span = $crate::solid::leaf::Leaf::<R>::span(self, view, row.row(), column.x);
                if let Some(span) = span {
                    stack.put(span.with_faces_from(first));
                }
            }

            #[inline(always)]
            fn holds(
                &self,
                view: &Self::View,
                row: &mut Self::Row,
                x: i32,
                t: Self::Scalar,
            ) -> bool {
                row.holds::<R, Self>(self, view, x, t)
            }

            #[inline(always)]
            fn look(
                &self,
                view: &Self::View,
                row: &mut Self::Row,
                x: i32,
                t: Self::Scalar,
                first: $crate::span::Face,
            ) -> $crate::solid::row::Look<Self::Scalar> {
                row.look::<R, Self>(self, view, x, t, first)
            }

            #[inline]
            fn look_apart(
                &self,
                view: &Self::View,
                row: &mut Self::Row,
                x: i32,
                t: Self::Scalar,
                first: $crate::span::Face,
            ) -> $crate::solid::row::Look<Self::Scalar> {
                row.look_apart::<R, Self>(self, view, x, t, first)
            }
        }
    };
}

pub(super) use leaf;
