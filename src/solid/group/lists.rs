//! The rows of a group's elements, and which of them matter.

use crate::solid::row::{Empty, Outlook, Scan};

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

impl<R: Empty> Empty for Member<R> {
    const EMPTY: Self = Self { row: R::EMPTY, until: 0, next: 0, near: 0 };
}

impl<R: Empty, const N: usize> Empty for GroupRow<[Member<R>; N]> {
    const EMPTY: Self =
        Self { run: [0; 2], first: 0, coming: 0, block: 0, near: 0, members: [Member::EMPTY; N] };
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
pub(in crate::solid) fn view_each<P, T: Scan<P>>(solids: &[T], rays: &P, views: &mut [T::View]) {
    for (solid, view) in solids.iter().zip(views) {
        solid.view(rays, view);
    }
}

impl<R> GroupRow<[Member<R>]> {
    #[inline(never)]
    pub(in crate::solid) fn set<P, T: Scan<P, Row = R>>(
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
    fn look_around<P, T: Scan<P, Row = R>>(&mut self, solids: &[T], views: &[T::View], block: i32) {
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
    pub(in crate::solid) fn outlook<P, T: Scan<P, Row = R>>(&self, column: u32) -> Outlook {
        let mut all = Outlook::EMPTY;
        for (_, row) in (0..self.near.into()).map_while(|place| self.near(place)) {
            let one = T::outlook(row, column);
            all.is_there |= one.is_there;
            all.until = all.until.min(one.until);
        }
        all
    }

    #[inline(never)] // once a run
    pub(in crate::solid) fn enter<P, T: Scan<P, Row = R>>(&mut self, column: u32) -> Outlook {
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
    fn go_back<P, T: Scan<P, Row = R>>(&mut self) {
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
    fn go_on<P, T: Scan<P, Row = R>>(&mut self, now: u32) {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::{Column, Extent};
    use crate::solid::Shape;
    use crate::solid::row::Look;
    use crate::span::{Face, SpanStack};
    use proptest::prelude::*;
    use std::vec::Vec;

    /// What is seen exactly in some rows, and there in some columns: without the room that primitives
    /// leave for rounding, in which a column too many or too few would be lost.
    #[derive(Debug, Clone, Copy)]
    struct Bar {
        rows: [i32; 2],
        extents: [Extent; 2],
    }

    #[derive(Debug, Clone, Copy)]
    struct Anywhere;

    #[derive(Debug, Clone, Copy)]
    struct BarRow([Extent; 2]);

    impl Empty for Anywhere {
        const EMPTY: Self = Self;
    }

    impl Empty for BarRow {
        const EMPTY: Self = Self([Extent::EMPTY; 2]);
    }

    impl Bar {
        fn is_at(&self, y: i32, column: u32) -> bool {
            (self.rows[0]..=self.rows[1]).contains(&y)
                && self.extents.iter().any(|extent| extent.contains(column))
        }
    }

    impl Shape for Bar {
        type Scalar = f32;
        const SPANS: usize = 0;
        const STACK: usize = 0;
        const FACES: u16 = 0;
    }

    impl Scan<()> for Bar {
        type View = Anywhere;
        type Row = BarRow;

        fn view(&self, (): &(), _: &mut Anywhere) {}

        fn is_in_rows(&self, _: &Anywhere, [first, last]: [i32; 2]) -> bool {
            self.rows[0] <= last && first <= self.rows[1]
        }

        fn row(&self, _: &Anywhere, y: i32, _: u32, row: &mut BarRow) {
            let is_here = (self.rows[0]..=self.rows[1]).contains(&y);
            row.0 = if is_here { self.extents } else { [Extent::EMPTY; 2] };
        }

        fn outlook(row: &BarRow, column: u32) -> Outlook {
            let [one, other] = row.0.map(|extent| Outlook::of(extent, column));
            Outlook { is_there: one.is_there || other.is_there, until: one.until.min(other.until) }
        }

        fn enter(row: &mut BarRow, column: u32) -> Outlook {
            Self::outlook(row, column)
        }

        fn spans_at(
            &self,
            _: &Anywhere,
            _: &BarRow,
            _: Column,
            _: Face,
            _: &mut SpanStack<'_, f32>,
        ) {
        }

        fn holds(&self, _: &Anywhere, _: &mut BarRow, _: i32, _: f32) -> bool {
            false
        }

        fn look(&self, _: &Anywhere, _: &mut BarRow, _: i32, _: f32, _: Face) -> Look<f32> {
            Look::EMPTY
        }
    }

    fn bar() -> impl Strategy<Value = Bar> {
        let extent = || {
            (0..40u32, 0..12u32).prop_map(|(start, length)| Extent { start, end: start + length })
        };
        ([extent(), extent()], -40..40i32, 0..50i32)
            .prop_map(|(extents, from, height)| Bar { rows: [from, from + height], extents })
    }

    proptest! {
        /// In every column that is asked for, in whatever order, the run's list is that of the elements
        /// there, and as long as it says nothing changes.
        #[test]
        fn a_run_has_what_is_there(
            bars in prop::array::uniform9(bar()),
            rows in prop::collection::vec((-50..50i32, prop::collection::vec(0..56u32, 1..30)), 1..12),
            is_in_order: bool,
        ) {
            let mut group = GroupRow::<[Member<BarRow>; 9]>::EMPTY;
            let group = group.as_slice_mut();
            for (y, mut columns) in rows {
                if is_in_order {
                    columns = (0..56).collect();
                }
                group.set::<(), Bar>(&bars, &[Anywhere; 9], y, 56);
                for column in columns {
                    let there = |column: u32| -> Vec<u16> {
                        (0..9).filter(|&i| bars[usize::from(i)].is_at(y, column)).collect()
                    };
                    let outlook = group.enter::<(), Bar>(column);
                    let mut list = Vec::new();
                    let mut index = group.first;
                    while let Some(member) = group.members.get(usize::from(index)) {
                        list.push(index);
                        index = member.next;
                    }
                    prop_assert_eq!(&list, &there(column), "row {}, column {}", y, column);
                    prop_assert_eq!(outlook.is_there, !list.is_empty());
                    for later in column + 1..outlook.until.min(56) {
                        prop_assert_eq!(&list, &there(later), "row {}, columns {} to {}", y, column, later);
                    }
                }
            }
        }
    }
}
