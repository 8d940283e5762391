//! A program whose view and row stay where they are, in memory of C's.
//!
//! A picture holds the view and the row of its solid, and is made by value: on a stack, from where it would be
//! copied to C's memory. These two are several kilobytes. So a picture of this solid holds references to them.

use crate::number::Scalar;
use crate::part::Program;
use core::cell::Cell;
use scancsg::geom::{Line, Vec3};
use scancsg::scan::{ColumnRun, Empty, Scan};
use scancsg::solid::{Rgb, Shape, Solid};
use scancsg::span::walk::{Path, Step};
use scancsg::span::{Face, SpanStack};

type View<R> = <Program as Scan<R>>::View;
type Row<R> = <Program as Scan<R>>::Row;

/// Memory that is set element by element. Set as a whole, it would be a constant in flash, as long as itself.
pub(crate) trait Fill {
    /// Nothing is decided.
    ///
    /// # Safety
    /// The place is aligned and large enough, and nobody else's.
    unsafe fn fill(place: *mut Self);
}

impl<T: Empty, const N: usize> Fill for [T; N] {
    unsafe fn fill(place: *mut Self) {
        for index in 0..N {
            // SAFETY: an array has so many elements, and the caller says the rest.
            unsafe { place.cast::<T>().add(index).write(T::EMPTY) };
        }
    }
}

/// The parts' views, and those of faces in a pool.
impl<A: Fill, B: Fill> Fill for (A, B) {
    unsafe fn fill(place: *mut Self) {
        // SAFETY: the caller says it of the pair, so it holds of both.
        unsafe {
            A::fill(&raw mut (*place).0);
            B::fill(&raw mut (*place).1);
        }
    }
}

/// A program, with the memory that it has not lent to a picture yet.
pub(crate) struct Lent<R: 'static>
where
    Program: Scan<R>,
{
    pub(crate) program: &'static Program,
    pub(crate) view: Cell<Option<&'static mut View<R>>>,
    pub(crate) row: Cell<Option<&'static mut Row<R>>>,
}

impl<R> Shape for Lent<R>
where
    Program: Scan<R>,
{
    type Scalar = Scalar;
    const SPANS: usize = Program::SPANS;
    const FACES: u16 = Program::FACES;
}

impl<R> Solid for Lent<R>
where
    Program: Scan<R>,
{
    fn spans(&self, line: &Line<Scalar>, first: Face, stack: &mut SpanStack<'_, Scalar>) {
        self.program.spans(line, first, stack);
    }

    fn normal(&self, face: Face, at: Vec3<Scalar>) -> Vec3<Scalar> {
        self.program.normal(face, at)
    }

    #[inline]
    fn cosine(&self, face: Face, at: impl FnOnce() -> Vec3<Scalar>, to: Vec3<Scalar>) -> Scalar {
        self.program.cosine(face, at, to)
    }

    fn color(&self, face: Face) -> Option<Rgb> {
        self.program.color(face)
    }
}

/// Memory that is lent: none before it is asked for.
pub(crate) struct Slot<T: 'static>(Option<&'static mut T>);

impl<T> Empty for Slot<T> {
    const EMPTY: Self = Self(None);
}

impl<T> Slot<T> {
    fn filled(&mut self, from: &Cell<Option<&'static mut T>>) -> Option<&mut T> {
        if self.0.is_none() {
            self.0 = from.take();
        }
        self.0.as_deref_mut()
    }
}

impl<R> Scan<R> for Lent<R>
where
    Program: Scan<R>,
{
    type View = Slot<View<R>>;
    type Row = Slot<Row<R>>;

    fn view(&self, rays: &R, view: &mut Self::View) {
        if let Some(view) = view.filled(&self.view) {
            self.program.view(rays, view);
        }
    }

    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        view.0.as_ref().is_none_or(|view| self.program.is_in_rows(view, rows))
    }

    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) {
        if let (Some(view), Some(row)) = (&view.0, row.filled(&self.row)) {
            self.program.row(view, y, columns, row);
        }
    }

    fn enter(row: &mut Self::Row, column: u32) -> ColumnRun {
        row.0.as_mut().map_or(ColumnRun::EMPTY, |row| <Program as Scan<R>>::enter(row, column))
    }

    #[inline]
    fn contains<P: Path>(&self, view: &Self::View, row: &mut Self::Row, x: i32, t: Scalar) -> bool {
        let (Some(view), Some(row)) = (&view.0, &mut row.0) else { return false };
        self.program.contains::<P>(view, row, x, t)
    }

    #[inline]
    fn step<P: Path>(
        &self,
        view: &Self::View,
        row: &mut Self::Row,
        x: i32,
        t: Scalar,
        first: Face,
    ) -> Step<Scalar> {
        let (Some(view), Some(row)) = (&view.0, &mut row.0) else { return Step::OUTSIDE };
        self.program.step::<P>(view, row, x, t, first)
    }
}
