//! Primitives in pictures: what each has to say, and the spans of a ray that are kept of it.

use super::empty::Empty;
use super::stage::ColumnRun;
use crate::geom::Extent;
use crate::scalar::Scalar;
use crate::span::walk::{Path, Step};
use crate::span::{Crossing, Face, Shape, Span};

/// The spans of one ray, in ascending order: an array, with spans that no parameter is in behind the last one.
pub trait Kept<S>: Copy + Empty {
    /// Whether one of them contains `t`.
    fn contain(&self, t: S) -> bool;

    /// What lies behind `t`, with faces counted from `first` on.
    fn behind(&self, t: S, first: Face) -> Step<S>;

    /// Whether `t` is not before the first span, and where that ends was [left open](Leaf::CLOSES_LATER).
    fn is_open(&self, t: S) -> bool;
}

/// The face at the end of a span that was left open.
pub(crate) const OPEN: Face = Face(u16::MAX);

impl<S: Scalar, const K: usize> Kept<S> for [Span<S>; K] {
    #[inline(always)]
    fn contain(&self, t: S) -> bool {
        self.iter().any(|span| span.contains(t))
    }

    #[inline(always)]
    fn behind(&self, t: S, first: Face) -> Step<S> {
        let mut step = Step::OUTSIDE;
        for &Span { enter, exit } in self {
            if t < enter.t {
                step = Step { inside: false, next: enter };
                break;
            }
            if t < exit.t {
                step = Step { inside: true, next: exit };
                break;
            }
        }
        let face = first.offset(step.next.face.0);
        Step { next: Crossing { face, ..step.next }, ..step }
    }

    #[inline(always)]
    fn is_open(&self, t: S) -> bool {
        self.first().is_some_and(|span| span.exit.face == OPEN && span.enter.t <= t)
    }
}

/// A primitive, seen along the rays `R`: at most so many spans in every column as it keeps.
pub trait Leaf<R>: Shape {
    /// As [`Scan::View`](super::Scan::View).
    type View: Empty;
    /// As [`Scan::Row`](super::Scan::Row).
    type Row: Empty;
    /// The spans of a ray: `[Span<S>; 1]` for a convex solid, `[Span<S>; 2]` for a torus.
    type Spans: Kept<Self::Scalar>;

    /// What the camera decides.
    fn view(&self, rays: &R) -> Self::View;

    /// As [`Scan::is_in_rows`](super::Scan::is_in_rows).
    #[inline]
    fn is_in_rows(&self, _: &Self::View, _rows: [i32; 2]) -> bool {
        true
    }

    /// Sets what a row decides, and returns the columns in which the primitive can be seen.
    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent;

    /// Sets the spans of the ray `x` half pixels to the right of the middle.
    fn spans(&self, view: &Self::View, row: &Self::Row, x: i32, spans: &mut Self::Spans);

    /// Whether [`spans`](Self::spans) may leave open where the first span ends: with the face `Face(u16::MAX)`
    /// there, and any parameter. Few pixels see the far side of a solid.
    const CLOSES_LATER: bool = false;

    /// Closes what was left open.
    fn close(&self, _: &Self::View, _: &Self::Row, _x: i32, _: &mut Self::Spans) {}

    /// Whether a span of that ray may contain `t`, if that takes less work than the spans.
    #[inline(always)]
    fn may_contain(&self, _: &Self::View, _: &Self::Row, _x: i32, _t: Self::Scalar) -> bool {
        true
    }
}

/// A row of a primitive.
#[derive(Debug, Clone, Copy)]
pub struct LeafRow<D, K> {
    row: D,
    /// The columns from the first to before the last.
    extent: [u16; 2],
    /// The ray that was asked for last, and its spans.
    x: i32,
    spans: K,
}

/// Farther away than any ray of a picture.
const NO_RAY: i32 = i32::MIN;

impl<D, K> LeafRow<D, K> {
    /// Sets another row.
    #[inline]
    pub(crate) fn set<R, T>(&mut self, solid: &T, view: &T::View, y: i32, columns: u32)
    where
        T: Leaf<R, Row = D>,
    {
        let is_there = solid.is_in_rows(view, [y; 2]);
        self.set_by(is_there, |row| solid.row(view, y, columns, row));
    }

    /// The same, by what sets the row and returns its columns.
    #[inline(always)]
    pub(crate) fn set_by(&mut self, is_there: bool, row: impl FnOnce(&mut D) -> Extent) {
        self.extent = [0; 2];
        if is_there {
            let column = |index: u32| u16::try_from(index).unwrap_or(u16::MAX);
            let extent = row(&mut self.row);
            self.extent = [column(extent.start), column(extent.end)];
            self.x = NO_RAY;
        }
    }

