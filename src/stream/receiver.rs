//! Packets into a frame, in the caller's memory, and what to ask for again.

use core::fmt;

use super::codec::RowPayload;
use super::crc::{FrameHash, RowHash};
use super::error::UnpackError;
use super::wire::{FrameHeader, Packet, Part, Request};

/// Puts one frame at a time together.
///
/// It holds no memory of its own: pixels and one flag per row are slices of the caller's, the largest
/// frame that they can hold is the largest that is accepted.
///
/// A frame begins with its header. A header of another frame begins that one, whatever is missing of the
/// old: the sender has moved on and could not repair it. A repeated header changes nothing. Rows may come
/// in any order and more than once; the first copy counts.
#[derive(Debug)]
pub struct Receiver<'a> {
    pixels: &'a mut [u8],
    rows: &'a mut [bool],
    header: Option<FrameHeader>,
    /// Flags set in `rows`, and the sum of those rows' hashes.
    received: u16,
    hash: FrameHash,
    /// The hash from the frame's end, if that came before the last row.
    end: Option<FrameHash>,
    complete: bool,
    /// Packets of this frame have come, but not its header.
    unknown: Option<u16>,
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
    /// A row has come.
    Row {
        /// Its number, 0 at the top.
        y: u16,
    },
    /// All rows are here and the hash is right. Answer with [`encode_ack`](super::encode_ack).
    ///
    /// Comes in place of the last missing row's [`Event::Row`] when the end came before that row, and once
    /// more for every repeated end, since then the acknowledgement was lost.
    Complete,
    /// The end has come, but rows are missing. Answer with [`Receiver::requests`].
    Incomplete {
        /// How many rows are missing.
        missing: u16,
    },
    /// All rows are here, but they are not those that the sender had. Which ones are wrong cannot be told,
    /// so all are missing again. Answer with [`Receiver::requests`].
    HashMismatch,
    /// This header or row is here already.
    Repeated,
    /// A packet of the back channel: nothing for a receiver.
    Ignored,
}

impl<'a> Receiver<'a> {
    /// A receiver that waits for its first header.
    ///
    /// A frame needs `width · height · bytes_per_pixel` bytes of `pixels` and `height` flags of `rows`.
    #[must_use]
    pub const fn new(pixels: &'a mut [u8], rows: &'a mut [bool]) -> Self {
        Self {
            pixels,
            rows,
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

    /// What to ask the sender for: the header of a frame that is under way without one, or the missing
    /// rows, or, with all rows here, the end. Nothing if the frame is complete or nothing is known.
    ///
    /// The receiver has no clock. The time to ask is after [`Event::Incomplete`] or
    /// [`Event::HashMismatch`], and when the line has been quiet for longer than a row takes to be rendered
    /// and sent: before, rows are "missing" that are yet to come.
    pub fn requests(&self) -> impl Iterator<Item = Request> + '_ {
        let header = self.unknown.map(|frame| Request { frame, part: Part::Header });
        let current = self.header.filter(|_| self.unknown.is_none() && !self.complete);
        let rows = current.into_iter().flat_map(|header| {
            self.missing().map(move |y| Request { frame: header.frame, part: Part::Row(y) })
        });
        let end = current
            .filter(|header| self.received == header.height)
            .map(|header| Request { frame: header.frame, part: Part::End });
        header.into_iter().chain(rows).chain(end)
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
        // That row and flag lie within the slices has been checked with the header.
        let start = usize::from(y).saturating_mul(header.row_bytes());
        let row = self
            .pixels
            .get_mut(start..)
            .and_then(|rest| rest.get_mut(..header.row_bytes()))
            .ok_or(ReceiveError::TooLarge)?;
        let here = self.rows.get_mut(usize::from(y)).ok_or(ReceiveError::TooLarge)?;
        if *here {
            return Ok(Event::Repeated);
        }
        payload.unpack(header.format, row).map_err(ReceiveError::Payload)?;
        *here = true;
        let mut hash = RowHash::new(y);
        hash.update(row);
        self.hash.add(hash.finish());
        self.received = self.received.saturating_add(1);
        match self.end {
            Some(hash) if self.received == header.height => Ok(self.conclude(hash)),
            _ => Ok(Event::Row { y }),
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
            _ => {
                if self.refused != Some(frame) {
                    self.unknown = Some(frame);
                }
                Err(ReceiveError::UnknownFrame)
            }
        }
    }

    /// Compares the hashes when all rows are here.
    fn conclude(&mut self, hash: FrameHash) -> Event {
        if hash == self.hash {
            self.complete = true;
            return Event::Complete;
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
