//! The rows of a group's elements, and which of them matter.

use crate::solid::row::{Blank, Outlook, Project};

/// The rows of a group, and which of them matter; `M` is an array of [`Member`]s, or a slice: what
/// isn't done for every pixel is compiled once for all lengths.
#[derive(Debug, Clone, Copy)]
pub struct GroupRow<M: ?Sized> {
    /// The columns from the one that was entered to where anything changes.
    run: [u16; 2],
    /// The first element that can be seen in this run, in the order of their indices.
    pub(super) first: u16,
    /// The first of the others that later columns can, in the order of these columns.
    coming: u16,
    /// The block of rows that was asked for last, 0 for none, and how many elements can be seen there.
    block: u16,
    near: u16,
    pub(super) members: M,
}

/// The row of an element, the column in which that changes, and the element behind it in its list.
/// The last one is followed by an index that no element has.
#[derive(Debug, Clone, Copy)]
pub struct Member<R> {
    pub(super) row: R,
    until: u16,
    pub(super) next: u16,
    /// Not of this element, but of a list of those that may be seen in the block of rows: an index.
    near: u16,
}

/// So many rows make a block, as a power of two.
const ROWS: u32 = 3;
/// The number of the block below the middle of the picture.
const MIDDLE: i32 = 1 << 14;

/// No element has this index.
pub(super) const NONE: u16 = u16::MAX;

impl<R: Blank> Blank for Member<R> {
    const BLANK: Self = Self { row: R::BLANK, until: 0, next: 0, near: 0 };
}

