//! The link byte by byte: golden packets, damaged packets, PackBits.

#![allow(clippy::unwrap_used, clippy::panic)]

use proptest::prelude::*;
use scancsg::render::{Gray8, Mono, Palette, Rgb, Rgb565, Rgb888};
use scancsg::stream::{
    CONTROL_CAPACITY, Decoder, EncodeError, Encoding, FrameHash, FrameHeader, Packet, PacketError,
    Part, PixelFormat, Request, RowHash, RowPayload, UnpackError, WirePixel, encode_ack,
    encode_end, encode_header, encode_request, encode_row, packet_capacity, row_capacity,
};
use testkit::link::{Bytes, sealed, unpack};

// All literal bytes were made with Python's zlib.crc32 and a COBS encoder written out by hand.
const HEADER: &[u8] = &[
    0x00, 0x08, 0x01, 0x02, 0x34, 0x12, 0x40, 0x01, 0xF0, 0x0D, 0x01, 0x02, 0x96, 0xA0, 0xAA, 0xC8,
    0xAA, 0x50, 0xB3, 0x17, 0x11, 0x0F, 0x00,
];
const HEADER_BITS: &[u8] = &[
    0x00, 0x04, 0x01, 0x02, 0x07, 0x02, 0x80, 0x02, 0x40, 0x02, 0x03, 0x05, 0xF1, 0x3D, 0xF2, 0x86,
    0x00,
];
const ROW_RAW: &[u8] = &[
    0x05, 0x02, 0x34, 0x12, 0x05, 0x01, 0x03, 0x34, 0x12, 0x06, 0xF8, 0xA2, 0x52, 0x89, 0x2B, 0x00,
];
const ROW_PACKED: &[u8] = &[
    0x03, 0x02, 0x07, 0x06, 0x02, 0x01, 0x01, 0xFD, 0x80, 0x01, 0x05, 0x44, 0xEB, 0x84, 0x77, 0x00,
];
const ROW_COLORS: &[u8] = &[
    0x03, 0x02, 0x07, 0x0C, 0x02, 0x01, 0x01, 0xFE, 0x01, 0x02, 0x03, 0x25, 0x06, 0xF9, 0x2E, 0x00,
];
const ROW_BITS: &[u8] =
    &[0x03, 0x02, 0x07, 0x03, 0x02, 0x01, 0x07, 0xA5, 0xC0, 0x83, 0x58, 0xC8, 0x68, 0x00];
const END: &[u8] = &[0x03, 0x03, 0x07, 0x09, 0x60, 0x8B, 0x13, 0xC7, 0xB8, 0xE0, 0x28, 0x03, 0x00];
const REQUEST_HEADER: &[u8] = &[
    0x00, 0x03, 0x81, 0x07, 0x01, 0x01, 0x01, 0x01, 0x01, 0x01, 0x05, 0xBB, 0x09, 0xE2, 0x9D, 0x00,
];
const REQUEST_ROWS: &[u8] = &[
    0x00, 0x03, 0x81, 0x07, 0x05, 0x01, 0x02, 0x01, 0x03, 0x06, 0x7F, 0xEF, 0x3C, 0x3E, 0x56, 0x00,
];
const REQUEST_END: &[u8] = &[
    0x00, 0x03, 0x81, 0x07, 0x02, 0x02, 0x01, 0x01, 0x01, 0x01, 0x05, 0xB0, 0xA8, 0x2A, 0xD0, 0x00,
];
const ACK: &[u8] = &[0x00, 0x03, 0x82, 0x07, 0x05, 0x3B, 0x80, 0xB1, 0x52, 0x00];

const SOME_ROWS: Part = Part::Rows { y: 258, count: 3, limit: 127 };

fn a_header() -> FrameHeader {
    let palette = [Rgb::new(150, 160, 170), Rgb::new(200, 170, 80)].into_iter().collect();
    FrameHeader { frame: 0x1234, width: 320, height: 240, format: PixelFormat::Rgb565, palette }
}

