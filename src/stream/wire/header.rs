//! The packet that begins a frame.

use super::fields::{Field, Fields};
use crate::render::{Palette, Rgb};
use crate::stream::error::{EncodeError, PacketError};
use crate::stream::framing::seal;
use crate::stream::pixel::PixelFormat;

/// The version of the protocol, sent in every frame header. Another version is refused, not guessed at.
pub const PROTOCOL_VERSION: u8 = 2;

pub(super) const HEADER: u8 = 0x01;
const HEADER_VERSION: Field = 1..2;
const HEADER_FRAME: Field = 2..4;
const HEADER_WIDTH: Field = 4..6;
const HEADER_HEIGHT: Field = 6..8;
const HEADER_FORMAT: Field = 8..9;
const HEADER_COLORS: Field = 9..10;
/// So many colours are from here on, three bytes each.
const HEADER_LEN: usize = HEADER_COLORS.end;
pub(super) const HEADER_MAX: usize = HEADER_LEN + 3 * Palette::CAPACITY;

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
    /// The colours of its surfaces, which rows are coded by.
    pub palette: Palette,
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
        self.format.row_bytes(self.width)
    }

    /// The size of all pixels in bytes, uncompressed, or `None` if it is beyond `usize`.
    #[must_use]
    pub const fn frame_bytes(&self) -> Option<usize> {
        self.row_bytes().checked_mul(self.height as usize)
    }

    pub(super) fn parse(content: &[u8]) -> Result<Self, PacketError> {
        // The version comes before the length: another version may well have another layout.
        if content.get(HEADER_VERSION).ok_or(PacketError::Length)? != [PROTOCOL_VERSION] {
            return Err(PacketError::Version);
        }
        let (fields, colors) = content.split_first_chunk().ok_or(PacketError::Length)?;
        let fields = Fields::<HEADER_LEN>(*fields);
        let (colors, []) = colors.as_chunks() else { return Err(PacketError::Length) };
        if colors.len() > Palette::CAPACITY || colors.len() != fields.get(HEADER_COLORS) as usize {
            return Err(PacketError::Length);
        }
        let header = Self {
            palette: colors.iter().map(|&[r, g, b]| Rgb::new(r, g, b)).collect(),
            frame: fields.get(HEADER_FRAME) as u16,
            width: fields.get(HEADER_WIDTH) as u16,
            height: fields.get(HEADER_HEIGHT) as u16,
            format: PixelFormat::from_code(fields.get(HEADER_FORMAT) as u8)
                .ok_or(PacketError::Format)?,
        };
        if header.is_empty() { Err(PacketError::Size) } else { Ok(header) }
    }
}

/// Encodes a frame header, with a zero byte before it that cuts off whatever was on the line.
///
/// Returns how many bytes of `buffer` are the packet, as do all the functions here.
///
/// # Errors
///
/// [`EncodeError::Size`] if width or height is zero; [`EncodeError::BufferTooSmall`].
pub fn encode_header(header: FrameHeader, buffer: &mut [u8]) -> Result<usize, EncodeError> {
    if header.is_empty() {
        return Err(EncodeError::Size);
    }
    let (cut, rest) = buffer.split_first_mut().ok_or(EncodeError::BufferTooSmall)?;
    *cut = 0;
    let fields = Fields::<HEADER_LEN>::new(HEADER)
        .set(HEADER_VERSION, PROTOCOL_VERSION.into())
        .set(HEADER_FRAME, header.frame.into())
        .set(HEADER_WIDTH, header.width.into())
        .set(HEADER_HEIGHT, header.height.into())
        .set(HEADER_FORMAT, header.format.code().into())
        .set(HEADER_COLORS, header.palette.len() as u32);
    let len = seal(rest, |writer| {
        writer.put(&fields.0)?;
        header.palette.iter().try_for_each(|color| writer.put(&[color.r, color.g, color.b]))
    })?;
    Ok(1 + len)
}
