//! Bytes into packets: a push parser that any byte can be thrown at.

use cobs::{DecodeResult, DecoderState};

use super::packet::{Packet, PacketError};

/// Finds packets in a stream of bytes, one byte at a time, whatever the bytes are.
///
/// `N` is the longest packet that it can hold, in bytes: [`packet_capacity`](super::packet_capacity) of
/// the frames to come, or [`CONTROL_CAPACITY`](super::CONTROL_CAPACITY) for a back channel.
///
/// Each bad packet gives one error and ends at its terminator; the packet after that terminator is
/// not affected. Zero bytes between packets are skipped.
///
/// ```
/// use scancsg::stream::{CONTROL_CAPACITY, Decoder, Packet, PacketError, encode_ack};
///
/// let mut line = [0; 32];
/// line[..4].copy_from_slice(b"\x09no\x00"); // promises eight bytes, brings two
/// let end = 4 + encode_ack(7, &mut line[4..]).unwrap();
///
/// let mut decoder: Decoder<CONTROL_CAPACITY> = Decoder::new();
/// let mut bytes = &line[..end];
/// assert_eq!(decoder.feed(&mut bytes), Some(Err(PacketError::Framing)));
/// assert_eq!(decoder.feed(&mut bytes), Some(Ok(Packet::Ack { frame: 7 })));
/// assert_eq!(decoder.feed(&mut bytes), None);
/// ```
#[derive(Debug)]
pub struct Decoder<const N: usize> {
    buffer: [u8; N],
    framing: Framing,
}

impl<const N: usize> Decoder<N> {
    /// A decoder at the start of a packet.
    #[must_use]
    pub const fn new() -> Self {
        Self { buffer: [0; N], framing: Framing::new() }
    }

    /// Takes in one byte. Returns the packet that it completes, or what is wrong with it.
    pub fn push(&mut self, byte: u8) -> Option<Result<Packet<'_>, PacketError>> {
        let end = self.framing.step(&mut self.buffer, byte)?;
        Some(self.parse(end))
    }

    /// Takes in `bytes` up to the end of the first packet, good or bad, and leaves the rest in `bytes`.
    /// `None` when all bytes have been taken in and the packet goes on.
    pub fn feed(&mut self, bytes: &mut &[u8]) -> Option<Result<Packet<'_>, PacketError>> {
        loop {
            let (&byte, rest) = bytes.split_first()?;
            *bytes = rest;
            if let Some(end) = self.framing.step(&mut self.buffer, byte) {
                return Some(self.parse(end));
            }
        }
    }

    fn parse(&self, end: Result<usize, PacketError>) -> Result<Packet<'_>, PacketError> {
        Packet::parse(self.buffer.get(..end?).unwrap_or_default())
    }
}

impl<const N: usize> Default for Decoder<N> {
    fn default() -> Self {
        Self::new()
    }
}

/// The state between two bytes, apart from the buffer, so that this code exists once and not per size.
#[derive(Debug)]
struct Framing {
    cobs: DecoderState,
    /// Decoded bytes in the buffer.
    len: usize,
    /// The packet was too long and has been reported; all is dropped up to the terminator.
    skipping: bool,
}

impl Framing {
    const fn new() -> Self {
        Self { cobs: DecoderState::Idle, len: 0, skipping: false }
    }

    /// Takes in one byte. At the end of a packet: its size in the buffer, or why it has none.
    fn step(&mut self, buffer: &mut [u8], byte: u8) -> Option<Result<usize, PacketError>> {
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