    /// Keeps the spans of another ray, unless they are kept already.
    #[inline(always)]
    pub(crate) fn keep(&mut self, x: i32, spans: impl FnOnce(&D) -> K) {
        if self.x != x {
            (self.x, self.spans) = (x, spans(&self.row));
        }
    }

    /// The spans that are kept.
    #[inline(always)]
    pub(crate) fn kept(&self) -> &K {
        &self.spans
    }

    #[inline]
    pub(crate) fn enter(&self, column: u32) -> ColumnRun {
        let [start, end] = self.extent.map(u32::from);
        ColumnRun::of(Extent { start, end }, column)
    }

    #[inline(always)]
    pub(crate) fn step<P: Path, R, T>(
        &mut self,
        solid: &T,
        view: &T::View,
        x: i32,
        t: T::Scalar,
        first: Face,
    ) -> Step<T::Scalar>
    where
        T: Leaf<R, Row = D, Spans = K>,
        K: Kept<T::Scalar>,
    {
        if self.x != x {
            if P::IS_COLD {
                self.compute_cold::<R, T>(solid, view, x);
            } else {
                self.compute::<R, T>(solid, view, x);
            }
        }
        self.close::<R, T>(solid, view, t);
        self.spans.behind(t, first)
    }

    #[inline(always)]
    pub(crate) fn contains<R, T>(&mut self, solid: &T, view: &T::View, x: i32, t: T::Scalar) -> bool
    where
        T: Leaf<R, Row = D, Spans = K>,
        K: Kept<T::Scalar>,
    {
        if self.x != x {
            if !solid.may_contain(view, &self.row, x, t) {
                return false;
            }
            self.compute_cold::<R, T>(solid, view, x);
        }
        self.close::<R, T>(solid, view, t);
        self.spans.contain(t)
    }

    /// Closes what was left open, if the answer depends on it.
    #[inline(always)]
    fn close<R, T>(&mut self, solid: &T, view: &T::View, t: T::Scalar)
    where
        T: Leaf<R, Row = D, Spans = K>,
        K: Kept<T::Scalar>,
    {
        if T::CLOSES_LATER && self.spans.is_open(t) {
            solid.close(view, &self.row, self.x, &mut self.spans);
        }
    }

    /// Keeps the spans of another ray.
    #[inline(always)]
    fn compute<R, T>(&mut self, solid: &T, view: &T::View, x: i32)
    where
        T: Leaf<R, Row = D, Spans = K>,
    {
        self.x = x;
        solid.spans(view, &self.row, x, &mut self.spans);
    }

    #[inline(never)]
    fn compute_cold<R, T>(&mut self, solid: &T, view: &T::View, x: i32)
    where
        T: Leaf<R, Row = D, Spans = K>,
    {
        self.compute::<R, T>(solid, view, x);
    }
}

/// All zeros, so that it needs no image in flash. Nothing is asked before it is set.
impl<D: Empty, K: Empty> Empty for LeafRow<D, K> {
    const EMPTY: Self = Self { row: D::EMPTY, extent: [0; 2], x: 0, spans: K::EMPTY };
}

impl<S: Scalar> Empty for Span<S> {
    const EMPTY: Self = Span::ZEROS;
}

/// Every [`Leaf`] can be scanned.
macro_rules! leaf {
    ([$($generics:tt)*] $Solid:ty) => {
        #[diagnostic::do_not_recommend]
        impl<$($generics)*, R> $crate::scan::Scan<R> for $Solid
        where
            Self: $crate::scan::Leaf<R>,
        {
            type View = <Self as $crate::scan::Leaf<R>>::View;
            type Row = $crate::scan::LeafRow<
                <Self as $crate::scan::Leaf<R>>::Row,
                <Self as $crate::scan::Leaf<R>>::Spans,
            >;

            fn view(&self, rays: &R, view: &mut Self::View) {
                *view = $crate::scan::Leaf::view(self, rays);
            }

            #[inline]
            fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
                $crate::scan::Leaf::is_in_rows(self, view, rows)
            }

            fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) {
                row.set::<R, Self>(self, view, y, columns);
            }

            #[inline]
            fn enter(row: &mut Self::Row, column: u32) -> $crate::scan::ColumnRun {
                row.enter(column)
            }

            #[inline(always)]
            fn contains<P: $crate::span::walk::Path>(
                &self, view: &Self::View, row: &mut Self::Row, x: i32, t: Self::Scalar,
            ) -> bool {
                row.contains::<R, Self>(self, view, x, t)
            }

            #[inline(always)]
            fn step<P: $crate::span::walk::Path>(
                &self, view: &Self::View, row: &mut Self::Row, x: i32, t: Self::Scalar,
                first: $crate::span::Face,
            ) -> $crate::span::walk::Step<Self::Scalar> {
                row.step::<P, R, Self>(self, view, x, t, first)
            }
        }
    };
}

pub(crate) use leaf;
