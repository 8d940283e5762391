//! How long packets can be.

use super::header::HEADER_MAX;
use super::rows::ROW_LEN;
use crate::stream::framing::{IN_PLACE, framed};
use crate::stream::pixel::PixelFormat;

/// The bytes that any packet without pixels needs: headers, ends, requests and acknowledgements.
pub const CONTROL_CAPACITY: usize = 1 + framed(HEADER_MAX);

/// The bytes that the longest packet of a frame with rows of `width` pixels in `format` needs.
///
/// A sender's and a receiver's buffer of this size can hold any packet of the frame, control packets
/// included. A sender whose packets hold one row each can do with [`row_capacity`].
///
/// ```
/// use scancsg::stream::{Decoder, PixelFormat, packet_capacity, row_capacity};
///
/// const CAPACITY: usize = packet_capacity(320, PixelFormat::Rgb565);
/// assert_eq!(CAPACITY, 654);
/// let decoder: Decoder<CAPACITY> = Decoder::new();
/// assert_eq!(packet_capacity(160, PixelFormat::Gray8), 256); // several rows
/// assert_eq!(row_capacity(160, PixelFormat::Gray8), 172);
/// ```
#[must_use]
pub const fn packet_capacity(width: u16, format: PixelFormat) -> usize {
    let row = row_capacity(width, format);
    if row > IN_PLACE { row } else { IN_PLACE }
}

/// The bytes that the longest packet with one row needs, or a control packet if that is longer.
///
/// A [`Sender`](crate::stream::Sender) with [`Plain`](crate::stream::Plain) rows needs no larger buffer.
#[must_use]
pub const fn row_capacity(width: u16, format: PixelFormat) -> usize {
    let row = framed(format.row_bytes(width).saturating_add(ROW_LEN));
    if row > CONTROL_CAPACITY { row } else { CONTROL_CAPACITY }
}
