//! The box along the coordinate axes.

use super::planes::Planes;
use crate::geom::{Axis, Direction, Vec3};
use crate::scalar::Scalar;
use crate::span::Face;

/// The points whose coordinates lie between those of two corners.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Corners<S: Scalar> {
    pub(crate) low: Vec3<S>,
    pub(crate) high: Vec3<S>,
}

impl<S: Scalar> Corners<S> {
    /// The two faces across an axis.
    #[inline(always)]
    pub(crate) fn planes(&self, axis: Axis) -> Planes<S> {
        let [low, high] = [self.low, self.high].map(|corner| axis.of(corner));
        Planes { normal: Direction::along_axis(axis), low, high }
    }

    /// The lower of the two faces across an axis.
    #[inline]
    pub(crate) fn first_face(axis: Axis) -> Face {
        Face(2 * axis as u16)
    }

    /// The axis that a face lies across, and the face's number there.
    #[inline]
    pub(crate) fn across(face: Face) -> (Axis, Face) {
        let axis = match face.0 >> 1 {
            0 => Axis::X,
            1 => Axis::Y,
            _ => Axis::Z,
        };
        (axis, Face(face.0 & 1))
    }
}