fn a_header_of_bits() -> FrameHeader {
    let (format, palette) = (PixelFormat::Mono, Palette::EMPTY);
    FrameHeader { frame: 7, width: 128, height: 64, format, palette }
}

fn request(part: Part) -> Request {
    Request { frame: 7, part }
}

/// A buffer's part that an encoder filled.
fn encoded(encode: impl FnOnce(&mut [u8]) -> Result<usize, EncodeError>) -> Vec<u8> {
    let mut buffer = vec![0xAA; 200_000];
    let len = encode(&mut buffer).unwrap();
    assert!(buffer[len..].iter().all(|&b| b == 0xAA), "written past the end");
    buffer.truncate(len);
    buffer
}

/// Everything that a decoder makes of these bytes, in words.
fn decode_all<const N: usize>(mut bytes: &[u8]) -> Vec<String> {
    let mut decoder = Decoder::<N>::new();
    let mut results = Vec::new();
    while let Some(result) = decoder.feed(&mut bytes) {
        results.push(format!("{result:?}"));
    }
    assert!(bytes.is_empty());
    results
}

#[test]
fn golden_bytes() {
    let raw = [Rgb565(0x1234), Rgb565(0xF800)];
    let packed = [0x80, 0x80, 0x80, 0x80, 0].map(Gray8);
    let mut hash = FrameHash::new();
    hash.add(RowHash::of(0, &[1, 2, 3, 4].map(Gray8)));
    hash.add(RowHash::of(1, &[9, 9, 9, 9].map(Gray8)));
    assert_eq!(hash.value(), 0xC713_8B60);

    assert_eq!(encoded(|b| encode_header(a_header(), b)), HEADER);
    assert_eq!(encoded(|b| encode_header(a_header_of_bits(), b)), HEADER_BITS);
    assert_eq!(encoded(|b| encode_row(0x1234, 5, &raw, b)), ROW_RAW);
    assert_eq!(encoded(|b| encode_row(7, 258, &packed, b)), ROW_PACKED);
    let colors = [Rgb888([1, 2, 3]); 3];
    assert_eq!(encoded(|b| encode_row(7, 258, &colors, b)), ROW_COLORS);
    let bits = [1, 0, 1, 0, 0, 1, 0, 1, 1, 1].map(|bit| Mono(bit == 1));
    assert_eq!(encoded(|b| encode_row(7, 258, &bits, b)), ROW_BITS);
    assert_eq!(encoded(|b| encode_end(7, hash, b)), END);
    let encode = |part| encoded(|b| encode_request(request(part), b));
    assert_eq!(encode(Part::Header), REQUEST_HEADER);
    assert_eq!(encode(SOME_ROWS), REQUEST_ROWS);
    assert_eq!(encode(Part::End), REQUEST_END);
    assert_eq!(encoded(|b| encode_ack(7, b)), ACK);
}

#[test]
fn golden_bytes_are_read() {
    fn check(mut bytes: &[u8], expected: Packet<'_>) {
        let mut decoder = Decoder::<64>::new();
        assert_eq!(decoder.feed(&mut bytes), Some(Ok(expected)));
        assert!(bytes.is_empty());
    }
    let row = |frame, y, encoding, bytes| Packet::Row {
        frame,
        y,
        payload: RowPayload { encoding, bytes },
    };
    check(HEADER, Packet::Header(a_header()));
    check(HEADER_BITS, Packet::Header(a_header_of_bits()));
    check(ROW_RAW, row(0x1234, 5, Encoding::Raw, &[0x34, 0x12, 0x00, 0xF8]));
    check(ROW_PACKED, row(7, 258, Encoding::PackBits, &[0xFD, 0x80, 0, 0]));
    check(ROW_COLORS, row(7, 258, Encoding::PackBits, &[0xFE, 1, 2, 3]));
    check(ROW_BITS, row(7, 258, Encoding::Raw, &[0xA5, 0xC0]));
    let hash = FrameHash::from_value(0xC713_8B60);
    check(END, Packet::End { frame: 7, hash });
    check(REQUEST_HEADER, Packet::Request(request(Part::Header)));
    check(REQUEST_ROWS, Packet::Request(request(SOME_ROWS)));
    check(REQUEST_END, Packet::Request(request(Part::End)));
    check(ACK, Packet::Ack { frame: 7 });
}

