//! The rows of a group's elements, and which of them matter.

use super::unite;
use crate::geom::Column;
use crate::scalar::Scalar;
use crate::solid::boolean::spans_inside;
use crate::solid::row::{Blank, Look, Outlook, Project};
use crate::span::{Crossing, Face, SpanStack};

/// The rows of a group, and which of them matter; `M` is an array of [`Member`]s, or a slice: what
/// isn't done for every pixel is compiled once for all lengths.
#[derive(Debug, Clone, Copy)]
pub struct GroupRow<M: ?Sized> {
    /// The columns from the one that was entered last to where anything changes.
    run: [u16; 2],
    /// The first element that the row can meet, and the first that the present run of columns can.
    first_of_row: u16,
    first_of_run: u16,
    members: M,
}

/// The row of an element, and which one of those that matter comes behind it; indices ascend. The
/// last one is followed by an index that no element has.
#[derive(Debug, Clone, Copy)]
pub struct Member<R> {
    row: R,
    next_of_row: u16,
    next_of_run: u16,
}

const NONE: u16 = u16::MAX;

impl<R: Blank> Blank for Member<R> {
    const BLANK: Self = Self { row: R::BLANK, next_of_row: 0, next_of_run: 0 };
}

impl<R: Blank, const N: usize> Blank for GroupRow<[Member<R>; N]> {
    const BLANK: Self =
        Self { run: [0; 2], first_of_row: 0, first_of_run: 0, members: [Member::BLANK; N] };
}

impl<R, const N: usize> GroupRow<[Member<R>; N]> {
    #[inline(always)]
    pub(in crate::solid) fn as_slice(&self) -> &GroupRow<[Member<R>]> {
        self
    }

    #[inline(always)]
    pub(in crate::solid) fn as_slice_mut(&mut self) -> &mut GroupRow<[Member<R>]> {
        self
    }
}

/// Gets all elements ready for a picture.
#[inline(never)]
pub(in crate::solid) fn view_each<P, T: Project<P>>(solids: &[T], rays: &P, views: &mut [T::View]) {
    for (solid, view) in solids.iter().zip(views) {
        solid.view(rays, view);
    }
}

impl<R> GroupRow<[Member<R>]> {
    #[inline(never)]
    pub(in crate::solid) fn set<P, T: Project<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        y: i32,
        columns: u32,
    ) {
        let mut last = NONE;
        self.first_of_row = NONE;
        self.run = [0; 2];
        for (index, (solid, view)) in (0..).zip(solids.iter().zip(views)) {
            let Some(member) = self.members.get_mut(usize::from(index)) else { break };
            solid.row(view, y, columns, &mut member.row);
            if T::outlook(&member.row, 0) != Outlook::EMPTY {
                member.next_of_row = NONE;
                match self.members.get_mut(usize::from(last)) {
                    Some(last) => last.next_of_row = index,
                    None => self.first_of_row = index,
                }
                last = index;
            }
        }
    }

    #[inline(never)]
    pub(in crate::solid) fn outlook<P, T: Project<P, Row = R>>(&self, column: u32) -> Outlook {
        let mut all = Outlook::EMPTY;
        let mut index = self.first_of_row;
        while let Some(member) = self.members.get(usize::from(index)) {
            let one = T::outlook(&member.row, column);
            all.is_there |= one.is_there;
            all.until = all.until.min(one.until);
            index = member.next_of_row;
        }
        all
    }

    #[inline(never)] // once a run
    pub(in crate::solid) fn enter<P, T: Project<P, Row = R>>(&mut self, column: u32) -> Outlook {
        let [from, until] = self.run.map(u32::from);
        if from <= column && column < until {
            let until = if until == u32::from(u16::MAX) { u32::MAX } else { until };
            return Outlook { is_there: self.first_of_run != NONE, until };
        }
        let all = self.find::<P, T>(column);
        self.run = [column as u16, u16::try_from(all.until).unwrap_or(u16::MAX)];
        all
    }

    #[inline(always)]
    fn find<P, T: Project<P, Row = R>>(&mut self, column: u32) -> Outlook {
        let mut all = Outlook::EMPTY;
        let (mut index, mut last) = (self.first_of_row, NONE);
        self.first_of_run = NONE;
        while let Some(member) = self.members.get_mut(usize::from(index)) {
            let one = T::enter(&mut member.row, column);
            let next = member.next_of_row;
            all.until = all.until.min(one.until);
            if one.is_there {
                all.is_there = true;
                member.next_of_run = NONE;
                match self.members.get_mut(usize::from(last)) {
                    Some(last) => last.next_of_run = index,
                    None => self.first_of_run = index,
                }
                last = index;
            }
            index = next;
        }
        all
    }

    pub(in crate::solid) fn spans<P, T: Project<P, Row = R>>(
        &self,
        solids: &[T],
        views: &[T::View],
        column: Column,
        first: Face,
        stack: &mut SpanStack<'_, T::Scalar>,
    ) {
        unite(solids.len(), T::FACES, first, stack, |index, face, stack| {
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
    fn ask_each<P, T: Project<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        mut ask: impl FnMut(u16, &T, &T::View, &mut R) -> bool,
    ) -> bool {
        let mut index = self.first_of_run;
        while let Some(member) = self.members.get_mut(usize::from(index)) {
            let element = usize::from(index);
            if let (Some(solid), Some(view)) = (solids.get(element), views.get(element))
                && ask(index, solid, view, &mut member.row)
            {
                return true;
            }
            index = member.next_of_run;
        }
        false
    }

    #[inline(always)]
    pub(in crate::solid) fn holds<P, T: Project<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        x: i32,
        t: T::Scalar,
    ) -> bool {
        self.ask_each::<P, T>(solids, views, |_, solid, view, row| solid.holds(view, row, x, t))
    }

    #[inline(never)]
    pub(in crate::solid) fn holds_apart<P, T: Project<P, Row = R>>(
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
    pub(in crate::solid) fn look<P, T: Project<P, Row = R>>(
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
    pub(in crate::solid) fn look_apart<P, T: Project<P, Row = R>>(
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
    fn look_at_each<P, T: Project<P, Row = R>>(
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
    fn exit<P, T: Project<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        x: i32,
        mut next: Crossing<T::Scalar>,
        first: Face,
    ) -> Crossing<T::Scalar> {
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
