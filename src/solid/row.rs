//! The stages of a picture: solid, then view, then row, then run of columns, then column.
//!
//! A ray's formulas are applied to their arguments one at a time, and each stage keeps what its
//! argument decided. The stages of a solid are plain memory, of types that mirror the solid's own,
//! and are filled in place; the solid itself goes along, so what it says is not kept twice.

use super::Shape;
use crate::geom::{Column, Extent};
use crate::scalar::Scalar;
use crate::span::{Crossing, Face, Span, SpanStack};

/// Memory of a stage that is yet to be reached.
pub trait Blank {
    /// Nothing is decided.
    const BLANK: Self;
}

impl<T: Blank, const N: usize> Blank for [T; N] {
    const BLANK: Self = [T::BLANK; N];
}

impl<T> Blank for Option<T> {
    const BLANK: Self = None;
}

impl<A: Blank, B: Blank> Blank for (A, B) {
    const BLANK: Self = (A::BLANK, B::BLANK);
}

/// What a row shows of a solid from some column on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Outlook {
    /// Whether the solid may be seen.
    pub is_there: bool,
    /// The column in which that, or what is there, changes.
    pub until: u32,
}

impl Outlook {
    /// No column shows anything.
    pub(super) const EMPTY: Self = Self { is_there: false, until: u32::MAX };

    /// What an extent says from `column` on.
    #[inline]
    pub(super) fn of(extent: Extent, column: u32) -> Self {
        let Extent { start, end } = extent;
        match () {
            () if column >= end => Self::EMPTY,
            () if column < start => Self { is_there: false, until: start },
            () => Self { is_there: true, until: end },
        }
    }
}

/// A solid that can be seen along the rays `R` of a camera: [`Parallel`](crate::geom::Parallel)
/// or [`Pencil`](crate::geom::Pencil).
///
/// Columns are asked for in two ways. [`spans_at`](Self::spans_at) is the whole list of a column, as
/// [`Solid::spans`](super::Solid::spans) is that of a line. [`holds`](Self::holds) and
/// [`look`](Self::look) walk along the ray from crossing to crossing, and compute only what the
/// answer depends on; the crossings are those of the list, bit by bit.
pub trait Project<R>: Shape {
    /// What the camera decides.
    type View: Blank;
    /// What the row decides, which elements of groups matter in the present run of columns, and
    /// the spans of primitives with the last ray that was asked for.
    type Row: Blank;

    /// Gets ready for all rows of a picture.
    fn view(&self, rays: &R, view: &mut Self::View);

    /// Whether the solid can be seen in any row from the first to the last of two, as far as little work
    /// tells.
    fn is_in_rows(&self, _: &Self::View, _rows: [i32; 2]) -> bool {
        true
    }

    /// Gets ready for all columns, so many, of the row `y` half pixels below the middle of the
    /// picture.
    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row);

    /// What can be seen from `column` on: may be too much, but never too little.
    fn outlook(row: &Self::Row, column: u32) -> Outlook;

    /// Gets ready for the columns from `column` on, up to those of the [`outlook`](Self::outlook),
    /// which is returned.
    fn enter(row: &mut Self::Row, column: u32) -> Outlook;

    /// Pushes the spans of the column's ray, in ascending order and regularised, with faces
    /// counted from `first` on.
    fn spans_at(
        &self,
        view: &Self::View,
        row: &Self::Row,
        column: Column,
        first: Face,
        stack: &mut SpanStack<'_, Self::Scalar>,
    );

    /// Whether the ray `x` half pixels to the right of the middle is inside just behind `t`.
    ///
    /// Only in columns that were [entered](Self::enter) and where the solid may be seen.
    fn holds(&self, view: &Self::View, row: &mut Self::Row, x: i32, t: Self::Scalar) -> bool;

    /// Whether the same ray is inside just behind `t`, and where that changes; faces are counted
    /// from `first` on.
    fn look(
        &self,
        view: &Self::View,
        row: &mut Self::Row,
        x: i32,
        t: Self::Scalar,
        first: Face,
    ) -> Look<Self::Scalar>;

    /// As [`holds`](Self::holds), where it is seldom: a call, where that is code in its place.
    #[inline(never)]
    fn holds_apart(&self, view: &Self::View, row: &mut Self::Row, x: i32, t: Self::Scalar) -> bool {
        self.holds(view, row, x, t)
    }

    /// As [`look`](Self::look), where it is seldom.
    #[inline(never)]
    fn look_apart(
        &self,
        view: &Self::View,
        row: &mut Self::Row,
        x: i32,
        t: Self::Scalar,
        first: Face,
    ) -> Look<Self::Scalar> {
        self.look(view, row, x, t, first)
    }
}

