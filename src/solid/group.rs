//! An array of one kind of solid is the union of its elements: a bolt circle, a box of balls.

use super::boolean::spans_inside;
use super::row::{Blank, Look, Outlook, Project, look_apart};
use super::{Rgb, Shape, Solid};
use crate::geom::{Column, Line, Vec3};
use crate::scalar::Scalar;
use crate::span::{Crossing, Face, Operation, SpanStack};

pub(super) const fn faces_of_group(count: usize, faces: u16) -> u16 {
    assert!(count > 0, "a group of solids needs at least one");
    assert!(count * faces as usize <= u16::MAX as usize, "the group has too many faces");
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

/// Unites the spans that `push` gives for each of `count` elements.
pub(super) fn unite<S: Scalar>(
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

/// [`Project`] for what has up to `N` elements of one kind: those that `items` gives.
macro_rules! project_as_group {
    ($Group:ty, $items:ident) => {
        impl<P, T: $crate::solid::Project<P>, const N: usize> $crate::solid::Project<P> for $Group {
            type View = [T::View; N];
            type Row = $crate::solid::group::GroupRow<T::Row, N>;

            fn view(&self, rays: &P, view: &mut Self::View) {
                for (solid, view) in self.$items().iter().zip(view) {
                    solid.view(rays, view);
                }
            }

            fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) {
                row.set::<P, T>(self.$items(), view, y, columns);
            }

            fn outlook(row: &Self::Row, column: u32) -> $crate::solid::Outlook {
                row.outlook::<P, T>(column)
            }

            fn enter(row: &mut Self::Row, column: u32) -> $crate::solid::Outlook {
                row.enter::<P, T>(column)
            }

            fn spans_at(
                &self,
                view: &Self::View,
                row: &Self::Row,
                column: $crate::geom::Column,
                first: Face,
                stack: &mut SpanStack<'_, Self::Scalar>,
            ) {
                row.spans::<P, T>(self.$items(), view, column, first, stack);
            }

            #[inline]
            fn holds(
                &self,
                view: &Self::View,
                row: &mut Self::Row,
                x: i32,
                t: Self::Scalar,
            ) -> bool {
                row.holds::<P, T>(self.$items(), view, x, t)
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
                row.look::<P, T>(self.$items(), view, x, t, first)
            }
        }
    };
}

project_as_group!([T; N], as_slice);

pub(super) use project_as_group;

/// The rows of a group, and which of them matter.
#[derive(Debug, Clone, Copy)]
pub struct GroupRow<R, const N: usize> {
    elements: [R; N],
    /// The elements that the row can meet, in ascending order: the first `in_row`.
    of_row: [u16; N],
    /// Those of them that the present run of columns can meet: the first `in_run`.
    of_run: [u16; N],
    in_row: u16,
    in_run: u16,
}

impl<R: Blank, const N: usize> Blank for GroupRow<R, N> {
    const BLANK: Self =
        Self { elements: [R::BLANK; N], of_row: [0; N], of_run: [0; N], in_row: 0, in_run: 0 };
}

impl<R, const N: usize> GroupRow<R, N> {
    pub(super) fn set<P, T: Project<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        y: i32,
        columns: u32,
    ) {
        self.in_row = 0;
        for ((index, solid), (view, element)) in
            (0..).zip(solids).zip(views.iter().zip(&mut self.elements))
        {
            solid.row(view, y, columns, element);
            if T::outlook(element, 0) != Outlook::EMPTY {
                put(&mut self.of_row, &mut self.in_row, index);
            }
        }
    }

    #[inline(never)]
    pub(super) fn outlook<P, T: Project<P, Row = R>>(&self, column: u32) -> Outlook {
        let mut all = Outlook::EMPTY;
        for element in listed(&self.of_row, self.in_row) {
            if let Some(element) = self.elements.get(usize::from(*element)) {
                let one = T::outlook(element, column);
                all.is_there |= one.is_there;
                all.until = all.until.min(one.until);
            }
        }
        all
    }

    #[inline(never)] // once a run
    pub(super) fn enter<P, T: Project<P, Row = R>>(&mut self, column: u32) -> Outlook {
        let mut all = Outlook::EMPTY;
        self.in_run = 0;
        for &index in listed(&self.of_row, self.in_row) {
            if let Some(element) = self.elements.get_mut(usize::from(index)) {
                let one = T::enter(element, column);
                all.until = all.until.min(one.until);
                if one.is_there {
                    all.is_there = true;
                    put(&mut self.of_run, &mut self.in_run, index);
                }
            }
        }
        all
    }

    pub(super) fn spans<P, T: Project<P, Row = R>>(
        &self,
        solids: &[T],
        views: &[T::View],
        column: Column,
        first: Face,
        stack: &mut SpanStack<'_, T::Scalar>,
    ) {
        unite(solids.len(), T::FACES, first, stack, |index, face, stack| {
            if let (Some(solid), Some(view), Some(row)) =
                (solids.get(index), views.get(index), self.elements.get(index))
            {
                spans_inside(solid, view, row, column, face, stack);
            }
        });
    }

    #[inline]
    pub(super) fn holds<P, T: Project<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        x: i32,
        t: T::Scalar,
    ) -> bool {
        listed(&self.of_run, self.in_run).iter().any(|&index| {
            let index = usize::from(index);
            match (solids.get(index), views.get(index), self.elements.get_mut(index)) {
                (Some(solid), Some(view), Some(row)) => solid.holds(view, row, x, t),
                _ => false,
            }
        })
    }

    #[inline]
    pub(super) fn look<P, T: Project<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        x: i32,
        t: T::Scalar,
        first: Face,
    ) -> Look<T::Scalar> {
        let mut all = Look::EMPTY;
        for &index in listed(&self.of_run, self.in_run) {
            let element = usize::from(index);
            if let (Some(solid), Some(view), Some(row)) =
                (solids.get(element), views.get(element), self.elements.get_mut(element))
            {
                let one = solid.look(view, row, x, t, first.offset(index * T::FACES));
                all.inside |= one.inside;
                if one.next.t < all.next.t {
                    all.next = one.next;
                }
            }
        }
        // From outside of all elements, the first that is entered decides.
        if all.inside {
            return Look { next: self.exit(solids, views, x, all.next, first), ..all };
        }
        all
    }

    /// The first crossing from `next` on behind which a ray is outside of all elements.
    #[inline(never)]
    fn exit<P, T: Project<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        x: i32,
        mut next: Crossing<T::Scalar>,
        first: Face,
    ) -> Crossing<T::Scalar> {
        while next.t < T::Scalar::HIGHEST {
            let mut all = Look::EMPTY;
            for &index in listed(&self.of_run, self.in_run) {
                let element = usize::from(index);
                if let (Some(solid), Some(view), Some(row)) =
                    (solids.get(element), views.get(element), self.elements.get_mut(element))
                {
                    let face = first.offset(index * T::FACES);
                    let one = look_apart(solid, view, row, x, next.t, face);
                    all.inside |= one.inside;
                    if one.next.t < all.next.t {
                        all.next = one.next;
                    }
                }
            }
            if !all.inside {
                break;
            }
            next = all.next;
        }
        next
    }
}

/// The indices of a list that has so many.
#[inline(always)]
fn listed(list: &[u16], count: u16) -> &[u16] {
    list.get(..usize::from(count)).unwrap_or(list)
}

/// Puts an index behind the first `count` of a list that has room for all there are.
#[inline]
fn put(list: &mut [u16], count: &mut u16, index: u16) {
    if let Some(place) = list.get_mut(usize::from(*count)) {
        *place = index;
        *count += 1;
    }
}
