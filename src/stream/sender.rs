//! The sending end, without I/O: rows in, packets out, requests in.

use super::codec::{Coding, RowCoding};
use super::crc::RowHash;
use super::decoder::Decoder;
use super::error::EncodeError;
use super::pixel::{Wire, WirePixel};
use super::schedule::{MAX_LIMIT, Open, Schedule, Target, Wanted};
use super::wire::{
    FrameHeader, Packet, REQUEST_CAPACITY, encode_row, row_capacity, rows_payload, seal_rows,
};

pub use super::schedule::{Delivery, Patience};

/// What a [`Sender`] wants next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Task<'a> {
    /// Write these bytes, then call [`Sender::sent`].
    Send(&'a [u8]),
    /// Give the pixels of this row to [`Sender::row`]. The same row may be wanted twice, one time after
    /// the other: keep it until another one is wanted, and it is rendered once.
    Row(u16),
    /// Flush the line, and listen for so many ticks.
    Listen(u32),
    /// The frame is over.
    Done(Delivery),
}

/// Sends frames row by row, and repairs them: a state machine without I/O or clock.
///
/// Use it where [`serve`](super::serve) and [`serve_async`](super::serve_async) don't fit, as in an
/// interrupt handler. [`poll`](Self::poll) says what to do next, [`receive`](Self::receive) takes what
/// the other end says. Nothing is kept of a row: to send it again, it is rendered again.
///
/// `C` says how rows are coded: [`Plain`](super::Plain), each for itself, or
/// [`Predictive`](super::Predictive), several in a packet and much shorter. `N` is the size of the packet
/// buffer in bytes: [`row_capacity`] of the widest frame to come, better
/// [`packet_capacity`](super::packet_capacity) for several rows in a packet.
///
/// ```
/// use scancsg::render::{Gray8, Palette};
/// use scancsg::stream::{
///     Delivery, FrameHeader, Patience, PixelFormat, Plain, Sender, Task, encode_ack, row_capacity,
/// };
///
/// const CAPACITY: usize = row_capacity(4, PixelFormat::Gray8);
/// let mut sender = Sender::<_, CAPACITY>::new(Plain, Patience { ticks: 100, silences: 3 });
/// let (format, palette) = (PixelFormat::Gray8, Palette::EMPTY);
/// sender.begin(FrameHeader { frame: 1, width: 4, height: 2, format, palette })?;
///
/// let mut line = Vec::new();
/// let delivery = loop {
///     match sender.poll(0) {
///         Task::Send(bytes) => {
///             line.extend_from_slice(bytes);
///             sender.sent(0);
///         }
///         Task::Row(y) => sender.row(y, &[Gray8(y as u8); 4])?,
///         Task::Listen(_) => {
///             // The other end answers.
///             let mut answer = [0; 16];
///             let length = encode_ack(1, &mut answer)?;
///             answer[..length].iter().for_each(|byte| sender.receive(*byte, 0));
///         }
///         Task::Done(delivery) => break delivery,
///     }
/// };
/// assert_eq!(delivery, Delivery::Acknowledged { repairs: 0 });
/// # Ok::<(), scancsg::stream::EncodeError>(())
/// ```
#[derive(Debug)]
pub struct Sender<C, const N: usize> {
    coding: C,
    packet: [u8; N],
    schedule: Schedule,
    decoder: Decoder<REQUEST_CAPACITY>,
}

impl<C, const N: usize> Sender<C, N> {
    /// A sender with no frame begun.
    #[must_use]
    pub const fn new(coding: C, patience: Patience) -> Self {
        Self { coding, packet: [0; N], schedule: Schedule::new(patience), decoder: Decoder::new() }
    }

    /// The header of the frame that was begun last.
    #[must_use]
    pub const fn header(&self) -> Option<FrameHeader> {
        self.schedule.header
    }

    /// The bytes of all packets that were sent.
    #[must_use]
    pub const fn bytes_sent(&self) -> u64 {
        self.schedule.bytes_sent
    }

