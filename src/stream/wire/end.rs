//! The packet that ends a frame.

use super::fields::{Field, Fields};
use crate::stream::crc::FrameHash;
use crate::stream::error::{EncodeError, PacketError};

pub(super) const END: u8 = 0x03;
const END_FRAME: Field = 1..3;
const END_HASH: Field = 3..7;
const END_LEN: usize = END_HASH.end;

/// The frame, and the hash of its rows.
pub(super) fn parse_end(content: &[u8]) -> Result<(u16, FrameHash), PacketError> {
    let fields = Fields::<END_LEN>::read(content)?;
    Ok((fields.get(END_FRAME) as u16, FrameHash::from_value(fields.get(END_HASH))))
}

/// Encodes the end of a frame with the hash of all its rows.
///
/// # Errors
///
/// [`EncodeError::BufferTooSmall`].
pub fn encode_end(frame: u16, hash: FrameHash, buffer: &mut [u8]) -> Result<usize, EncodeError> {
    Fields::<END_LEN>::new(END)
        .set(END_FRAME, frame.into())
        .set(END_HASH, hash.value())
        .seal(buffer)
}
