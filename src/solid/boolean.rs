//! Union, intersection and difference of two solids, and the operators `|`, `&` and `-`.

use super::row::{Project, Row, View};
use super::{Cylinder, Painted, Placed, Rgb, Shape, Slab, Solid, Sphere};
use crate::geom::{Column, Extent, Line, Vec3};
use crate::scalar::Scalar;
use crate::span::{Face, Operation, SpanStack};
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

    fn color(&self, face: Face) -> Option<Rgb> {
        match operand::<L>(face) {
            Ok(face) => self.left.color(face),
            Err(face) => self.right.color(face),
        }
    }
}

impl<P, O: Rule, L: Project<P>, R: Project<P, Scalar = L::Scalar>> Project<P> for Boolean<O, L, R> {
    type View<'a>
        = BooleanView<O, L::View<'a>, R::View<'a>>
    where
        Self: 'a;

    fn view<'a>(&'a self, rays: &P) -> Self::View<'a> {
        BooleanView(Boolean::new(self.left.view(rays), self.right.view(rays)))
    }
}

/// Two views and what to do with them.
#[derive(Debug, Clone, Copy)]
pub struct BooleanView<O, L, R>(Boolean<O, L, R>);

impl<O: Rule, L: View, R: View<Scalar = L::Scalar>> View for BooleanView<O, L, R> {
    type Scalar = L::Scalar;
    type Row<'a>
        = BooleanRow<O, L::Row<'a>, R::Row<'a>>
    where
        Self: 'a;

    fn row(&self, y: i32) -> Self::Row<'_> {
        let (left, right) = (self.0.left.row(y), self.0.right.row(y));
        let extent = if !O::OPERATION.needs_left() {
            left.extent().hull(right.extent())
        } else if O::CUTS {
            left.extent()
        } else {
            left.extent().overlap(right.extent())
        };
        BooleanRow { operands: Boolean::new(left, right), extent }
    }
}

/// Two rows and what to do with them.
#[derive(Debug, Clone, Copy)]
pub struct BooleanRow<O, L, R> {
    operands: Boolean<O, L, R>,
    extent: Extent,
}

impl<O: Rule, L: Row, R: Row<Scalar = L::Scalar>> Row for BooleanRow<O, L, R> {
    type Scalar = L::Scalar;
    const FACES: u16 = L::FACES + R::FACES;

    fn extent(&self) -> Extent {
        self.extent
    }

    fn spans(&self, column: Column, first: Face, stack: &mut SpanStack<'_, L::Scalar>) {
        let Boolean { left, right, .. } = &self.operands;
        combine(
            O::OPERATION,
            stack,
            |stack| spans_inside(left, column, first, stack),
            |stack| spans_inside(right, column, first.offset(L::FACES), stack),
        );
    }
}

/// The spans of a row, without asking it outside of its extent.
#[inline]
pub(super) fn spans_inside<R: Row>(
    row: &R,
    column: Column,
    first: Face,
    stack: &mut SpanStack<'_, R::Scalar>,
) {
    if row.extent().contains(column.index) {
        row.spans(column, first, stack);
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
    [S] Sphere<S>,
    [T] Painted<T>,
    ['a, T: Shape] Placed<'a, T>,
    [O, L, R] Boolean<O, L, R>,
}
