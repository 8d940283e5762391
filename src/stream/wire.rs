//! The packets of the link: what each one says, and its layout, for both directions.
//!
//! A layout is written once, in constants of the packet's name: its kind, and where each field is, counted
//! from the kind; `LEN` is where the last one ends. All numbers are little-endian. What goes around these
//! contents on the line is framing. The packets of an upload are in `upload/wire.rs`: firmware without one
//! doesn't read them.

use core::ops::Range;

use super::codec::{Encoding, RowPayload};
use super::crc::FrameHash;
use super::error::{EncodeError, PacketError};
use super::framing::{IN_PLACE, framed, in_place, seal, seal_in_place, unseal};
use super::pixel::{PixelFormat, WirePixel};
use crate::render::{Palette, Rgb};

/// The version of the protocol, sent in every frame header. Another version is refused, not guessed at.
pub const PROTOCOL_VERSION: u8 = 2;

/// The place of a field.
pub(super) type Field = Range<usize>;

const HEADER: u8 = 0x01;
const HEADER_VERSION: Field = 1..2;
const HEADER_FRAME: Field = 2..4;
const HEADER_WIDTH: Field = 4..6;
const HEADER_HEIGHT: Field = 6..8;
const HEADER_FORMAT: Field = 8..9;
const HEADER_COLORS: Field = 9..10;
/// So many colours are from here on, three bytes each.
const HEADER_LEN: usize = HEADER_COLORS.end;
const HEADER_MAX: usize = HEADER_LEN + 3 * Palette::CAPACITY;

const ROW: u8 = 0x02;
const ROW_FRAME: Field = 1..3;
const ROW_Y: Field = 3..5;
const ROW_ENCODING: Field = 5..6;
/// The payload is from here on.
const ROW_LEN: usize = ROW_ENCODING.end;

const ROWS: u8 = 0x04;
const ROWS_FRAME: Field = 1..3;
const ROWS_Y: Field = 3..5;
const ROWS_COUNT: Field = 5..6;
/// The payload is from here on.
const ROWS_LEN: usize = ROWS_COUNT.end;

const END: u8 = 0x03;
const END_FRAME: Field = 1..3;
const END_HASH: Field = 3..7;
const END_LEN: usize = END_HASH.end;

const REQUEST: u8 = 0x81;
const REQUEST_FRAME: Field = 1..3;
const REQUEST_PART: Field = 3..4;
const REQUEST_Y: Field = 4..6;
const REQUEST_COUNT: Field = 6..8;
const REQUEST_LIMIT: Field = 8..9;
const REQUEST_LEN: usize = REQUEST_LIMIT.end;
const PART_HEADER: u8 = 0;
const PART_ROWS: u8 = 1;
const PART_END: u8 = 2;

const ACK: u8 = 0x82;
const ACK_FRAME: Field = 1..3;
const ACK_LEN: usize = ACK_FRAME.end;

/// The bytes that any packet without pixels needs: headers, ends, requests and acknowledgements.
pub const CONTROL_CAPACITY: usize = 1 + framed(HEADER_MAX);

/// The bytes that a request or an acknowledgement needs.
pub(super) const REQUEST_CAPACITY: usize = 1 + framed(REQUEST_LEN);

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
/// A [`Sender`](super::Sender) with [`Plain`](super::Plain) rows needs no larger buffer.
#[must_use]
pub const fn row_capacity(width: u16, format: PixelFormat) -> usize {
    let row = framed(format.row_bytes(width).saturating_add(ROW_LEN));
    if row > CONTROL_CAPACITY { row } else { CONTROL_CAPACITY }
}

/// The contents of a packet, or of a row what is before the payload: the kind and the fields.
pub(super) struct Fields<const LEN: usize>(pub(super) [u8; LEN]);

impl<const LEN: usize> Fields<LEN> {
    /// A packet of this kind, whose fields are yet to be set.
    pub(super) const fn new(kind: u8) -> Self {
        Self([kind; LEN])
    }

