//! The stages of a picture: solid, then view, then row, then run of columns, then column.
//!
//! A ray's formulas are applied to their arguments one at a time, and each stage keeps what its
//! argument decided. The stages of a solid are plain memory, of types that mirror the solid's own,
//! and are filled in place; the solid itself goes along, so what it says is not kept twice.

use super::Shape;
use crate::geom::{Column, Extent};
use crate::scalar::Scalar;
use crate::span::{Crossing, Face, SpanStack};

/// Memory of a stage that is yet to be reached.
pub trait Empty {
    /// Nothing is decided.
    const EMPTY: Self;
}

impl<T: Empty, const N: usize> Empty for [T; N] {
    const EMPTY: Self = [T::EMPTY; N];
}

impl<T> Empty for Option<T> {
    const EMPTY: Self = None;
}

impl<A: Empty, B: Empty> Empty for (A, B) {
    const EMPTY: Self = (A::EMPTY, B::EMPTY);
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

/// A solid that can be seen along the rays `R` of a camera: [`OrthographicRays`](crate::geom::OrthographicRays)
/// or [`PerspectiveRays`](crate::geom::PerspectiveRays).
///
/// Columns are asked for in two ways. [`spans_at`](Self::spans_at) is the whole list of a column, as
/// [`Solid::spans`](super::Solid::spans) is that of a line. [`holds`](Self::holds) and
/// [`look`](Self::look) walk along the ray from crossing to crossing, and compute only what the
/// answer depends on; the crossings are those of the list, bit by bit.
pub trait Scan<R>: Shape {
    /// What the camera decides.
    type View: Empty;
    /// What the row decides, which elements of groups matter in the present run of columns, and
    /// the spans of primitives with the last ray that was asked for.
    type Row: Empty;

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

/// [`Scan`] for what is another solid in its field of that name, seen along `own` rays.
macro_rules! project_as_within {
    ($field:ident: $Solid:ty, |$around:ident, $rays:ident: $Rays:ident| $own:expr) => {
        type View = <$Solid as $crate::solid::Scan<$Rays>>::View;
        type Row = <$Solid as $crate::solid::Scan<$Rays>>::Row;

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
            <$Solid as $crate::solid::Scan<$Rays>>::outlook(row, column)
        }

        fn enter(row: &mut Self::Row, column: u32) -> $crate::solid::row::Outlook {
            <$Solid as $crate::solid::Scan<$Rays>>::enter(row, column)
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

pub(super) use project_as_within;