#[test]
fn each_wrong_thing_has_its_error() {
    fn error(bytes: &[u8]) -> PacketError {
        let mut rest = bytes;
        match Decoder::<32>::new().feed(&mut rest) {
            Some(Err(error)) => error,
            other => panic!("{bytes:02X?}: {other:?}"),
        }
    }
    let header = [1, 2, 7, 0, 4, 0, 2, 0, 0, 1, 9, 8, 7];
    let with = |i: usize, value: u8| {
        let mut content = header;
        content[i] = value;
        sealed(&content)
    };
    assert_eq!(error(&with(1, 3)), PacketError::Version);
    assert_eq!(error(&with(4, 0)), PacketError::Size);
    assert_eq!(error(&with(6, 0)), PacketError::Size);
    assert_eq!(error(&with(8, 4)), PacketError::Format);
    assert_eq!(error(&with(0, 5)), PacketError::Kind);
    // Colours are counted, and there are at most so many.
    assert_eq!(error(&with(9, 0)), PacketError::Length);
    assert_eq!(error(&with(9, 2)), PacketError::Length);
    let colors = |count: u8| {
        let colors = (0..count).flat_map(|i| [i, 0, 9]).collect::<Vec<_>>();
        sealed(&[&header[..9], &[count], &colors].concat())
    };
    let most = Palette::CAPACITY as u8;
    assert!(decode_all::<64>(&colors(most))[0].starts_with("Ok"));
    let mut decoder = Decoder::<64>::new();
    assert_eq!(decoder.feed(&mut &colors(most + 1)[..]), Some(Err(PacketError::Length)));
    // Another version may be of another length, and is still named as what it is.
    assert_eq!(error(&sealed(&[1, 3])), PacketError::Version);
    assert_eq!(error(&sealed(&[1, 1, 7, 0, 4, 0, 2, 0, 0])), PacketError::Version);
    assert_eq!(error(&sealed(&[2, 7, 0, 0, 0, 2, 9])), PacketError::Encoding);
    assert_eq!(error(&sealed(&[0x81, 7, 0, 3, 0, 0, 0, 0, 0])), PacketError::Part);

    assert_eq!(error(&sealed(&[4, 7, 0, 0, 0, 0, 9])), PacketError::Length);

    // Every kind, one byte short and (but for rows) one too long.
    let whole: [&[u8]; 6] = [
        &header,
        &[2, 7, 0, 0, 0, 0, 9],
        &[3, 7, 0, 1, 2, 3, 4],
        &[4, 7, 0, 0, 0, 1],
        &[0x81, 7, 0, 0, 0, 0, 0, 0, 0],
        &[0x82, 7, 0],
    ];
    for content in whole {
        assert_eq!(decode_all::<32>(&sealed(content)).len(), 1);
        assert!(decode_all::<32>(&sealed(content))[0].starts_with("Ok"));
        let short = sealed(&content[..content.len() - 1]);
        assert_eq!(error(&short), PacketError::Length, "{content:02X?}");
        let long = sealed(&[content, &[1]].concat());
        if !matches!(content[0], 2 | 4) {
            assert_eq!(error(&long), PacketError::Length, "{content:02X?}");
        }
    }
    assert_eq!(error(&sealed(&[])), PacketError::Length);
    assert_eq!(error(&[1, 0]), PacketError::Length);

    let mut damaged = ACK.to_vec();
    damaged[3] ^= 1;
    assert_eq!(error(&damaged), PacketError::Crc);
    assert_eq!(error(&[0x03, 0x82, 0x00]), PacketError::Framing);
    // A right packet of 33 bytes for a decoder of 32, and of 32.
    let row = |payload| sealed(&[&[2, 7, 0, 0, 0, 0][..], &vec![9; payload]].concat());
    assert_eq!(error(&row(23)), PacketError::TooLong);
    assert!(decode_all::<32>(&row(22))[0].starts_with("Ok"));
}

