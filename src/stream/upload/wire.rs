//! The two packets of an upload, laid out as those of [`wire`](super::super::wire).

use super::super::error::{EncodeError, PacketError};
use super::super::framing::{framed, seal, unseal};
use super::super::wire::{Field, Fields};

const CHUNK: u8 = 0x83;
const CHUNK_LENGTH: Field = 1..3;
const CHUNK_HASH: Field = 3..7;
const CHUNK_OFFSET: Field = 7..9;
/// The bytes are from here on.
const CHUNK_LEN: usize = CHUNK_OFFSET.end;

const STATUS: u8 = 0x05;
const STATUS_HASH: Field = 1..5;
const STATUS_HAVE: Field = 5..7;
const STATUS_REFUSAL: Field = 7..8;
const STATUS_CAPACITY: Field = 8..10;
const STATUS_NUMBER: Field = 10..11;
const STATUS_LEN: usize = STATUS_NUMBER.end;

/// The most bytes of an upload in a packet: then it is one COBS block.
pub(super) const CHUNK_BYTES: usize = 240;

/// The buffer for a chunk on its way out, and, unframed, on its way in.
pub(super) const CHUNK_ROOM: usize = 1 + framed(CHUNK_LEN + CHUNK_BYTES);

/// The buffer for a status.
pub(super) const STATUS_ROOM: usize = 1 + framed(STATUS_LEN);

crate::error_text! {
    /// Why a device doesn't take an upload.
    pub enum Refusal {
        /// It is longer than the device's memory for it.
        TooLong => "it is longer than the device has room for",
        /// Its numbers are of another type than the device computes in.
        Number => "the device computes in another number type",
        /// It has a part of a kind that the device's firmware doesn't name.
        Kind => "it has a part of a kind that the device doesn't know",
        /// It has more parts, poses or faces in a pool than the device has room for.
        TooLarge => "it has more parts, poses or faces than the device has room for",
        /// It isn't what the device takes, for any other reason.
        Invalid => "it is nothing that the device can read",
    }
}

/// What the codes from 1 on mean. 0 is no refusal.
const REFUSALS: [Refusal; 5] =
    [Refusal::TooLong, Refusal::Number, Refusal::Kind, Refusal::TooLarge, Refusal::Invalid];

/// Some bytes of an upload.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Chunk<'a> {
    /// The number of all bytes, and their CRC-32: they tell uploads apart.
    pub(super) length: u16,
    pub(super) hash: u32,
    pub(super) offset: u16,
    /// None of them, behind all others, hands the upload over.
    pub(super) bytes: &'a [u8],
}

impl<'a> Chunk<'a> {
    /// The chunk in these bytes, which have been taken out of their COBS frame.
    pub(super) fn parse(bytes: &'a [u8]) -> Result<Self, PacketError> {
        let (fields, bytes) = unseal(bytes)?.split_first_chunk().ok_or(PacketError::Length)?;
        let fields = Fields::<CHUNK_LEN>(*fields);
        if fields.get(0..1) != u32::from(CHUNK) {
            return Err(PacketError::Kind);
        }
        Ok(Self {
            length: fields.get(CHUNK_LENGTH) as u16,
            hash: fields.get(CHUNK_HASH),
            offset: fields.get(CHUNK_OFFSET) as u16,
            bytes,
        })
    }

    /// Writes the packet, with a zero byte before it.
    pub(super) fn encode(&self, buffer: &mut [u8]) -> Result<usize, EncodeError> {
        let (cut, rest) = buffer.split_first_mut().ok_or(EncodeError::BufferTooSmall)?;
        *cut = 0;
        let fields = Fields::<CHUNK_LEN>::new(CHUNK)
            .set(CHUNK_LENGTH, self.length.into())
            .set(CHUNK_HASH, self.hash)
            .set(CHUNK_OFFSET, self.offset.into());
        let len = seal(rest, |writer| {
            writer.put(&fields.0)?;
            if self.bytes.is_empty() { Ok(()) } else { writer.put(self.bytes) }
        })?;
        Ok(1 + len)
    }
}

/// What a device says of an upload, and of itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Status {
    /// The upload's.
    pub(super) hash: u32,
    /// So many bytes of it are there: those behind are wanted.
    pub(super) have: u16,
    pub(super) refusal: Option<Refusal>,
    pub(super) device: Device,
}

