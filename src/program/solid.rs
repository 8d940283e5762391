//! What a program says of itself.

use super::build::Program;
use super::tree::Fold;
use crate::geom::{Line, Vec3};
use crate::scalar::Number;
use crate::solid::{Bounds, Rgb, Solid, operators};
use crate::span::{Face, Operation, Shape, SpanStack, StackFull, merge};

impl<L: Shape, const PARTS: usize, const POSES: usize, const SPANS: usize, const POOL: usize> Shape
    for Program<L, PARTS, POSES, SPANS, POOL>
{
    type Scalar = L::Scalar;
    const SPANS: usize = SPANS;
    const FACES: u16 = PARTS as u16 * L::FACES;
}

/// The lists of spans of a line: each value is where a list begins.
struct Lists<'s, 'l, S, F> {
    stack: &'s mut SpanStack<'l, S>,
    push: F,
    is_full: bool,
}

impl<S: crate::scalar::Scalar, F> Fold<u16> for Lists<'_, '_, S, F>
where
    F: FnMut(u16, &mut SpanStack<'_, S>) -> Result<(), StackFull>,
{
    fn leaf(&mut self, index: u16) -> u16 {
        let start = self.stack.len() as u16;
        self.is_full |= !self.is_full && (self.push)(index, self.stack).is_err();
        start
    }

    fn combine(&mut self, operation: Operation, left: u16, right: u16) -> u16 {
        let [from, to] = [left, right].map(usize::from);
        self.is_full |= !self.is_full && merge(operation, self.stack, from, to).is_err();
        left
    }

    fn is_nothing(&self, start: u16) -> bool {
        self.stack.len() == usize::from(start)
    }
}

/// Bounds of the parts, and those of an operand that the result lies in.
struct PartBounds<'a, P>(&'a P);

impl<L: Solid, const PARTS: usize, const POSES: usize, const SPANS: usize, const POOL: usize>
    Fold<Bounds<L::Scalar>> for PartBounds<'_, Program<L, PARTS, POSES, SPANS, POOL>>
{
    fn leaf(&mut self, index: u16) -> Bounds<L::Scalar> {
        let part = self.0.in_place(index.into());
        part.map_or(Bounds::Unbounded, |(part, _)| part.bounds())
    }

    fn combine(
        &mut self,
        operation: Operation,
        left: Bounds<L::Scalar>,
        right: Bounds<L::Scalar>,
    ) -> Bounds<L::Scalar> {
        match left {
            _ if !operation.needs_left() => left.united(&right),
            Bounds::Unbounded if operation == Operation::INTERSECTION => right,
            _ => left,
        }
    }
}

impl<L: Solid, const PARTS: usize, const POSES: usize, const SPANS: usize, const POOL: usize>
    Program<L, PARTS, POSES, SPANS, POOL>
{
    /// Pushes the spans of a line; none if there is no room for them.
    pub(super) fn push_spans(
        &self,
        line: &Line<L::Scalar>,
        first: Face,
        stack: &mut SpanStack<'_, L::Scalar>,
    ) -> Result<(), StackFull> {
        let start = stack.len();
        let push = |index: u16, stack: &mut SpanStack<'_, L::Scalar>| {
            // Solids don't say when they have no room.
            if stack.room() < L::STACK {
                return Err(StackFull);
            }
            if let Some((part, _)) = self.in_place(index.into()) {
                part.spans(line, first.offset(index * L::FACES), stack);
            }
            Ok(())
        };
        let mut lists = Lists { stack, push, is_full: false };
        self.tree().fold(&mut [0; PARTS], &mut lists);
        if lists.is_full {
            stack.truncate(start);
            return Err(StackFull);
        }
        Ok(())
    }

    /// The part that a face belongs to, whether it is cut away, and the face within the part.
    fn part_of(&self, face: Face) -> Option<(impl Solid<Scalar = L::Scalar>, bool, Face)> {
        let index = face.0.checked_div(L::FACES)?;
        let (part, is_cut) = self.in_place(index.into())?;
        Some((part, is_cut, Face(face.0 % L::FACES)))
    }
}

impl<L: Solid, const PARTS: usize, const POSES: usize, const SPANS: usize, const POOL: usize> Solid
    for Program<L, PARTS, POSES, SPANS, POOL>
{
    /// Of a line with more spans than there is room for, none.
    fn spans(&self, line: &Line<L::Scalar>, first: Face, stack: &mut SpanStack<'_, L::Scalar>) {
        let _ = self.push_spans(line, first, stack);
    }

    fn bounds(&self) -> Bounds<L::Scalar> {
        let mut stack = [Bounds::Unbounded; PARTS];
        self.tree().fold(&mut stack, &mut PartBounds(self));
        stack.first().copied().unwrap_or(Bounds::Unbounded)
    }

    fn normal(&self, face: Face, at: Vec3<L::Scalar>) -> Vec3<L::Scalar> {
        let Some((part, is_cut, face)) = self.part_of(face) else { return Vec3::ZERO };
        let normal = part.normal(face, at);
        if is_cut { -normal } else { normal }
    }

    fn onto(&self, face: Face, near: Vec3<L::Scalar>) -> Vec3<L::Scalar> {
        self.part_of(face).map_or(near, |(part, _, face)| part.onto(face, near))
    }

    #[inline]
    fn cosine(
        &self,
        face: Face,
        at: impl FnOnce() -> Vec3<L::Scalar>,
        to: Vec3<L::Scalar>,
    ) -> L::Scalar {
        let Some((part, is_cut, face)) = self.part_of(face) else { return L::Scalar::ZERO };
        let cosine = part.cosine(face, at, to);
        if is_cut { cosine.negated() } else { cosine }
    }

    fn color(&self, face: Face) -> Option<Rgb> {
        self.part_of(face).and_then(|(part, _, face)| part.color(face))
    }
}

operators! {
    [L: Shape, const PARTS: usize, const POSES: usize, const SPANS: usize, const POOL: usize]
    Program<L, PARTS, POSES, SPANS, POOL>,
}