#[test]
fn encoders_refuse_what_they_must_and_prefer_raw() {
    let mut buffer = [0; 256];
    let flat = |width, height| FrameHeader { width, height, ..a_header() };
    assert_eq!(encode_header(flat(0, 1), &mut buffer), Err(EncodeError::Size));
    assert_eq!(encode_header(flat(1, 0), &mut buffer), Err(EncodeError::Size));
    let none: [Gray8; 0] = [];
    assert_eq!(encode_row(1, 0, &none, &mut buffer), Err(EncodeError::Size));
    let wide = vec![Gray8(0); 65_536];
    assert_eq!(encode_row(1, 0, &wide, &mut buffer), Err(EncodeError::Size));
    assert!(encode_row(1, 0, &wide[1..], &mut [0; 2000]).is_ok());
    // Two alike take two bytes either way; raw is the simpler one to read.
    let tie = encoded(|b| encode_row(1, 0, &[Gray8(5); 2], b));
    assert_eq!(tie, sealed(&[2, 1, 0, 0, 0, 0, 5, 5]));
}

/// A buffer of exactly the packet's size is enough, and every shorter one is an error.
#[test]
fn buffers_are_used_to_the_last_byte() {
    fn check(expected: &[u8], encode: impl Fn(&mut [u8]) -> Result<usize, EncodeError>) {
        for size in 0..expected.len() {
            let result = encode(&mut vec![0xAA; size]);
            assert_eq!(result, Err(EncodeError::BufferTooSmall), "{size}");
        }
        let mut exact = vec![0xAA; expected.len()];
        assert_eq!(encode(&mut exact), Ok(expected.len()));
        assert_eq!(exact, expected);
    }
    check(HEADER, |b| encode_header(a_header(), b));
    check(ACK, |b| encode_ack(7, b));
    check(REQUEST_END, |b| encode_request(request(Part::End), b));
    // Across the ends of COBS blocks, where a full block of 254 comes last or not.
    for width in (1..12).chain(236..256).chain(490..512) {
        let row: Vec<_> = (0..width).map(|x| Gray8((x % 255) as u8 + 1)).collect();
        let raw: Vec<u8> = row.iter().map(|p| p.0).collect();
        let whole = sealed(&[&[2, 1, 1, 1, 1, 0][..], &raw].concat());
        check(&whole, |b| encode_row(0x0101, 0x0101, &row, b));
    }
}

/// The capacity is what the worst row needs. The rows here have neither runs nor zeros, so that every
/// COBS block is full.
#[test]
fn capacity_is_the_worst_case() {
    fn check<P: WirePixel>(width: u16, format: PixelFormat, pixel: impl Fn(u16) -> P) {
        let row: Vec<P> = (0..width).map(pixel).collect();
        let capacity = row_capacity(width, format);
        let raw = (usize::from(width) * format.bits_per_pixel()).div_ceil(8);
        assert_eq!(format.row_bytes(width), raw);
        let mut longest = 0;
        for salt in 1..=4 {
            let frame = u16::from_le_bytes([salt, salt]);
            longest = longest.max(encoded(|b| encode_row(frame, 0x0101, &row, b)).len());
        }
        let bound = 11 + raw + (raw + 10).div_ceil(254);
        assert!(longest <= bound, "{width}: {longest} > {bound}");
        assert_eq!(capacity, bound.max(CONTROL_CAPACITY), "{width}");
        // A packet of several rows is one COBS block at most.
        assert_eq!(packet_capacity(width, format), capacity.max(256), "{width}");
        // The encoding byte of a raw row is a zero, which splits a block, so that sometimes the bound
        // is missed by one.
        assert!(longest + 1 >= bound, "{width}: {longest} < {bound}");
    }
    for width in [1, 2, 3, 7, 120, 121, 122, 123, 243, 244, 245, 300, 509, 65_535] {
        check(width, PixelFormat::Gray8, |x| Gray8(1 + (x % 255) as u8));
        check(width, PixelFormat::Rgb565, |x| Rgb565(0x0101 + (x % 255) * 0x0100));
        // Seven bits of a number, and a one, so that no byte is zero or like the one beside it.
        check(width, PixelFormat::Mono, |x| {
            Mono(x % 8 == 0 || (x / 8 % 127 + 1) >> (x % 8 - 1) & 1 == 1)
        });
        check(width, PixelFormat::Rgb888, |x| Rgb888([1 + (x % 255) as u8, 7, 9]));
    }
    // The longest control packet is a header with all its colours.
    let palette: Palette = (0..9).map(|i| Rgb::new(i, i, 255)).collect();
    let header = FrameHeader { palette, ..a_header() };
    assert_eq!(encoded(|b| encode_header(header, b)).len(), CONTROL_CAPACITY);
}

