//! A packet of any kind.

use super::answers::{ACK, REQUEST, Request, parse_ack};
use super::end::{END, parse_end};
use super::header::{FrameHeader, HEADER};
use super::rows::{ROW, ROWS, parse_row, parse_rows};
use crate::stream::codec::RowPayload;
use crate::stream::crc::FrameHash;
use crate::stream::error::PacketError;
use crate::stream::framing::unseal;

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
    pub(in crate::stream) fn parse(bytes: &'a [u8]) -> Result<Self, PacketError> {
        let content = unseal(bytes)?;
        match *content.first().ok_or(PacketError::Length)? {
            HEADER => FrameHeader::parse(content).map(Packet::Header),
            ROW => {
                let (frame, y, payload) = parse_row(content)?;
                Ok(Packet::Row { frame, y, payload })
            }
            ROWS => {
                let (frame, y, count, payload) = parse_rows(content)?;
                Ok(Packet::Rows { frame, y, count, payload })
            }
            END => parse_end(content).map(|(frame, hash)| Packet::End { frame, hash }),
            REQUEST => Request::parse(content).map(Packet::Request),
            ACK => parse_ack(content).map(|frame| Packet::Ack { frame }),
            _ => Err(PacketError::Kind),
        }
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::*;
    use crate::render::{Rgb, Rgb565};
    use crate::stream::codec::Encoding;
    use crate::stream::error::EncodeError;
    use crate::stream::framing::{Reader, framed};
    use crate::stream::pixel::PixelFormat;
    use crate::stream::wire::answers::{Part, encode_ack, encode_request};
    use crate::stream::wire::end::encode_end;
    use crate::stream::wire::header::encode_header;
    use crate::stream::wire::rows::{encode_row, rows_payload, seal_rows};

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
