//! What the lidar stands among, and what it measures there.

#![allow(dead_code)] // every user takes what it needs

use embedded_io::Write;
use scancsg::Error;
use scancsg::geom::{Axis, Ray, RayError, Vec3, vec3};
use scancsg::scalar::{I16F16, Scalar};
use scancsg::solid::{AxisCylinder, CylinderError, RayCast};
use scancsg::span::SpanList;
use scancsg::stream::LinkError;

/// The beams of a turn, at equal angles.
pub const BEAMS: usize = 32;
/// The frames after which everything is where it was.
pub const FRAMES: u16 = 16;

/// A cylinder along an axis, which moves to and fro or swells, in hundredths.
#[derive(Clone, Copy)]
pub struct Thing {
    pub axis: Axis,
    pub at: [i32; 2],
    pub radius: i32,
    pub ends: [i32; 2],
    /// What a step adds to the place and to the radius.
    moves: [i32; 2],
    swells: i32,
}

const fn thing(axis: Axis, at: [i32; 2], radius: i32, ends: [i32; 2]) -> Thing {
    Thing { axis, at, radius, ends, moves: [0; 2], swells: 0 }
}

/// Posts along z, rails along x and y. Some rails end where beams pass.
pub const THINGS: usize = 10;
#[rustfmt::skip]
const ALL: [Thing; THINGS] = [
    Thing { moves: [7, 0], ..thing(Axis::Z, [300, 100], 40, [-100, 200]) },
    Thing { moves: [0, -9], ..thing(Axis::Z, [-250, 300], 60, [-100, 200]) },
    Thing { swells: 6, ..thing(Axis::Z, [-400, -80], 25, [-100, 50]) },
    Thing { moves: [-5, 8], ..thing(Axis::Z, [120, -350], 35, [-20, 20]) },
    Thing { swells: 3, ..thing(Axis::Z, [500, -300], 90, [-100, 300]) },
    Thing { moves: [-11, 0], ..thing(Axis::X, [600, 0], 50, [-200, 150]) },
    Thing { moves: [0, 4], ..thing(Axis::X, [-550, -20], 45, [-300, 250]) },
    Thing { swells: 4, ..thing(Axis::X, [450, 10], 20, [-100, 500]) },
    Thing { moves: [13, 0], ..thing(Axis::Y, [-650, 0], 30, [-150, 400]) },
    Thing { moves: [-6, 3], ..thing(Axis::Y, [700, -30], 55, [-250, 100]) },
];

/// The other beams are these, turned by a quarter of a turn, a half, and three quarters.
#[rustfmt::skip]
const QUARTER: [[i32; 2]; BEAMS / 4] = [
    [9_951_847, 980_171], [9_569_403, 2_902_847], [8_819_213, 4_713_967], [7_730_105, 6_343_933],
    [6_343_933, 7_730_105], [4_713_967, 8_819_213], [2_902_847, 9_569_403], [980_171, 9_951_847],
];

/// Everything as it is in a frame.
pub fn things<S: Scalar>(frame: u16) -> Result<[AxisCylinder<S>; THINGS], CylinderError> {
    let [first, ..] = ALL;
    let mut things = [made(&first)?; THINGS];
    for (place, thing) in things.iter_mut().zip(moved(frame)) {
        *place = made(&thing)?;
    }
    Ok(things)
}

fn made<S: Scalar>(thing: &Thing) -> Result<AxisCylinder<S>, CylinderError> {
    let n = |hundredths| S::from_ratio(hundredths, 100);
    let Thing { axis, at, radius, ends: [low, high], .. } = *thing;
    AxisCylinder::along(axis, at.map(n), n(radius), n(low), n(high))
}

/// Everything as it is in a frame, in hundredths.
pub fn moved(frame: u16) -> [Thing; THINGS] {
    let forth = i32::from(frame % FRAMES);
    let step = forth.min(i32::from(FRAMES) - forth);
    ALL.map(|thing| {
        let Thing { at: [u, v], moves, .. } = thing;
        let at = [u + step * moves[0], v + step * moves[1]];
        Thing { at, radius: thing.radius + step * thing.swells, ..thing }
    })
}

/// The direction of a beam, of length 1. All start at the lidar, in the origin.
pub fn beam<S: Scalar>(index: usize) -> Vec3<S> {
    let of_quarter = QUARTER.get(index % QUARTER.len()).unwrap_or(&[0, 0]);
    let [x, y] = of_quarter.map(|part| S::from_ratio(part, 10_000_000));
    let [x, y] = match index / QUARTER.len() {
        0 => [x, y],
        1 => [y.negated(), x],
        2 => [x.negated(), y.negated()],
        _ => [y, x.negated()],
    };
    vec3(x, y, S::ZERO)
}

/// What comes back along a beam.
#[derive(Clone, Copy)]
pub struct Echo<S> {
    /// How far away the beam was thrown back.
    pub distance: S,
    /// How squarely it was met, 1 for straight on: the cosine of the angle to the normal.
    pub strength: S,
}

/// Measures along a beam; `None` if nothing is there.
pub fn measured<S: Scalar>(
    things: &[AxisCylinder<S>; THINGS],
    beam: Vec3<S>,
) -> Result<Option<Echo<S>>, RayError> {
    let ray = Ray::new(Vec3::ZERO, beam)?;
    let hit = things.hit(&ray, &mut SpanList::<S, { 2 * THINGS }>::new());
    Ok(hit.map(|hit| Echo { distance: hit.t, strength: hit.normal.dot(beam).negated() }))
}

/// A number's bits.
pub trait Bits {
    fn bits(self) -> u32;
}

impl Bits for f32 {
    fn bits(self) -> u32 {
        self.to_bits()
    }
}

impl Bits for I16F16 {
    fn bits(self) -> u32 {
        self.to_bits().cast_unsigned()
    }
}

/// Writes what is measured in all frames.
pub fn sent<S: Scalar + Bits>(line: &mut impl Write) -> Result<(), Error> {
    for frame in 0..FRAMES {
        let things = things::<S>(frame)?;
        for index in 0..BEAMS {
            let echo = measured(&things, beam(index))?;
            let bits = echo.map_or([u32::MAX; 2], |it| [it.distance.bits(), it.strength.bits()]);
            for bits in bits {
                line.write_all(&bits.to_le_bytes()).map_err(|_| LinkError::Write)?;
            }
        }
    }
    line.flush().map_err(|_| LinkError::Write)?;
    Ok(())
}
