//! Packets into a frame, in the caller's memory, and what to ask for again.

use core::fmt;

use super::codec::{RowPayload, unpack};
use super::crc::{FrameHash, RowHash};
use super::error::UnpackError;
use super::wire::{FrameHeader, Packet};

/// The memory that a frame is put together in.
///
/// The largest frame that it can hold is the largest that is accepted.
#[derive(Debug)]
pub struct Memory<'m> {
    /// The pixels: [`FrameHeader::frame_bytes`].
    pub pixels: &'m mut [u8],
    /// A flag for each row.
    pub rows: &'m mut [bool],
    /// For rows that were coded together: as long as the width. Without it, rows are taken that were
    /// sent each for itself.
    pub above: &'m mut [u16],
}

/// Puts one frame at a time together from packets: what a [`Receiver`](super::Receiver) does with them.
///
/// Use it where packets come some other way than over a line of bytes.
///
/// A frame begins with its header. A header of another frame begins that one, whatever is missing of the
/// old: the sender has moved on and could not repair it. A repeated header changes nothing. Rows may come
/// in any order and more than once; the first copy counts.
#[derive(Debug)]
pub struct Assembler<'a> {
    pixels: &'a mut [u8],
    rows: &'a mut [bool],
    above: &'a mut [u16],
    header: Option<FrameHeader>,
    /// Flags set in `rows`, and the sum of those rows' hashes.
    received: u16,
    hash: FrameHash,
    /// The hash from the frame's end, if that came before the last row.
    end: Option<FrameHash>,
    complete: bool,
    /// A packet of this frame has come last, but not its header; whether that is to be asked for.
    unknown: Option<(u16, bool)>,
    /// This frame's header has come and was no good: asking for it again would not help.
    refused: Option<u16>,
}

/// What a packet meant for the frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Event {
    /// A frame has begun.
    Started {
        /// Its header.
        header: FrameHeader,
        /// The id of the frame before it, if that one was still incomplete and is lost now.
        lost: Option<u16>,
    },
    /// Rows have come.
    Rows {
        /// The number of the first one, 0 at the top.
        y: u16,
        /// How many they are.
        count: u8,
    },
    /// All rows are here and the hash is right, for the first time.
    ///
    /// Comes in place of the last missing rows' [`Event::Rows`] when the end came before them.
    Complete,
    /// The end of a complete frame has come once more: the acknowledgement was lost.
    CompleteAgain,
    /// The end has come, but rows are missing.
    Incomplete {
        /// How many rows are missing.
        missing: u16,
    },
    /// All rows are here, but they are not those that the sender had. Which ones are wrong cannot be told,
    /// so all are missing again.
    HashMismatch,
    /// This header, or all of these rows are here already.
    Repeated,
    /// A packet of the back channel: nothing for a receiver.
    Ignored,
    /// A packet does not belong to the frame, or does not fit it. From a [`Receiver`](super::Receiver).
    Refused(ReceiveError),
    /// Nothing has come for so long that the frame was given up; what comes later is taken in all the
    /// same. From a [`Receiver`](super::Receiver).
    Silent {
        /// The frame's id.
        frame: u16,
    },
}

impl<'a> Assembler<'a> {
    /// An assembler that waits for its first header.
    #[must_use]
    pub const fn new(memory: Memory<'a>) -> Self {
        let Memory { pixels, rows, above } = memory;
        Self {
            pixels,
            rows,
            above,
            header: None,
            received: 0,
            hash: FrameHash::new(),
            end: None,
            complete: false,
            unknown: None,
            refused: None,
        }
    }

    /// Takes in one packet.
    ///
    /// # Errors
    ///
    /// [`ReceiveError`] if the packet does not belong to the frame or does not fit it. The frame is as it
    /// was; requests may change, because a packet of an unknown frame is a reason to ask for its header.
    pub fn accept(&mut self, packet: &Packet<'_>) -> Result<Event, ReceiveError> {
        match *packet {
            Packet::Header(header) => self.accept_header(header),
            Packet::Row { frame, y, payload } => self.accept_row(frame, y, payload),
            Packet::Rows { frame, y, count, payload } => self.accept_rows(frame, y, count, payload),
            Packet::End { frame, hash } => self.accept_end(frame, hash),
            Packet::Request(_) | Packet::Ack { .. } => Ok(Event::Ignored),
        }
    }

