//! What a program is read from.

use super::numbers::{FromBits, UnitFromBits};
use super::{BytesError, width};
use crate::geom::{Axis, Direction, Pose, Vec3};
use crate::scalar::Scalar;

/// The bytes of a program that are still to be read.
#[derive(Debug, Clone, Copy)]
pub struct Reader<'b> {
    rest: &'b [u8],
}

impl<'b> Reader<'b> {
    pub(super) fn new(bytes: &'b [u8]) -> Self {
        Self { rest: bytes }
    }

    /// The next byte, if there is one; it stays to be read.
    pub(super) fn peek(&self) -> Option<u8> {
        self.rest.first().copied()
    }

    /// Reads so many bytes.
    ///
    /// # Errors
    /// [`BytesError::Length`].
    pub fn array<const N: usize>(&mut self) -> Result<[u8; N], BytesError> {
        let (bytes, rest) = self.rest.split_first_chunk().ok_or(BytesError::Length)?;
        self.rest = rest;
        Ok(*bytes)
    }

    /// The bytes of a number, and zeros.
    fn bits<S: Scalar>(&mut self) -> Result<[u8; 8], BytesError> {
        let (bytes, rest) = self.rest.split_at_checked(width::<S>()).ok_or(BytesError::Length)?;
        self.rest = rest;
        let mut bits = [0; 8];
        bits.iter_mut().zip(bytes).for_each(|(bit, byte)| *bit = *byte);
        Ok(bits)
    }

    /// Reads a number. It may be infinite or NaN: the constructors of solids check that.
    ///
    /// # Errors
    /// [`BytesError::Length`].
    pub fn number<S: Scalar>(&mut self) -> Result<S, BytesError> {
        Ok(S::compute(FromBits(self.bits::<S>()?)))
    }

    /// Reads the coordinates of a point.
    ///
    /// # Errors
    /// [`BytesError::Length`].
    pub fn vector<S: Scalar>(&mut self) -> Result<Vec3<S>, BytesError> {
        Ok(Vec3::new(self.number()?, self.number()?, self.number()?))
    }

    fn unit<S: Scalar>(&mut self) -> Result<Vec3<S::Unit>, BytesError> {
        let mut coordinate = || self.bits::<S>().map(|bits| S::compute(UnitFromBits(bits)));
        Ok(Vec3::new(coordinate()?, coordinate()?, coordinate()?))
    }

    /// As [`Writer::direction`](super::Writer::direction) writes it.
    pub(super) fn direction<S: Scalar>(&mut self) -> Result<Direction<S>, BytesError> {
        let [axis] = self.array()?;
        match Axis::ALL.get(usize::from(axis)) {
            Some(axis) => Ok(Direction::along_axis(*axis)),
            None if usize::from(axis) == Axis::ALL.len() => {
                Direction::of_length_1(self.unit::<S>()?).ok_or(BytesError::Solid)
            }
            None => Err(BytesError::Tag),
        }
    }

    /// As [`Writer::pose`](super::Writer::pose) writes it.
    pub(super) fn pose<S: Scalar>(&mut self) -> Result<Pose<S>, BytesError> {
        match self.array()? {
            [0] => Pose::translation(self.vector()?).map_err(|_| BytesError::Pose),
            [1] => {
                let axes = [self.unit::<S>()?, self.unit::<S>()?, self.unit::<S>()?];
                Pose::of_frame(axes, self.vector()?).ok_or(BytesError::Pose)
            }
            _ => Err(BytesError::Tag),
        }
    }
}
