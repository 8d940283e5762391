//! Turned frames: few, so that what is parallel has the same axes, bit for bit.

use super::digits;
use crate::map::{Map, SIX_DIGITS, Vector, length};

/// The frames found so far. The first is the scene's own.
#[derive(Debug, Clone)]
pub(super) struct Frames {
    axes: Vec<[Vector; 3]>,
}

impl Default for Frames {
    fn default() -> Self {
        Self { axes: vec![Map::IDENTITY.columns] }
    }
}

/// How a solid lies in a frame: each of its axes along one of the frame's, or against it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Turn {
    pub(super) frame: usize,
    /// The images of the own axes in the frame: multiples of its axes.
    columns: [Vector; 3],
    /// The image of the own origin.
    shift: Vector,
}

impl Turn {
    /// Where a point of the solid is in the frame.
    pub(super) fn point(&self, own: Vector) -> Vector {
        self.map().point(own).map(digits)
    }

    /// The map into the frame.
    pub(super) fn map(&self) -> Map {
        Map { columns: self.columns, shift: self.shift }
    }

    /// Which axis of the frame the own z axis lies along.
    pub(super) fn axis_of_z(&self) -> usize {
        let parts = self.columns[2].to_array();
        parts.iter().position(|part| *part != 0.0).unwrap_or(2)
    }
}

/// The factor of a length, which is 1 if it may have been meant to be.
pub(super) fn factor(scale: f64) -> f64 {
    if (scale - 1.0).abs() < SIX_DIGITS { 1.0 } else { digits(scale) }
}

/// How far off the six digits of two matrices let their product be.
const OFF: f64 = 2.0 * SIX_DIGITS;

impl Frames {
    /// The axes of all frames.
    pub(super) fn axes(self) -> Vec<[Vector; 3]> {
        self.axes
    }

    /// Finds or adds the frame of a map.
    pub(super) fn note(&mut self, map: &Map) {
        let _ = self.turn(map);
    }

    /// How a map turns a solid into a frame. None if its axes aren't at right angles.
    pub(super) fn turn(&mut self, map: &Map) -> Option<Turn> {
        if let Some(turn) = self.turn_if_known(map) {
            return Some(turn);
        }
        let axes = right_angled(map)?;
        self.axes.push(axes);
        self.turn_if_known(map)
    }

    /// The same, for a frame that is there.
    pub(super) fn turn_if_known(&self, map: &Map) -> Option<Turn> {
        (0..self.axes.len()).find_map(|frame| self.turn_into(frame, map, [0, 1, 2]))
    }

    /// How a map turns a solid that is round about its z axis into a frame.
    pub(super) fn turn_about_z(&mut self, map: &Map) -> Option<Turn> {
        let axes = right_angled(map)?;
        for frame in 0..self.axes.len() {
            if let Some(turn) = self.turn_into(frame, map, [2; 3]) {
                return Some(turn);
            }
        }
        self.axes.push(axes);
        self.turn_if_known(map)
    }

    /// How a map turns a solid into a frame, if these of its axes lie along those of the frame.
    fn turn_into(&self, frame: usize, map: &Map, needed: [usize; 3]) -> Option<Turn> {
        let axes = *self.axes.get(frame)?;
        let into = |vector: Vector| Vector::from(axes.map(|axis| axis.dot(vector)));
        let snapped = |column: Vector| {
            let (seen, scale) = (into(column), length(column));
            let parts = seen.map(|part| {
                if part.abs() < OFF * scale { 0.0 } else { part.signum() * factor(scale) }
            });
            (parts.to_array().iter().filter(|part| **part != 0.0).count() == 1).then_some(parts)
        };
        if needed.iter().any(|i| snapped(map.columns[*i]).is_none()) {
            return None;
        }
        let columns =
            map.columns.map(|column| snapped(column).unwrap_or(Vector::new(0.0, 0.0, 0.0)));
        Some(Turn { frame, columns, shift: into(map.shift) })
    }
}

/// The axes of a map, made orthonormal and right-handed, if they are at right angles but for the digits.
fn right_angled(map: &Map) -> Option<[Vector; 3]> {
    let [x, y, z] = map.columns;
    let [a, b, c] = [x, y, z].map(length);
    let is_square = |product: f64, size: f64| product.abs() < OFF * size;
    if !(is_square(x.dot(y), a * b) && is_square(y.dot(z), b * c) && is_square(z.dot(x), c * a)) {
        return None;
    }
    // z first: solids with an axis have it there. What is zero stays zero.
    let z = z.normalized()?;
    let x = (x - z * z.dot(x)).normalized()?;
    Some([x, z.cross(x), z])
}
