//! How many spans of a line a device needs room for: found by lines through the part.

use super::count::{PARTS, POSES, on_large_stack};
use super::leaf::Leaf;
use super::{Bytes, NumberType};
use crate::error::Error;
use crate::map::{Vector, length};
use crate::picture::Angles;
use scancsg::geom::Ray;
use scancsg::program::Program;
use scancsg::scalar::{I16F16, Scalar};
use scancsg::span::SpanList;

/// From where lines come: along the axes, a little askew, and from corners.
const FROM: [[f64; 3]; 7] = [
    [1.0, 0.5, 0.0],
    [89.0, 0.0, 1.0],
    [89.0, 0.0, 91.0],
    [55.0, 0.0, 25.0],
    [55.0, 0.0, 115.0],
    [125.0, 0.0, 25.0],
    [125.0, 0.0, 115.0],
];

/// How many lines there are from everywhere, in each direction of a square.
const LINES: u16 = 40;

/// The most spans of a single ray that firmware gets room for.
pub const MOST_SPANS: usize = 512;

impl Bytes {
    /// Of 32, 64, 128, 256 and [`MOST_SPANS`], the fewest that are room enough for 11,200 lines through the part, within
    /// a box. None, if all are too few.
    ///
    /// # Errors
    /// An [`Error`] for more than 1,024 parts.
    pub fn spans(&self, corners: [Vector; 2]) -> Result<Option<usize>, Error> {
        on_large_stack(|| match self.number {
            NumberType::F32 => found::<f32>(&self.bytes, corners),
            NumberType::I16F16 => found::<I16F16>(&self.bytes, corners),
        })
    }
}

type Read<S> = Program<Leaf<S>, PARTS, POSES, 1>;
type HasRoom<S> = fn(&Read<S>, &Ray<S>) -> bool;

fn found<S: Scalar>(bytes: &[u8], [low, high]: [Vector; 2]) -> Result<Option<usize>, Error> {
    let part = Read::<S>::from_bytes(bytes).map_err(|error| Error::limit(error.to_string()))?;
    let (middle, radius) = ((low + high) * 0.5, length(high - low) * 0.5);
    let narrow = |vector: Vector| vector.map(S::from_f64);
    let lines = FROM.into_iter().flat_map(|angles| {
        let [right, up, back] = Angles(angles).axes();
        let across = |index: u16| radius * (f64::from(2 * index + 1) / f64::from(LINES) - 1.0);
        (0..LINES * LINES).filter_map(move |index| {
            let beside = right * across(index % LINES) + up * across(index / LINES);
            Ray::new(narrow(middle + back * (radius * 1.1) + beside), narrow(-back)).ok()
        })
    });
    let steps: [HasRoom<S>; 5] = [
        has_room::<S, 32>,
        has_room::<S, 64>,
        has_room::<S, 128>,
        has_room::<S, 256>,
        has_room::<S, MOST_SPANS>,
    ];
    let mut step = 0;
    for line in lines {
        while !steps[step](&part, &line) {
            step += 1;
            if step == steps.len() {
                return Ok(None);
            }
        }
    }
    Ok(Some(32 << step))
}

fn has_room<S: Scalar, const N: usize>(part: &Read<S>, line: &Ray<S>) -> bool {
    part.trace(line, &mut SpanList::<S, N>::new()).is_ok()
}