    /// The header of the current frame.
    #[must_use]
    pub const fn header(&self) -> Option<FrameHeader> {
        self.header
    }

    /// Whether all rows are here and the hash is right.
    #[must_use]
    pub const fn is_complete(&self) -> bool {
        self.complete
    }

    /// How many rows are here.
    #[must_use]
    pub const fn rows_received(&self) -> u16 {
        self.received
    }

    /// The pixels of the current frame, top row first, as little-endian bytes. Rows that are missing hold
    /// what was there before; without a frame there are no pixels.
    #[must_use]
    pub fn pixels(&self) -> &[u8] {
        let size = self.header.and_then(|header| header.frame_bytes());
        self.pixels.get(..size.unwrap_or(0)).unwrap_or_default()
    }

    /// The pixels of row `y` (0 at the top), if it is here.
    #[must_use]
    pub fn row(&self, y: u16) -> Option<&[u8]> {
        let header = self.header?;
        // Flags past the frame's height are never set.
        let here = *self.rows.get(usize::from(y))?;
        let start = usize::from(y).checked_mul(header.row_bytes())?;
        let row = self.pixels.get(start..)?.get(..header.row_bytes())?;
        here.then_some(row)
    }

    /// The numbers of the missing rows, from the top.
    pub fn missing(&self) -> impl Iterator<Item = u16> + '_ {
        let height = self.header.map_or(0, |header| header.height);
        (0..height).zip(self.rows.iter()).filter(|(_, here)| !**here).map(|(y, _)| y)
    }

    /// The missing rows from the top, as ranges: the first row's number, and how many they are.
    pub fn gaps(&self) -> impl Iterator<Item = (u16, u16)> + '_ {
        let mut missing = self.missing().peekable();
        core::iter::from_fn(move || {
            let first = missing.next()?;
            let mut count = 1;
            while missing.next_if_eq(&first.saturating_add(count)).is_some() {
                count += 1;
            }
            Some((first, count))
        })
    }

    /// The frame that is under way without a header, if there is one: two packets of it have come, one
    /// after the other, or one when nothing else was expected.
    #[must_use]
    pub const fn unknown(&self) -> Option<u16> {
        match self.unknown {
            Some((frame, true)) => Some(frame),
            _ => None,
        }
    }

    fn accept_header(&mut self, header: FrameHeader) -> Result<Event, ReceiveError> {
        if self.header == Some(header) {
            self.unknown = None;
            return Ok(Event::Repeated);
        }
        if let Err(error) = self.check(header) {
            self.unknown = None;
            self.refused = Some(header.frame);
            return Err(error);
        }
        let lost = self.header.filter(|_| !self.complete).map(|old| old.frame);
        self.header = Some(header);
        self.unknown = None;
        self.refused = None;
        self.forget_rows();
        Ok(Event::Started { header, lost })
    }

    /// Whether a frame can be taken in.
    fn check(&self, header: FrameHeader) -> Result<(), ReceiveError> {
        let fits = header.frame_bytes().is_some_and(|size| size <= self.pixels.len())
            && usize::from(header.height) <= self.rows.len();
        match () {
            () if header.is_empty() => Err(ReceiveError::Size),
            () if !fits => Err(ReceiveError::TooLarge),
            () => Ok(()),
        }
    }

    /// The bytes of row `y`, whether or not they are here.
    fn place(&mut self, header: &FrameHeader, y: u16) -> Option<&mut [u8]> {
        let start = usize::from(y).checked_mul(header.row_bytes())?;
        self.pixels.get_mut(start..)?.get_mut(..header.row_bytes())
    }

    fn accept_row(
        &mut self,
        frame: u16,
        y: u16,
        payload: RowPayload<'_>,
    ) -> Result<Event, ReceiveError> {
        let header = self.frame_of(frame)?;
        if y >= header.height {
            return Err(ReceiveError::Row);
        }
        if self.is_here(y) {
            return Ok(Event::Repeated);
        }
        // That row and flag lie within the slices has been checked with the header.
        let row = self.place(&header, y).ok_or(ReceiveError::TooLarge)?;
        payload.unpack(header.format, row).map_err(ReceiveError::Payload)?;
        self.row_came(&header, y);
        Ok(self.rows_came(&header, y, 1))
    }

    fn accept_rows(
        &mut self,
        frame: u16,
        y: u16,
        count: u8,
        payload: &[u8],
    ) -> Result<Event, ReceiveError> {
        let header = self.frame_of(frame)?;
        let end = y.checked_add(count.into()).filter(|end| *end <= header.height);
        let end = end.ok_or(ReceiveError::Row)?;
        if (y..end).all(|y| self.is_here(y)) {
            return Ok(Event::Repeated);
        }
        let rows = usize::from(y)..usize::from(end);
        let [from, to] = [rows.start, rows.end].map(|row| row.saturating_mul(header.row_bytes()));
        let FrameHeader { format, palette, width, .. } = header;
        let pixels = self.pixels.get_mut(from..to).ok_or(ReceiveError::TooLarge)?;
        let here = self.rows.get(rows).ok_or(ReceiveError::TooLarge)?;
        unpack(format, &palette, width, payload, pixels, here, self.above)
            .map_err(ReceiveError::Payload)?;
        for y in y..end {
            if !self.is_here(y) {
                self.row_came(&header, y);
            }
        }
        Ok(self.rows_came(&header, y, count))
    }

    fn is_here(&self, y: u16) -> bool {
        self.rows.get(usize::from(y)).is_some_and(|here| *here)
    }

    /// Row `y` has been written.
    fn row_came(&mut self, header: &FrameHeader, y: u16) {
        let mut hash = RowHash::new(y);
        hash.update(self.place(header, y).unwrap_or_default());
        self.hash.add(hash.finish());
        self.received = self.received.saturating_add(1);
        if let Some(here) = self.rows.get_mut(usize::from(y)) {
            *here = true;
        }
    }

    /// What it means that rows have come.
    fn rows_came(&mut self, header: &FrameHeader, y: u16, count: u8) -> Event {
        match self.end {
            Some(hash) if self.received == header.height => self.conclude(hash),
            _ => Event::Rows { y, count },
        }
    }

    fn accept_end(&mut self, frame: u16, hash: FrameHash) -> Result<Event, ReceiveError> {
        let header = self.frame_of(frame)?;
        if self.received == header.height {
            return Ok(self.conclude(hash));
        }
        self.end = Some(hash);
        Ok(Event::Incomplete { missing: header.height.saturating_sub(self.received) })
    }

    /// The current header, if a packet of frame `frame` belongs to it.
    fn frame_of(&mut self, frame: u16) -> Result<FrameHeader, ReceiveError> {
        match self.header {
            Some(header) if header.frame == frame => {
                self.unknown = None;
                Ok(header)
            }
            current => {
                if self.refused == Some(frame) {
                    self.unknown = None;
                } else {
                    // A late packet of the frame before is no reason to ask for that one's header.
                    let is_expected = current.is_none_or(|_| self.complete);
                    let is_second = self.unknown.is_some_and(|(before, _)| before == frame);
                    self.unknown = Some((frame, is_expected || is_second));
                }
                Err(ReceiveError::UnknownFrame)
            }
        }
    }

    /// Compares the hashes when all rows are here.
    fn conclude(&mut self, hash: FrameHash) -> Event {
        if hash == self.hash {
            let again = core::mem::replace(&mut self.complete, true);
            return if again { Event::CompleteAgain } else { Event::Complete };
        }
        self.forget_rows();
        Event::HashMismatch
    }

    fn forget_rows(&mut self) {
        self.rows.fill(false);
        self.received = 0;
        self.hash = FrameHash::new();
        self.end = None;
        self.complete = false;
    }
}

/// Why a packet was not taken in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum ReceiveError {
    /// The header's frame has no pixels.
    Size,
    /// The header's frame does not fit into the receiver's slices.
    TooLarge,
    /// The packet is of a frame whose header has not been accepted.
    UnknownFrame,
    /// The frame has no row of this number.
    Row,
    /// The row's pixels are not one row of the frame.
    Payload(UnpackError),
}

impl ReceiveError {
    /// The error in words.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Size => "frame has no pixels",
            Self::TooLarge => "frame does not fit into the receiver's memory",
            Self::UnknownFrame => "packet of a frame without a header",
            Self::Row => "frame has no row of this number",
            Self::Payload(error) => error.as_str(),
        }
    }
}

impl fmt::Display for ReceiveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

impl core::error::Error for ReceiveError {}
