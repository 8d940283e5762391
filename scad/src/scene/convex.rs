//! A convex polyhedron of any number of faces.

use crate::map::Vector;
use crate::tree::Convex;
use scancsg::geom::Line;
use scancsg::span::{Crossing, Face, Span};

/// The half-spaces of a convex polyhedron.
#[derive(Debug)]
pub(super) struct HalfSpaces {
    planes: Vec<Plane>,
    are_counted: bool,
}

#[derive(Debug)]
struct Plane {
    normal: Vector,
    offset: f64,
    /// The coordinate axis that it is across, and whether outside is where coordinates are larger.
    across: Option<(usize, bool)>,
}

/// With more faces than this, all count as one, and the face that is seen is the one nearest to the point.
const MOST_COUNTED: usize = 32;

impl HalfSpaces {
    pub(super) fn of(convex: &Convex) -> Self {
        let plane = |&(normal, offset): &(Vector, f64)| {
            let parts = normal.to_array();
            let across =
                (0..3).find(|axis| (0..3).all(|other| other == *axis || parts[other] == 0.0));
            Plane { normal, offset, across: across.map(|axis| (axis, parts[axis] > 0.0)) }
        };
        let are_counted = convex.planes.len() <= MOST_COUNTED;
        Self { planes: convex.planes.iter().map(plane).collect(), are_counted }
    }

    /// How many faces count.
    pub(super) fn count(&self) -> u16 {
        if self.are_counted { self.planes.len() as u16 } else { 1 }
    }

    /// The part of a line that is inside. Planes across a coordinate axis are crossed as those of boxes are, to the bit.
    pub(super) fn span(&self, line: &Line<f64>, first: Face) -> Option<Span<f64>> {
        let (origin, direction) = (line.origin.to_array(), line.direction.to_array());
        let mut span = Span::whole_line(first);
        for (plane, index) in self.planes.iter().zip(0..) {
            let (height, speed) = match plane.across {
                Some((axis, true)) => (plane.offset - origin[axis], direction[axis]),
                // Twice negative: the same as a box's low plane.
                Some((axis, false)) => (origin[axis] + plane.offset, -direction[axis]),
                None => {
                    (plane.offset - plane.normal.dot(line.origin), plane.normal.dot(line.direction))
                }
            };
            if speed == 0.0 {
                if !has_below(&plane.normal, height) {
                    return None;
                }
                continue;
            }
            let face = if self.are_counted { first.offset(index) } else { first };
            let crossing = Crossing { t: height / speed, face };
            if speed > 0.0 {
                if crossing.t < span.exit.t {
                    span.exit = crossing;
                }
            } else if crossing.t > span.enter.t {
                span.enter = crossing;
            }
            if span.enter.t >= span.exit.t {
                return None;
            }
        }
        Some(span)
    }

    /// The normal of a face, at a point on it.
    pub(super) fn normal(&self, face: Face, at: Vector) -> Vector {
        let above = |plane: &Plane| (plane.normal.dot(at) - plane.offset).abs();
        let seen = if self.are_counted {
            self.planes.get(usize::from(face.0))
        } else {
            self.planes.iter().min_by(|a, b| above(a).total_cmp(&above(b)))
        };
        seen.map_or(Vector::new(0.0, 0.0, 0.0), |plane| plane.normal)
    }
}

/// Whether a line along a plane, so far below it, is inside. Of two half-spaces on either side of a plane, one has it.
fn has_below(normal: &Vector, height: f64) -> bool {
    let first = normal.to_array().into_iter().find(|part| *part != 0.0);
    height > 0.0 || height == 0.0 && first.is_some_and(|part| part < 0.0)
}
