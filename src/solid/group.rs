//! An array of one kind of solid is the union of its elements: a bolt circle, a box of balls.

use super::boolean::spans_inside;
use super::row::{Project, Row, View};
use super::{Rgb, Shape, Solid};
use crate::geom::{Column, Extent, Line, Vec3};
use crate::scalar::Scalar;
use crate::span::{Face, Operation, SpanStack};

const fn faces_of_group(count: usize, faces: u16) -> u16 {
    assert!(count > 0, "a group of solids needs at least one");
    assert!(count * faces as usize <= u16::MAX as usize, "the group has too many faces");
    count as u16 * faces
}

const fn stack_of_group(count: usize, spans: usize, stack: usize) -> usize {
    // Before the last element: the union of all others. Then the element's own work, or the
    // element's spans and the merged list.
    let merging = if count > 1 { spans + count * spans } else { spans };
    let others = count.saturating_sub(1) * spans;
    others + if stack > merging { stack } else { merging }
}

impl<T: Shape, const N: usize> Shape for [T; N] {
    type Scalar = T::Scalar;
    const SPANS: usize = {
        assert!(Self::FACES > 0);
        N * T::SPANS
    };
    const STACK: usize = stack_of_group(N, Self::SPANS / N, T::STACK);
    const FACES: u16 = faces_of_group(N, T::FACES);
}

/// The element that a face belongs to, and the face within that element.
fn element<T: Shape, const N: usize>(group: &[T; N], face: Face) -> Option<(&T, Face)> {
    let index = face.0.checked_div(T::FACES)?;
    Some((group.get(usize::from(index))?, Face(face.0 % T::FACES)))
}

/// Unites the spans that `push` gives for each of `count` elements.
fn unite<S: Scalar>(
    count: usize,
    faces: u16,
    first: Face,
    stack: &mut SpanStack<'_, S>,
    mut push: impl FnMut(usize, Face, &mut SpanStack<'_, S>),
) {
    let left = stack.len();
    let mut face = first;
    for index in 0..count {
        let right = stack.len();
        push(index, face, stack);
        stack.merge(Operation::UNION, left, right);
        face = face.offset(faces);
    }
}

impl<T: Solid, const N: usize> Solid for [T; N] {
    fn spans(
        &self,
        line: &Line<Self::Scalar>,
        first: Face,
        stack: &mut SpanStack<'_, Self::Scalar>,
    ) {
        unite(N, T::FACES, first, stack, |index, face, stack| {
            if let Some(solid) = self.get(index) {
                solid.spans(line, face, stack);
            }
        });
    }

    fn onto(&self, face: Face, near: Vec3<Self::Scalar>) -> Vec3<Self::Scalar> {
        element(self, face).map_or(near, |(solid, face)| solid.onto(face, near))
    }

    fn normal(&self, face: Face, at: Vec3<Self::Scalar>) -> Vec3<Self::Scalar> {
        element(self, face).map_or(Vec3::ZERO, |(solid, face)| solid.normal(face, at))
    }

    fn color(&self, face: Face) -> Option<Rgb> {
        element(self, face).and_then(|(solid, face)| solid.color(face))
    }
}

impl<P, T: Project<P>, const N: usize> Project<P> for [T; N] {
    type View<'a>
        = GroupView<T::View<'a>, N>
    where
        Self: 'a;

    fn view<'a>(&'a self, rays: &P) -> Self::View<'a> {
        GroupView(self.each_ref().map(|solid| solid.view(rays)))
    }
}

/// The views of a group.
#[derive(Debug, Clone, Copy)]
pub struct GroupView<V, const N: usize>([V; N]);

impl<V: View, const N: usize> View for GroupView<V, N> {
    type Scalar = V::Scalar;
    type Row<'a>
        = GroupRow<V::Row<'a>, N>
    where
        Self: 'a;

    fn row(&self, y: i32) -> Self::Row<'_> {
        let rows = self.0.each_ref().map(|view| view.row(y));
        let extent = rows.iter().fold(Extent::EMPTY, |all, row| all.hull(row.extent()));
        GroupRow { rows, extent }
    }
}

/// The rows of a group.
#[derive(Debug, Clone, Copy)]
pub struct GroupRow<R, const N: usize> {
    rows: [R; N],
    extent: Extent,
}

impl<R: Row, const N: usize> Row for GroupRow<R, N> {
    type Scalar = R::Scalar;
    const FACES: u16 = faces_of_group(N, R::FACES);

    fn extent(&self) -> Extent {
        self.extent
    }

    fn spans(&self, column: Column, first: Face, stack: &mut SpanStack<'_, R::Scalar>) {
        unite(N, R::FACES, first, stack, |index, face, stack| {
            if let Some(row) = self.rows.get(index) {
                spans_inside(row, column, face, stack);
            }
        });
    }
}
