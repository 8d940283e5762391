//! The packets of the link: what they say, and their layout between framing and meaning.
//!
//! `[kind u8][body][crc32 u32]`, little-endian throughout; the CRC covers kind and body. The layouts of
//! the bodies are in the [table of this layer](super).

use super::crc::{FrameHash, crc32};
use super::pixel::PixelFormat;
use super::rle;

/// The version of the protocol, sent in every frame header. Another version is refused, not guessed at.
pub const PROTOCOL_VERSION: u8 = 1;

/// The first byte of each packet. The back channel's kinds have the top bit set.
pub(super) mod kind {
    pub(crate) const HEADER: u8 = 0x01;
    pub(crate) const ROW: u8 = 0x02;
    pub(crate) const END: u8 = 0x03;
    pub(crate) const REQUEST: u8 = 0x81;
    pub(crate) const ACK: u8 = 0x82;
}

/// The tags of a request's part.
mod part {
    pub(super) const HEADER: u8 = 0;
    pub(super) const ROW: u8 = 1;
    pub(super) const END: u8 = 2;
}

/// What a receiver must know before a frame's first row.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FrameHeader {
    /// The frame's id. Frames in a row need different ids: a header that equals the last one is taken
    /// for its repetition. Counting up and wrapping around is enough.
    pub frame: u16,
    /// Pixels in a row, 1..=65535.
    pub width: u16,
    /// Rows in the frame, 1..=65535.
    pub height: u16,
    /// The format of all its pixels.
    pub format: PixelFormat,
}

impl FrameHeader {
    /// Whether the frame has no pixels. Neither end accepts such a frame.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.width == 0 || self.height == 0
    }

    /// The size of one row's pixels in bytes, uncompressed.
    #[must_use]
    pub const fn row_bytes(&self) -> usize {
        // Saturates only where usize has 16 bits; no slice is that long, so it still compares rightly.
        (self.width as usize).saturating_mul(self.format.bytes_per_pixel())
    }

    /// The size of all pixels in bytes, uncompressed, or `None` if it is beyond `usize`.
    #[must_use]
    pub const fn frame_bytes(&self) -> Option<usize> {
        self.row_bytes().checked_mul(self.height as usize)
    }
}

/// How a row's pixels are written down.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
#[repr(u8)]
pub enum Encoding {
    /// The pixels' little-endian bytes, one after the other.
    Raw = 0,
    /// PackBits runs in units of pixels.
    PackBits = 1,
}

impl Encoding {
    /// The encoding with this code, if there is one.
    #[must_use]
    pub const fn from_code(code: u8) -> Option<Self> {
        match code {
            0 => Some(Self::Raw),
            1 => Some(Self::PackBits),
            _ => None,
        }
    }

    /// The code of this encoding on the link.
    #[must_use]
    pub const fn code(self) -> u8 {
        self as u8
    }
}

/// A row's pixels as they came over the link.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RowPayload<'a> {
    /// How the bytes are to be read.
    pub encoding: Encoding,
    /// The bytes, in that encoding.
    pub bytes: &'a [u8],
}

impl RowPayload<'_> {
    /// Writes the row's pixels, as little-endian bytes, into the whole of `row`.
    ///
    /// # Errors
    ///
    /// [`UnpackError`] if the payload is not exactly one row of `row.len()` bytes in `format`. Nothing is
    /// written then.
    ///
    /// ```
    /// use scancsg::stream::{Encoding, PixelFormat, RowPayload};
    ///
    /// // Three copies of one RGB565 pixel: control byte 1 - 3 = -2.
    /// let payload = RowPayload { encoding: Encoding::PackBits, bytes: &[0xFE, 0x34, 0x12] };
    /// let mut row = [0; 6];
    /// assert_eq!(payload.unpack(PixelFormat::Rgb565, &mut row), Ok(()));
    /// assert_eq!(row, [0x34, 0x12, 0x34, 0x12, 0x34, 0x12]);
    /// ```
    pub fn unpack(&self, format: PixelFormat, row: &mut [u8]) -> Result<(), UnpackError> {
        match self.encoding {
            Encoding::PackBits => rle::unpack(self.bytes, format, row),
            Encoding::Raw if self.bytes.len() > row.len() => Err(UnpackError::TooLong),
            Encoding::Raw if self.bytes.len() < row.len() => Err(UnpackError::TooShort),
            Encoding::Raw => {
                // The lengths are equal; a zip cannot panic, and compiles to the same copy.
                for (to, from) in row.iter_mut().zip(self.bytes) {
                    *to = *from;
                }
                Ok(())
            }
        }
    }
}

/// Why a payload is not the row that it should be.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum UnpackError {
    /// The payload ends inside a run or a pixel.
    Truncated,
    /// The payload holds more than the row.
    TooLong,
    /// The payload holds less than the row.
    TooShort,
}

crate::error_text!(UnpackError {
    Truncated => "row payload ends inside a run",
    TooLong => "row payload is longer than the row",
    TooShort => "row payload is shorter than the row",
});

/// The part of a frame that a request asks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Part {
    /// The frame header.
    Header,
    /// The row with this number, 0 at the top.
    Row(u16),
    /// The end of the frame with its hash.
    End,
}

impl Part {
    /// The part's tag and row number (0 where there is none).
    pub(super) const fn code(self) -> (u8, u16) {
        match self {
            Self::Header => (part::HEADER, 0),
            Self::Row(y) => (part::ROW, y),
            Self::End => (part::END, 0),
        }
    }

