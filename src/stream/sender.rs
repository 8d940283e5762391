//! Frames into a writer, row by row, with repairs.

use core::fmt;

use embedded_io::Write;

use super::crc::{FrameHash, RowHash};
use super::error::EncodeError;
use super::pixel::WirePixel;
use super::wire::{FrameHeader, encode_end, encode_header, encode_row, packet_capacity};
use crate::render::RowError;

/// Sends frames row by row.
///
/// `N` is the size of its packet buffer in bytes: [`packet_capacity`] of the widest frame to come.
/// Nothing is kept of a row: to send it again, render it again.
///
/// Each packet is one [`write_all`](Write::write_all). When a write fails, the sender's state is as it was
/// before the call, so that the call can be repeated; since a part of the packet may be on the line, the
/// next packet then goes out behind a zero byte, which cuts that part off.
pub struct Sender<W, const N: usize> {
    writer: W,
    packet: [u8; N],
    frame: Option<Frame>,
    bytes_sent: u64,
    /// A write has failed, perhaps in the middle of a packet.
    cut: bool,
}

#[derive(Clone, Copy)]
struct Frame {
    header: FrameHeader,
    /// The next row of the sweep; as many have been sent and hashed.
    next: u16,
    hash: FrameHash,
    ended: bool,
}

impl<W, const N: usize> Sender<W, N> {
    /// A sender with no frame begun.
    #[must_use]
    pub const fn new(writer: W) -> Self {
        Self { writer, packet: [0; N], frame: None, bytes_sent: 0, cut: false }
    }

    /// The header of the frame that was begun last.
    #[must_use]
    pub fn header(&self) -> Option<FrameHeader> {
        self.frame.map(|frame| frame.header)
    }

    /// The bytes of all packets that the writer has taken whole, and of zeros before packets.
    #[must_use]
    pub const fn bytes_sent(&self) -> u64 {
        self.bytes_sent
    }

    /// The writer. What is written past the sender should end with a zero byte.
    pub const fn writer_mut(&mut self) -> &mut W {
        &mut self.writer
    }

    /// The writer, when the sender is no longer needed.
    #[must_use]
    pub fn into_inner(self) -> W {
        self.writer
    }
}

impl<W: Write, const N: usize> Sender<W, N> {
    /// Begins a frame and sends its header. A frame that was under way is abandoned.
    ///
    /// # Errors
    ///
    /// [`SendError::Encode`] if the frame has no pixels or `N` is too small for its rows;
    /// [`SendError::Io`].
    pub fn begin(&mut self, header: FrameHeader) -> Result<(), SendError<W::Error>> {
        // Now, and not at the first row that happens not to be compressible.
        if packet_capacity(header.width, header.format) > N {
            return Err(SendError::Encode(EncodeError::BufferTooSmall));
        }
        self.send_header(header)?;
        self.frame = Some(Frame { header, next: 0, hash: FrameHash::new(), ended: false });
        Ok(())
    }

    /// Sends the frame's next row; `y` counts up from 0.
    ///
    /// # Errors
    ///
    /// [`SendError::NoFrame`], [`SendError::Format`], [`SendError::Width`], [`SendError::Row`] or
    /// [`SendError::Order`] if this is not the frame's next row; [`SendError::Io`].
    pub fn row<P: WirePixel>(&mut self, y: u16, pixels: &[P]) -> Result<(), SendError<W::Error>> {
        let mut frame = self.frame_of(y, pixels)?;
        // The sum of the hashes is right only if every row is in it once.
        if y != frame.next {
            return Err(SendError::Order);
        }
        self.send_row(frame.header.frame, y, pixels)?;
        frame.hash.add(RowHash::of(y, pixels));
        frame.next = frame.next.saturating_add(1);
        self.frame = Some(frame);
        Ok(())
    }

    /// Sends row `y` once more, because it was asked for. Rows may come in any order; they do not count
    /// in the frame's hash.
    ///
    /// # Errors
    ///
    /// As [`row`](Self::row), without [`SendError::Order`].
    pub fn resend_row<P: WirePixel>(
        &mut self,
        y: u16,
        pixels: &[P],
    ) -> Result<(), SendError<W::Error>> {
        let frame = self.frame_of(y, pixels)?;
        self.send_row(frame.header.frame, y, pixels)
    }

    /// Sends the header once more, because it was asked for. The frame goes on as it was.
    ///
    /// # Errors
    ///
    /// [`SendError::NoFrame`]; [`SendError::Io`].
    pub fn header_again(&mut self) -> Result<(), SendError<W::Error>> {
        let frame = self.frame.ok_or(SendError::NoFrame)?;
        self.send_header(frame.header)
    }

