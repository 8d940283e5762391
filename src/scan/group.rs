//! The walk along a ray through a group.

use super::active::{GroupRow, Member, NONE};
use super::stage::Scan;
use crate::span::walk::{Cold, Members, Path, Step, exit_of_union, step_of_union};
use crate::span::{Crossing, Face};

/// The active elements of a group, on one ray.
struct Active<'a, P, T: Scan<P>> {
    group: &'a mut GroupRow<[Member<T::Row>]>,
    solids: &'a [T],
    views: &'a [T::View],
    x: i32,
    first: Face,
}

impl<P, T: Scan<P>> Active<'_, P, T> {
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

impl<P, T: Scan<P>> Members<T::Scalar> for Active<'_, P, T> {
    fn is_single(&self) -> bool {
        let first = self.group.members.get(usize::from(self.group.active));
        first.is_some_and(|member| member.next == NONE)
    }

    #[inline(always)]
    fn unite<H: Path>(&mut self, t: T::Scalar) -> Step<T::Scalar> {
        if H::IS_COLD {
            self.group.unite_cold::<P, T>(self.solids, self.views, self.x, t, self.first)
        } else {
            self.unite_all::<H>(t)
        }
    }

    #[inline(always)]
    fn exit(&mut self, next: Crossing<T::Scalar>) -> Crossing<T::Scalar> {
        self.group.exit::<P, T>(self.solids, self.views, self.x, next, self.first)
    }
}

impl<R> GroupRow<[Member<R>]> {
    /// As [`Scan::contains`].
    #[inline(always)]
    pub(crate) fn contains<H: Path, P, T: Scan<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        x: i32,
        t: T::Scalar,
    ) -> bool {
        if H::IS_COLD {
            self.contains_cold::<P, T>(solids, views, x, t)
        } else {
            self.contains_in::<H, P, T>(solids, views, x, t)
        }
    }

    #[inline(never)]
    fn contains_cold<P, T: Scan<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        x: i32,
        t: T::Scalar,
    ) -> bool {
        self.contains_in::<Cold, P, T>(solids, views, x, t)
    }

    #[inline(always)]
    fn contains_in<H: Path, P, T: Scan<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        x: i32,
        t: T::Scalar,
    ) -> bool {
        let mut active = Active::<P, T> { group: self, solids, views, x, first: Face(0) };
        active.any(|_, solid, view, row| solid.contains::<H>(view, row, x, t))
    }

    /// As [`Scan::step`].
    #[inline(always)]
    pub(crate) fn step<H: Path, P, T: Scan<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        x: i32,
        t: T::Scalar,
        first: Face,
    ) -> Step<T::Scalar> {
        if H::IS_COLD {
            self.step_cold::<P, T>(solids, views, x, t, first)
        } else {
            step_of_union::<H, _>(&mut Active::<P, T> { group: self, solids, views, x, first }, t)
        }
    }

    #[inline(never)]
    fn step_cold<P, T: Scan<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        x: i32,
        t: T::Scalar,
        first: Face,
    ) -> Step<T::Scalar> {
        step_of_union::<Cold, _>(&mut Active::<P, T> { group: self, solids, views, x, first }, t)
    }

    #[inline(never)]
    fn unite_cold<P, T: Scan<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        x: i32,
        t: T::Scalar,
        first: Face,
    ) -> Step<T::Scalar> {
        Active::<P, T> { group: self, solids, views, x, first }.unite_all::<Cold>(t)
    }

    #[inline(never)]
    fn exit<P, T: Scan<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        x: i32,
        next: Crossing<T::Scalar>,
        first: Face,
    ) -> Crossing<T::Scalar> {
        exit_of_union(&mut Active::<P, T> { group: self, solids, views, x, first }, next)
    }
}
