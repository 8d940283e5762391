//! Packets between their meaning and the line: checksum and COBS framing, both ways.
//!
//! The contents of a packet, kind and body, get a CRC-32 behind them; COBS makes all of that free of
//! zeros; a zero ends it. Both happen on the fly, straight into the caller's buffer: there is no second
//! one.

use cobs::{CobsEncoder, DecodeResult, DecoderState};

use super::crc::{Crc32, crc32, crc32_start};
use super::error::{EncodeError, PacketError};

/// The size of the checksum behind a packet's contents.
const CRC_LEN: usize = size_of::<u32>();

/// The most bytes on the line that a packet of `len` bytes of contents takes: the checksum, one COBS code
/// byte per 254 bytes begun, and the terminator.
pub(super) const fn framed(len: usize) -> usize {
    let len = len.saturating_add(CRC_LEN);
    len.saturating_add(len.div_ceil(254)).saturating_add(1)
}

/// A packet on its way into a buffer.
pub(super) struct Writer<'a> {
    cobs: CobsEncoder<'a>,
    crc: Crc32,
}

impl Writer<'_> {
    /// Takes in the next bytes of the contents. They must not be none: after a full block of 254 an
    /// empty push makes the COBS encoder count one byte too many.
    pub(super) fn put(&mut self, bytes: &[u8]) -> Result<(), EncodeError> {
        self.crc.update(bytes);
        self.cobs.push(bytes).map_err(|_| EncodeError::BufferTooSmall)
    }

    /// Adds the checksum. Returns the size of the COBS frame, which may be beyond the buffer: the COBS
    /// encoder checks bytes that it writes, not the last code byte.
    fn finish(mut self) -> Result<usize, EncodeError> {
        let crc = self.crc.finalize().to_le_bytes();
        self.cobs.push(&crc).map_err(|_| EncodeError::BufferTooSmall)?;
        Ok(self.cobs.finalize())
    }
}

/// Writes the packet whose contents `fill` puts in. Returns its size, terminator included.
pub(super) fn seal(
    buffer: &mut [u8],
    fill: impl FnOnce(&mut Writer<'_>) -> Result<(), EncodeError>,
) -> Result<usize, EncodeError> {
    let mut writer = Writer { cobs: CobsEncoder::new(buffer), crc: crc32_start() };
    fill(&mut writer)?;
    let len = writer.finish()?;
    // Where the frame ended beyond the buffer, there is no place for the terminator either.
    *buffer.get_mut(len).ok_or(EncodeError::BufferTooSmall)? = 0;
    Ok(len + 1)
}

/// The most contents of a packet that is framed in its own buffer, checksum included: one COBS block.
const BLOCK: usize = 254;

/// The buffer of such a packet: with the code byte before it and the terminator behind it.
pub(super) const IN_PLACE: usize = 1 + BLOCK + 1;

/// The place of the contents of a packet that is framed in its own buffer: `limit` bytes, or as many as
/// fit.
pub(super) fn in_place(buffer: &mut [u8], limit: usize) -> &mut [u8] {
    let room = buffer.len().min(IN_PLACE).saturating_sub(2 + CRC_LEN).min(limit);
    buffer.get_mut(1..1 + room).unwrap_or_default()
}

/// Makes a packet of `start` and of the `len` bytes that are in the place of its contents behind that.
/// Returns its size, terminator included.
pub(super) fn seal_in_place(
    buffer: &mut [u8],
    start: &[u8],
    len: usize,
) -> Result<usize, EncodeError> {
    let end = 1 + start.len().saturating_add(len);
    let packet = buffer.get_mut(..end + CRC_LEN + 1).ok_or(EncodeError::BufferTooSmall)?;
    if packet.len() > IN_PLACE {
        return Err(EncodeError::BufferTooSmall);
    }
    packet.iter_mut().skip(1).zip(start).for_each(|(to, from)| *to = *from);
    let crc = crc32(packet.get(1..end).unwrap_or_default()).to_le_bytes();
    packet.iter_mut().skip(end).zip(crc).for_each(|(to, from)| *to = from);
    // From the last byte to the first: each zero becomes the distance to the next one.
    if let [contents @ .., terminator] = packet {
        *terminator = 0;
        if let Some(code) = contents.first_mut() {
            *code = 0;
        }
        let mut distance = 1;
        for byte in contents.iter_mut().rev() {
            if *byte == 0 {
                (*byte, distance) = (distance, 0);
            }
            distance += 1;
        }
    }
    Ok(packet.len())
}

/// The contents of a packet that has been taken out of its COBS frame, if the checksum is right.
pub(super) fn unseal(bytes: &[u8]) -> Result<&[u8], PacketError> {
    let (content, crc) = bytes.split_last_chunk().ok_or(PacketError::Length)?;
    if content.is_empty() {
        return Err(PacketError::Length);
    }
    if crc32(content) != u32::from_le_bytes(*crc) {
        return Err(PacketError::Crc);
    }
    Ok(content)
}

/// The state of a reader between two bytes, apart from the buffer, so that this code exists once and not
/// per size.
#[derive(Debug)]
pub(super) struct Reader {
    cobs: DecoderState,
    /// Decoded bytes in the buffer.
    len: usize,
    /// The packet was too long and has been reported; all is dropped up to the terminator.
    skipping: bool,
}

impl Reader {
    /// The state at the start of a packet.
    pub(super) const fn new() -> Self {
        Self { cobs: DecoderState::Idle, len: 0, skipping: false }
    }

    /// Takes in one byte. At the end of a packet: its size in the buffer, or why it has none.
    pub(super) fn step(
        &mut self,
        buffer: &mut [u8],
        byte: u8,
    ) -> Option<Result<usize, PacketError>> {
        // The cobs crate has whole decoders too, but when their buffer is full they give an error for
        // every further byte and then, at the terminator, pass the truncated packet off as a good one.
        if self.skipping {
            if byte == 0 {
                *self = Self::new();
            }
            return None;
        }
        match self.cobs.feed(byte) {
            Ok(DecodeResult::NoData) => None,
            Ok(DecodeResult::DataStart) => {
                self.len = 0;
                None
            }
            Ok(DecodeResult::DataContinue(data)) => {
                let Some(slot) = buffer.get_mut(self.len) else {
                    self.skipping = true;
                    return Some(Err(PacketError::TooLong));
                };
                *slot = data;
                self.len += 1;
                None
            }
            Ok(DecodeResult::DataComplete) => Some(Ok(self.len)),
            // Only ever at a zero byte: it ends the bad packet, and the next byte begins a new one.
            Err(_) => Some(Err(PacketError::Framing)),
        }
    }
}
