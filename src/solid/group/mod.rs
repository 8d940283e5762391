//! An array of one kind of solid is the union of its elements: a bolt circle, a box of balls.

mod lists;
mod row;

pub(super) use lists::{GroupRow, Member, view_each};

use super::{Rgb, Shape, Solid};
use crate::geom::{Line, Vec3};
use crate::scalar::{Number, Scalar};
use crate::span::{Face, Operation, SpanStack};

pub(super) const fn faces_of_group(count: usize, faces: u16) -> u16 {
    assert!(count > 0, "a group of solids needs at least one");
    assert!(count * (faces as usize) < u16::MAX as usize, "the group has too many faces");
    count as u16 * faces
}

pub(super) const fn stack_of_group(count: usize, spans: usize, stack: usize) -> usize {
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

/// Unites the spans that `push` gives for each of some elements, in ascending order.
pub(super) fn unite<S: Scalar>(
    indices: impl Iterator<Item = u16>,
    faces: u16,
    first: Face,
    stack: &mut SpanStack<'_, S>,
    mut push: impl FnMut(usize, Face, &mut SpanStack<'_, S>),
) {
    let left = stack.len();
    for index in indices {
        let right = stack.len();
        push(index.into(), first.offset(index * faces), stack);
        stack.merge(Operation::UNION, left, right);
    }
}

impl<T: Solid, const N: usize> Solid for [T; N] {
    fn spans(
        &self,
        line: &Line<Self::Scalar>,
        first: Face,
        stack: &mut SpanStack<'_, Self::Scalar>,
    ) {
        unite(0..N as u16, T::FACES, first, stack, |index, face, stack| {
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

    #[inline]
    fn cosine(
        &self,
        face: Face,
        at: impl FnOnce() -> Vec3<Self::Scalar>,
        to: Vec3<Self::Scalar>,
    ) -> Self::Scalar {
        element(self, face).map_or(T::Scalar::ZERO, |(solid, face)| solid.cosine(face, at, to))
    }

    fn color(&self, face: Face) -> Option<Rgb> {
        element(self, face).and_then(|(solid, face)| solid.color(face))
    }
}

/// [`Scan`] for what has up to `N` elements of one kind: those that `items` gives.
macro_rules! project_as_group {
    ($Group:ty, $items:ident) => {
        impl<P, T: $crate::solid::Scan<P>, const N: usize> $crate::solid::Scan<P> for $Group {
            type View = [T::View; N];
            type Row = $crate::solid::group::GroupRow<[$crate::solid::group::Member<T::Row>; N]>;

            fn view(&self, rays: &P, view: &mut Self::View) {
                $crate::solid::group::view_each(self.$items(), rays, view);
            }

            fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) {
                row.as_slice_mut().set::<P, T>(self.$items(), view, y, columns);
            }

            fn outlook(row: &Self::Row, column: u32) -> $crate::solid::Outlook {
                row.as_slice().outlook::<P, T>(column)
            }

            fn enter(row: &mut Self::Row, column: u32) -> $crate::solid::Outlook {
                row.as_slice_mut().enter::<P, T>(column)
            }

            fn spans_at(
                &self,
                view: &Self::View,
                row: &Self::Row,
                column: $crate::geom::Column,
                first: Face,
                stack: &mut SpanStack<'_, Self::Scalar>,
            ) {
                row.as_slice().spans::<P, T>(self.$items(), view, column, first, stack);
            }

            #[inline]
            fn holds(
                &self,
                view: &Self::View,
                row: &mut Self::Row,
                x: i32,
                t: Self::Scalar,
            ) -> bool {
                row.as_slice_mut().holds::<P, T>(self.$items(), view, x, t)
            }

            #[inline]
            fn look(
                &self,
                view: &Self::View,
                row: &mut Self::Row,
                x: i32,
                t: Self::Scalar,
                first: Face,
            ) -> $crate::solid::Look<Self::Scalar> {
                row.as_slice_mut().look::<P, T>(self.$items(), view, x, t, first)
            }

            fn holds_apart(
                &self,
                view: &Self::View,
                row: &mut Self::Row,
                x: i32,
                t: Self::Scalar,
            ) -> bool {
                row.as_slice_mut().holds_apart::<P, T>(self.$items(), view, x, t)
            }

            fn look_apart(
                &self,
                view: &Self::View,
                row: &mut Self::Row,
                x: i32,
                t: Self::Scalar,
                first: Face,
            ) -> $crate::solid::Look<Self::Scalar> {
                row.as_slice_mut().look_apart::<P, T>(self.$items(), view, x, t, first)
            }
        }
    };
}

project_as_group!([T; N], as_slice);

pub(super) use project_as_group;
