//! Programs from bytes.

use super::kinds::half_space;
use super::{
    BytesError, Coded, INTERSECT, MAGIC, Number, PAINTED, POSED, Reader, SUBTRACT, UNITE, VERSION,
    numbers,
};
use crate::geom::Pose;
use crate::program::build::Program;
use crate::program::tree::Kind;
use crate::solid::Rgb;
use crate::span::Shape;
use core::marker::PhantomData;

impl<L: Coded + Copy, const PARTS: usize, const POSES: usize, const SPANS: usize, const POOL: usize>
    Program<L, PARTS, POSES, SPANS, POOL>
{
    /// Reads a program. All that it says is checked, and nothing but what it has room for is kept.
    ///
    /// # Errors
    /// [`BytesError`].
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, BytesError> {
        let mut items = Items::<L>::new(bytes, POSES)?;
        while let Some(item) = items.next()? {
            if let Item::Part(first) = item {
                let mut program = Self::new(first.leaf);
                program.read_bytes(bytes)?;
                return Ok(program);
            }
        }
        Err(BytesError::Length)
    }

    /// Reads a program into this one's place: where it is too large for the stack, or memory is short.
    /// [`from_bytes`](Self::from_bytes) returns it, so it needs that memory twice. The bytes are read twice.
    ///
    /// On a host, a thread with a stack that is large enough makes a box, and bytes are read there:
    ///
    /// ```
    /// use scancsg::constant;
    /// use scancsg::geom::vec3;
    /// use scancsg::program::Program;
    /// use scancsg::solid::{Polyhedron, Sphere};
    ///
    /// scancsg::leaves! {
    ///     /// Balls, and solids of up to 64 faces.
    ///     enum Part<S> {
    ///         Ball(Sphere<S>),
    ///         Faces(Polyhedron<S, 64>),
    ///     }
    /// }
    ///
    /// /// More than 300 kilobytes; its picture takes more than 400.
    /// type Large = Program<Part<f32>, 256, 64, 64>;
    /// const BALL: Sphere<f32> = constant!(Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0));
    ///
    /// # let mut buffer = [0; 64];
    /// # let bytes = Program::<Part<f32>, 1>::new(Part::Ball(BALL)).to_bytes(&mut buffer)?;
    /// let thread = std::thread::Builder::new().stack_size(64 << 20);
    /// let boxed = thread.spawn(|| Box::new(Large::new(Part::Ball(BALL))))?.join();
    /// let mut program = boxed.map_err(|_| "the thread has ended too early")?;
    /// program.read_bytes(bytes)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`BytesError`]. The program is as it was then.
    pub fn read_bytes(&mut self, bytes: &[u8]) -> Result<(), BytesError> {
        let mut items = Items::<L>::new(bytes, POSES)?;
        let (mut parts, mut operands, mut faces) = (0, 0, 0);
        while let Some(item) = items.next()? {
            match item {
                Item::Part(part) if parts < PARTS && part.faces()?.0 <= POOL - faces => {
                    faces += part.faces()?.0;
                    (parts, operands) = (parts + 1, operands + 1);
                }
                Item::Operator(_) if operands > 1 => operands -= 1,
                Item::Pose(_) => {}
                _ => return Err(BytesError::Tree),
            }
        }
        if parts == 0 {
            return Err(BytesError::Length);
        }
        self.clear();
        let (mut items, mut place) = (Items::<L>::new(bytes, POSES)?, 0);
        while let Some(item) = items.next()? {
            match item {
                Item::Pose(pose) => {
                    self.add_pose(pose)?;
                }
                Item::Part(part) => {
                    let index = self.push(part.leaf)?;
                    self.paint(index, part.color)?;
                    self.place(index, part.pose)?;
                    let (count, mut from) = part.faces()?;
                    for _ in 0..count {
                        self.pool.put(place, index, half_space(&mut from)?);
                        place += 1;
                    }
                }
                Item::Operator(Kind::Unite) => self.unite(2)?,
                Item::Operator(Kind::Intersect) => self.intersect(2)?,
                Item::Operator(Kind::Subtract) => self.subtract(1)?,
            }
        }
        Ok(())
    }
}

/// What a program's bytes say, in their order.
struct Items<'b, L> {
    from: Reader<'b>,
    poses: u8,
    poses_left: u8,
    is_tree: bool,
    leaf: PhantomData<L>,
}

enum Item<'b, L: Shape> {
    Pose(Pose<Number<L>>),
    Part(Dressed<'b, L>),
    Operator(Kind),
}

impl<'b, L: Coded> Items<'b, L> {
    /// Reads the header.
    fn new(bytes: &'b [u8], most_poses: usize) -> Result<Self, BytesError> {
        let mut from = Reader::new(bytes);
        if from.array()? != MAGIC {
            return Err(BytesError::Magic);
        }
        let [version, number, low, high, poses, zero] = from.array()?;
        match () {
            () if version != VERSION => Err(BytesError::Version),
            () if number != numbers::format::<Number<L>>() => Err(BytesError::Number),
            () if usize::from(u16::from_le_bytes([low, high])) != bytes.len() => {
                Err(BytesError::Length)
            }
            () if usize::from(poses) > most_poses => Err(BytesError::Tree),
            () if zero != 0 => Err(BytesError::Tag),
            () => {
                let leaf = PhantomData;
                Ok(Self { from, poses, poses_left: poses, is_tree: false, leaf })
            }
        }
    }

    fn next(&mut self) -> Result<Option<Item<'b, L>>, BytesError> {
        if let Some(left) = self.poses_left.checked_sub(1) {
            self.poses_left = left;
            return self.from.pose().map(|pose| Some(Item::Pose(pose)));
        }
        let Some(tag) = self.from.peek() else { return Ok(None) };
        let kind = match tag {
            UNITE => Some(Kind::Unite),
            INTERSECT => Some(Kind::Intersect),
            SUBTRACT => Some(Kind::Subtract),
            _ => None,
        };
        // A tree begins with a part.
        match kind.filter(|_| self.is_tree) {
            Some(kind) => self.from.array::<1>().map(|_| Some(Item::Operator(kind))),
            None => {
                self.is_tree = true;
                Dressed::read(&mut self.from, self.poses).map(|part| Some(Item::Part(part)))
            }
        }
    }
}

/// A part, its colour and the index of its pose.
struct Dressed<'b, L> {
    leaf: L,
    color: Option<Rgb>,
    pose: Option<usize>,
    /// Its numbers.
    numbers: Reader<'b>,
}

impl<'b, L: Coded> Dressed<'b, L> {
    /// How many faces it needs in the pool, and where they are read from.
    fn faces(&self) -> Result<(usize, Reader<'b>), BytesError> {
        let mut from = self.numbers;
        if self.leaf.pooled().is_none() {
            return Ok((0, from));
        }
        let [count] = from.array()?;
        Ok((count.into(), from))
    }

    fn read(from: &mut Reader<'b>, poses: u8) -> Result<Self, BytesError> {
        let [kind, has] = from.array()?;
        if kind >= UNITE || has & !(PAINTED | POSED) != 0 {
            return Err(BytesError::Tag);
        }
        let mut color = None;
        if has & PAINTED != 0 {
            let [r, g, b] = from.array()?;
            color = Some(Rgb::new(r, g, b));
        }
        let mut pose = None;
        if has & POSED != 0 {
            let [index] = from.array()?;
            if index >= poses {
                return Err(BytesError::Pose);
            }
            pose = Some(index.into());
        }
        let numbers = *from;
        Ok(Self { leaf: L::read(kind, from)?, color, pose, numbers })
    }
}