#[test]
fn worked_example_of_tn1023() {
    let packed =
        [0xFE, 0xAA, 0x02, 0x80, 0x00, 0x2A, 0xFD, 0xAA, 0x03, 0x80, 0x00, 0x2A, 0x22, 0xF7, 0xAA];
    let unpacked = [
        0xAA, 0xAA, 0xAA, 0x80, 0x00, 0x2A, 0xAA, 0xAA, 0xAA, 0xAA, 0x80, 0x00, 0x2A, 0x22, 0xAA,
        0xAA, 0xAA, 0xAA, 0xAA, 0xAA, 0xAA, 0xAA, 0xAA, 0xAA,
    ];
    assert_eq!(unpack(&packed, 1), unpacked);
    let mut row = [0; 24];
    assert_eq!(payload(&packed).unpack(PixelFormat::Gray8, &mut row), Ok(()));
    assert_eq!(row, unpacked);
    // The encoder finds the same 15 bytes.
    let whole = encoded(|b| encode_row(1, 0, &unpacked.map(Gray8), b));
    assert_eq!(whole, sealed(&[&[2, 1, 0, 0, 0, 1][..], &packed].concat()));
}

fn payload(bytes: &[u8]) -> RowPayload<'_> {
    RowPayload { encoding: Encoding::PackBits, bytes }
}

#[test]
fn bad_payloads_are_errors_and_write_nothing() {
    let check = |payload: RowPayload<'_>, format, expected| {
        let mut row = [0xAA; 4];
        assert_eq!(payload.unpack(format, &mut row), Err(expected));
        assert_eq!(row, [0xAA; 4]);
    };
    let gray = PixelFormat::Gray8;
    let rgb = PixelFormat::Rgb565;
    check(payload(&[0, 1, 0xFF]), gray, UnpackError::Truncated);
    check(payload(&[3, 1, 2, 3]), gray, UnpackError::Truncated);
    check(payload(&[0xFF, 1]), rgb, UnpackError::Truncated);
    check(payload(&[0xFC, 1]), gray, UnpackError::TooLong);
    check(payload(&[0xFD, 1, 0, 1]), gray, UnpackError::TooLong);
    check(payload(&[0xFE, 1]), gray, UnpackError::TooShort);
    check(payload(&[0x80, 0x80]), gray, UnpackError::TooShort);
    let raw = |bytes| RowPayload { encoding: Encoding::Raw, bytes };
    check(raw(&[1, 2, 3]), gray, UnpackError::TooShort);
    check(raw(&[1, 2, 3, 4, 5]), rgb, UnpackError::TooLong);
    // No-ops are skipped wherever they stand.
    let mut row = [0; 2];
    let padded = payload(&[0x80, 0xFF, 5, 0x80]);
    assert_eq!(padded.unpack(gray, &mut row), Ok(()));
    assert_eq!(row, [5, 5]);
}

const PACKETS: [&[u8]; 11] = [
    HEADER,
    HEADER_BITS,
    ROW_RAW,
    ROW_PACKED,
    ROW_COLORS,
    ROW_BITS,
    END,
    REQUEST_HEADER,
    REQUEST_ROWS,
    REQUEST_END,
    ACK,
];

