//! The packets of the back channel: requests and acknowledgements.

use super::fields::{Field, Fields};
use crate::stream::error::{EncodeError, PacketError};
use crate::stream::framing::framed;

pub(super) const REQUEST: u8 = 0x81;
const REQUEST_FRAME: Field = 1..3;
const REQUEST_PART: Field = 3..4;
const REQUEST_Y: Field = 4..6;
const REQUEST_COUNT: Field = 6..8;
const REQUEST_LIMIT: Field = 8..9;
const REQUEST_LEN: usize = REQUEST_LIMIT.end;
const PART_HEADER: u8 = 0;
const PART_ROWS: u8 = 1;
const PART_END: u8 = 2;

pub(super) const ACK: u8 = 0x82;
const ACK_FRAME: Field = 1..3;
const ACK_LEN: usize = ACK_FRAME.end;

/// The bytes that a request or an acknowledgement needs.
pub(in crate::stream) const REQUEST_CAPACITY: usize = 1 + framed(REQUEST_LEN);
/// The part of a frame that a request asks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Part {
    /// The frame header.
    Header,
    /// Some rows, one below the other.
    Rows {
        /// The number of the first one, 0 at the top.
        y: u16,
        /// How many, at least one.
        count: u16,
        /// A packet of several rows should have no more bytes of contents than this: where much gets
        /// lost, short packets get through.
        limit: u8,
    },
    /// The end of the frame with its hash.
    End,
}

/// A receiver's request: send this part of this frame again.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Request {
    /// The frame's id.
    pub frame: u16,
    /// The part that is wanted.
    pub part: Part,
}

impl Request {
    pub(super) fn parse(content: &[u8]) -> Result<Self, PacketError> {
        let fields = Fields::<REQUEST_LEN>::read(content)?;
        let part = match fields.get(REQUEST_PART) as u8 {
            PART_HEADER => Part::Header,
            PART_ROWS => Part::Rows {
                y: fields.get(REQUEST_Y) as u16,
                count: fields.get(REQUEST_COUNT) as u16,
                limit: fields.get(REQUEST_LIMIT) as u8,
            },
            PART_END => Part::End,
            _ => return Err(PacketError::Part),
        };
        Ok(Self { frame: fields.get(REQUEST_FRAME) as u16, part })
    }
}

/// Encodes a request, from a receiver to its sender, with a zero byte before it: a sender that was busy
/// may have heard the end of an earlier one.
///
/// # Errors
///
/// [`EncodeError::BufferTooSmall`].
pub fn encode_request(request: Request, buffer: &mut [u8]) -> Result<usize, EncodeError> {
    let (part, y, count, limit) = match request.part {
        Part::Header => (PART_HEADER, 0, 0, 0),
        Part::Rows { y, count, limit } => (PART_ROWS, y, count, limit),
        Part::End => (PART_END, 0, 0, 0),
    };
    let (cut, rest) = buffer.split_first_mut().ok_or(EncodeError::BufferTooSmall)?;
    *cut = 0;
    let len = Fields::<REQUEST_LEN>::new(REQUEST)
        .set(REQUEST_FRAME, request.frame.into())
        .set(REQUEST_PART, part.into())
        .set(REQUEST_Y, y.into())
        .set(REQUEST_COUNT, count.into())
        .set(REQUEST_LIMIT, limit.into())
        .seal(rest)?;
    Ok(1 + len)
}

/// The frame that is acknowledged.
pub(super) fn parse_ack(content: &[u8]) -> Result<u16, PacketError> {
    Ok(Fields::<ACK_LEN>::read(content)?.get(ACK_FRAME) as u16)
}

/// Encodes the acknowledgement of a complete frame, from a receiver to its sender, with a zero byte before
/// it.
///
/// # Errors
///
/// [`EncodeError::BufferTooSmall`].
pub fn encode_ack(frame: u16, buffer: &mut [u8]) -> Result<usize, EncodeError> {
    let (cut, rest) = buffer.split_first_mut().ok_or(EncodeError::BufferTooSmall)?;
    *cut = 0;
    Ok(1 + Fields::<ACK_LEN>::new(ACK).set(ACK_FRAME, frame.into()).seal(rest)?)
}
