//! The host's end of an upload, without I/O: packets out, answers in.

use super::super::crc::crc32;
use super::super::framing::Reader;
use super::super::sender::Patience;
use super::super::wire::{CONTROL_CAPACITY, Packet};
use super::wire::{CHUNK_BYTES, CHUNK_ROOM, Chunk, Device, Refusal, Status};

/// How an [`Upload`] ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Outcome {
    /// The device has all of it, and a frame has begun. An upload of no bytes: the device has answered.
    Taken,
    /// The device doesn't want it.
    Refused(Refusal),
    /// The device said nothing for as long as there was [`Patience`], or it lost again and again what it had.
    Unheard,
}

/// What an [`Upload`] wants next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum UploadTask<'a> {
    /// Write these bytes, then call [`Upload::sent`].
    Send(&'a [u8]),
    /// Flush the line, and listen for so many ticks.
    Listen(u32),
    /// The upload is over.
    Done(Outcome),
}

/// The fewest bytes of a chunk, but for the last one.
const MIN_BYTES: usize = 15;

/// Sends bytes, as those of a program, to a device that takes them with [`take`](super::take): a state machine
/// without I/O or clock.
///
/// [`poll`](Self::poll) says what to do next, [`receive`](Self::receive) takes what the device says. Chunks that
/// get lost are sent again, and are shorter then. A device that was reset gets all of it anew. A device that is
/// busy with a frame doesn't listen: be patient for longer than a frame takes.
///
/// When it is [`Taken`](Outcome::Taken), packets of the frame have come already: keep what comes behind a status, or
/// let the [`Receiver`](crate::stream::Receiver) ask for them again.
///
/// An upload of no bytes only asks what the device takes: see [`device`](Self::device).
///
/// There is an example at [`Inbox`](super::Inbox).
#[derive(Debug)]
pub struct Upload<'b> {
    bytes: &'b [u8],
    hash: u32,
    patience: Patience,
    packet: [u8; CHUNK_ROOM],
    /// So many bytes of the packet wait to be written.
    ready: usize,
    answer: [u8; CONTROL_CAPACITY],
    reader: Reader,
    /// The device has so many bytes, and those behind are sent next, or are on their way.
    offset: usize,
    is_due: bool,
    /// The device was told that it has everything.
    is_offered: bool,
    since: u32,
    /// Sends in a row that nothing new was heard of.
    silences: u16,
    /// How often the device had less than before, since it had more than ever.
    losses: u16,
    /// The most that the device ever had.
    most: usize,
    /// The most bytes of a chunk.
    limit: usize,
    device: Option<Device>,
    outcome: Option<Outcome>,
}

impl<'b> Upload<'b> {
    /// An upload of which nothing is sent. More than 65,535 bytes are [`Refused`](Outcome::Refused) at once.
    ///
    /// [`ticks`](Patience::ticks) without an answer, and a chunk is sent again. After as many
    /// [`silences`](Patience::silences) in a row, the upload counts as unheard. So it does if a device loses what it
    /// has as many times, and never has more than before.
    #[must_use]
    pub const fn new(bytes: &'b [u8], patience: Patience) -> Self {
        let is_long = bytes.len() > u16::MAX as usize;
        Self {
            bytes,
            hash: crc32(bytes),
            patience,
            packet: [0; CHUNK_ROOM],
            ready: 0,
            answer: [0; CONTROL_CAPACITY],
            reader: Reader::new(),
            offset: 0,
            is_due: true,
            is_offered: false,
            since: 0,
            silences: 0,
            losses: 0,
            most: 0,
            limit: CHUNK_BYTES,
            device: None,
            outcome: if is_long { Some(Outcome::Refused(Refusal::TooLong)) } else { None },
        }
    }

    /// What the device takes, if it has said so.
    #[must_use]
    pub const fn device(&self) -> Option<Device> {
        self.device
    }

    /// So many bytes of the upload are in the device.
    #[must_use]
    pub const fn delivered(&self) -> usize {
        self.offset
    }

    /// What to do next.
    pub fn poll(&mut self, now: u32) -> UploadTask<'_> {
        if let Some(outcome) = self.outcome {
            return UploadTask::Done(outcome);
        }
        if self.ready == 0 {
            let waited = now.wrapping_sub(self.since);
            if !self.is_due && waited < self.patience.ticks {
                return UploadTask::Listen(self.patience.ticks - waited);
            }
            if !self.is_due {
                self.limit = (self.limit / 2).max(MIN_BYTES);
                self.silences = self.silences.saturating_add(1);
                if self.is_enough(self.silences) {
                    return UploadTask::Done(Outcome::Unheard);
                }
            }
            self.seal();
        }
        UploadTask::Send(self.packet.get(..self.ready).unwrap_or_default())
    }

    /// Whether something has happened so often that the upload is over.
    const fn is_enough(&mut self, times: u16) -> bool {
        let is_end = times >= self.patience.silences;
        if is_end {
            self.outcome = Some(Outcome::Unheard);
        }
        is_end
    }

    /// Makes the packet that is next.
    fn seal(&mut self) {
        let rest = self.bytes.get(self.offset..).unwrap_or_default();
        let bytes = rest.get(..self.limit).unwrap_or(rest);
        let (length, offset) = (self.bytes.len() as u16, self.offset as u16);
        let chunk = Chunk { length, hash: self.hash, offset, bytes };
        // Cannot fail: the buffer is large enough.
        self.ready = chunk.encode(&mut self.packet).unwrap_or_default();
        self.is_due = false;
        self.is_offered |= bytes.is_empty();
    }

    /// The bytes of [`UploadTask::Send`] are written.
    pub const fn sent(&mut self, now: u32) {
        (self.ready, self.since) = (0, now);
    }

    /// Takes in a byte that the device sent.
    pub fn receive(&mut self, byte: u8, now: u32) {
        let Some(Ok(len)) = self.reader.step(&mut self.answer, byte) else { return };
        if self.outcome.is_some() {
            return;
        }
        let packet = self.answer.get(..len).unwrap_or_default();
        match Status::parse(packet) {
            Ok(status) => self.heard(status, now),
            // A frame is the answer to a whole upload. Those before it were of another one.
            Err(_) if self.is_offered && !self.bytes.is_empty() => match Packet::parse(packet) {
                Ok(Packet::Request(_) | Packet::Ack { .. }) | Err(_) => {}
                Ok(_) => {
                    self.offset = self.bytes.len();
                    self.outcome = Some(Outcome::Taken);
                }
            },
            Err(_) => {}
        }
    }

    fn heard(&mut self, status: Status, now: u32) {
        let have = usize::from(status.have);
        if status.hash != self.hash || have > self.bytes.len() {
            return;
        }
        self.device = Some(status.device);
        if let Some(refusal) = status.refusal {
            self.outcome = Some(Outcome::Refused(refusal));
            return;
        }
        if self.bytes.is_empty() {
            self.outcome = Some(Outcome::Taken);
            return;
        }
        // An answer that says nothing new may be a late one: the clock decides then, lest each packet is sent
        // twice from now on.
        if have == self.offset {
            return;
        }
        if have > self.most {
            (self.most, self.losses) = (have, 0);
        }
        if have > self.offset {
            self.limit = (self.limit * 2).min(CHUNK_BYTES);
        } else {
            self.losses = self.losses.saturating_add(1);
            if self.is_enough(self.losses) {
                return;
            }
        }
        self.silences = 0;
        (self.offset, self.is_due, self.since) = (have, true, now);
    }
}