/// A packet with one bit flipped is refused or says what it said before; a packet cut short is refused.
#[test]
fn single_bit_flips_never_change_a_packet() {
    for packet in PACKETS {
        let good = decode_all::<64>(packet);
        assert_eq!(good.len(), 1);
        for bit in 0..packet.len() * 8 {
            let mut bytes = packet.to_vec();
            bytes[bit / 8] ^= 1 << (bit % 8);
            // The terminator of a packet may be what was hit.
            bytes.push(0);
            let results = decode_all::<64>(&bytes);
            assert!(!results.is_empty());
            for result in results {
                assert!(result.starts_with("Err") || result == good[0], "bit {bit}: {result}");
            }
        }
        for len in 1..packet.len() - 1 {
            let results = decode_all::<64>(&[&packet[..len], &[0]].concat());
            assert!(results.iter().all(|result| result.starts_with("Err")));
        }
    }
}

#[test]
fn bad_packets_do_not_swallow_good_ones() {
    let good = "Ok(Ack { frame: 7 })";
    let long = vec![9; 100];
    for (bad, error) in [
        (&[0x09, 1, 2, 3][..], "Err(Framing)"),
        (&[0xFF, 1, 2, 3], "Err(Framing)"),
        (&[0xFF], "Err(Framing)"),
        (&[0x01], "Err(Length)"),
        (&[0x03, 0x82, 0x07, 0x05, 0x3B, 0x80, 0xB1, 0x53], "Err(Crc)"),
        (&long, "Err(TooLong)"),
        (&[1; 100], "Err(TooLong)"),
    ] {
        let line = [&[0, 0], ACK, bad, &[0], ACK, &[0, 0, 0], bad, &[0], ACK].concat();
        let expected = [good, error, good, error, good];
        assert_eq!(decode_all::<CONTROL_CAPACITY>(&line), expected, "{bad:?}");
    }
    // Too small for anything, and still no panic.
    assert_eq!(decode_all::<0>(&[ACK, ACK].concat()), ["Err(TooLong)"; 2]);
}

fn rows() -> impl Strategy<Value = Vec<u8>> {
    // Noise, and runs of few values: both encodings, and sizes across the COBS block.
    let noise = proptest::collection::vec(any::<u8>(), 1..700);
    let runs = proptest::collection::vec((0..3_u8, 1..200_usize), 1..20).prop_map(|runs| {
        let runs = runs.into_iter();
        runs.flat_map(|(value, count)| std::iter::repeat_n(value, count)).collect()
    });
    prop_oneof![noise, runs]
}

/// The bytes of a pixel, or of eight pixels of one bit.
fn unit_bytes(format: PixelFormat) -> usize {
    format.bits_per_pixel().div_ceil(8)
}

fn check_row<P: Bytes>(format: PixelFormat, pixels: &[P]) -> Result<(), TestCaseError> {
    let bytes = P::bytes(pixels);
    let packet = encoded(|b| encode_row(3, 9, pixels, b));
    prop_assert!(packet.len() <= row_capacity(pixels.len() as u16, format));
    let mut decoder = Decoder::<8192>::new();
    let Some(Ok(Packet::Row { frame, y, payload })) = decoder.feed(&mut &packet[..]) else {
        return Err(TestCaseError::fail("no row"));
    };
    prop_assert_eq!((frame, y), (3, 9));
    prop_assert!(payload.bytes.len() <= bytes.len());
    match payload.encoding {
        Encoding::Raw => prop_assert_eq!(payload.bytes, &bytes),
        Encoding::PackBits => {
            let size = unit_bytes(format);
            prop_assert_eq!(&unpack(payload.bytes, size), &bytes);
        }
        other => return Err(TestCaseError::fail(format!("{other:?}"))),
    }
    // The frame around it, by the plain encoder.
    let mut content = vec![2, 3, 0, 9, 0, payload.encoding.code()];
    content.extend_from_slice(payload.bytes);
    prop_assert_eq!(sealed(&content), packet);
    let mut row = vec![0; bytes.len()];
    prop_assert_eq!(payload.unpack(format, &mut row), Ok(()));
    prop_assert_eq!(row, bytes);
    Ok(())
}

