//! Programs, and how they are built and changed.

use super::in_place::{InPlace, Whole};
use super::pool::Pool;
use super::tree::{Kind, MOST_LEAVES, Tree, TreeRef};
use crate::geom::Pose;
use crate::solid::Rgb;
use crate::span::Shape;

/// A solid whose tree is built at run time: up to `PARTS` leaves of one kind, combined in postfix order.
///
/// Use it where the tree isn't known to the compiler: a part that comes over the wire, a mechanism that
/// moves, a radius that a user turns. `L` is a solid, or an enum of the solids that a firmware names:
/// see [`leaves!`](crate::leaves).
///
/// The last operand is what was pushed or combined last. Operands that nothing combines are united.
///
/// ```
/// use scancsg::geom::{Ray, vec3};
/// use scancsg::program::Program;
/// use scancsg::solid::{Cuboid, Cylinder, Solid};
/// use scancsg::span::SpanList;
///
/// scancsg::leaves! {
///     /// What parts are made of.
///     pub enum Part<S> {
///         Cylinder(Cylinder<S>),
///         Cuboid(Cuboid<S>),
///     }
/// }
///
/// let plate = Cuboid::<f32>::new(vec3(-3.0, -1.0, 0.0), vec3(3.0, 1.0, 0.5))?;
/// let hole = |x| Cylinder::<f32>::along_z(x, 0.0, 0.4, -1.0, 1.0);
///
/// let mut drilled = Program::<Part<f32>, 8>::new(Part::Cuboid(plate));
/// drilled.push(Part::Cylinder(hole(-2.0)?))?;
/// let last = drilled.push(Part::Cylinder(hole(2.0)?))?;
/// drilled.subtract(2)?; // both holes from the plate
///
/// let ray = Ray::new(vec3(2.0, 0.0, 5.0), vec3(0.0, 0.0, -1.0))?;
/// let mut list = SpanList::<f32, 32>::new();
/// assert_eq!(drilled.trace(&ray, &mut list)?, []);
///
/// *drilled.part_mut(last)? = Part::Cylinder(hole(1.0)?);
/// assert_eq!(drilled.trace(&ray, &mut list)?.len(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// In a constant, a part lies in flash:
///
/// ```
/// use scancsg::constant;
/// use scancsg::geom::vec3;
/// use scancsg::program::Program;
/// use scancsg::solid::Sphere;
///
/// static LENS: Program<Sphere<f32>, 2> = {
///     let mut lens = Program::new(constant!(Sphere::<f32>::new(vec3(0.0, 0.0, -1.0), 2.0)));
///     let other = constant!(Sphere::<f32>::new(vec3(0.0, 0.0, 1.0), 2.0));
///     assert!(lens.push(other).is_ok() && lens.intersect(2).is_ok());
///     lens
/// };
/// assert_eq!(LENS.part_count(), 2);
/// ```
///
/// Parts may stand in one of up to `POSES` frames. A frame that is turned takes all of its parts along:
/// see [`set_pose`](Self::set_pose).
///
/// `SPANS` is the room for the spans of a single ray, and while they are merged. More of them are an
/// error of [`trace`](Self::trace) and [`hit`](Self::hit). Pictures need no such room.
///
/// `POOL` is the room for the faces of [`Pooled`](crate::solid::Pooled) polyhedra, all parts' together: see
/// [`push_polyhedron`](Self::push_polyhedron).
///
/// Part i has the faces from i times [`Shape::FACES`] of `L` on.
#[derive(Debug, Clone, Copy)]
pub struct Program<
    L: Shape,
    const PARTS: usize,
    const POSES: usize = 0,
    const SPANS: usize = 32,
    const POOL: usize = 0,
> {
    /// Behind the last one, any that there were.
    pub(super) leaves: [L; PARTS],
    pub(super) places: [Place; PARTS],
    tree: Tree<PARTS>,
    pub(super) poses: [Pose<L::Scalar>; POSES],
    pub(super) pose_count: u8,
    pub(super) pool: Pool<L::Scalar, POOL>,
}

/// What else there is of a part.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    pub(super) color: Rgb,
    /// The index of its pose, or one that no pose has.
    pub(super) pose: u8,
    /// Of these bits.
    pub(super) is: u8,
}

impl Place {
    const HERE: Self = Self { color: Rgb::WHITE, pose: NO_POSE, is: 0 };

    pub(super) const PAINTED: u8 = 1;