    /// Ends the frame: sends the hash of its rows and flushes the writer.
    ///
    /// # Errors
    ///
    /// [`SendError::NoFrame`]; [`SendError::RowsLeft`] if not all rows have been sent; [`SendError::Io`].
    pub fn end(&mut self) -> Result<(), SendError<W::Error>> {
        let mut frame = self.frame.ok_or(SendError::NoFrame)?;
        if frame.next < frame.header.height {
            return Err(SendError::RowsLeft);
        }
        let len = encode_end(frame.header.frame, frame.hash, &mut self.packet)
            .map_err(SendError::Encode)?;
        self.transmit(len)?;
        self.writer.flush().map_err(SendError::Io)?;
        frame.ended = true;
        self.frame = Some(frame);
        Ok(())
    }

    /// Sends the end once more, because it was asked for or no acknowledgement has come.
    ///
    /// # Errors
    ///
    /// [`SendError::NoFrame`]; [`SendError::NotEnded`] if [`end`](Self::end) has not succeeded yet, so that
    /// a request in mid-frame does not end it; [`SendError::Io`].
    pub fn end_again(&mut self) -> Result<(), SendError<W::Error>> {
        let frame = self.frame.ok_or(SendError::NoFrame)?;
        if !frame.ended {
            return Err(SendError::NotEnded);
        }
        self.end()
    }

    /// The frame, if these pixels can be its row `y`.
    fn frame_of<P: WirePixel>(&self, y: u16, pixels: &[P]) -> Result<Frame, SendError<W::Error>> {
        let frame = self.frame.ok_or(SendError::NoFrame)?;
        match () {
            () if P::FORMAT != frame.header.format => Err(SendError::Format),
            () if pixels.len() != usize::from(frame.header.width) => Err(SendError::Width),
            () if y >= frame.header.height => Err(SendError::Row),
            () => Ok(frame),
        }
    }

    fn send_header(&mut self, header: FrameHeader) -> Result<(), SendError<W::Error>> {
        let len = encode_header(header, &mut self.packet).map_err(SendError::Encode)?;
        self.transmit(len)
    }

    fn send_row<P: WirePixel>(
        &mut self,
        frame: u16,
        y: u16,
        pixels: &[P],
    ) -> Result<(), SendError<W::Error>> {
        let len = encode_row(frame, y, pixels, &mut self.packet).map_err(SendError::Encode)?;
        self.transmit(len)
    }

    /// Writes the first `len` bytes of the packet buffer.
    fn transmit(&mut self, len: usize) -> Result<(), SendError<W::Error>> {
        if self.cut {
            self.writer.write_all(&[0]).map_err(SendError::Io)?;
            self.bytes_sent = self.bytes_sent.wrapping_add(1);
        }
        let packet = self.packet.get(..len).unwrap_or_default();
        self.cut = true;
        self.writer.write_all(packet).map_err(SendError::Io)?;
        self.cut = false;
        self.bytes_sent = self.bytes_sent.wrapping_add(packet.len() as u64);
        Ok(())
    }
}

/// Why something could not be sent. The sender's state is as it was.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SendError<E> {
    /// The writer failed.
    Io(E),
    /// The packet cannot be encoded.
    Encode(EncodeError),
    /// No frame has been begun.
    NoFrame,
    /// The pixels are not in the frame's format.
    Format,
    /// The row is not as wide as the frame.
    Width,
    /// The frame has no row of this number.
    Row,
    /// The row is not the next one.
    Order,
    /// Not all rows have been sent.
    RowsLeft,
    /// The frame has not been ended.
    NotEnded,
    /// The row can't be rendered.
    Render(RowError),
    /// The line failed while answers were listened for.
    Listen(E),
    /// No more answers can come: the line's other end is closed.
    Closed,
}

impl<E> SendError<E> {
    /// The error in words. Of a line's own error only that there is one:
    /// [`source`](core::error::Error::source) has the rest.
    #[must_use]
    pub const fn as_str(&self) -> &'static str {
        match self {
            Self::Io(_) => "writer failed",
            Self::Encode(error) => error.as_str(),
            Self::NoFrame => "no frame has been begun",
            Self::Format => "pixels are not in the frame's format",
            Self::Width => "row is not as wide as the frame",
            Self::Row => "frame has no row of this number",
            Self::Order => "row is not the next one",
            Self::RowsLeft => "not all rows have been sent",
            Self::NotEnded => "frame has not been ended",
            Self::Render(error) => error.as_str(),
            Self::Listen(_) => "reader failed",
            Self::Closed => "line is closed at its other end",
        }
    }
}

impl<E> fmt::Display for SendError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

impl<E: core::error::Error + 'static> core::error::Error for SendError<E> {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Io(error) | Self::Listen(error) => Some(error),
            _ => None,
        }
    }
}
