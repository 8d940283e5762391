//! The rows of a group's elements, and which of them matter: the active and the pending list.

use super::empty::Empty;
use super::stage::{ColumnRun, Scan};

/// The rows of a group, and which of them matter. `M` is an array of [`Member`]s, or a slice: code that
/// isn't run for every pixel is compiled once for all lengths.
///
/// Elements wait in a pending list, sorted by the first column in which they may be seen. Then they
/// join the active list, sorted by index: at equal parameters the lower index wins. Blocks of rows
/// (bands) share a list of the elements that they can meet.
#[derive(Debug, Clone, Copy)]
pub struct GroupRow<M: ?Sized> {
    /// The columns from the one that was entered to where anything changes.
    run: [u16; 2],
    /// The first element of the active list.
    pub(super) active: u16,
    /// The first element of the pending list.
    pending: u16,
    /// The band of rows that was asked for last, 0 for none, and the length of its list.
    band: u16,
    band_count: u16,
    pub(super) members: M,
}

/// The row of an element, the column in which it changes, and the next element in its list. Behind the
/// last one stands an index that no element has.
#[derive(Debug, Clone, Copy)]
pub struct Member<R> {
    pub(super) row: R,
    until: u16,
    pub(super) next: u16,
    /// Slot i of the band's list, kept here to save an array: the i-th element visible in this band.
    in_band: u16,
}

/// A power of two: the number of rows of a band.
const BAND_ROWS: u32 = 3;
/// The number of the band below the middle of the picture.
const MIDDLE: i32 = 1 << 14;

/// No element has this index.
pub(super) const NONE: u16 = u16::MAX;

impl<R: Empty> Empty for Member<R> {
    const EMPTY: Self = Self { row: R::EMPTY, until: 0, next: 0, in_band: 0 };
}

impl<R: Empty, const N: usize> Empty for GroupRow<[Member<R>; N]> {
    const EMPTY: Self = Self {
        run: [0; 2],
        active: 0,
        pending: 0,
        band: 0,
        band_count: 0,
        members: [Member::EMPTY; N],
    };
}

impl<R, const N: usize> GroupRow<[Member<R>; N]> {
    /// The row of an element.
    #[inline(always)]
    pub(crate) fn row_of(&mut self, index: usize) -> Option<&mut R> {
        self.members.get_mut(index).map(|member| &mut member.row)
    }

    #[inline(always)]
    pub(crate) fn as_slice_mut(&mut self) -> &mut GroupRow<[Member<R>]> {
        self
    }
}

/// Gets all elements ready for a picture.
#[inline(never)]
pub(crate) fn view_each<P, T: Scan<P>>(solids: &[T], rays: &P, views: &mut [T::View]) {
    for (solid, view) in solids.iter().zip(views) {
        solid.view(rays, view);
    }
}

impl<R> GroupRow<[Member<R>]> {
    /// Sets another row.
    #[inline(never)]
    pub(crate) fn set<P, T: Scan<P, Row = R>>(
        &mut self,
        solids: &[T],
        views: &[T::View],
        y: i32,
        columns: u32,
    ) {
        self.clear();
        let band = y >> (BAND_ROWS + 1); // of half pixels
        let number = (MIDDLE + band) as u16;
        if self.band != number {
            self.band = number;
            self.list_band::<P, T>(solids, views, band);
        }
        for place in 0..self.band_count.into() {
            let Some(index) = self.members.get(place).map(|member| member.in_band) else { break };
            let element = usize::from(index);
            let (Some(solid), Some(view), Some(member)) =
                (solids.get(element), views.get(element), self.members.get_mut(element))
            else {
                break;
            };
            solid.row(view, y, columns, &mut member.row);
            let run = T::enter(&mut member.row, 0);
            self.await_first(index, run);
        }
    }

    /// Lists the elements that may be seen in a band of rows, the last one first: so that their columns
    /// mostly descend, too.
    #[inline(never)]
    fn list_band<P, T: Scan<P, Row = R>>(&mut self, solids: &[T], views: &[T::View], band: i32) {
        let first = band << (BAND_ROWS + 1);
        let rows = [first, first + ((2 << BAND_ROWS) - 1)];
        self.band_count = 0;
        for (index, (solid, view)) in solids.iter().zip(views).enumerate().rev() {
            if solid.is_in_rows(view, rows)
                && let Some(member) = self.members.get_mut(usize::from(self.band_count))
            {
                member.in_band = index as u16;
                self.band_count += 1;
            }
        }
    }

    #[inline(never)] // once a run
    pub(crate) fn enter<P, T: Scan<P, Row = R>>(&mut self, column: u32) -> ColumnRun {
        let [from, until] = self.run.map(u32::from);
        if column < from {
            self.go_back::<P, T>();
        }
        if column < from || until <= column {
            self.go_on::<P, T>(column);
        }
        let [_, until] = self.run;
        let until = if until == u16::MAX { u32::MAX } else { until.into() };
        ColumnRun { is_visible: self.active != NONE, until }
    }

    /// The band of rows that was asked for last, 0 for none.
    pub(crate) fn band(&self) -> u16 {
        self.band
    }

