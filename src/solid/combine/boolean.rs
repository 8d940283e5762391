//! Union, intersection and difference of two solids.

use crate::geom::{Line, Vec3};
use crate::scalar::Number;
use crate::scan::bounds::Bounds;
use crate::scan::{ColumnRun, Empty, Scan};
use crate::solid::{Rgb, Solid};
use crate::span::walk::{self, Operands, Path, Side, Step};
use crate::span::{Face, Operation, Shape, SpanStack};
use core::marker::PhantomData;

/// What is in the left solid, in the right one, or in both.
pub type Union<L, R> = Boolean<Either, L, R>;
/// What is in both solids.
pub type Intersection<L, R> = Boolean<Both, L, R>;
/// What is in the left solid but not in the right one.
pub type Difference<L, R> = Boolean<LeftOnly, L, R>;

/// The operation of a [`Union`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Either {}
/// The operation of an [`Intersection`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Both {}
/// The operation of a [`Difference`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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

    /// The first operand.
    #[must_use]
    pub const fn left(&self) -> &L {
        &self.left
    }

    /// The first operand, to change it: to move a part, say.
    #[must_use]
    pub const fn left_mut(&mut self) -> &mut L {
        &mut self.left
    }

    /// The second operand, to change it.
    #[must_use]
    pub const fn right_mut(&mut self) -> &mut R {
        &mut self.right
    }

    /// The second operand.
    #[must_use]
    pub const fn right(&self) -> &R {
        &self.right
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

impl<O: Rule, L: Solid, R: Solid<Scalar = L::Scalar>> Solid for Boolean<O, L, R> {
    fn spans(&self, line: &Line<L::Scalar>, first: Face, stack: &mut SpanStack<'_, L::Scalar>) {
        let left = stack.len();
        self.left.spans(line, first, stack);
        let right = stack.len();
        if left == right && O::OPERATION.needs_left() {
            return;
        }
        self.right.spans(line, first.offset(L::FACES), stack);
        stack.merge(O::OPERATION, left, right);
    }

    /// Those of an operand that the result lies in.
    fn bounds(&self) -> Bounds<Self::Scalar> {
        match (self.left.bounds(), O::OPERATION.needs_left(), O::CUTS) {
            (Bounds::Unbounded, true, false) => self.right.bounds(),
            (bounds, true, _) => bounds,
            _ => Bounds::Unbounded,
        }
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

/// The operands of a boolean operation, on one ray.
struct OnRay<'a, P, O, L: Scan<P>, R: Scan<P>> {
    solid: &'a Boolean<O, L, R>,
    view: &'a (L::View, R::View),
    row: &'a mut BooleanRow<L::Row, R::Row>,
    x: i32,
    first: Face,
}

impl<P, O, L, R> Operands<L::Scalar> for OnRay<'_, P, O, L, R>
where
    O: Rule,
    L: Scan<P>,
    R: Scan<P, Scalar = L::Scalar>,
{
    #[inline(always)]
    fn operation(&self) -> Operation {
        O::OPERATION
    }

    #[inline(always)]
    fn has(&self, side: Side) -> bool {
        match side {
            Side::Left => self.row.has_left,
            Side::Right => self.row.has_right,
        }
    }

    #[inline(always)]
    fn contains<H: Path>(&mut self, side: Side, t: L::Scalar) -> bool {
        let Self { solid, view: (left, right), row, x, .. } = self;
        match side {
            Side::Left => solid.left.contains::<H>(left, &mut row.left, *x, t),
            Side::Right => solid.right.contains::<H>(right, &mut row.right, *x, t),
        }
    }

    #[inline(always)]
    fn step<H: Path>(&mut self, side: Side, t: L::Scalar) -> Step<L::Scalar> {
        let Self { solid, view: (left, right), row, x, first } = self;
        match side {
            Side::Left => solid.left.step::<H>(left, &mut row.left, *x, t, *first),
            Side::Right => {
                solid.right.step::<H>(right, &mut row.right, *x, t, first.offset(L::FACES))
            }
        }
    }

    #[inline(always)]
    fn outlined<A, B>(self, with: A, ask: impl FnOnce(Self, A) -> B) -> B {
        let Self { solid, view, row, x, first } = self;
        outlined(solid, view, row, x, with, first, ask)
    }
}

/// A question out of line. The operands are arguments, not a struct in memory: so they stay in registers.
#[inline(never)]
fn outlined<'a, P, O, L: Scan<P>, R: Scan<P>, A, B>(
    solid: &'a Boolean<O, L, R>,
    view: &'a (L::View, R::View),
    row: &'a mut BooleanRow<L::Row, R::Row>,
    x: i32,
    with: A,
    first: Face,
    ask: impl FnOnce(OnRay<'a, P, O, L, R>, A) -> B,
) -> B {
    ask(OnRay { solid, view, row, x, first }, with)
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
        O::OPERATION.may_contain(left, right)
    }

    fn row(&self, (left, right): &Self::View, y: i32, columns: u32, row: &mut Self::Row) {
        self.left.row(left, y, columns, &mut row.left);
        self.right.row(right, y, columns, &mut row.right);
    }

    fn enter(row: &mut Self::Row, column: u32) -> ColumnRun {
        let left = L::enter(&mut row.left, column);
        row.has_left = left.is_visible;
        if !left.is_visible && O::OPERATION.needs_left() {
            return left;
        }
        let right = R::enter(&mut row.right, column);
        row.has_right = right.is_visible;
        let is_visible = O::OPERATION.may_contain(left.is_visible, right.is_visible);
        ColumnRun { is_visible, until: left.until.min(right.until) }
    }

    #[inline]
    fn contains<H: Path>(
        &self,
        view: &Self::View,
        row: &mut Self::Row,
        x: i32,
        t: Self::Scalar,
    ) -> bool {
        walk::contains::<H, _>(OnRay { solid: self, view, row, x, first: Face(0) }, t)
    }

    #[inline]
    fn step<H: Path>(
        &self,
        view: &Self::View,
        row: &mut Self::Row,
        x: i32,
        t: Self::Scalar,
        first: Face,
    ) -> Step<Self::Scalar> {
        walk::step::<H, _>(OnRay { solid: self, view, row, x, first }, t)
    }
}

/// Two rows, and which of them matter in the present run of columns.
#[derive(Debug, Clone, Copy)]
pub struct BooleanRow<L, R> {
    left: L,
    right: R,
    has_left: bool,
    has_right: bool,
}

impl<L: Empty, R: Empty> Empty for BooleanRow<L, R> {
    const EMPTY: Self = Self { left: L::EMPTY, right: R::EMPTY, has_left: false, has_right: false };
}
