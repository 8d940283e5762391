//! Fields of a packet's contents.

use core::ops::Range;

use crate::stream::error::{EncodeError, PacketError};
use crate::stream::framing::seal;

/// The place of a field.
pub(in crate::stream) type Field = Range<usize>;

/// The contents of a packet, or of a row what is before the payload: the kind and the fields.
pub(in crate::stream) struct Fields<const LEN: usize>(pub(in crate::stream) [u8; LEN]);

impl<const LEN: usize> Fields<LEN> {
    /// A packet of this kind, whose fields are yet to be set.
    pub(in crate::stream) const fn new(kind: u8) -> Self {
        Self([kind; LEN])
    }

    /// The contents of a packet that must be just as long.
    pub(in crate::stream) fn read(content: &[u8]) -> Result<Self, PacketError> {
        content.try_into().map(Self).map_err(|_| PacketError::Length)
    }

    pub(in crate::stream) fn set(mut self, field: Field, value: u32) -> Self {
        let bytes = self.0.get_mut(field).unwrap_or_default();
        bytes.iter_mut().zip(value.to_le_bytes()).for_each(|(to, from)| *to = from);
        self
    }

    pub(in crate::stream) fn get(&self, field: Field) -> u32 {
        let bytes = self.0.get(field).unwrap_or_default();
        bytes.iter().rev().fold(0, |value, byte| value << 8 | u32::from(*byte))
    }

    pub(in crate::stream) fn seal(&self, buffer: &mut [u8]) -> Result<usize, EncodeError> {
        seal_whole(&self.0, buffer)
    }
}

/// Writes a packet whose contents are at hand. Here the code exists once and not per length.
fn seal_whole(content: &[u8], buffer: &mut [u8]) -> Result<usize, EncodeError> {
    seal(buffer, |writer| writer.put(content))
}
