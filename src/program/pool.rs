//! Where the faces of a program's polyhedra lie.

use crate::geom::Direction;
use crate::quadric::HalfSpace;
use crate::scalar::Scalar;

/// Up to `N` faces, in the order of the parts that they belong to.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pool<S: Scalar, const N: usize> {
    pub(super) faces: [HalfSpace<S>; N],
    /// The part of each face; behind the last face, one that there isn't.
    parts: [u16; N],
}

const NO_PART: u16 = u16::MAX;

impl<S: Scalar, const N: usize> Pool<S, N> {
    pub(super) const EMPTY: Self = {
        let face = HalfSpace { normal: Direction::Z, offset: S::ZERO };
        Self { faces: [face; N], parts: [NO_PART; N] }
    };

    /// The first face of this part or a later one.
    const fn start_of(&self, part: usize) -> usize {
        let (mut place, mut end) = (0, N);
        while place < end {
            let middle = place + (end - place) / 2;
            if (self.parts[middle] as usize) < part {
                place = middle + 1;
            } else {
                end = middle;
            }
        }
        place
    }

    /// Where the faces of a part are.
    pub(super) const fn range(&self, part: usize) -> [usize; 2] {
        [self.start_of(part), self.start_of(part + 1)]
    }

    /// How many more faces there is room for.
    pub(super) const fn room(&self) -> usize {
        N - self.start_of(NO_PART as usize)
    }

    /// Moves the faces from `from` on to `to`, as far as there are places for them.
    const fn shift(&mut self, from: usize, to: usize) {
        let mut count = 0;
        while to < from && from + count < N {
            self.faces[to + count] = self.faces[from + count];
            self.parts[to + count] = self.parts[from + count];
            count += 1;
        }
        while to < from && to + count < N {
            self.parts[to + count] = NO_PART;
            count += 1;
        }
        let mut left = N;
        while to > from && left > to {
            left -= 1;
            self.faces[left] = self.faces[left - (to - from)];
            self.parts[left] = self.parts[left - (to - from)];
        }
    }

    /// Takes faces for those of a part. There is room for them.
    pub(super) const fn set<const M: usize>(
        &mut self,
        part: usize,
        faces: &[HalfSpace<S>; M],
        count: usize,
    ) {
        let [start, end] = self.range(part);
        self.shift(end, start + count);
        let mut index = 0;
        while index < count && index < M && start + index < N {
            self.faces[start + index] = faces[index];
            self.parts[start + index] = part as u16;
            index += 1;
        }
    }

    /// Removes a part: those behind it have an index less.
    pub(super) const fn remove(&mut self, part: usize) {
        let [start, end] = self.range(part);
        self.shift(end, start);
        let mut place = start;
        while place < N && self.parts[place] != NO_PART {
            self.parts[place] -= 1;
            place += 1;
        }
    }

    /// The faces of a part.
    pub(super) fn of(&self, part: usize) -> &[HalfSpace<S>] {
        let [start, end] = self.range(part);
        self.faces.get(start..end).unwrap_or_default()
    }

    /// Sets a face. Those before it are there, and of no part behind this one.
    pub(super) fn put(&mut self, place: usize, part: usize, face: HalfSpace<S>) {
        if let (Some(to), Some(owner)) = (self.faces.get_mut(place), self.parts.get_mut(place)) {
            (*to, *owner) = (face, part as u16);
        }
    }
}
