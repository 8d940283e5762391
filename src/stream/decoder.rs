//! Bytes into packets: a push parser that any byte can be thrown at.

use super::error::PacketError;
use super::framing::Reader;
use super::wire::Packet;

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
    reader: Reader,
}

impl<const N: usize> Decoder<N> {
    /// A decoder at the start of a packet.
    #[must_use]
    pub const fn new() -> Self {
        Self { buffer: [0; N], reader: Reader::new() }
    }

    /// Takes in one byte. Returns the packet that it completes, or what is wrong with it.
    pub fn push(&mut self, byte: u8) -> Option<Result<Packet<'_>, PacketError>> {
        let end = self.reader.step(&mut self.buffer, byte)?;
        Some(self.parse(end))
    }

    /// Takes in `bytes` up to the end of the first packet, good or bad, and leaves the rest in `bytes`.
    /// `None` when all bytes have been taken in and the packet goes on.
    pub fn feed(&mut self, bytes: &mut &[u8]) -> Option<Result<Packet<'_>, PacketError>> {
        loop {
            let (&byte, rest) = bytes.split_first()?;
            *bytes = rest;
            if let Some(end) = self.reader.step(&mut self.buffer, byte) {
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