    /// The contents of a packet that must be just as long.
    pub(super) fn read(content: &[u8]) -> Result<Self, PacketError> {
        content.try_into().map(Self).map_err(|_| PacketError::Length)
    }

    pub(super) fn set(mut self, field: Field, value: u32) -> Self {
        let bytes = self.0.get_mut(field).unwrap_or_default();
        bytes.iter_mut().zip(value.to_le_bytes()).for_each(|(to, from)| *to = from);
        self
    }

    pub(super) fn get(&self, field: Field) -> u32 {
        let bytes = self.0.get(field).unwrap_or_default();
        bytes.iter().rev().fold(0, |value, byte| value << 8 | u32::from(*byte))
    }

    pub(super) fn seal(&self, buffer: &mut [u8]) -> Result<usize, EncodeError> {
        seal_whole(&self.0, buffer)
    }
}

/// Writes a packet whose contents are at hand. Here the code exists once and not per length.
fn seal_whole(content: &[u8], buffer: &mut [u8]) -> Result<usize, EncodeError> {
    seal(buffer, |writer| writer.put(content))
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
    /// Some rows of a frame, one below the other.
    Rows {
        /// The frame's id.
        frame: u16,
        /// The number of the first row, 0 at the top.
        y: u16,
        /// How many rows there are, at least one.
        count: u8,
        /// The rows' pixels, coded together.
        payload: &'a [u8],
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
        let content = unseal(bytes)?;
        match *content.first().ok_or(PacketError::Length)? {
            HEADER => FrameHeader::parse(content).map(Packet::Header),
            ROW => parse_row(content),
            ROWS => parse_rows(content),
            END => parse_end(content),
            REQUEST => Request::parse(content).map(Packet::Request),
            ACK => parse_ack(content),
            _ => Err(PacketError::Kind),
        }
    }
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

    fn parse(content: &[u8]) -> Result<Self, PacketError> {
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

fn parse_row(content: &[u8]) -> Result<Packet<'_>, PacketError> {
    let (fields, bytes) = content.split_first_chunk().ok_or(PacketError::Length)?;
    let fields = Fields::<ROW_LEN>(*fields);
    let encoding =
        Encoding::from_code(fields.get(ROW_ENCODING) as u8).ok_or(PacketError::Encoding)?;
    // No frame has rows without pixels.
    if bytes.is_empty() {
        return Err(PacketError::Length);
    }
    Ok(Packet::Row {
        frame: fields.get(ROW_FRAME) as u16,
        y: fields.get(ROW_Y) as u16,
        payload: RowPayload { encoding, bytes },
    })
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

fn parse_rows(content: &[u8]) -> Result<Packet<'_>, PacketError> {
    let (fields, payload) = content.split_first_chunk().ok_or(PacketError::Length)?;
    let fields = Fields::<ROWS_LEN>(*fields);
    let count = fields.get(ROWS_COUNT) as u8;
    if count == 0 {
        return Err(PacketError::Length);
    }
    Ok(Packet::Rows {
        frame: fields.get(ROWS_FRAME) as u16,
        y: fields.get(ROWS_Y) as u16,
        count,
        payload,
    })
}

/// The place in a packet's buffer for the coded pixels of several rows, `limit` bytes of contents in all.
pub(super) fn rows_payload(buffer: &mut [u8], limit: usize) -> &mut [u8] {
    in_place(buffer, limit).get_mut(ROWS_LEN..).unwrap_or_default()
}

/// Makes a packet of rows whose payload of `len` bytes is in the place of [`rows_payload`].
pub(super) fn seal_rows(
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

fn parse_end(content: &[u8]) -> Result<Packet<'_>, PacketError> {
    let fields = Fields::<END_LEN>::read(content)?;
    Ok(Packet::End {
        frame: fields.get(END_FRAME) as u16,
        hash: FrameHash::from_value(fields.get(END_HASH)),
    })
}

/// Encodes the end of a frame with the hash of all its rows.
///
/// # Errors
///
/// [`EncodeError::BufferTooSmall`].
pub fn encode_end(frame: u16, hash: FrameHash, buffer: &mut [u8]) -> Result<usize, EncodeError> {
    Fields::<END_LEN>::new(END)
        .set(END_FRAME, frame.into())
        .set(END_HASH, hash.value())
        .seal(buffer)
}

/// The part of a frame that a request asks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Part {
    /// The frame header.
    Header,
    /// Some rows, one below the other.
    Rows {
        /// The number of the first one, 0 at the top.
        y: u16,
        /// How many, at least one.
        count: u16,
        /// A packet of several rows should have no more bytes of contents than this: where much gets
        /// lost, short packets get through.
        limit: u8,
    },
    /// The end of the frame with its hash.
    End,
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

impl Request {
    fn parse(content: &[u8]) -> Result<Self, PacketError> {
        let fields = Fields::<REQUEST_LEN>::read(content)?;
        let part = match fields.get(REQUEST_PART) as u8 {
            PART_HEADER => Part::Header,
            PART_ROWS => Part::Rows {
                y: fields.get(REQUEST_Y) as u16,
                count: fields.get(REQUEST_COUNT) as u16,
                limit: fields.get(REQUEST_LIMIT) as u8,
            },
            PART_END => Part::End,
            _ => return Err(PacketError::Part),
        };
        Ok(Self { frame: fields.get(REQUEST_FRAME) as u16, part })
    }
}

/// Encodes a request, from a receiver to its sender, with a zero byte before it: a sender that was busy
/// may have heard the end of an earlier one.
///
/// # Errors
///
/// [`EncodeError::BufferTooSmall`].
pub fn encode_request(request: Request, buffer: &mut [u8]) -> Result<usize, EncodeError> {
    let (part, y, count, limit) = match request.part {
        Part::Header => (PART_HEADER, 0, 0, 0),
        Part::Rows { y, count, limit } => (PART_ROWS, y, count, limit),
        Part::End => (PART_END, 0, 0, 0),
    };
    let (cut, rest) = buffer.split_first_mut().ok_or(EncodeError::BufferTooSmall)?;
    *cut = 0;
    let len = Fields::<REQUEST_LEN>::new(REQUEST)
        .set(REQUEST_FRAME, request.frame.into())
        .set(REQUEST_PART, part.into())
        .set(REQUEST_Y, y.into())
        .set(REQUEST_COUNT, count.into())
        .set(REQUEST_LIMIT, limit.into())
        .seal(rest)?;
    Ok(1 + len)
}

fn parse_ack(content: &[u8]) -> Result<Packet<'_>, PacketError> {
    let fields = Fields::<ACK_LEN>::read(content)?;
    Ok(Packet::Ack { frame: fields.get(ACK_FRAME) as u16 })
}

