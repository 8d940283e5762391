//! Union, intersection and difference of two solids, and the operators `|`, `&` and `-`.

use super::row::{Empty, Look, Outlook, Scan};
use super::{Cylinder, Painted, Placed, Rgb, Shape, Slab, Solid, Sphere};
use crate::geom::{Column, Line, Vec3};
use crate::scalar::{Number, Scalar};
use crate::span::{Crossing, Face, Operation, SpanStack};
use core::marker::PhantomData;
use core::ops::{BitAnd, BitOr, Sub};

/// What is in the left solid, in the right one, or in both.
pub type Union<L, R> = Boolean<Either, L, R>;
/// What is in both solids.
pub type Intersection<L, R> = Boolean<Both, L, R>;
/// What is in the left solid but not in the right one.
pub type Difference<L, R> = Boolean<LeftOnly, L, R>;

/// The operation of a [`Union`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Either {}
/// The operation of an [`Intersection`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Both {}
/// The operation of a [`Difference`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LeftOnly {}

/// A boolean operation as a type.
pub trait Rule: sealed::Sealed {
    #[doc(hidden)]
    const OPERATION: Operation;
    /// By how much the most spans of the result stay below those of both operands together.
    #[doc(hidden)]
    const FEWER: usize;
    /// Whether the right operand is cut away, so that its faces are seen from their other side.
    #[doc(hidden)]
    const CUTS: bool;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::Either {}
    impl Sealed for super::Both {}
    impl Sealed for super::LeftOnly {}
}

impl Rule for Either {
    const OPERATION: Operation = Operation::UNION;
    const FEWER: usize = 0;
    const CUTS: bool = false;
}

impl Rule for Both {
    const OPERATION: Operation = Operation::INTERSECTION;
    // Every span of the result begins where a span of an operand begins, and the very first
    // beginning of all begins none, or two of them begin one.
    const FEWER: usize = 1;
    const CUTS: bool = false;
}

impl Rule for LeftOnly {
    const OPERATION: Operation = Operation::DIFFERENCE;
    const FEWER: usize = 0;
    const CUTS: bool = true;
}

/// Two solids and what to do with them: [`Union`], [`Intersection`] or [`Difference`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Boolean<O, L, R> {
    left: L,
    right: R,
    rule: PhantomData<O>,
}

impl<O, L, R> Boolean<O, L, R> {
    /// Combines two solids; also in constants, where operators can't be used yet.
    #[must_use]
    pub const fn new(left: L, right: R) -> Self {
        Self { left, right, rule: PhantomData }
    }
}

const fn larger(a: usize, b: usize) -> usize {
    if a > b { a } else { b }
}

impl<O: Rule, L: Shape, R: Shape<Scalar = L::Scalar>> Shape for Boolean<O, L, R> {
    type Scalar = L::Scalar;
    const SPANS: usize = L::SPANS + R::SPANS - O::FEWER;
    const STACK: usize =
        larger(larger(L::STACK, L::SPANS + R::STACK), L::SPANS + R::SPANS + Self::SPANS);
    const FACES: u16 = L::FACES + R::FACES;
}

/// The face within the operand that it belongs to: left or right.
fn operand<L: Shape>(face: Face) -> Result<Face, Face> {
    match face.0.checked_sub(L::FACES) {
        None => Ok(face),
        Some(of_right) => Err(Face(of_right)),
    }
}

