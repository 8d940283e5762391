//! The packets with pixels: of one row, and of several.

use super::fields::{Field, Fields};
use crate::stream::codec::{Encoding, RowPayload};
use crate::stream::error::{EncodeError, PacketError};
use crate::stream::framing::{in_place, seal, seal_in_place};
use crate::stream::pixel::WirePixel;

pub(super) const ROW: u8 = 0x02;
const ROW_FRAME: Field = 1..3;
const ROW_Y: Field = 3..5;
const ROW_ENCODING: Field = 5..6;
/// The payload is from here on.
pub(super) const ROW_LEN: usize = ROW_ENCODING.end;

pub(super) const ROWS: u8 = 0x04;
const ROWS_FRAME: Field = 1..3;
const ROWS_Y: Field = 3..5;
const ROWS_COUNT: Field = 5..6;
/// The payload is from here on.
const ROWS_LEN: usize = ROWS_COUNT.end;

/// A row's frame, its number, and its pixels.
pub(super) fn parse_row(content: &[u8]) -> Result<(u16, u16, RowPayload<'_>), PacketError> {
    let (fields, bytes) = content.split_first_chunk().ok_or(PacketError::Length)?;
    let fields = Fields::<ROW_LEN>(*fields);
    let encoding =
        Encoding::from_code(fields.get(ROW_ENCODING) as u8).ok_or(PacketError::Encoding)?;
    // No frame has rows without pixels.
    if bytes.is_empty() {
        return Err(PacketError::Length);
    }
    let [frame, y] = [ROW_FRAME, ROW_Y].map(|field| fields.get(field) as u16);
    Ok((frame, y, RowPayload { encoding, bytes }))
}

/// Encodes row `y` (0 at the top) of a frame, run-length coded if that is shorter than the bare pixels.
///
/// # Errors
///
/// [`EncodeError::Size`] if there are no pixels or more than 65535; [`EncodeError::BufferTooSmall`].
///
/// ```
/// use scancsg::render::Gray8;
/// use scancsg::stream::{PixelFormat, encode_row, packet_capacity};
///
/// let mut buffer = [0; packet_capacity(320, PixelFormat::Gray8)];
/// // An even row of 320 pixels is three runs.
/// assert_eq!(encode_row(7, 0, &[Gray8(0); 320], &mut buffer), Ok(18));
/// ```
pub fn encode_row<P: WirePixel>(
    frame: u16,
    y: u16,
    pixels: &[P],
    buffer: &mut [u8],
) -> Result<usize, EncodeError> {
    if pixels.is_empty() || pixels.len() > usize::from(u16::MAX) {
        return Err(EncodeError::Size);
    }
    let encoding = Encoding::shortest(pixels);
    let fields = Fields::<ROW_LEN>::new(ROW)
        .set(ROW_FRAME, frame.into())
        .set(ROW_Y, y.into())
        .set(ROW_ENCODING, encoding.code().into());
    seal(buffer, |writer| {
        writer.put(&fields.0)?;
        encoding.pack(pixels, &mut |bytes| writer.put(bytes))
    })
}

/// The rows' frame, the number of the first one, how many there are, and their pixels.
pub(super) fn parse_rows(content: &[u8]) -> Result<(u16, u16, u8, &[u8]), PacketError> {
    let (fields, payload) = content.split_first_chunk().ok_or(PacketError::Length)?;
    let fields = Fields::<ROWS_LEN>(*fields);
    let count = fields.get(ROWS_COUNT) as u8;
    if count == 0 {
        return Err(PacketError::Length);
    }
    let [frame, y] = [ROWS_FRAME, ROWS_Y].map(|field| fields.get(field) as u16);
    Ok((frame, y, count, payload))
}

/// The place in a packet's buffer for the coded pixels of several rows, `limit` bytes of contents in all.
pub(in crate::stream) fn rows_payload(buffer: &mut [u8], limit: usize) -> &mut [u8] {
    in_place(buffer, limit).get_mut(ROWS_LEN..).unwrap_or_default()
}

/// Makes a packet of rows whose payload of `len` bytes is in the place of [`rows_payload`].
pub(in crate::stream) fn seal_rows(
    frame: u16,
    y: u16,
    count: u8,
    len: usize,
    buffer: &mut [u8],
) -> Result<usize, EncodeError> {
    let fields = Fields::<ROWS_LEN>::new(ROWS)
        .set(ROWS_FRAME, frame.into())
        .set(ROWS_Y, y.into())
        .set(ROWS_COUNT, count.into());
    seal_in_place(buffer, &fields.0, len)
}
