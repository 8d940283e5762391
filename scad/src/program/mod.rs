//! Parts as bytes of programs, for devices.
//!
//! The repository's `docs/program.md` has the format. Solids of a turned frame share a pose.

mod cost;
mod count;
mod firmware;
mod kind;
mod leaf;
mod memory;
mod numbers;
mod part;
mod room;

pub use count::Work;
pub use firmware::firmware;
pub use kind::Kind;
pub use leaf::{FACES, Leaf};
pub use memory::Memory;
pub use numbers::NumberType;
pub use room::MOST_SPANS;

use crate::error::{Error, ErrorKind};
use crate::map::Vector;
use crate::picture::View;
use crate::place::{Body, Model, Placed};
use crate::tree::Tree;
use numbers::Writer;

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

const HEADER: usize = 8;
const UNITE: u8 = 0xf0;
const INTERSECT: u8 = 0xf1;
const SUBTRACT: u8 = 0xf2;
const PAINTED: u8 = 1;
const POSED: u8 = 2;
const MOST_POSES: usize = 254;

fn header(number: NumberType, length: u16, poses: u8) -> Vec<u8> {
    let [low, high] = length.to_le_bytes();
    vec![b'S', b'P', 1, number.code(), low, high, poses, 0]
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
    let mut frames = vec![None; model.frames.len()];
    let mut used = 0;
    model.tree.for_each(&mut |solid: &Placed| {
        if let Some(pose @ None) = frames.get_mut(solid.frame).filter(|_| solid.frame != 0) {
            *pose = Some(used);
            used += 1;
        }
    });
    if used > MOST_POSES {
        return Err(Error::limit(format!("a program of {used} turned frames, of {MOST_POSES}")));
    }
    let mut writing = Writing {
        to: Writer::new(number),
        frames: &frames,
        parts: 0,
        kinds: [0; Kind::ALL.len()],
        most_faces: faces.clamp(4, FACES),
        faces: 0,
    };
    let mut placed: Vec<_> = model
        .frames
        .iter()
        .zip(&frames)
        .filter_map(|(axes, pose)| Some((pose.as_ref()?, axes)))
        .collect();
    placed.sort_by_key(|(pose, _)| **pose);
    for (_, axes) in placed {
        writing.to.bytes.push(1);
        axes.iter().for_each(|axis| writing.to.unit(*axis));
        writing.to.vector(Vector::new(0.0, 0.0, 0.0));
    }
    if !writing.tree(&model.tree)? {
        return Err(Error::limit("the part is empty"));
    }
    let Writing { to, parts, kinds, faces, .. } = writing;
    let length = to.bytes.len() + HEADER;
    let length = u16::try_from(length)
        .map_err(|_| Error::limit(format!("a program of {length} bytes, of 65535")))?;
    let mut bytes = header(number, length, used as u8);
    bytes.extend(to.bytes);
    Ok(Bytes { bytes, number, parts, poses: used, kinds, faces })
}

/// A program that is written.
struct Writing<'a> {
    to: Writer,
    /// The pose of each frame.
    frames: &'a [Option<usize>],
    parts: usize,
    kinds: [usize; Kind::ALL.len()],
    /// The most faces of a polyhedron that there may be, and that there are.
    most_faces: usize,
    faces: usize,
}

impl Writing<'_> {
    /// Writes a tree, and says whether there is something in it.
    fn tree(&mut self, tree: &Tree<Placed>) -> Result<bool, Error> {
        match tree {
            Tree::Empty => Ok(false),
            Tree::Solid(solid) => self.solid(solid).map(|()| true),
            Tree::Union(members) => self.all(members, UNITE),
            Tree::Intersection(members) => self.all(members, INTERSECT),
            Tree::Difference(first, others) => {
                if !self.tree(first)? {
                    return Ok(false);
                }
                if self.all(others, UNITE)? {
                    self.to.bytes.push(SUBTRACT);
                }
                Ok(true)
            }
        }
    }

    fn all(&mut self, members: &[Tree<Placed>], operator: u8) -> Result<bool, Error> {
        let mut is_there = false;
        for member in members {
            if self.tree(member)? {
                if is_there {
                    self.to.bytes.push(operator);
                }
                is_there = true;
            }
        }
        Ok(is_there)
    }

    /// Writes a solid: a part, or the intersection of several.
    fn solid(&mut self, solid: &Placed) -> Result<(), Error> {
        let Body::Convex(convex) = &solid.body else { return self.part(solid, &[]) };
        // In turn, so that all of them are about as large.
        let count = convex.planes.len().div_ceil(self.most_faces).max(1);
        for index in 0..count {
            let faces: Vec<_> = convex.planes.iter().copied().skip(index).step_by(count).collect();
            self.part(solid, &faces)?;
            if index > 0 {
                self.to.bytes.push(INTERSECT);
            }
        }
        Ok(())
    }

    fn part(&mut self, solid: &Placed, faces: &[(Vector, f64)]) -> Result<(), Error> {
        let number = self.to.number_type;
        let pose = self.frames.get(solid.frame).copied().flatten();
        let mut numbers = Writer::new(number);
        let kind = part::write(&solid.body, faces, &mut numbers);
        part::check(number, kind, &numbers.bytes).map_err(|_| Error {
            line: solid.line,
            kind: ErrorKind::Limit(out_of_range(number, numbers.largest)),
        })?;
        let flag = |is_there, bit| if is_there { bit } else { 0 };
        let has = flag(solid.color.is_some(), PAINTED) | flag(pose.is_some(), POSED);
        self.to.bytes.extend([kind.tag(), has]);
        self.to.bytes.extend(solid.color.into_iter().flat_map(|color| [color.r, color.g, color.b]));
        self.to.bytes.extend(pose.map(|pose| pose as u8));
        self.to.bytes.extend(numbers.bytes);
        self.parts += 1;
        self.kinds[kind as usize] += 1;
        self.faces = self.faces.max(faces.len());
        Ok(())
    }
}

/// What is wrong with numbers of which this is the largest, and what would help.
fn out_of_range(number: NumberType, largest: f64) -> String {
    let most = number.most();
    if largest > most {
        let scale = rounded_down(most / largest);
        format!("{largest} is beyond the {most} of {number}: --scale {scale} makes it fit")
    } else {
        format!("a solid is too thin or too small for {number}: a larger --scale, or f32, may do")
    }
}

/// 1, 2 or 5 times a power of ten.
fn rounded_down(number: f64) -> f64 {
    let power = 10f64.powf(number.log10().floor());
    let first = [5.0, 2.0].into_iter().find(|first| first * power <= number).unwrap_or(1.0);
    first * power
}