/// What lies behind some parameter of a ray.
#[derive(Debug, Clone, Copy)]
pub struct Look<S> {
    /// Whether the ray is inside just behind the parameter.
    pub inside: bool,
    /// The first crossing behind it: none, if its parameter is [`Scalar::HIGHEST`].
    pub next: Crossing<S>,
}

impl<S: Scalar> Look<S> {
    /// Nothing is there.
    pub(super) const EMPTY: Self = Self { inside: false, next: Crossing::NEVER };
}

/// A convex primitive, seen along the rays `R`: at most one span in every column.
pub trait Leaf<R>: Shape {
    /// As [`Project::View`].
    type View: Blank;
    /// As [`Project::Row`].
    type Row: Blank;

    /// What the camera decides.
    fn seen_along(&self, rays: &R) -> Self::View;

    /// As [`Project::is_in_rows`].
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

impl<S: Scalar, D: Blank> Blank for LeafRow<S, D> {
    const BLANK: Self = Self { row: D::BLANK, extent: [0; 2], x: 0, span: Span::BLANK };
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
        impl<$($generics)*, R> $crate::solid::Project<R> for $Solid
        where
            Self: $crate::solid::row::Leaf<R>,
        {
            type View = <Self as $crate::solid::row::Leaf<R>>::View;
            type Row =
                $crate::solid::row::LeafRow<Self::Scalar, <Self as $crate::solid::row::Leaf<R>>::Row>;

            fn view(&self, rays: &R, view: &mut Self::View) {
                *view = $crate::solid::row::Leaf::seen_along(self, rays);
            }

            #[inline]
            fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
                $crate::solid::row::Leaf::is_in_rows(self, view, rows)
            }

            fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) {
                if $crate::solid::row::Leaf::is_in_rows(self, view, [y; 2]) {
                    row.set(|row| $crate::solid::row::Leaf::in_row(self, view, y, columns, row));
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
                let span = $crate::solid::row::Leaf::<R>::span(self, view, row.row(), column.x);
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

/// [`Project`] for what is another solid in its field of that name, seen along `own` rays.
macro_rules! project_as_within {
    ($field:ident: $Solid:ty, |$around:ident, $rays:ident: $Rays:ident| $own:expr) => {
        type View = <$Solid as $crate::solid::Project<$Rays>>::View;
        type Row = <$Solid as $crate::solid::Project<$Rays>>::Row;

        fn view(&self, $rays: &$Rays, view: &mut Self::View) {
            let $around = self;
            self.$field.view($own, view);
        }

        fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
            self.$field.is_in_rows(view, rows)
        }

        fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) {
            self.$field.row(view, y, columns, row);
        }

        fn outlook(row: &Self::Row, column: u32) -> $crate::solid::row::Outlook {
            <$Solid as $crate::solid::Project<$Rays>>::outlook(row, column)
        }

        fn enter(row: &mut Self::Row, column: u32) -> $crate::solid::row::Outlook {
            <$Solid as $crate::solid::Project<$Rays>>::enter(row, column)
        }

        #[inline]
        fn spans_at(
            &self,
            view: &Self::View,
            row: &Self::Row,
            column: $crate::geom::Column,
            first: Face,
            stack: &mut SpanStack<'_, Self::Scalar>,
        ) {
            self.$field.spans_at(view, row, column, first, stack);
        }

        #[inline]
        fn holds(&self, view: &Self::View, row: &mut Self::Row, x: i32, t: Self::Scalar) -> bool {
            self.$field.holds(view, row, x, t)
        }

        #[inline]
        fn look(
            &self,
            view: &Self::View,
            row: &mut Self::Row,
            x: i32,
            t: Self::Scalar,
            first: Face,
        ) -> $crate::solid::row::Look<Self::Scalar> {
            self.$field.look(view, row, x, t, first)
        }

        fn holds_apart(
            &self,
            view: &Self::View,
            row: &mut Self::Row,
            x: i32,
            t: Self::Scalar,
        ) -> bool {
            self.$field.holds_apart(view, row, x, t)
        }

        fn look_apart(
            &self,
            view: &Self::View,
            row: &mut Self::Row,
            x: i32,
            t: Self::Scalar,
            first: Face,
        ) -> $crate::solid::row::Look<Self::Scalar> {
            self.$field.look_apart(view, row, x, t, first)
        }
    };
}

pub(super) use {leaf, project_as_within};
