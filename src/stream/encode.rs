//! Packets into bytes: the sending half of the protocol without any I/O.
//!
//! Checksum, COBS framing and run-length coding happen on the fly, straight into the caller's buffer:
//! there is no second one.

use cobs::CobsEncoder;

use super::crc::{Crc32, FrameHash, crc32_start};
use super::packet::{Encoding, FrameHeader, PROTOCOL_VERSION, Request, kind};
use super::pixel::{PixelFormat, WirePixel};
use super::rle;

/// The size of a frame header between the COBS framing: the longest packet but for rows.
const HEADER_LEN: usize = 13;
/// The size of a row packet between the COBS framing, apart from its payload.
const ROW_OVERHEAD: usize = 10;

/// The bytes that any packet without pixels needs: headers, ends, requests and acknowledgements.
pub const CONTROL_CAPACITY: usize = 1 + framed(HEADER_LEN);

/// The bytes that the longest packet of a frame with rows of `width` pixels in `format` needs.
///
/// A sender's and a decoder's buffer of this size can hold any packet of the frame, control packets
/// included.
///
/// ```
/// use scancsg::stream::{Decoder, PixelFormat, packet_capacity};
///
/// const CAPACITY: usize = packet_capacity(320, PixelFormat::Rgb565);
/// assert_eq!(CAPACITY, 654);
/// let decoder: Decoder<CAPACITY> = Decoder::new();
/// ```
#[must_use]
pub const fn packet_capacity(width: u16, format: PixelFormat) -> usize {
    let pixels = (width as usize).saturating_mul(format.bytes_per_pixel());
    let row = framed(pixels.saturating_add(ROW_OVERHEAD));
    if row > CONTROL_CAPACITY { row } else { CONTROL_CAPACITY }
}

/// The most bytes that a packet of `len` bytes takes on the link: one COBS code byte per 254 bytes begun,
/// and the terminator.
const fn framed(len: usize) -> usize {
    len.saturating_add(len.div_ceil(254)).saturating_add(1)
}

/// Why a packet could not be encoded. The buffer's contents are then meaningless.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum EncodeError {
    /// The packet does not fit into the buffer: see [`packet_capacity`].
    BufferTooSmall,
    /// The frame or the row has no pixels, or the row has more than 65535.
    Size,
}

crate::error_text!(EncodeError {
    BufferTooSmall => "packet does not fit into the buffer",
    Size => "frame or row has no pixels, or too many",
});

/// A packet on its way into a buffer.
struct Encoder<'a> {
    cobs: CobsEncoder<'a>,
    crc: Crc32,
}

impl<'a> Encoder<'a> {
    fn new(buffer: &'a mut [u8]) -> Self {
        Self { cobs: CobsEncoder::new(buffer), crc: crc32_start() }
    }

    /// Takes in the next bytes of kind and body.
    fn put(&mut self, bytes: &[u8]) -> Result<(), EncodeError> {
        self.crc.update(bytes);
        self.frame(bytes)
    }

    /// Takes in bytes that the checksum does not cover. They must not be none: after a full block of 254
    /// an empty push makes this encoder count one byte too many.
    fn frame(&mut self, bytes: &[u8]) -> Result<(), EncodeError> {
        self.cobs.push(bytes).map_err(|_| EncodeError::BufferTooSmall)
    }

    /// Adds the checksum. Returns the size of the COBS frame, which may be beyond the buffer: the COBS
    /// encoder checks bytes that it writes, not the last code byte.
    fn finish(mut self) -> Result<usize, EncodeError> {
        let crc = self.crc.clone().finalize();
        self.frame(&crc.to_le_bytes())?;
        Ok(self.cobs.finalize())
    }
}

/// Puts the terminator after a COBS frame of `len` bytes; returns the size of both.
fn terminate(buffer: &mut [u8], len: usize) -> Result<usize, EncodeError> {
    // Where the frame ended beyond the buffer, there is no place for the terminator either.
    *buffer.get_mut(len).ok_or(EncodeError::BufferTooSmall)? = 0;
    Ok(len + 1)
}

/// Encodes a packet whose kind and body are at hand.
fn encode_whole(content: &[u8], buffer: &mut [u8]) -> Result<usize, EncodeError> {
    let mut encoder = Encoder::new(buffer);
    encoder.put(content)?;
    let len = encoder.finish()?;
    terminate(buffer, len)
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
    let [f0, f1] = header.frame.to_le_bytes();
    let [w0, w1] = header.width.to_le_bytes();
    let [h0, h1] = header.height.to_le_bytes();
    let format = header.format.code();
    let content = [kind::HEADER, PROTOCOL_VERSION, f0, f1, w0, w1, h0, h1, format];
    let (cut, rest) = buffer.split_first_mut().ok_or(EncodeError::BufferTooSmall)?;
    *cut = 0;
    Ok(1 + encode_whole(&content, rest)?)
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
    let raw = pixels.len().saturating_mul(P::FORMAT.bytes_per_pixel());
    let encoding = if rle::packed_len(pixels) < raw { Encoding::PackBits } else { Encoding::Raw };
    let [f0, f1] = frame.to_le_bytes();
    let [y0, y1] = y.to_le_bytes();

    let mut encoder = Encoder::new(buffer);
    encoder.put(&[kind::ROW, f0, f1, y0, y1, encoding.code()])?;
    match encoding {
        Encoding::Raw => put_pixels(&mut encoder, pixels)?,
        Encoding::PackBits => {
            for chunk in rle::chunks(pixels) {
                encoder.put(&[chunk.control()])?;
                put_pixels(&mut encoder, chunk.pixels())?;
            }
        }
    }
    let len = encoder.finish()?;
    terminate(buffer, len)
}

fn put_pixels<P: WirePixel>(encoder: &mut Encoder<'_>, pixels: &[P]) -> Result<(), EncodeError> {
    pixels.iter().try_for_each(|pixel| encoder.put(pixel.to_le_bytes().as_ref()))
}

/// Encodes the end of a frame with the hash of all its rows.
///
/// # Errors
///
/// [`EncodeError::BufferTooSmall`].
pub fn encode_end(frame: u16, hash: FrameHash, buffer: &mut [u8]) -> Result<usize, EncodeError> {
    let [f0, f1] = frame.to_le_bytes();
    let [h0, h1, h2, h3] = hash.value().to_le_bytes();
    encode_whole(&[kind::END, f0, f1, h0, h1, h2, h3], buffer)
}

/// Encodes a request, from a receiver to its sender.
///
/// # Errors
///
/// [`EncodeError::BufferTooSmall`].
pub fn encode_request(request: Request, buffer: &mut [u8]) -> Result<usize, EncodeError> {
    let [f0, f1] = request.frame.to_le_bytes();
    let (tag, y) = request.part.code();
    let [y0, y1] = y.to_le_bytes();
    encode_whole(&[kind::REQUEST, f0, f1, tag, y0, y1], buffer)
}

/// Encodes the acknowledgement of a complete frame, from a receiver to its sender.
///
/// # Errors
///
/// [`EncodeError::BufferTooSmall`].
pub fn encode_ack(frame: u16, buffer: &mut [u8]) -> Result<usize, EncodeError> {
    let [f0, f1] = frame.to_le_bytes();
    encode_whole(&[kind::ACK, f0, f1], buffer)
}
