//! Parts as bytes of programs, for devices.
//!
//! The repository's `docs/program.md` has the format. Solids of a turned frame share a pose.

mod compare;
mod cost;
mod count;
mod firmware;
mod kind;
mod leaf;
mod memory;
mod numbers;
mod part;
mod room;
mod write;

pub use compare::{Deviation, deviation};
pub use count::Work;
pub use firmware::firmware;
pub use kind::Kind;
pub use leaf::{FACES, Leaf};
pub use memory::Memory;
pub use numbers::NumberType;
pub use room::MOST_SPANS;

use crate::error::Error;
use crate::picture::View;
use crate::place::Model;
use count::on_large_stack;
use scancsg::scalar::I16F16;
use write::written;

/// A part as a program: its bytes, and what a device needs to hold it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Bytes {
    /// As `Program::from_bytes` reads them.
    pub bytes: Vec<u8>,
    /// The type of their numbers.
    pub number: NumberType,
    /// How many parts there are.
    pub parts: usize,
    /// How many poses there are.
    pub poses: usize,
    /// How many parts there are of each of [`Kind::ALL`].
    pub kinds: [usize; Kind::ALL.len()],
    /// The most faces of a polyhedron; 0 without one.
    pub faces: usize,
}

impl Bytes {
    /// What a device does for a picture of it, in `f32`.
    ///
    /// # Errors
    /// An [`Error`] for a program in another number type, and for one of more than 1,024 parts.
    pub fn work(&self, view: &View, size: [u16; 2]) -> Result<Work, Error> {
        count::count(&self.bytes, view, size)
    }

    /// The kinds of its parts.
    pub fn kinds(&self) -> impl Iterator<Item = Kind> {
        Kind::ALL.into_iter().zip(self.kinds).filter(|(_, count)| *count > 0).map(|(kind, _)| kind)
    }
}

/// The program of a part. A polyhedron of more faces than `faces`, from 4 to [`FACES`], is an intersection of several.
///
/// ```
/// use scancsg::program::Program;
/// use scancsg_scad::program::{FACES, Leaf, NumberType, program};
/// use scancsg_scad::{Model, lower, parse};
///
/// let part = lower(&parse("difference() { cube(size = [3, 2, 1]); cylinder(h = 9, r1 = 1, r2 = 1); }")?, false)?;
/// let made = program(&Model::of(part.tree)?, NumberType::F32, FACES)?;
/// assert_eq!((made.parts, made.poses, made.bytes.len()), (2, 0, 62));
/// let read = Program::<Leaf<f32>, 2>::from_bytes(&made.bytes)?;
/// assert_eq!(read.part_count(), 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// An [`Error`] for an empty part, for numbers out of the type's range, for more than 254 turned frames, and for
/// more bytes than a program may have.
pub fn program(model: &Model, number: NumberType, faces: usize) -> Result<Bytes, Error> {
    let faces = faces.clamp(4, FACES);
    on_large_stack(|| match number {
        NumberType::F32 => written::<f32>(model, number, faces),
        NumberType::I16F16 => written::<I16F16>(model, number, faces),
    })
}