    /// Takes in a byte that the other end sent.
    pub fn receive(&mut self, byte: u8, now: u32) {
        // What can't be read is asked for again by the other end.
        match self.decoder.push(byte) {
            Some(Ok(Packet::Ack { frame })) => self.schedule.acknowledge(frame, now),
            Some(Ok(Packet::Request(request))) => self.schedule.ask(request, now),
            _ => {}
        }
    }

    /// The bytes of [`Task::Send`] are written.
    pub fn sent(&mut self, now: u32) {
        self.schedule.sent(now);
    }
}

impl<C: Coding, const N: usize> Sender<C, N> {
    /// Begins a frame. One that was under way is abandoned.
    ///
    /// # Errors
    ///
    /// [`EncodeError::Size`] if the frame has no pixels; [`EncodeError::BufferTooSmall`] if `N` is less
    /// than [`row_capacity`].
    pub fn begin(&mut self, header: FrameHeader) -> Result<(), EncodeError> {
        if header.is_empty() {
            return Err(EncodeError::Size);
        }
        // Now, and not at the first row that happens not to be compressible.
        if row_capacity(header.width, header.format) > N {
            return Err(EncodeError::BufferTooSmall);
        }
        self.coding.begin_frame(&header.palette);
        self.schedule.begin(header);
        Ok(())
    }

    /// What to do next.
    pub fn poll(&mut self, now: u32) -> Task<'_> {
        if self.schedule.ready == 0 && self.schedule.is_packet_full() {
            self.seal();
        }
        let wanted = self.schedule.poll(&mut self.packet, now);
        match wanted {
            Wanted::Packet => {
                Task::Send(self.packet.get(..self.schedule.ready).unwrap_or_default())
            }
            Wanted::Row(y) => Task::Row(y),
            Wanted::Silence(ticks) => Task::Listen(ticks),
            Wanted::Nothing(delivery) => Task::Done(delivery),
        }
    }

    /// Makes a packet of the rows that have been coded.
    fn seal(&mut self) {
        let Some((header, Open { y, count, .. })) = self.schedule.close() else { return };
        let len = self.coding.finish(rows_payload(&mut self.packet, MAX_LIMIT.into()));
        // The payload is in its place, so that there is room for the packet.
        self.schedule.ready =
            seal_rows(header.frame, y, count, len, &mut self.packet).unwrap_or_default();
    }

    /// Takes the pixels of the row that [`poll`](Self::poll) wants. It may want the same row again.
    ///
    /// # Errors
    ///
    /// [`EncodeError::NoFrame`], [`EncodeError::Format`], [`EncodeError::Width`] or
    /// [`EncodeError::Order`] if this is not the row that is wanted: one that has been asked for since
    /// [`poll`](Self::poll) may be wanted before it. Nothing has changed then: poll again.
    pub fn row<P: WirePixel>(&mut self, y: u16, pixels: &[P]) -> Result<(), EncodeError>
    where
        C: RowCoding<P>,
    {
        let Target { header, is_repair, limit } = self.schedule.target(y)?;
        if P::Wire::FORMAT != header.format {
            return Err(EncodeError::Format);
        }
        if pixels.len() != usize::from(header.width) {
            return Err(EncodeError::Width);
        }
        if self.schedule.open.is_none() {
            self.coding.begin();
        }
        let open = self.schedule.open.unwrap_or(Open { y, count: 0, is_repair });
        let payload = rows_payload(&mut self.packet, limit.into());
        let mut fits = open.is_followed_by(y, is_repair) && self.coding.push(pixels, payload);
        if !fits && open.count == 0 && limit < MAX_LIMIT {
            // A row that is longer than the limit is still shorter so than by itself.
            self.coding.begin();
            fits = self.coding.push(pixels, rows_payload(&mut self.packet, MAX_LIMIT.into()));
        }
        match (fits, open.count) {
            (true, count) => self.schedule.open = Some(Open { count: count + 1, ..open }),
            (false, 0) => {
                self.schedule.open = None;
                self.schedule.ready = encode_row(header.frame, y, pixels, &mut self.packet)?;
            }
            (false, _) => {
                self.seal();
                return Ok(());
            }
        }
        self.schedule.row_taken(is_repair, || RowHash::of(y, pixels));
        Ok(())
    }
}