/// Encodes the acknowledgement of a complete frame, from a receiver to its sender, with a zero byte before
/// it.
///
/// # Errors
///
/// [`EncodeError::BufferTooSmall`].
pub fn encode_ack(frame: u16, buffer: &mut [u8]) -> Result<usize, EncodeError> {
    let (cut, rest) = buffer.split_first_mut().ok_or(EncodeError::BufferTooSmall)?;
    *cut = 0;
    Ok(1 + Fields::<ACK_LEN>::new(ACK).set(ACK_FRAME, frame.into()).seal(rest)?)
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::*;
    use crate::render::Rgb565;
    use crate::stream::framing::Reader;

    const FORMAT: PixelFormat = PixelFormat::Rgb565;

    /// The one packet on the line, without its COBS frame.
    fn unframed<'a>(line: &[u8], buffer: &'a mut [u8]) -> &'a [u8] {
        let mut reader = Reader::new();
        let mut ends = line.iter().filter_map(|byte| reader.step(buffer, *byte));
        let (len, None) = (ends.next().unwrap().unwrap(), ends.next()) else {
            panic!("more than one packet");
        };
        &buffer[..len]
    }

    /// Packet, encoder and bytes are one and the same. The bytes were written down from the table of the
    /// documentation; every number in them is different, so that no field can stand in another's place.
    #[track_caller]
    fn check(
        packet: Packet<'_>,
        bytes: &[u8],
        encode: impl FnOnce(&mut [u8]) -> Result<usize, EncodeError>,
    ) {
        let (mut line, mut buffer) = ([0; 64], [0; 64]);
        let len = encode(&mut line).unwrap();
        let unframed = unframed(&line[..len], &mut buffer);
        assert_eq!(unseal(unframed), Ok(bytes));
        assert_eq!(Packet::parse(unframed), Ok(packet));
        assert!(len <= framed(bytes.len()) + 1);
    }

    #[test]
    fn packets_are_laid_out_as_documented() {
        let palette = [Rgb::new(0xDE, 0xF0, 0x11), Rgb::new(0x22, 0x33, 0x44)];
        let header = FrameHeader {
            frame: 0x3412,
            width: 0x7856,
            height: 0xBC9A,
            format: FORMAT,
            palette: palette.into_iter().collect(),
        };
        check(
            Packet::Header(header),
            &[
                0x01, 2, 0x12, 0x34, 0x56, 0x78, 0x9A, 0xBC, 1, 2, 0xDE, 0xF0, 0x11, 0x22, 0x33,
                0x44,
            ],
            |buffer| encode_header(header, buffer),
        );
        let payload = RowPayload { encoding: Encoding::Raw, bytes: &[0x9A, 0xBC] };
        check(
            Packet::Row { frame: 0x3412, y: 0x7856, payload },
            &[0x02, 0x12, 0x34, 0x56, 0x78, 0, 0x9A, 0xBC],
            |buffer| encode_row(0x3412, 0x7856, &[Rgb565(0xBC9A)], buffer),
        );
        let payload = RowPayload { encoding: Encoding::PackBits, bytes: &[0xFE, 0x9A, 0xBC] };
        check(
            Packet::Row { frame: 0x3412, y: 0x7856, payload },
            &[0x02, 0x12, 0x34, 0x56, 0x78, 1, 0xFE, 0x9A, 0xBC],
            |buffer| encode_row(0x3412, 0x7856, &[Rgb565(0xBC9A); 3], buffer),
        );
        let hash = FrameHash::from_value(0xDEBC_9A78);
        check(
            Packet::End { frame: 0x3412, hash },
            &[0x03, 0x12, 0x34, 0x78, 0x9A, 0xBC, 0xDE],
            |buffer| encode_end(0x3412, hash, buffer),
        );
        for (part, [tag, y0, y1, n0, n1, limit]) in [
            (Part::Header, [0; 6]),
            (
                Part::Rows { y: 0x7856, count: 0xBC9A, limit: 0xDE },
                [1, 0x56, 0x78, 0x9A, 0xBC, 0xDE],
            ),
            (Part::End, [2, 0, 0, 0, 0, 0]),
        ] {
            let request = Request { frame: 0x3412, part };
            let bytes = [0x81, 0x12, 0x34, tag, y0, y1, n0, n1, limit];
            check(Packet::Request(request), &bytes, |buffer| encode_request(request, buffer));
        }
        let payload = [0x9A, 0, 0xDE];
        check(
            Packet::Rows { frame: 0x3412, y: 0x7856, count: 0xBC, payload: &payload },
            &[0x04, 0x12, 0x34, 0x56, 0x78, 0xBC, 0x9A, 0, 0xDE],
            |buffer| {
                rows_payload(buffer, 254)[..3].copy_from_slice(&payload);
                seal_rows(0x3412, 0x7856, 0xBC, 3, buffer)
            },
        );
        check(Packet::Ack { frame: 0x3412 }, &[0x82, 0x12, 0x34], |buffer| {
            encode_ack(0x3412, buffer)
        });
    }
}