    /// The elements that may be seen in this band, the last one first.
    pub(crate) fn in_band(&self) -> impl Iterator<Item = u16> {
        self.members.iter().take(self.band_count.into()).map(|member| member.in_band)
    }

    /// The active elements, in their order.
    pub(crate) fn active(&self) -> impl Iterator<Item = u16> + Clone {
        let next = |index: &u16| Some(self.next_active(*index));
        core::iter::successors(Some(self.active), next).take_while(|index| *index != NONE)
    }

    /// The active element behind another one, or an index that none has.
    pub(crate) fn next_active(&self, index: u16) -> u16 {
        self.members.get(usize::from(index)).map_or(NONE, |member| member.next)
    }

    /// Whether a column is in the run that was entered last.
    pub(crate) fn is_entered(&self, column: u32) -> bool {
        let [from, until] = self.run.map(u32::from);
        from <= column && column < until
    }

    /// Before the first column, without elements.
    fn clear(&mut self) {
        (self.run, self.active, self.pending) = ([0; 2], NONE, NONE);
    }

    /// Before the first column.
    #[cold]
    fn go_back<P, T: Scan<P, Row = R>>(&mut self) {
        self.clear();
        for place in 0..self.band_count.into() {
            let Some(index) = self.members.get(place).map(|member| member.in_band) else { break };
            if let Some(member) = self.members.get_mut(usize::from(index)) {
                let run = T::enter(&mut member.row, 0);
                self.await_first(index, run);
            }
        }
    }

    /// Puts an element into the pending list, by its run from the first column on.
    #[inline]
    fn await_first(&mut self, index: u16, run: ColumnRun) {
        if run != ColumnRun::EMPTY {
            self.wait(index, if run.is_visible { 0 } else { column(run.until) });
        }
    }

    /// Puts an element into the pending list.
    #[inline(never)]
    fn wait(&mut self, index: u16, until: u16) {
        let (mut last, mut next) = (NONE, self.pending);
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
            None => self.pending = index,
        }
    }

    /// Enters a run to the right: only active elements and the first pending ones can change.
    #[inline(always)]
    fn go_on<P, T: Scan<P, Row = R>>(&mut self, now: u32) {
        let mut run_until = u16::MAX;
        let (mut index, mut last) = (self.active, NONE);
        while let Some(member) = self.members.get_mut(usize::from(index)) {
            let next = member.next;
            let mut stays = u32::from(member.until) > now;
            if !stays {
                let run = T::enter(&mut member.row, now);
                member.until = column(run.until);
                stays = run.is_visible;
            }
            let until = member.until;
            if stays {
                run_until = run_until.min(until);
                last = index;
            } else {
                match self.members.get_mut(usize::from(last)) {
                    Some(last) => last.next = next,
                    None => self.active = next,
                }
                if until != u16::MAX {
                    self.wait(index, until);
                }
            }
            index = next;
        }
        loop {
            let index = self.pending;
            let Some(member) = self.members.get_mut(usize::from(index)) else { break };
            if u32::from(member.until) > now {
                run_until = run_until.min(member.until);
                break;
            }
            self.pending = member.next;
            let run = T::enter(&mut member.row, now);
            let until = column(run.until);
            if run.is_visible {
                member.until = until;
                run_until = run_until.min(until);
                self.join(index);
            } else if until != u16::MAX {
                self.wait(index, until);
            }
        }
        self.run = [now as u16, run_until];
    }

    /// Puts an element into the active list.
    #[inline(always)]
    fn join(&mut self, index: u16) {
        let (mut last, mut next) = (NONE, self.active);
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
            None => self.active = index,
        }
    }
}

/// A column as it is kept: the largest one for never.
fn column(index: u32) -> u16 {
    u16::try_from(index).unwrap_or(u16::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::Extent;
    use crate::span::walk::{Path, Step};
    use crate::span::{Face, Shape};
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

        fn enter(row: &mut BarRow, column: u32) -> ColumnRun {
            let [one, other] = row.0.map(|extent| ColumnRun::of(extent, column));
            ColumnRun {
                is_visible: one.is_visible || other.is_visible,
                until: one.until.min(other.until),
            }
        }

        fn contains<P: Path>(&self, _: &Anywhere, _: &mut BarRow, _: i32, _: f32) -> bool {
            false
        }

        fn step<P: Path>(
            &self,
            _: &Anywhere,
            _: &mut BarRow,
            _: i32,
            _: f32,
            _: Face,
        ) -> Step<f32> {
            Step::OUTSIDE
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
                    let run = group.enter::<(), Bar>(column);
                    let mut list = Vec::new();
                    let mut index = group.active;
                    while let Some(member) = group.members.get(usize::from(index)) {
                        list.push(index);
                        index = member.next;
                    }
                    prop_assert_eq!(&list, &there(column), "row {}, column {}", y, column);
                    prop_assert_eq!(run.is_visible, !list.is_empty());
                    for later in column + 1..run.until.min(56) {
                        prop_assert_eq!(&list, &there(later), "row {}, columns {} to {}", y, column, later);
                    }
                }
            }
        }
    }
}