    /// It is cut away, so that its faces are seen from their other side.
    const CUT: u8 = 2;
}

pub(super) const NO_POSE: u8 = u8::MAX;

crate::error_text! {
    /// Why a [`Program`] can't be changed like that.
    pub enum ProgramError {
        /// There is no room for another part.
        Parts => "the program has no room for another part",
        /// There is no room for another pose.
        Poses => "the program has no room for another pose",
        /// There is no room for so many faces: in the pool, or in a leaf.
        Faces => "the program has no room for so many faces",
        /// There are fewer operands than are to be combined.
        Operands => "there are fewer operands than are to be combined",
        /// No part has this index.
        NoPart => "the program has no part of this index",
        /// No pose has this index.
        NoPose => "the program has no pose of this index",
        /// The last part can't be removed.
        LastPart => "a program needs at least one part",
        /// Something is cut out of the part that is to be removed. What would be left?
        CutInto => "something is cut out of this part, so it can't be removed",
    }
}

impl<L: Shape, const PARTS: usize, const POSES: usize, const SPANS: usize, const POOL: usize>
    Program<L, PARTS, POSES, SPANS, POOL>
where
    L: Copy,
{
    /// A program of one part.
    #[must_use]
    pub const fn new(first: L) -> Self {
        const {
            assert!(PARTS > 0, "a program needs room for at least one part");
            assert!(PARTS < MOST_LEAVES, "a program has less than 16,384 parts");
            assert!(POSES < NO_POSE as usize, "a program has at most 254 poses");
            assert!(PARTS * (L::FACES as usize) < u16::MAX as usize - 2, "too many faces");
            assert!(POOL < u16::MAX as usize, "a pool has less than 65,535 faces");
        }
        Self {
            leaves: [first; PARTS],
            places: [Place::HERE; PARTS],
            tree: Tree::LEAF,
            poses: [Pose::IDENTITY; POSES],
            pose_count: 0,
            pool: Pool::EMPTY,
        }
    }

    /// Adds a part, as the last operand, and returns its index.
    ///
    /// # Errors
    /// [`ProgramError::Parts`].
    pub const fn push(&mut self, part: L) -> Result<usize, ProgramError> {
        let index = self.tree.leaves();
        if index >= PARTS || !self.tree.push() {
            return Err(ProgramError::Parts);
        }
        self.leaves[index] = part;
        self.places[index] = Place::HERE;
        Ok(index)
    }

    /// Removes a part, and the operation that has it as its operand: the other operand stays. Parts
    /// behind it have an index less.
    ///
    /// ```
    /// use scancsg::geom::vec3;
    /// use scancsg::program::Program;
    /// use scancsg::solid::Sphere;
    ///
    /// let ball = |x| Sphere::<f32>::new(vec3(x, 0.0, 0.0), 1.0);
    /// let mut bitten = Program::<_, 3>::new(ball(0.0)?);
    /// bitten.push(ball(1.0)?)?;
    /// let bite = bitten.push(ball(-1.0)?)?;
    /// bitten.subtract(2)?;
    /// bitten.remove(bite)?; // one is cut out still
    /// assert_eq!((bitten.part_count(), bitten.operand_count()), (2, 1));
    /// assert!(bitten.remove(0).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ProgramError::NoPart`], [`ProgramError::LastPart`]; [`ProgramError::CutInto`] where others are
    /// cut out of this part alone.
    pub const fn remove(&mut self, part: usize) -> Result<(), ProgramError> {
        let count = self.tree.leaves();
        if let Err(error) = self.check(part) {
            return Err(error);
        }
        if count == 1 {
            return Err(ProgramError::LastPart);
        }
        if self.tree.is_cut_into(part) {
            return Err(ProgramError::CutInto);
        }
        self.tree.remove(part);
        self.pool.remove(part);
        let mut index = part;
        while index + 1 < count {
            self.leaves[index] = self.leaves[index + 1];
            self.places[index] = self.places[index + 1];
            index += 1;
        }
        Ok(())
    }
}

