//! What a program is written to.

use super::numbers::{ToBits, UnitToBits};
use super::{BytesError, width};
use crate::geom::{Axis, Direction, Pose, Vec3};
use crate::scalar::{Number, Scalar};

/// The bytes of a program that is written.
#[derive(Debug)]
pub struct Writer<'b> {
    buffer: &'b mut [u8],
    length: usize,
}

impl<'b> Writer<'b> {
    pub(super) fn new(buffer: &'b mut [u8]) -> Self {
        Self { buffer, length: 0 }
    }

    /// Writes bytes.
    ///
    /// # Errors
    /// [`BytesError::Length`].
    pub fn bytes(&mut self, bytes: &[u8]) -> Result<(), BytesError> {
        let room = self.buffer.get_mut(self.length..).and_then(|rest| rest.get_mut(..bytes.len()));
        room.ok_or(BytesError::Length)?.copy_from_slice(bytes);
        self.length += bytes.len();
        Ok(())
    }

    /// Writes a number.
    ///
    /// # Errors
    /// [`BytesError::Length`].
    pub fn number<S: Scalar>(&mut self, number: S) -> Result<(), BytesError> {
        let bits = S::compute(ToBits(number));
        self.bytes(bits.get(..width::<S>()).unwrap_or_default())
    }

    /// Writes the coordinates of a point.
    ///
    /// # Errors
    /// [`BytesError::Length`].
    pub fn vector<S: Scalar>(&mut self, vector: Vec3<S>) -> Result<(), BytesError> {
        vector.to_array().into_iter().try_for_each(|coordinate| self.number(coordinate))
    }

    fn unit<S: Scalar>(&mut self, vector: Vec3<S::Unit>) -> Result<(), BytesError> {
        vector.to_array().into_iter().try_for_each(|coordinate| {
            let bits = S::compute(UnitToBits::<S>(coordinate));
            self.bytes(bits.get(..width::<S>()).unwrap_or_default())
        })
    }

    /// The number of a coordinate axis, or 3 and the coordinates.
    pub(super) fn direction<S: Scalar>(
        &mut self,
        direction: &Direction<S>,
    ) -> Result<(), BytesError> {
        match direction.along().filter(|axis| *direction == Direction::along_axis(*axis)) {
            Some(axis) => self.bytes(&[axis as u8]),
            None => {
                self.bytes(&[Axis::ALL.len() as u8])?;
                self.unit::<S>(direction.vector())
            }
        }
    }

    /// 0 for a translation, or 1 and the axes; and where the origin comes to.
    pub(super) fn pose<S: Scalar>(&mut self, pose: &Pose<S>) -> Result<(), BytesError> {
        let (axes, translation) = pose.frame();
        let (one, zero) = (S::Unit::ONE, S::Unit::ZERO);
        let is_shift =
            axes == [[one, zero, zero], [zero, one, zero], [zero, zero, one]].map(Vec3::from);
        self.bytes(&[u8::from(!is_shift)])?;
        if !is_shift {
            axes.into_iter().try_for_each(|axis| self.unit::<S>(axis))?;
        }
        self.vector(translation)
    }

    /// Fills in the length, and returns all bytes.
    pub(super) fn finish(self) -> Result<&'b [u8], BytesError> {
        let length = u16::try_from(self.length).map_err(|_| BytesError::Length)?;
        let bytes = self.buffer.get_mut(..self.length).ok_or(BytesError::Length)?;
        if let Some(place) = bytes.get_mut(4..6) {
            place.copy_from_slice(&length.to_le_bytes());
        }
        Ok(bytes)
    }
}