/// Evaluates both operands on top of the stack and merges them.
#[inline]
fn combine<S: Scalar>(
    operation: Operation,
    stack: &mut SpanStack<'_, S>,
    left: impl FnOnce(&mut SpanStack<'_, S>),
    right: impl FnOnce(&mut SpanStack<'_, S>),
) {
    let left_start = stack.len();
    left(stack);
    let right_start = stack.len();
    if left_start == right_start && operation.needs_left() {
        return;
    }
    right(stack);
    stack.merge(operation, left_start, right_start);
}

impl<O: Rule, L: Solid, R: Solid<Scalar = L::Scalar>> Solid for Boolean<O, L, R> {
    fn spans(
        &self,
        line: &Line<Self::Scalar>,
        first: Face,
        stack: &mut SpanStack<'_, Self::Scalar>,
    ) {
        combine(
            O::OPERATION,
            stack,
            |stack| self.left.spans(line, first, stack),
            |stack| self.right.spans(line, first.offset(L::FACES), stack),
        );
    }

    fn onto(&self, face: Face, near: Vec3<Self::Scalar>) -> Vec3<Self::Scalar> {
        match operand::<L>(face) {
            Ok(face) => self.left.onto(face, near),
            Err(face) => self.right.onto(face, near),
        }
    }

    fn normal(&self, face: Face, at: Vec3<Self::Scalar>) -> Vec3<Self::Scalar> {
        match operand::<L>(face) {
            Ok(face) => self.left.normal(face, at),
            Err(face) if O::CUTS => -self.right.normal(face, at),
            Err(face) => self.right.normal(face, at),
        }
    }

    #[inline]
    fn cosine(
        &self,
        face: Face,
        at: impl FnOnce() -> Vec3<Self::Scalar>,
        to: Vec3<Self::Scalar>,
    ) -> Self::Scalar {
        match operand::<L>(face) {
            Ok(face) => self.left.cosine(face, at, to),
            Err(face) if O::CUTS => self.right.cosine(face, at, to).negated(),
            Err(face) => self.right.cosine(face, at, to),
        }
    }

    fn color(&self, face: Face) -> Option<Rgb> {
        match operand::<L>(face) {
            Ok(face) => self.left.color(face),
            Err(face) => self.right.color(face),
        }
    }
}

impl<P, O: Rule, L: Scan<P>, R: Scan<P, Scalar = L::Scalar>> Scan<P> for Boolean<O, L, R> {
    type View = (L::View, R::View);
    type Row = BooleanRow<L::Row, R::Row>;

    fn view(&self, rays: &P, (left, right): &mut Self::View) {
        self.left.view(rays, left);
        self.right.view(rays, right);
    }

    fn is_in_rows(&self, (left, right): &Self::View, rows: [i32; 2]) -> bool {
        let (left, right) = (self.left.is_in_rows(left, rows), self.right.is_in_rows(right, rows));
        O::OPERATION.may_hold(left, right)
    }

    fn row(&self, (left, right): &Self::View, y: i32, columns: u32, row: &mut Self::Row) {
        self.left.row(left, y, columns, &mut row.left);
        self.right.row(right, y, columns, &mut row.right);
    }

    fn outlook(row: &Self::Row, column: u32) -> Outlook {
        let left = L::outlook(&row.left, column);
        if !left.is_there && O::OPERATION.needs_left() {
            return left;
        }
        let right = R::outlook(&row.right, column);
        let is_there = O::OPERATION.may_hold(left.is_there, right.is_there);
        Outlook { is_there, until: left.until.min(right.until) }
    }

    fn enter(row: &mut Self::Row, column: u32) -> Outlook {
        let left = L::enter(&mut row.left, column);
        row.asks_left = left.is_there;
        if !left.is_there && O::OPERATION.needs_left() {
            return left;
        }
        let right = R::enter(&mut row.right, column);
        row.asks_right = right.is_there;
        let is_there = O::OPERATION.may_hold(left.is_there, right.is_there);
        Outlook { is_there, until: left.until.min(right.until) }
    }

    fn spans_at(
        &self,
        view: &Self::View,
        row: &Self::Row,
        column: Column,
        first: Face,
        stack: &mut SpanStack<'_, Self::Scalar>,
    ) {
        combine(
            O::OPERATION,
            stack,
            |stack| spans_inside(&self.left, &view.0, &row.left, column, first, stack),
            |stack| {
                let first = first.offset(L::FACES);
                spans_inside(&self.right, &view.1, &row.right, column, first, stack);
            },
        );
    }

    #[inline]
    fn holds(&self, view: &Self::View, row: &mut Self::Row, x: i32, t: Self::Scalar) -> bool {
        let in_left = row.asks_left && self.left.holds(&view.0, &mut row.left, x, t);
        if O::OPERATION.holds(in_left, false) == O::OPERATION.holds(in_left, true) {
            return O::OPERATION.holds(in_left, false);
        }
        let in_right = row.asks_right && self.right.holds(&view.1, &mut row.right, x, t);
        O::OPERATION.holds(in_left, in_right)
    }

    /// The merge of two lists, with the crossings of either computed when they are needed. While the
    /// left operand is left and needed, that is none of the right one's.
    #[inline]
    fn look(
        &self,
        view: &Self::View,
        row: &mut Self::Row,
        x: i32,
        t: Self::Scalar,
        first: Face,
    ) -> Look<Self::Scalar> {
        let left = if row.asks_left {
            self.left.look(&view.0, &mut row.left, x, t, first)
        } else {
            Look::EMPTY
        };
        if left.inside || !O::OPERATION.needs_left() {
            return self.look_on(view, row, x, t, left, first);
        }
        // From outside of the left operand, its first crossing decides in most cases.
        let t = left.next.t;
        if t >= Self::Scalar::HIGHEST {
            return Look::EMPTY;
        }
        let in_right = row.asks_right && self.right.holds(&view.1, &mut row.right, x, t);
        if O::OPERATION.holds(true, in_right) {
            return Look { inside: false, next: left.next };
        }
        let next = self.next_of_right(view, row, x, t, first);
        Look { inside: false, next }
    }
}

impl<O: Rule, L: Shape, R: Shape<Scalar = L::Scalar>> Boolean<O, L, R> {
    /// The first crossing behind `t`, where a ray is inside of the left operand and the right one
    /// keeps it out of the result: for operations that need the left one.
    #[inline(never)]
    fn next_of_right<P>(
        &self,
        view: &<Self as Scan<P>>::View,
        row: &mut <Self as Scan<P>>::Row,
        x: i32,
        mut t: L::Scalar,
        first: Face,
    ) -> Crossing<L::Scalar>
    where
        L: Scan<P>,
        R: Scan<P>,
    {
        if !row.asks_right {
            return Crossing::NEVER;
        }
        loop {
            let first_of_right = first.offset(L::FACES);
            let right = self.right.look_apart(&view.1, &mut row.right, x, t, first_of_right);
            t = right.next.t;
            if t >= L::Scalar::HIGHEST {
                return right.next;
            }
            if self.left.holds_apart(&view.0, &mut row.left, x, t) {
                // Where both cross, the face is that of the left.
                let before = t.next_below();
                if self.left.holds_apart(&view.0, &mut row.left, x, before) {
                    return right.next;
                }
                return self.left.look_apart(&view.0, &mut row.left, x, before, first).next;
            }
            let left = self.left.look_apart(&view.0, &mut row.left, x, t, first);
            t = left.next.t;
            let ends = t >= L::Scalar::HIGHEST;
            let in_right = !ends && self.right.holds_apart(&view.1, &mut row.right, x, t);
            if ends || O::OPERATION.holds(true, in_right) {
                return left.next;
            }
        }
    }

    /// What lies behind `t`, and behind that, where it is known of the left operand.
    #[inline(never)]
    fn look_on<P>(
        &self,
        view: &<Self as Scan<P>>::View,
        row: &mut <Self as Scan<P>>::Row,
        x: i32,
        mut t: L::Scalar,
        mut left: Look<L::Scalar>,
        first: Face,
    ) -> Look<L::Scalar>
    where
        L: Scan<P>,
        R: Scan<P>,
    {
        let (operation, endless) = (O::OPERATION, L::Scalar::HIGHEST);
        let counts = |left: &Look<L::Scalar>| left.inside || !operation.needs_left();
        let first_of_right = first.offset(L::FACES);
        let mut right = Look::EMPTY;
        if row.asks_right && counts(&left) {
            right = self.right.look_apart(&view.1, &mut row.right, x, t, first_of_right);
        }
        let inside = operation.holds(left.inside, right.inside);
        loop {
            // Where both cross, the face is that of the left.
            let next = if right.next.t < left.next.t { right.next } else { left.next };
            if next.t >= endless {
                return Look { inside, next };
            }
            t = next.t;
            let (passes_left, mut passes_right) = (left.next.t <= t, right.next.t <= t);
            left.inside ^= passes_left;
            right.inside ^= passes_right;
            if passes_left && operation.needs_left() {
                passes_right = row.asks_right;
                right.inside = left.inside
                    && row.asks_right
                    && self.right.holds_apart(&view.1, &mut row.right, x, t);
            }
            if operation.holds(left.inside, right.inside) != inside {
                return Look { inside, next };
            }
            if passes_left {
                left = self.left.look_apart(&view.0, &mut row.left, x, t, first);
            }
            if !counts(&left) {
                right = Look::EMPTY;
            } else if passes_right {
                right = self.right.look_apart(&view.1, &mut row.right, x, t, first_of_right);
            }
        }
    }
}

/// Two rows, and which of them matter in the present run of columns.
#[derive(Debug, Clone, Copy)]
pub struct BooleanRow<L, R> {
    left: L,
    right: R,
    asks_left: bool,
    asks_right: bool,
}

impl<L: Empty, R: Empty> Empty for BooleanRow<L, R> {
    const EMPTY: Self =
        Self { left: L::EMPTY, right: R::EMPTY, asks_left: false, asks_right: false };
}

/// The spans of a column, without asking for them where nothing can be seen.
#[inline]
pub(super) fn spans_inside<P, T: Scan<P>>(
    solid: &T,
    view: &T::View,
    row: &T::Row,
    column: Column,
    first: Face,
    stack: &mut SpanStack<'_, T::Scalar>,
) {
    if T::outlook(row, column.index).is_there {
        solid.spans_at(view, row, column, first, stack);
    }
}

macro_rules! operators {
    ($([$($generics:tt)*] $Solid:ty),+ $(,)?) => {$(
        impl<$($generics)*, Right> BitOr<Right> for $Solid {
            type Output = Union<Self, Right>;
            fn bitor(self, right: Right) -> Self::Output {
                Boolean::new(self, right)
            }
        }

        impl<$($generics)*, Right> BitAnd<Right> for $Solid {
            type Output = Intersection<Self, Right>;
            fn bitand(self, right: Right) -> Self::Output {
                Boolean::new(self, right)
            }
        }

        impl<$($generics)*, Right> Sub<Right> for $Solid {
            type Output = Difference<Self, Right>;
            fn sub(self, right: Right) -> Self::Output {
                Boolean::new(self, right)
            }
        }
    )+};
}

operators! {
    [S: Scalar] Cylinder<S>,
    [S: Scalar] Slab<S>,
    [S: Scalar] Sphere<S>,
    [T] Painted<T>,
    ['a, T: Shape] Placed<'a, T>,
    [O, L, R] Boolean<O, L, R>,
}
