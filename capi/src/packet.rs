//! Packets of the link. The repository's `docs/link.md` has their format.

use crate::border::{self, Plain};
use crate::picture::{Picture, current};
use crate::pixels::Format;
use crate::status::Status;
use scancsg::render::{Palette, Pixel, Rgb, Rgb565};
use scancsg::stream::{
    EncodeError, FrameHash, FrameHeader, PixelFormat, RowHash, WirePixel, encode_end,
    encode_header, encode_row, row_capacity,
};

/// The link's name of a format.
fn on_link(format: Format) -> Result<PixelFormat, Status> {
    match format {
        Format::Gray8 => Ok(PixelFormat::Gray8),
        Format::Rgb565 | Format::Rgb565Be => Ok(PixelFormat::Rgb565),
        Format::Rgb888 => Ok(PixelFormat::Rgb888),
        Format::Mono => Err(Status::Format),
    }
}

/// The bytes that any packet of a frame with so wide rows needs, or 0 for a format that packets can't have.
/// `SCANCSG_PACKET_CAPACITY` is the same, or more, for constants.
#[unsafe(no_mangle)]
pub extern "C" fn scancsg_packet_capacity(width: u16, format: u8) -> usize {
    let format = Format::of(format).and_then(on_link);
    format.map_or(0, |format| row_capacity(width, format))
}

/// Writes the packet that a frame begins with, and its length to `length`. `frame` is a number that differs
/// from the last frame's.
///
/// # Safety
/// `picture` is a picture's memory, `packet` has `capacity` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn scancsg_packet_header(
    picture: *const Picture,
    frame: u16,
    format: u8,
    packet: *mut u8,
    capacity: usize,
    length: *mut usize,
) -> Status {
    let encode = |packet: &mut [u8]| {
        // SAFETY: the caller says the same.
        let size = unsafe { current(picture) }?.size;
        let format = on_link(Format::of(format)?)?;
        let (width, height) = (size.width(), size.height());
        let header = FrameHeader { frame, width, height, format, palette: Palette::EMPTY };
        Ok(encode_header(header, packet)?)
    };
    // SAFETY: the caller has lent both.
    unsafe { write_packet(packet, capacity, length, encode) }
}

/// Writes the packet of row `y`, and its length to `length`. The row's hash is added to `hash`, which is 0 at a
/// frame's beginning. Add each row once.
///
/// `pixels` are `bytes` of a whole row, as `scancsg_picture_row` has rendered it.
///
/// # Safety
/// `pixels` has `bytes`, `packet` has `capacity` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn scancsg_packet_row(
    frame: u16,
    y: u16,
    format: u8,
    pixels: *const u8,
    bytes: usize,
    hash: *mut u32,
    packet: *mut u8,
    capacity: usize,
    length: *mut usize,
) -> Status {
    let encode = |packet: &mut [u8]| {
        // SAFETY: the caller has lent both.
        let (pixels, mut sum) =
            unsafe { (border::slice(pixels, bytes)?, FrameHash::from_value(border::read(hash)?)) };
        let (len, row) = match Format::of(format)? {
            Format::Gray8 => encode_bytes::<[u8; 1]>(frame, y, pixels, packet),
            Format::Rgb565 => encode_bytes::<LowFirst>(frame, y, pixels, packet),
            Format::Rgb888 => encode_bytes::<[u8; 3]>(frame, y, pixels, packet),
            Format::Rgb565Be => encode_bytes::<[u8; 2]>(frame, y, pixels, packet),
            Format::Mono => Err(Status::Format),
        }?;
        sum.add(row);
        // SAFETY: as above.
        unsafe { border::write(hash, sum.value()) }?;
        Ok(len)
    };
    // SAFETY: the caller has lent both.
    unsafe { write_packet(packet, capacity, length, encode) }
}

/// Writes the packet that a frame ends with, and its length to `length`. `hash` is the sum of the rows' hashes.
///
/// # Safety
/// `packet` has `capacity` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn scancsg_packet_end(
    frame: u16,
    hash: u32,
    packet: *mut u8,
    capacity: usize,
    length: *mut usize,
) -> Status {
    let encode = |packet: &mut [u8]| Ok(encode_end(frame, FrameHash::from_value(hash), packet)?);
    // SAFETY: the caller has lent both.
    unsafe { write_packet(packet, capacity, length, encode) }
}

/// Writes a packet, and its length.
///
/// # Safety
/// `packet` has `capacity` bytes.
unsafe fn write_packet(
    packet: *mut u8,
    capacity: usize,
    length: *mut usize,
    encode: impl FnOnce(&mut [u8]) -> Result<usize, Status>,
) -> Status {
    let write = || {
        // SAFETY: the caller has lent both; what `length` is matters before a hash is changed.
        unsafe {
            border::write(length, 0)?;
            let written = encode(border::room(packet, capacity)?)?;
            border::write(length, written)
        }
    };
    Status::of(write())
}

/// The packet of a row whose bytes are its pixels, and the row's hash.
fn encode_bytes<P: WirePixel + Plain>(
    frame: u16,
    y: u16,
    bytes: &[u8],
    packet: &mut [u8],
) -> Result<(usize, u32), Status> {
    let count = bytes.len() / size_of::<P>();
    if bytes.len() != count * size_of::<P>() {
        return Err(Status::Length);
    }
    // SAFETY: the bytes are there, and any bytes are pixels.
    let pixels = unsafe { border::slice(bytes.as_ptr().cast::<P>(), count)? };
    let len = encode_row(frame, y, pixels, packet).map_err(|error| match error {
        EncodeError::Size => Status::Length,
        other => other.into(),
    })?;
    Ok((len, RowHash::of(y, pixels)))
}

/// A colour pixel of 16 bits, the lower byte first.
#[derive(Clone, Copy, PartialEq, Eq)]
#[repr(transparent)]
struct LowFirst([u8; 2]);

// SAFETY: it is bytes.
unsafe impl Plain for LowFirst {}

impl Pixel for LowFirst {
    fn shaded(color: Rgb, level: u8) -> Self {
        Self(Rgb565::shaded(color, level).0.to_le_bytes())
    }
}

impl WirePixel for LowFirst {
    type Wire = Rgb565;

    fn to_wire(self) -> Rgb565 {
        Rgb565(u16::from_le_bytes(self.0))
    }
}
