//! Scenes as tables: parts and operators in postfix order.

use crate::border::Plain;
use crate::number::{Number, Scalar, scalar, vector};
use crate::part::{Part, Program};
use crate::status::Status;
use scancsg::geom::Pose;
use scancsg::program::ProgramError;
use scancsg::solid::{Cone, Cuboid, Cylinder, HalfSpace, Rgb, Sphere};

/// What a step does: push a part, or combine the last `count` operands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Kind {
    /// A part: from `a` to `b`, the middles of its caps, with radius `r[0]`.
    Cylinder = 1,
    /// A part: a box with the lowest corner `a` and the highest corner `b`.
    Box = 2,
    /// A part: around `a`, with radius `r[0]`.
    Sphere = 3,
    /// A part: from `a`, with radius `r[0]`, to `b`, with radius `r[1]`.
    Cone = 4,
    /// A part: a ring around `a`. `b` is its axis, `r[0]` the ring's radius, `r[1]` the tube's. Only in a build
    /// with the feature `torus`.
    Torus = 5,
    /// A part: all points p whose product `a · p` with the normal `a` of length 1 is less than `r[0]`. A normal
    /// of another length is made one of length 1.
    HalfSpace = 6,
    /// Takes the last `count` operands for their union.
    Unite = 240,
    /// Takes the last `count` operands for what they have in common.
    Intersect = 241,
    /// Cuts the last `count` operands out of the one before them.
    Subtract = 242,
}

/// The part has a colour: a bit of `has`.
pub const HAS_COLOR: u8 = 1;
/// The part stands in a pose: a bit of `has`.
pub const HAS_POSE: u8 = 2;

/// A row of the table. Fields that the kind doesn't name are not looked at.
#[derive(Debug, Clone, Copy, Default)]
#[repr(C)]
pub struct Step {
    /// What it does: a `scancsg_kind`.
    pub kind: u8,
    /// How many operands an operator takes.
    pub count: u8,
    /// What a part has: `SCANCSG_HAS_COLOR`, `SCANCSG_HAS_POSE`, both or neither.
    pub has: u8,
    /// The index of a part's pose.
    pub pose: u8,
    /// A part's colour: red, green, blue.
    pub color: [u8; 3],
    /// A point, or a normal.
    pub a: [Number; 3],
    /// Another point, or an axis.
    pub b: [Number; 3],
    /// Radii, or an offset.
    pub r: [Number; 2],
}

// SAFETY: it is integers and numbers.
unsafe impl Plain for Step {}

/// Where parts stand: turned about an axis through the origin, then shifted.
#[derive(Debug, Clone, Copy, Default)]
#[repr(C)]
pub struct Motion {
    /// The axis, of any length. It isn't looked at if the angle is 0.
    pub axis: [Number; 3],
    /// The angle in radians: clockwise for whoever looks along the axis.
    pub angle: Number,
    /// The shift.
    pub shift: [Number; 3],
}

// SAFETY: it is numbers.
unsafe impl Plain for Motion {}

impl Motion {
    pub(crate) fn pose(&self) -> Result<Pose<Scalar>, Status> {
        let shift = Pose::translation(vector(self.shift))?;
        if self.angle == Number::default() {
            return Ok(shift);
        }
        Ok(Pose::about(vector(self.axis), scalar(self.angle))?.then(&shift)?)
    }
}

impl Step {
    const PUSHES: [Kind; 6] =
        [Kind::Cylinder, Kind::Box, Kind::Sphere, Kind::Cone, Kind::Torus, Kind::HalfSpace];

    fn is(&self, kind: Kind) -> bool {
        self.kind == kind as u8
    }

    fn pushes(&self) -> bool {
        Self::PUSHES.iter().any(|kind| self.is(*kind))
    }

    fn part(&self) -> Result<Part<Scalar>, Status> {
        let (a, b, [r, q]) = (vector(self.a), vector(self.b), self.r.map(scalar));
        Ok(match () {
            () if self.is(Kind::Cylinder) => Part::Cylinder(Cylinder::from_to(a, b, r)?),
            () if self.is(Kind::Box) => Part::Cuboid(Cuboid::between(a, b)?),
            () if self.is(Kind::Sphere) => Part::Sphere(Sphere::around(a, r)?),
            () if self.is(Kind::Cone) => Part::Cone(Cone::from_to(a, b, [r, q])?),
            #[cfg(feature = "torus")]
            () if self.is(Kind::Torus) => Part::Torus(scancsg::solid::Torus::around(a, b, r, q)?),
            () if self.is(Kind::HalfSpace) => Part::HalfSpace(HalfSpace::facing(a, r)?),
            () => return Err(Status::Kind),
        })
    }

    /// Gives the part that was pushed last what it has.
    fn dress(&self, program: &mut Program) -> Result<(), Status> {
        if self.has & !(HAS_COLOR | HAS_POSE) != 0 {
            return Err(Status::Has);
        }
        let part = program.part_count().saturating_sub(1);
        if self.has & HAS_COLOR != 0 {
            let [r, g, b] = self.color;
            program.paint(part, Some(Rgb::new(r, g, b)))?;
        }
        if self.has & HAS_POSE != 0 {
            program.place(part, Some(self.pose.into()))?;
        }
        Ok(())
    }

    fn combine(&self, program: &mut Program) -> Result<(), Status> {
        let count = self.count.into();
        Ok(match () {
            () if self.is(Kind::Unite) => program.unite(count),
            () if self.is(Kind::Intersect) => program.intersect(count),
            () if self.is(Kind::Subtract) => program.subtract(count),
            () => return Err(Status::Kind),
        }?)
    }
}

/// The first part of a table, as a program that has the poses.
pub(crate) fn begin(steps: &[Step], poses: &[Motion]) -> Result<Program, Status> {
    let first = steps.first().ok_or(Status::Operands)?;
    if first.kind >= Kind::Unite as u8 && first.kind <= Kind::Subtract as u8 {
        return Err(Status::Operands);
    }
    let mut program = Program::new(first.part()?);
    for motion in poses {
        program.add_pose(motion.pose()?)?;
    }
    first.dress(&mut program)?;
    Ok(program)
}

/// One step more.
pub(crate) fn go_on(program: &mut Program, step: &Step) -> Result<(), Status> {
    if !step.pushes() {
        return step.combine(program);
    }
    // The part's own problem comes before that of room.
    let part = step.part()?;
    program.push(part).map_err(|error: ProgramError| Status::from(error))?;
    step.dress(program)
}