proptest! {
    #[test]
    fn rows_round_trip(values in rows()) {
        let gray: Vec<_> = values.iter().copied().map(Gray8).collect();
        let rgb: Vec<_> = values.iter().map(|&v| Rgb565(u16::from(v) * 0x0101)).collect();
        let colors: Vec<_> = values.iter().map(|&v| Rgb888([v, v / 2, 9])).collect();
        let bits: Vec<_> = values.iter().map(|&v| Mono(v >= 3 || v == 1)).collect();
        check_row(PixelFormat::Gray8, &gray)?;
        check_row(PixelFormat::Rgb565, &rgb)?;
        check_row(PixelFormat::Rgb888, &colors)?;
        check_row(PixelFormat::Mono, &bits)?;
    }

    /// After any bytes and a zero, a good packet is found, and it is the last thing found.
    #[test]
    fn garbage_never_hides_a_packet(
        garbage in proptest::collection::vec(prop_oneof![any::<u8>(), 0..4_u8], 0..600)
    ) {
        let line = [&garbage, &[0][..], ROW_RAW].concat();
        let expected = decode_all::<64>(ROW_RAW).pop();
        prop_assert_eq!(&decode_all::<64>(&line).pop(), &expected);
        prop_assert_eq!(&decode_all::<1000>(&line).pop(), &expected);
        // Byte by byte is the same as all at once.
        let mut decoder = Decoder::<64>::new();
        let pushed: Vec<_> = line
            .iter()
            .filter_map(|&byte| decoder.push(byte).map(|result| format!("{result:?}")))
            .collect();
        prop_assert_eq!(pushed, decode_all::<64>(&line));
    }

    /// Anything with a right checksum: the parser behind it does not panic either.
    #[test]
    fn sealed_garbage_is_parsed_or_refused(
        kind in prop_oneof![
            Just(1_u8), Just(2), Just(3), Just(4), Just(0x81), Just(0x82), any::<u8>()
        ],
        body in proptest::collection::vec(prop_oneof![any::<u8>(), 0..3_u8], 0..40),
    ) {
        let content = [&[kind][..], &body].concat();
        let packet = sealed(&content);
        let mut decoder = Decoder::<64>::new();
        let result = decoder.feed(&mut &packet[..]);
        prop_assert!(matches!(result, Some(Ok(_) | Err(
            PacketError::Kind | PacketError::Length | PacketError::Version | PacketError::Format
            | PacketError::Size | PacketError::Encoding | PacketError::Part
        ))), "{:?}", result);
    }

    /// Any payload: an error with nothing written, or exactly what the plain decoder says.
    #[test]
    fn any_payload_is_unpacked_or_refused(
        bytes in proptest::collection::vec(prop_oneof![any::<u8>(), 0..4_u8, 0xFC..=0xFF_u8], 0..40),
        len in 0..300_usize,
        code in 0..4_u8,
    ) {
        let format = PixelFormat::from_code(code).unwrap();
        let mut row = vec![0xAA; len];
        match payload(&bytes).unpack(format, &mut row) {
            Ok(()) => prop_assert_eq!(row, unpack(&bytes, unit_bytes(format))),
            Err(UnpackError::Truncated) => prop_assert!(row.iter().all(|&b| b == 0xAA)),
            Err(error) => {
                prop_assert!(row.iter().all(|&b| b == 0xAA));
                let right = unpack(&bytes, unit_bytes(format)).len();
                let expected = if right > len { UnpackError::TooLong } else { UnpackError::TooShort };
                prop_assert!(right != len);
                prop_assert_eq!(error, expected);
                // With the right length it is the row.
                let mut row = vec![0; right];
                prop_assert_eq!(payload(&bytes).unpack(format, &mut row), Ok(()));
                prop_assert_eq!(row, unpack(&bytes, unit_bytes(format)));
            }
        }
    }
}
