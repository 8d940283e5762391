//! The faces of a program's polyhedra.

use super::build::{Program, ProgramError};
use crate::geom::Direction;
use crate::quadric::HalfSpace;
use crate::scalar::Scalar;
use crate::solid::Polyhedron;
use crate::span::Shape;

/// Up to `N` faces, in the order of the parts that they belong to.
#[derive(Debug, Clone, Copy, PartialEq)]
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
    const fn room(&self) -> usize {
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
    const fn set<const M: usize>(&mut self, part: usize, faces: &[HalfSpace<S>; M], count: usize) {
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

impl<L: Shape, const PARTS: usize, const POSES: usize, const SPANS: usize, const POOL: usize>
    Program<L, PARTS, POSES, SPANS, POOL>
where
    L: Copy,
{
    /// Adds a polyhedron as a part, with its faces in the pool, and returns its index. `part` is the leaf that
    /// stands for it.
    ///
    /// ```
    /// use scancsg::geom::{Axis, Ray, vec3};
    /// use scancsg::program::Program;
    /// use scancsg::solid::{Cylinder, Polyhedron, Pooled};
    /// use scancsg::span::SpanList;
    ///
    /// scancsg::leaves! {
    ///     /// Tubes, and polyhedra of up to 24 faces.
    ///     enum Part<S> {
    ///         Tube(Cylinder<S>),
    ///         Faces(Pooled<S, 24>),
    ///     }
    /// }
    ///
    /// let nut = [[1.0, 0.0], [0.5, 0.866], [-0.5, 0.866], [-1.0, 0.0], [-0.5, -0.866], [0.5, -0.866]];
    /// let nut = Polyhedron::<f32, 8>::prism(Axis::Z, nut, 0.0, 0.5)?;
    /// let bolt = Cylinder::<f32>::along_z(0.0, 0.0, 0.4, -3.0, 0.0)?;
    ///
    /// // Up to 16 parts, no poses, lines of up to 32 spans, 50 faces.
    /// let mut screw = Program::<Part<f32>, 16, 0, 32, 50>::new(Part::Tube(bolt));
    /// screw.push_polyhedron(Part::Faces(Pooled::of(&nut)), &nut)?;
    ///
    /// let ray = Ray::new(vec3(0.0, 0.0, 9.0), vec3(0.0, 0.0, -1.0))?;
    /// let hit = screw.hit(&ray, &mut SpanList::<_, 32>::new())?.ok_or("a miss")?;
    /// assert_eq!(hit.t, 8.5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ProgramError::Parts`]; [`ProgramError::Faces`] as for [`set_faces`](Self::set_faces).
    pub const fn push_polyhedron<const M: usize>(
        &mut self,
        part: L,
        polyhedron: &Polyhedron<L::Scalar, M>,
    ) -> Result<usize, ProgramError> {
        let count = polyhedron.count as usize;
        if count > L::FACES as usize || count > self.pool.room() {
            return Err(ProgramError::Faces);
        }
        let index = match self.push(part) {
            Ok(index) => index,
            Err(error) => return Err(error),
        };
        self.pool.set(index, &polyhedron.faces, count);
        Ok(index)
    }
}

impl<L: Shape, const PARTS: usize, const POSES: usize, const SPANS: usize, const POOL: usize>
    Program<L, PARTS, POSES, SPANS, POOL>
{
    /// Gives a part faces in the pool, in place of those it had: for a first part that is a polyhedron, and to
    /// change one. [`part_mut`](Self::part_mut) changes the leaf, which has a box around the polyhedron.
    /// A part that becomes another solid keeps its faces, unused, until it is removed.
    ///
    /// ```
    /// use scancsg::geom::Axis;
    /// use scancsg::program::Program;
    /// use scancsg::solid::{Polyhedron, Pooled};
    ///
    /// let wedge = |x| Polyhedron::<f32, 5>::prism(Axis::Z, [[0.0, 0.0], [x, 0.0], [0.0, 1.0]], 0.0, 1.0);
    /// let (short, long) = (wedge(1.0)?, wedge(2.0)?);
    /// let mut program = Program::<Pooled<f32, 5>, 1, 0, 4, 5>::new(Pooled::of(&short));
    /// program.set_faces(0, &short)?;
    ///
    /// *program.part_mut(0)? = Pooled::of(&long);
    /// program.set_faces(0, &long)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ProgramError::NoPart`]; [`ProgramError::Faces`] for more faces than the pool has room for, or than a
    /// leaf has.
    pub const fn set_faces<const M: usize>(
        &mut self,
        part: usize,
        polyhedron: &Polyhedron<L::Scalar, M>,
    ) -> Result<(), ProgramError> {
        if let Err(error) = self.check(part) {
            return Err(error);
        }
        let (count, [start, end]) = (polyhedron.count as usize, self.pool.range(part));
        if count > L::FACES as usize || count > self.pool.room() + (end - start) {
            return Err(ProgramError::Faces);
        }
        self.pool.set(part, &polyhedron.faces, count);
        Ok(())
    }

    /// The half-spaces of a part whose faces are in the pool; of another one, none.
    ///
    /// # Errors
    /// [`ProgramError::NoPart`].
    pub fn faces(&self, part: usize) -> Result<&[HalfSpace<L::Scalar>], ProgramError> {
        self.check(part).map(|()| self.pool.of(part))
    }
}