impl<L: Shape, const PARTS: usize, const POSES: usize, const SPANS: usize, const POOL: usize>
    Program<L, PARTS, POSES, SPANS, POOL>
{
    /// Takes the last `count` operands for their union.
    ///
    /// ```
    /// use scancsg::geom::vec3;
    /// use scancsg::program::Program;
    /// use scancsg::solid::Sphere;
    ///
    /// let ball = |x| Sphere::<f32>::new(vec3(x, 0.0, 0.0), 1.0);
    /// let mut row = Program::<_, 4>::new(ball(0.0)?);
    /// for x in [1.0, 2.0, 9.0] {
    ///     row.push(ball(x)?)?;
    /// }
    /// row.unite(3)?; // the first ball is an operand still
    /// assert_eq!(row.operand_count(), 2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ProgramError::Operands`] for fewer operands than that, or a `count` of 0.
    pub const fn unite(&mut self, count: usize) -> Result<(), ProgramError> {
        self.combine(count, Kind::Unite, Kind::Unite)
    }

    /// Takes the last `count` operands for what they have in common.
    ///
    /// # Errors
    /// As [`unite`](Self::unite).
    pub const fn intersect(&mut self, count: usize) -> Result<(), ProgramError> {
        self.combine(count, Kind::Intersect, Kind::Intersect)
    }

    /// Cuts the last `count` operands out of the one before them.
    ///
    /// # Errors
    /// [`ProgramError::Operands`] for no more operands than that, or a `count` of 0.
    pub const fn subtract(&mut self, count: usize) -> Result<(), ProgramError> {
        if count == 0 || count >= self.tree.open() {
            return Err(ProgramError::Operands);
        }
        let mut index = self.tree.start_of(count);
        while index < self.tree.leaves() {
            self.places[index].is ^= Place::CUT;
            index += 1;
        }
        self.combine(count + 1, Kind::Unite, Kind::Subtract)
    }

    const fn combine(&mut self, count: usize, kind: Kind, last: Kind) -> Result<(), ProgramError> {
        if count == 0 || count > self.tree.open() {
            return Err(ProgramError::Operands);
        }
        let mut left = count;
        while left > 1 {
            self.tree.combine(if left == 2 { last } else { kind });
            left -= 1;
        }
        Ok(())
    }

    /// The number of parts.
    #[must_use]
    pub const fn part_count(&self) -> usize {
        self.tree.leaves()
    }

    /// The number of operands that nothing combines yet.
    #[must_use]
    pub const fn operand_count(&self) -> usize {
        self.tree.open()
    }

    /// Nothing is left, not even a part: until one is pushed.
    pub(super) fn clear(&mut self) {
        (self.tree, self.pose_count, self.pool) = (Tree::NOTHING, 0, Pool::EMPTY);
    }

    pub(super) const fn check(&self, part: usize) -> Result<(), ProgramError> {
        if part < self.tree.leaves() { Ok(()) } else { Err(ProgramError::NoPart) }
    }

    /// A part.
    ///
    /// # Errors
    /// [`ProgramError::NoPart`].
    pub const fn part(&self, part: usize) -> Result<&L, ProgramError> {
        match self.check(part) {
            Ok(()) => Ok(&self.leaves[part]),
            Err(error) => Err(error),
        }
    }

    /// A part, to change it.
    ///
    /// # Errors
    /// [`ProgramError::NoPart`].
    pub const fn part_mut(&mut self, part: usize) -> Result<&mut L, ProgramError> {
        match self.check(part) {
            Ok(()) => Ok(&mut self.leaves[part]),
            Err(error) => Err(error),
        }
    }

    /// A part where it stands, and whether it is cut away.
    pub(super) fn in_place(&self, part: usize) -> Option<(InPlace<'_, L, POOL>, bool)> {
        let (leaf, place) = (self.leaves().get(part)?, self.places.get(part)?);
        let pose = self.poses.get(usize::from(place.pose));
        let color = (place.is & Place::PAINTED != 0).then_some(place.color);
        let leaf = Whole { leaf, pool: &self.pool, part };
        Some((InPlace { leaf, pose, color }, place.is & Place::CUT != 0))
    }

    /// The index of a part's pose.
    pub(super) fn pose_of(&self, part: usize) -> Option<u8> {
        self.places.get(part).map(|place| place.pose).filter(|pose| *pose != NO_POSE)
    }

    pub(super) fn poses(&self) -> &[Pose<L::Scalar>] {
        self.poses.get(..self.pose_count.into()).unwrap_or_default()
    }

    pub(super) fn leaves(&self) -> &[L] {
        self.leaves.get(..self.tree.leaves()).unwrap_or_default()
    }

    pub(super) fn tree(&self) -> TreeRef<'_> {
        self.tree.as_ref()
    }
}