impl<R: Blank, const N: usize> Blank for GroupRow<[Member<R>; N]> {
    const BLANK: Self =
        Self { run: [0; 2], first: 0, coming: 0, block: 0, near: 0, members: [Member::BLANK; N] };
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
        self.clear();
        let block = y >> (ROWS + 1); // of half pixels
        let number = (MIDDLE + block) as u16;
        if self.block != number {
            self.block = number;
            self.look_around::<P, T>(solids, views, block);
        }
        for place in 0..self.near.into() {
            let Some(index) = self.members.get(place).map(|member| member.near) else { break };
            let element = usize::from(index);
            let (Some(solid), Some(view), Some(member)) =
                (solids.get(element), views.get(element), self.members.get_mut(element))
            else {
                break;
            };
            solid.row(view, y, columns, &mut member.row);
            let outlook = T::outlook(&member.row, 0);
            self.await_first(index, outlook);
        }
    }

    /// Lists the elements that may be seen in a block of rows.
    #[inline(never)] // seldom
    fn look_around<P, T: Project<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        block: i32,
    ) {
        let first = block << (ROWS + 1);
        let rows = [first, first + (2 << ROWS) - 1];
        self.near = 0;
        for (index, (solid, view)) in solids.iter().zip(views).enumerate().rev() {
            if solid.is_in_rows(view, rows)
                && let Some(member) = self.members.get_mut(usize::from(self.near))
            {
                member.near = index as u16;
                self.near += 1;
            }
        }
    }

    /// The indices of elements that may be seen in the block of rows, ascending.
    pub(super) fn all_near(&self) -> impl Iterator<Item = u16> {
        (0..usize::from(self.near)).rev().filter_map(|place| Some(self.members.get(place)?.near))
    }

    /// An element that may be seen in the block of rows, and its index, which descend: so that columns
    /// mostly do, too.
    #[inline]
    fn near(&self, place: usize) -> Option<(u16, &R)> {
        let index = self.members.get(place)?.near;
        Some((index, &self.members.get(usize::from(index))?.row))
    }

    #[inline(never)]
    pub(in crate::solid) fn outlook<P, T: Project<P, Row = R>>(&self, column: u32) -> Outlook {
        let mut all = Outlook::EMPTY;
        for (_, row) in (0..self.near.into()).map_while(|place| self.near(place)) {
            let one = T::outlook(row, column);
            all.is_there |= one.is_there;
            all.until = all.until.min(one.until);
        }
        all
    }

    #[inline(never)] // once a run
    pub(in crate::solid) fn enter<P, T: Project<P, Row = R>>(&mut self, column: u32) -> Outlook {
        let [from, until] = self.run.map(u32::from);
        if column < from {
            self.go_back::<P, T>();
        }
        if column < from || until <= column {
            self.go_on::<P, T>(column);
        }
        let [_, until] = self.run;
        let until = if until == u16::MAX { u32::MAX } else { until.into() };
        Outlook { is_there: self.first != NONE, until }
    }

    /// Before the first column, without elements.
    fn clear(&mut self) {
        (self.run, self.first, self.coming) = ([0; 2], NONE, NONE);
    }

    /// Before the first column.
    #[cold]
    fn go_back<P, T: Project<P, Row = R>>(&mut self) {
        self.clear();
        for place in 0..self.near.into() {
            if let Some((index, row)) = self.near(place) {
                self.await_first(index, T::outlook(row, 0));
            }
        }
    }

    /// Puts an element among those to come, by what can be seen of it from the first column on.
    #[inline]
    fn await_first(&mut self, index: u16, outlook: Outlook) {
        if outlook != Outlook::EMPTY {
            self.wait(index, if outlook.is_there { 0 } else { column(outlook.until) });
        }
    }

    /// Puts an element among those to come.
    #[inline(never)]
    fn wait(&mut self, index: u16, until: u16) {
        let (mut last, mut next) = (NONE, self.coming);
        while let Some(member) = self.members.get(usize::from(next))
            && member.until < until
        {
            (last, next) = (next, member.next);
        }
        if let Some(member) = self.members.get_mut(usize::from(index)) {
            (member.until, member.next) = (until, next);
        }
        match self.members.get_mut(usize::from(last)) {
            Some(last) => last.next = index,
            None => self.coming = index,
        }
    }

    /// Enters a run to the right, where only the elements of the last one and the first of those to
    /// come can be others.
    #[inline(always)]
    fn go_on<P, T: Project<P, Row = R>>(&mut self, now: u32) {
        let mut run_until = u16::MAX;
        let (mut index, mut last) = (self.first, NONE);
        while let Some(member) = self.members.get_mut(usize::from(index)) {
            let next = member.next;
            let mut stays = u32::from(member.until) > now;
            if !stays {
                let outlook = T::enter(&mut member.row, now);
                member.until = column(outlook.until);
                stays = outlook.is_there;
            }
            let until = member.until;
            if stays {
                run_until = run_until.min(until);
                last = index;
            } else {
                match self.members.get_mut(usize::from(last)) {
                    Some(last) => last.next = next,
                    None => self.first = next,
                }
                if until != u16::MAX {
                    self.wait(index, until);
                }
            }
            index = next;
        }
        loop {
            let index = self.coming;
            let Some(member) = self.members.get_mut(usize::from(index)) else { break };
            if u32::from(member.until) > now {
                run_until = run_until.min(member.until);
                break;
            }
            self.coming = member.next;
            let outlook = T::enter(&mut member.row, now);
            let until = column(outlook.until);
            if outlook.is_there {
                member.until = until;
                run_until = run_until.min(until);
                self.join(index);
            } else if until != u16::MAX {
                self.wait(index, until);
            }
        }
        self.run = [now as u16, run_until];
    }

    /// Puts an element among those of the run.
    #[inline(always)]
    fn join(&mut self, index: u16) {
        let (mut last, mut next) = (NONE, self.first);
        while next < index
            && let Some(member) = self.members.get(usize::from(next))
        {
            (last, next) = (next, member.next);
        }
        if let Some(member) = self.members.get_mut(usize::from(index)) {
            member.next = next;
        }
        match self.members.get_mut(usize::from(last)) {
            Some(last) => last.next = index,
            None => self.first = index,
        }
    }
}

/// As it is kept: the largest one for never.
fn column(index: u32) -> u16 {
    u16::try_from(index).unwrap_or(u16::MAX)
}
