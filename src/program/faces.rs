//! Polyhedra whose faces are in a program's pool.

use super::build::{Program, ProgramError};
use crate::quadric::HalfSpace;
use crate::solid::Polyhedron;
use crate::span::Shape;

impl<L: Shape, const PARTS: usize, const POSES: usize, const SPANS: usize, const POOL: usize>
    Program<L, PARTS, POSES, SPANS, POOL>
where
    L: Copy,
{
    /// Adds a polyhedron as a part, with its faces in the pool, and returns its index. `part` is the leaf that
    /// stands for it: a [`Pooled`](crate::solid::Pooled) of as many faces. The faces of any other leaf are not used.
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
    /// [`ProgramError::NoPart`]; [`ProgramError::Faces`] for more faces than the pool has room for, or than the
    /// leaf with the most faces has. A part with more faces than its own leaf names is rendered, but its bytes
    /// can't be read by a program without a larger leaf.
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
