//! Programs as bytes.
//!
//! The repository's `docs/program.md` has the format, byte by byte.

mod kinds;
mod numbers;
mod read;
mod reader;
mod writer;

pub use kinds::Coded;
pub use reader::Reader;
pub use writer::Writer;

use super::build::{Program, ProgramError};
use super::tree::Kind;
use crate::scalar::Scalar;
use crate::span::Shape;

crate::error_text! {
    /// Why bytes are no program of this type, or a program doesn't become bytes.
    pub enum BytesError {
        /// They don't begin as a program does.
        Magic => "the bytes are no program",
        /// They are of another version of the format.
        Version => "the program has another version of the format",
        /// They have numbers of another type.
        Number => "the program has numbers of another type",
        /// There are fewer or more of them than they say, or than a buffer has room for.
        Length => "the bytes of the program end too early or too late, or have no room",
        /// A tag, or bits of one, that the version doesn't have.
        Tag => "the program has an unknown tag",
        /// A part of a kind that the program's leaves don't name.
        Kind => "the program has a part of a kind that isn't known here",
        /// The numbers of a part are those of no such solid.
        Solid => "the numbers of a part make no solid of its kind",
        /// The numbers of a pose are those of no rigid motion.
        Pose => "the numbers of a pose are no rigid motion",
        /// The tree is larger than the program has room for, or an operator has no operands.
        Tree => "the tree is too large, or an operator has too few operands",
    }
}

impl From<ProgramError> for BytesError {
    fn from(_: ProgramError) -> Self {
        Self::Tree
    }
}

const MAGIC: [u8; 2] = *b"SP";
const VERSION: u8 = 1;
/// Tags of operators; smaller ones are kinds of parts.
const UNITE: u8 = 0xf0;
const INTERSECT: u8 = 0xf1;
const SUBTRACT: u8 = 0xf2;
/// What a part has: bits of the byte behind its kind.
const PAINTED: u8 = 1;
const POSED: u8 = 2;

impl<L: Coded + Copy, const PARTS: usize, const POSES: usize, const SPANS: usize, const POOL: usize>
    Program<L, PARTS, POSES, SPANS, POOL>
{
    /// Writes the program to the beginning of a buffer, and returns what was written.
    ///
    /// ```
    /// use scancsg::geom::vec3;
    /// use scancsg::program::Program;
    /// use scancsg::solid::Sphere;
    ///
    /// let ball = Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)?;
    /// let program = Program::<Sphere<f32>, 4>::new(ball);
    /// let mut buffer = [0; 64];
    /// let bytes = program.to_bytes(&mut buffer)?;
    /// assert_eq!(bytes.len(), 26);
    /// assert_eq!(Program::<Sphere<f32>, 4>::from_bytes(bytes)?, program);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`BytesError::Length`] if the buffer is too short, or the program has more than 65,535 bytes;
    /// [`BytesError::Solid`] for a [`Pooled`](crate::solid::Pooled) polyhedron without faces.
    pub fn to_bytes<'b>(&self, buffer: &'b mut [u8]) -> Result<&'b [u8], BytesError> {
        let mut to = Writer::new(buffer);
        to.bytes(&MAGIC)?;
        to.bytes(&[VERSION, numbers::format::<Number<L>>()])?;
        to.bytes(&[0, 0, self.poses().len() as u8, 0])?;
        for pose in self.poses() {
            to.pose(pose)?;
        }
        let mut index = 0;
        for kind in self.tree().postfix() {
            match kind {
                Some(kind) => to.bytes(&[match kind {
                    Kind::Unite => UNITE,
                    Kind::Intersect => INTERSECT,
                    Kind::Subtract => SUBTRACT,
                }])?,
                None => {
                    let Some((part, _)) = self.in_place(index) else { break };
                    let pose = self.pose_of(index);
                    let flag = |is_there, bit| if is_there { bit } else { 0 };
                    let has = flag(part.color.is_some(), PAINTED) | flag(pose.is_some(), POSED);
                    to.bytes(&[part.leaf.leaf.kind(), has])?;
                    if let Some(color) = part.color {
                        to.bytes(&[color.r, color.g, color.b])?;
                    }
                    if let Some(pose) = pose {
                        to.bytes(&[pose])?;
                    }
                    match part.leaf.leaf.pooled() {
                        Some(corners) => {
                            kinds::write_polyhedron(self.pool.of(index), corners, &mut to)?;
                        }
                        None => part.leaf.leaf.write(&mut to)?,
                    }
                    index += 1;
                }
            }
        }
        to.finish()
    }
}

type Number<L> = <L as Shape>::Scalar;

/// The number of bytes of a number.
const fn width<S: Scalar>() -> usize {
    size_of::<S>()
}
