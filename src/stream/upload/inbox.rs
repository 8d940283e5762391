//! The device's end of an upload, without I/O: bytes in, answers and a whole upload out.

use super::super::crc::crc32;
use super::super::framing::Reader;
use super::wire::{CHUNK_ROOM, Chunk, Device, Refusal, STATUS_ROOM, Status};

/// Takes uploads, one after the other: a state machine without I/O or clock.
///
/// Use it where [`take`](super::take) doesn't fit. Give it what the line brings
/// ([`receive`](Self::receive)), and write what [`answer`](Self::answer) returns. An upload that is handed
/// over is in [`bytes`](Self::bytes): answer it with a frame, or [`refuse`](Self::refuse) it.
///
/// ```
/// use scancsg::stream::{Inbox, Outcome, Patience, Refusal, Upload, UploadTask};
///
/// let mut memory = [0; 64];
/// let mut inbox = Inbox::new(&mut memory, 32);
///
/// // The other end; see `Upload`.
/// let mut upload = Upload::new(b"no program", Patience { ticks: 100, silences: 3 });
/// let outcome = loop {
///     match upload.poll(0) {
///         UploadTask::Send(bytes) => {
///             for byte in bytes {
///                 if inbox.receive(*byte) {
///                     assert_eq!(inbox.bytes(), b"no program");
///                     inbox.refuse(Refusal::Invalid);
///                 }
///             }
///             upload.sent(0);
///         }
///         UploadTask::Listen(_) => {
///             let answer = inbox.answer().unwrap_or_default();
///             answer.iter().for_each(|byte| upload.receive(*byte, 0));
///         }
///         UploadTask::Done(outcome) => break outcome,
///     }
/// };
/// assert_eq!(outcome, Outcome::Refused(Refusal::Invalid));
/// ```
#[derive(Debug)]
pub struct Inbox<'m> {
    memory: &'m mut [u8],
    packet: [u8; CHUNK_ROOM],
    reader: Reader,
    number: u8,
    /// The upload that the memory is for.
    length: u16,
    hash: u32,
    /// So many of its first bytes are there.
    have: u16,
    refusal: Option<Refusal>,
    /// So many bytes have been handed over and are still there.
    given: u16,
    /// The upload to say the status of.
    asked: Option<(u16, u32)>,
    answer: [u8; STATUS_ROOM],
}

impl<'m> Inbox<'m> {
    /// An empty one. The memory is for a whole upload; of more than 65,535 bytes, so many are used.
    ///
    /// `number` is told to the other end: the number type of the programs that are taken, as in the header
    /// of a program (32 for `f32`, 16 for `I16F16`), or 0 for other bytes.
    #[must_use]
    pub const fn new(memory: &'m mut [u8], number: u8) -> Self {
        Self {
            memory,
            packet: [0; CHUNK_ROOM],
            reader: Reader::new(),
            number,
            length: 0,
            hash: 0,
            have: 0,
            refusal: None,
            given: 0,
            asked: None,
            answer: [0; STATUS_ROOM],
        }
    }

    /// Takes in a byte. Returns whether it hands an upload over, whole and checked.
    pub fn receive(&mut self, byte: u8) -> bool {
        let Some(Ok(len)) = self.reader.step(&mut self.packet, byte) else { return false };
        // What can't be read is sent again.
        let Ok(chunk) = Chunk::parse(self.packet.get(..len).unwrap_or_default()) else {
            return false;
        };
        let Chunk { length, hash, offset, bytes } = chunk;
        self.asked = Some((length, hash));
        // A question, or nothing that there is room for.
        if length == 0 || usize::from(length) > self.memory.len() {
            return false;
        }
        if (length, hash) != (self.length, self.hash) {
            // Only its start begins an upload: other chunks may be late ones of an earlier upload.
            if offset != 0 {
                return false;
            }
            (self.length, self.hash, self.have, self.refusal) = (length, hash, 0, None);
            // A refusal would be of this one.
            self.given = 0;
        }
        if offset != self.have || self.refusal.is_some() {
            return false;
        }
        if bytes.is_empty() {
            return self.have == length && self.hand_over();
        }
        let start = usize::from(offset);
        let rest = self.memory.get_mut(start..length.into()).unwrap_or_default();
        let Some(place) = rest.get_mut(..bytes.len()) else { return false };
        place.copy_from_slice(bytes);
        (self.have, self.given) = ((start + bytes.len()) as u16, 0);
        false
    }

    fn hand_over(&mut self) -> bool {
        self.have = 0;
        let bytes = self.memory.get(..self.length.into()).unwrap_or_default();
        // Each packet had a checksum of its own, so this is seldom wrong.
        if crc32(bytes) != self.hash {
            return false;
        }
        (self.given, self.asked) = (self.length, None);
        true
    }

    /// The upload that was handed over last, until another one comes; then nothing.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        self.memory.get(..self.given.into()).unwrap_or_default()
    }

    /// Doesn't want the upload that was handed over last: tells the other end why, now and whenever it sends
    /// the same bytes again.
    pub const fn refuse(&mut self, why: Refusal) {
        if self.given > 0 {
            self.refusal = Some(why);
            self.asked = Some((self.length, self.hash));
        }
    }

    /// The bytes of the next answer, if there is one. It is given once: if it gets lost, the other end asks
    /// again.
    pub fn answer(&mut self) -> Option<&[u8]> {
        let (length, hash) = self.asked.take()?;
        let capacity = u16::try_from(self.memory.len()).unwrap_or(u16::MAX);
        let (have, refusal) = match () {
            () if length > capacity => (0, Some(Refusal::TooLong)),
            () if (length, hash) == (self.length, self.hash) => (self.have, self.refusal),
            () => (0, None),
        };
        let device = Device { capacity, number: self.number };
        let len = Status { hash, have, refusal, device }.encode(&mut self.answer).ok()?;
        self.answer.get(..len)
    }
}