    const fn from_code(tag: u8, y: u16) -> Option<Self> {
        match tag {
            part::HEADER => Some(Self::Header),
            part::ROW => Some(Self::Row(y)),
            part::END => Some(Self::End),
            _ => None,
        }
    }
}

/// A receiver's request: send this part of this frame again.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Request {
    /// The frame's id.
    pub frame: u16,
    /// The part that is wanted.
    pub part: Part,
}

/// One packet, whole and checked. Rows borrow their bytes from the decoder.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Packet<'a> {
    /// A frame begins.
    Header(FrameHeader),
    /// One row of a frame.
    Row {
        /// The frame's id.
        frame: u16,
        /// The row's number, 0 at the top.
        y: u16,
        /// The row's pixels.
        payload: RowPayload<'a>,
    },
    /// All rows of a frame have been sent.
    End {
        /// The frame's id.
        frame: u16,
        /// The hash of all its rows.
        hash: FrameHash,
    },
    /// Back channel: something is wanted again.
    Request(Request),
    /// Back channel: the frame is complete and its hash is right.
    Ack {
        /// The frame's id.
        frame: u16,
    },
}

impl<'a> Packet<'a> {
    /// The packet in these bytes, which have been taken out of their COBS frame.
    pub(super) fn parse(bytes: &'a [u8]) -> Result<Self, PacketError> {
        let (content, crc) = bytes.split_last_chunk().ok_or(PacketError::Length)?;
        let (&kind, body) = content.split_first().ok_or(PacketError::Length)?;
        // First of all: a packet that was damaged must not be blamed for what it seems to say.
        if crc32(content) != u32::from_le_bytes(*crc) {
            return Err(PacketError::Crc);
        }
        match kind {
            kind::HEADER => parse_header(body),
            kind::ROW => parse_row(body),
            kind::END => {
                let &[f0, f1, h0, h1, h2, h3] = body else {
                    return Err(PacketError::Length);
                };
                Ok(Packet::End {
                    frame: u16::from_le_bytes([f0, f1]),
                    hash: FrameHash::from_value(u32::from_le_bytes([h0, h1, h2, h3])),
                })
            }
            kind::REQUEST => {
                let &[f0, f1, tag, y0, y1] = body else {
                    return Err(PacketError::Length);
                };
                let part = Part::from_code(tag, u16::from_le_bytes([y0, y1]));
                Ok(Packet::Request(Request {
                    frame: u16::from_le_bytes([f0, f1]),
                    part: part.ok_or(PacketError::Part)?,
                }))
            }
            kind::ACK => {
                let &[f0, f1] = body else {
                    return Err(PacketError::Length);
                };
                Ok(Packet::Ack { frame: u16::from_le_bytes([f0, f1]) })
            }
            _ => Err(PacketError::Kind),
        }
    }
}

fn parse_header(body: &[u8]) -> Result<Packet<'_>, PacketError> {
    // The version comes before the length: another version may well have another layout.
    let (&version, body) = body.split_first().ok_or(PacketError::Length)?;
    if version != PROTOCOL_VERSION {
        return Err(PacketError::Version);
    }
    let &[f0, f1, w0, w1, h0, h1, format] = body else {
        return Err(PacketError::Length);
    };
    let header = FrameHeader {
        frame: u16::from_le_bytes([f0, f1]),
        width: u16::from_le_bytes([w0, w1]),
        height: u16::from_le_bytes([h0, h1]),
        format: PixelFormat::from_code(format).ok_or(PacketError::Format)?,
    };
    if header.is_empty() {
        return Err(PacketError::Size);
    }
    Ok(Packet::Header(header))
}

fn parse_row(body: &[u8]) -> Result<Packet<'_>, PacketError> {
    let [f0, f1, y0, y1, encoding, bytes @ ..] = body else {
        return Err(PacketError::Length);
    };
    let encoding = Encoding::from_code(*encoding).ok_or(PacketError::Encoding)?;
    // No frame has rows without pixels.
    if bytes.is_empty() {
        return Err(PacketError::Length);
    }
    Ok(Packet::Row {
        frame: u16::from_le_bytes([*f0, *f1]),
        y: u16::from_le_bytes([*y0, *y1]),
        payload: RowPayload { encoding, bytes },
    })
}

/// Why the bytes up to a terminator are not a packet. The next packet is not affected.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum PacketError {
    /// The terminator came inside a COBS block.
    Framing,
    /// The packet does not fit into the decoder's buffer.
    TooLong,
    /// The checksum is wrong.
    Crc,
    /// The kind is unknown.
    Kind,
    /// The packet has a wrong length for its kind.
    Length,
    /// The header is of another protocol version than [`PROTOCOL_VERSION`].
    Version,
    /// The header's pixel format is unknown.
    Format,
    /// The header's width or height is zero.
    Size,
    /// The row's encoding is unknown.
    Encoding,
    /// The request's part is unknown.
    Part,
}

crate::error_text!(PacketError {
    Framing => "packet ends inside a COBS block",
    TooLong => "packet is longer than the decoder's buffer",
    Crc => "packet checksum is wrong",
    Kind => "packet kind is unknown",
    Length => "packet has a wrong length for its kind",
    Version => "frame header is of another protocol version",
    Format => "pixel format is unknown",
    Size => "frame has no pixels",
    Encoding => "row encoding is unknown",
    Part => "requested part is unknown",
});