/// What a device takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Device {
    /// The most bytes of an upload.
    pub capacity: u16,
    /// The number type that it computes in, as in the header of a program: 32 for `f32`, 16 for `I16F16`.
    pub number: u8,
}

impl Status {
    /// The status in these bytes, which have been taken out of their COBS frame.
    pub(super) fn parse(bytes: &[u8]) -> Result<Self, PacketError> {
        let fields = Fields::<STATUS_LEN>::read(unseal(bytes)?)?;
        if fields.get(0..1) != u32::from(STATUS) {
            return Err(PacketError::Kind);
        }
        let code = fields.get(STATUS_REFUSAL) as usize;
        let refusal = code.checked_sub(1).map(|index| REFUSALS.get(index));
        Ok(Self {
            hash: fields.get(STATUS_HASH),
            have: fields.get(STATUS_HAVE) as u16,
            // Codes of a later version are refusals, too.
            refusal: refusal.map(|known| known.copied().unwrap_or(Refusal::Invalid)),
            device: Device {
                capacity: fields.get(STATUS_CAPACITY) as u16,
                number: fields.get(STATUS_NUMBER) as u8,
            },
        })
    }

    /// Writes the packet, with a zero byte before it.
    pub(super) fn encode(&self, buffer: &mut [u8]) -> Result<usize, EncodeError> {
        let (cut, rest) = buffer.split_first_mut().ok_or(EncodeError::BufferTooSmall)?;
        *cut = 0;
        let code = REFUSALS.iter().position(|refusal| Some(*refusal) == self.refusal);
        let len = Fields::<STATUS_LEN>::new(STATUS)
            .set(STATUS_HASH, self.hash)
            .set(STATUS_HAVE, self.have.into())
            .set(STATUS_REFUSAL, code.map_or(0, |index| index as u32 + 1))
            .set(STATUS_CAPACITY, self.device.capacity.into())
            .set(STATUS_NUMBER, self.device.number.into())
            .seal(rest)?;
        Ok(1 + len)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stream::framing::Reader;

    /// What is between two zeros, taken out of its COBS frame.
    fn unframed<'a>(line: &[u8], buffer: &'a mut [u8]) -> &'a [u8] {
        let mut reader = Reader::new();
        let mut ends = line.iter().filter_map(|byte| reader.step(buffer, *byte));
        let (Some(Ok(len)), None) = (ends.next(), ends.next()) else { panic!("not one packet") };
        &buffer[..len]
    }

    /// The bytes were written down from the table of the documentation. Every number in them is different.
    #[test]
    fn packets_are_laid_out_as_documented() {
        let (mut line, mut buffer) = ([0; 64], [0; 64]);
        let (length, hash, offset) = (0x2211, 0x6655_4433, 0x8877);
        for bytes in [&[0x99, 0, 0xAA][..], &[]] {
            let chunk = Chunk { length, hash, offset, bytes };
            let len = chunk.encode(&mut line).unwrap();
            let packet = unframed(&line[..len], &mut buffer);
            let start = [0x83, 0x11, 0x22, 0x33, 0x44, 0x55, 0x66, 0x77, 0x88];
            assert_eq!(unseal(packet).unwrap().strip_prefix(&start), Some(bytes));
            assert_eq!(Chunk::parse(packet), Ok(chunk));
            assert_eq!(Status::parse(packet), Err(PacketError::Length));
        }
        for (code, refusal) in [
            (0, None),
            (1, Some(Refusal::TooLong)),
            (2, Some(Refusal::Number)),
            (3, Some(Refusal::Kind)),
            (4, Some(Refusal::TooLarge)),
            (5, Some(Refusal::Invalid)),
        ] {
            let device = Device { capacity: 0x9988, number: 0xAA };
            let status = Status { hash: 0x4433_2211, have: 0x6655, refusal, device };
            let len = status.encode(&mut line).unwrap();
            let packet = unframed(&line[..len], &mut buffer);
            let bytes = [0x05, 0x11, 0x22, 0x33, 0x44, 0x55, 0x66, code, 0x88, 0x99, 0xAA];
            assert_eq!(unseal(packet), Ok(&bytes[..]));
            assert_eq!(Status::parse(packet), Ok(status));
            assert_eq!(Chunk::parse(packet), Err(PacketError::Kind));
        }
    }
}
