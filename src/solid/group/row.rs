//! The walk along a ray through a group.

use super::lists::{GroupRow, Member, NONE};
use super::unite;
use crate::geom::Column;
use crate::scalar::Scalar;
use crate::solid::boolean::spans_inside;
use crate::solid::row::{Look, Scan};
use crate::span::{Crossing, Face, SpanStack};

impl<R> GroupRow<[Member<R>]> {
    pub(in crate::solid) fn spans<P, T: Scan<P, Row = R>>(
        &self,
        solids: &[T],
        views: &[T::View],
        column: Column,
        first: Face,
        stack: &mut SpanStack<'_, T::Scalar>,
    ) {
        unite(self.all_near(), T::FACES, first, stack, |index, face, stack| {
            if let (Some(solid), Some(view), Some(member)) =
                (solids.get(index), views.get(index), self.members.get(index))
            {
                spans_inside(solid, view, &member.row, column, face, stack);
            }
        });
    }

    /// Calls `ask` with every element that matters in the present run of columns, and its index,
    /// until it says that this is enough.
    #[inline(always)]
    fn ask_each<P, T: Scan<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        mut ask: impl FnMut(u16, &T, &T::View, &mut R) -> bool,
    ) -> bool {
        let mut index = self.first;
        while let Some(member) = self.members.get_mut(usize::from(index)) {
            let element = usize::from(index);
            if let (Some(solid), Some(view)) = (solids.get(element), views.get(element))
                && ask(index, solid, view, &mut member.row)
            {
                return true;
            }
            index = member.next;
        }
        false
    }

    #[inline(always)]
    pub(in crate::solid) fn holds<P, T: Scan<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        x: i32,
        t: T::Scalar,
    ) -> bool {
        self.ask_each::<P, T>(solids, views, |_, solid, view, row| solid.holds(view, row, x, t))
    }

    #[inline(never)]
    pub(in crate::solid) fn holds_apart<P, T: Scan<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        x: i32,
        t: T::Scalar,
    ) -> bool {
        self.ask_each::<P, T>(solids, views, |_, solid, view, row| {
            solid.holds_apart(view, row, x, t)
        })
    }

    #[inline(always)]
    pub(in crate::solid) fn look<P, T: Scan<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        x: i32,
        t: T::Scalar,
        first: Face,
    ) -> Look<T::Scalar> {
        let mut all = Look::EMPTY;
        self.ask_each::<P, T>(solids, views, |index, solid, view, row| {
            all.add(solid.look(view, row, x, t, first.offset(index * T::FACES)))
        });
        // From outside of all elements, the first that is entered decides.
        if all.inside {
            return Look { next: self.exit(solids, views, x, all.next, first), ..all };
        }
        all
    }

    #[inline(never)]
    pub(in crate::solid) fn look_apart<P, T: Scan<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        x: i32,
        t: T::Scalar,
        first: Face,
    ) -> Look<T::Scalar> {
        let all = self.look_at_each(solids, views, x, t, first);
        if all.inside {
            return Look { next: self.exit(solids, views, x, all.next, first), ..all };
        }
        all
    }

    /// Whether a ray is inside of any element, and the first crossing of one.
    #[inline(never)]
    fn look_at_each<P, T: Scan<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        x: i32,
        t: T::Scalar,
        first: Face,
    ) -> Look<T::Scalar> {
        let mut all = Look::EMPTY;
        self.ask_each::<P, T>(solids, views, |index, solid, view, row| {
            all.add(solid.look_apart(view, row, x, t, first.offset(index * T::FACES)))
        });
        all
    }

    /// The first crossing from `next` on behind which a ray is outside of all elements.
    #[inline(never)]
    fn exit<P, T: Scan<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        x: i32,
        mut next: Crossing<T::Scalar>,
        first: Face,
    ) -> Crossing<T::Scalar> {
        // What is left of the only element is left of all.
        let first_of_run = self.members.get(usize::from(self.first));
        if first_of_run.is_some_and(|member| member.next == NONE) {
            return next;
        }
        while next.t < T::Scalar::HIGHEST {
            let all = self.look_at_each(solids, views, x, next.t, first);
            if !all.inside {
                break;
            }
            next = all.next;
        }
        next
    }
}

impl<S: Scalar> Look<S> {
    /// Of two solids, whether a ray is inside of either, and the first crossing.
    #[inline(always)]
    fn add(&mut self, one: Self) -> bool {
        self.inside |= one.inside;
        if one.next.t < self.next.t {
            self.next = one.next;
        }
        false
    }
}
