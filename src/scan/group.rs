//! The walk along a ray through a group.

use super::active::{GroupRow, Member, NONE};
use super::stage::Scan;
use crate::span::Face;
use crate::span::walk::{Cold, Members, Path, Step, step_of_union};

/// The active elements of a group, on one ray.
pub(crate) struct Active<'a, P, T: Scan<P>> {
    pub(crate) group: &'a mut GroupRow<[Member<T::Row>]>,
    pub(crate) solids: &'a [T],
    pub(crate) views: &'a [T::View],
    pub(crate) x: i32,
    pub(crate) first: Face,
}

impl<P, T: Scan<P>> Active<'_, P, T> {
    /// As [`Scan::contains`].
    #[inline(always)]
    pub(crate) fn contains<H: Path>(mut self, t: T::Scalar) -> bool {
        if H::IS_COLD {
            self.outlined(t, |mut active, t| active.any_contains::<Cold>(t))
        } else {
            self.any_contains::<H>(t)
        }
    }

    /// As [`Scan::step`].
    #[inline(always)]
    pub(crate) fn step<H: Path>(self, t: T::Scalar) -> Step<T::Scalar> {
        if H::IS_COLD {
            self.outlined(t, step_of_union::<Cold, _>)
        } else {
            step_of_union::<H, _>(self, t)
        }
    }

    /// Calls `ask` with every active element and its index, until it says that this is enough.
    #[inline(always)]
    fn any(&mut self, mut ask: impl FnMut(u16, &T, &T::View, &mut T::Row) -> bool) -> bool {
        let mut index = self.group.active;
        while let Some(member) = self.group.members.get_mut(usize::from(index)) {
            let element = usize::from(index);
            if let (Some(solid), Some(view)) = (self.solids.get(element), self.views.get(element))
                && ask(index, solid, view, &mut member.row)
            {
                return true;
            }
            index = member.next;
        }
        false
    }

    #[inline(always)]
    fn any_contains<H: Path>(&mut self, t: T::Scalar) -> bool {
        let x = self.x;
        self.any(|_, solid, view, row| solid.contains::<H>(view, row, x, t))
    }

    #[inline(always)]
    fn unite_all<H: Path>(&mut self, t: T::Scalar) -> Step<T::Scalar> {
        let (x, first) = (self.x, self.first);
        let mut all = Step::OUTSIDE;
        self.any(|index, solid, view, row| {
            all.unite(solid.step::<H>(view, row, x, t, first.offset(index * T::FACES)));
            false
        });
        all
    }
}

/// A question out of line. The elements are arguments, not a struct in memory: so they stay in registers.
#[inline(never)]
fn outlined<'a, P, T: Scan<P>, A, B>(
    group: &'a mut GroupRow<[Member<T::Row>]>,
    solids: &'a [T],
    views: &'a [T::View],
    x: i32,
    with: A,
    first: Face,
    ask: impl FnOnce(Active<'a, P, T>, A) -> B,
) -> B {
    ask(Active { group, solids, views, x, first }, with)
}

impl<P, T: Scan<P>> Members<T::Scalar> for Active<'_, P, T> {
    fn is_single(&self) -> bool {
        let first = self.group.members.get(usize::from(self.group.active));
        first.is_some_and(|member| member.next == NONE)
    }

    #[inline(always)]
    fn unite<H: Path>(&mut self, t: T::Scalar) -> Step<T::Scalar> {
        if H::IS_COLD {
            let unite = |mut active: Active<'_, P, T>, t| active.unite_all::<Cold>(t);
            outlined(self.group, self.solids, self.views, self.x, t, self.first, unite)
        } else {
            self.unite_all::<H>(t)
        }
    }

    #[inline(always)]
    fn outlined<A, B>(self, with: A, ask: impl FnOnce(Self, A) -> B) -> B {
        outlined(self.group, self.solids, self.views, self.x, with, self.first, ask)
    }
}
