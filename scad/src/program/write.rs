//! The program of a part: a tree of solids in the program's number type, which the library writes.

use super::kind::Kind;
use super::leaf::Leaf;
use super::numbers::NumberType;
use super::{Bytes, part};
use crate::error::{Error, ErrorKind};
use crate::map::Vector;
use crate::place::{Body, Model, Placed};
use crate::tree::Tree;
use scancsg::geom::{Pose, Vec3};
use scancsg::program::{BytesError, Program, ProgramError};
use scancsg::render::Rgb;
use scancsg::scalar::Scalar;

/// No program of fewer bytes than the most has more parts.
const MOST_PARTS: usize = 4096;
const MOST_POSES: usize = 254;
const MOST_BYTES: usize = 65_535;

/// How many times as long as 1 axes are when they are rounded, so that they have the digits of unit vectors.
const LONG: f64 = 8192.0;

/// The program, in a number type. Of the stack, it needs 16 MB.
pub(super) fn written<S: Scalar<Unit: Scalar>>(
    model: &Model,
    number: NumberType,
    most_faces: usize,
) -> Result<Bytes, Error> {
    let mut frames = vec![None; model.frames.len()];
    let mut poses = Vec::new();
    model.tree.for_each(&mut |solid: &Placed| {
        if let Some(pose @ None) = frames.get_mut(solid.frame).filter(|_| solid.frame != 0) {
            *pose = Some(poses.len());
            poses.extend(model.frames.get(solid.frame));
        }
    });
    if poses.len() > MOST_POSES {
        let count = poses.len();
        return Err(Error::limit(format!("a program of {count} turned frames, of {MOST_POSES}")));
    }
    let mut writing = Writing::<S> { number, most_faces, frames: &frames, steps: Vec::new() };
    if !writing.tree(&model.tree)? {
        return Err(Error::limit("the part is empty"));
    }
    let steps = writing.steps;
    let mut made = Bytes {
        bytes: Vec::new(),
        number,
        parts: 0,
        poses: poses.len(),
        kinds: [0; Kind::ALL.len()],
        faces: 0,
    };
    for step in &steps {
        if let Step::Part(Part { leaf, .. }) = step {
            made.parts += 1;
            made.kinds[leaf.kind_of() as usize] += 1;
            if let Leaf::Polyhedron(polyhedron) = leaf {
                made.faces = made.faces.max(polyhedron.faces().len());
            }
        }
    }
    if made.parts > MOST_PARTS {
        return Err(too_long(made.parts));
    }
    made.bytes = bytes(&steps, &poses, made.parts)?;
    Ok(made)
}

/// A part with what it is dressed in.
struct Part<S: Scalar> {
    leaf: Leaf<S>,
    color: Option<Rgb>,
    pose: Option<usize>,
}

/// Something on the way through the tree, in postfix order.
enum Step<S: Scalar> {
    Part(Part<S>),
    Unite,
    Intersect,
    Subtract,
}

/// A program on its way.
struct Writing<'a, S: Scalar> {
    number: NumberType,
    /// The most faces of a polyhedron that there may be.
    most_faces: usize,
    /// The pose of each frame.
    frames: &'a [Option<usize>],
    steps: Vec<Step<S>>,
}

impl<S: Scalar<Unit: Scalar>> Writing<'_, S> {
    /// Goes through a tree, and says whether there is something in it.
    fn tree(&mut self, tree: &Tree<Placed>) -> Result<bool, Error> {
        match tree {
            Tree::Empty => Ok(false),
            Tree::Solid(solid) => self.solid(solid).map(|()| true),
            Tree::Union(members) => self.all(members, || Step::Unite),
            Tree::Intersection(members) => self.all(members, || Step::Intersect),
            Tree::Difference(first, others) => {
                if !self.tree(first)? {
                    return Ok(false);
                }
                if self.all(others, || Step::Unite)? {
                    self.steps.push(Step::Subtract);
                }
                Ok(true)
            }
        }
    }

    fn all(
        &mut self,
        members: &[Tree<Placed>],
        operator: impl Fn() -> Step<S>,
    ) -> Result<bool, Error> {
        let mut is_there = false;
        for member in members {
            if self.tree(member)? {
                if is_there {
                    self.steps.push(operator());
                }
                is_there = true;
            }
        }
        Ok(is_there)
    }

    /// A solid: a part, or the intersection of several.
    fn solid(&mut self, solid: &Placed) -> Result<(), Error> {
        let Body::Convex(convex) = &solid.body else { return self.part(solid, &[]) };
        // In turn, so that all of them are about as large.
        let count = convex.planes.len().div_ceil(self.most_faces).max(1);
        for index in 0..count {
            let faces: Vec<_> = convex.planes.iter().copied().skip(index).step_by(count).collect();
            self.part(solid, &faces)?;
            if index > 0 {
                self.steps.push(Step::Intersect);
            }
        }
        Ok(())
    }

    fn part(&mut self, solid: &Placed, faces: &[(Vector, f64)]) -> Result<(), Error> {
        let leaf = part::part(&solid.body, faces).ok_or_else(|| Error {
            line: solid.line,
            kind: ErrorKind::Limit(out_of_range(self.number, part::largest(&solid.body))),
        })?;
        let pose = self.frames.get(solid.frame).copied().flatten();
        self.steps.push(Step::Part(Part { leaf, color: solid.color, pose }));
        Ok(())
    }
}

/// What the library writes of a tree of so many parts.
fn bytes<S: Scalar>(
    steps: &[Step<S>],
    poses: &[&[Vector; 3]],
    parts: usize,
) -> Result<Vec<u8>, Error> {
    let wrong = |error: ProgramError| Error::limit(error.to_string());
    let Some((Step::Part(first), rest)) = steps.split_first() else {
        return Err(Error::limit("the part is empty"));
    };
    let mut program = Program::<Leaf<S>, MOST_PARTS, MOST_POSES, 1>::new(first.leaf);
    for axes in poses {
        let axes = axes.map(|axis| (axis * LONG).map(S::from_f64));
        let pose = Pose::with_axes(axes, Vec3::ZERO);
        program.add_pose(pose.map_err(|error| Error::limit(error.to_string()))?).map_err(wrong)?;
    }
    program.paint(0, first.color).and_then(|()| program.place(0, first.pose)).map_err(wrong)?;
    for step in rest {
        match step {
            Step::Part(part) => program.push(part.leaf).and_then(|index| {
                program.paint(index, part.color)?;
                program.place(index, part.pose)
            }),
            Step::Unite => program.unite(2),
            Step::Intersect => program.intersect(2),
            Step::Subtract => program.subtract(1),
        }
        .map_err(wrong)?;
    }
    let mut buffer = vec![0; MOST_BYTES];
    match program.to_bytes(&mut buffer) {
        Ok(bytes) => Ok(bytes.to_vec()),
        Err(BytesError::Length) => Err(too_long(parts)),
        Err(error) => Err(Error::limit(error.to_string())),
    }
}

fn too_long(parts: usize) -> Error {
    Error::limit(format!("a program of {parts} parts needs more than {MOST_BYTES} bytes"))
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
pub(super) fn rounded_down(number: f64) -> f64 {
    let power = 10f64.powf(number.log10().floor());
    let first = [5.0, 2.0].into_iter().find(|first| first * power <= number).unwrap_or(1.0);
    first * power
}
