//! The link byte by byte: golden packets, damaged packets, PackBits.

#![allow(clippy::unwrap_used, clippy::panic)]

use proptest::prelude::*;
use scancsg::render::{Gray8, Rgb565};
use scancsg::stream::{
    CONTROL_CAPACITY, Decoder, EncodeError, Encoding, FrameHash, FrameHeader, Packet, PacketError,
    Part, PixelFormat, Request, RowHash, RowPayload, UnpackError, WirePixel, encode_ack,
    encode_end, encode_header, encode_request, encode_row, packet_capacity,
};

// All literal bytes were made with Python's zlib.crc32 and a COBS encoder written out by hand.
const HEADER: &[u8] = &[
    0x00, 0x08, 0x01, 0x01, 0x34, 0x12, 0x40, 0x01, 0xF0, 0x06, 0x01, 0xC8, 0x5E, 0x66, 0x0D, 0x00,
];
const ROW_RAW: &[u8] = &[
    0x05, 0x02, 0x34, 0x12, 0x05, 0x01, 0x03, 0x34, 0x12, 0x06, 0xF8, 0xA2, 0x52, 0x89, 0x2B, 0x00,
];
const ROW_PACKED: &[u8] = &[
    0x03, 0x02, 0x07, 0x06, 0x02, 0x01, 0x01, 0xFD, 0x80, 0x01, 0x05, 0x44, 0xEB, 0x84, 0x77, 0x00,
];
const END: &[u8] = &[0x03, 0x03, 0x07, 0x09, 0x60, 0x8B, 0x13, 0xC7, 0xB8, 0xE0, 0x28, 0x03, 0x00];
const REQUEST_HEADER: &[u8] =
    &[0x03, 0x81, 0x07, 0x01, 0x01, 0x01, 0x05, 0xCE, 0xBA, 0x0E, 0xD6, 0x00];
const REQUEST_ROW: &[u8] =
    &[0x03, 0x81, 0x07, 0x08, 0x01, 0x02, 0x01, 0xED, 0x82, 0xFD, 0x92, 0x00];
const REQUEST_END: &[u8] =
    &[0x03, 0x81, 0x07, 0x02, 0x02, 0x01, 0x05, 0xA0, 0x6E, 0x8A, 0xD5, 0x00];
const ACK: &[u8] = &[0x03, 0x82, 0x07, 0x05, 0x3B, 0x80, 0xB1, 0x52, 0x00];

const A_HEADER: FrameHeader =
    FrameHeader { frame: 0x1234, width: 320, height: 240, format: PixelFormat::Rgb565 };

fn request(part: Part) -> Request {
    Request { frame: 7, part }
}

/// A buffer's part that an encoder filled.
fn encoded(encode: impl FnOnce(&mut [u8]) -> Result<usize, EncodeError>) -> Vec<u8> {
    let mut buffer = vec![0xAA; 140_000];
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

/// CRC-32/ISO-HDLC bit by bit, from its definition.
fn plain_crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0_u32, |crc, &byte| {
        (0..8).fold(crc ^ u32::from(byte), |crc, _| {
            (crc >> 1) ^ (0xEDB8_8320 & (crc & 1).wrapping_neg())
        })
    })
}

/// COBS by its definition: cut at zeros, and after 254 bytes without one.
fn plain_cobs(bytes: &[u8]) -> Vec<u8> {
    let mut out = Vec::new();
    let mut rest = bytes;
    loop {
        let zero = rest.iter().position(|&b| b == 0);
        let len = zero.unwrap_or(rest.len()).min(254);
        out.push(len as u8 + 1);
        out.extend_from_slice(&rest[..len]);
        if len == rest.len() {
            break;
        }
        // A full block takes no zero with it.
        rest = &rest[if len == 254 { 254 } else { len + 1 }..];
    }
    out
}

/// A framed packet with a right checksum around any contents.
fn sealed(content: &[u8]) -> Vec<u8> {
    let mut bytes = content.to_vec();
    bytes.extend_from_slice(&plain_crc(content).to_le_bytes());
    let mut framed = plain_cobs(&bytes);
    framed.push(0);
    framed
}

/// PackBits as in TIFF 6.0, section 9, with a pixel of `size` bytes as the unit.
fn plain_unpack(packed: &[u8], size: usize) -> Vec<u8> {
    let mut out = Vec::new();
    let mut i = 0;
    while i < packed.len() {
        let n = packed[i] as i8;
        i += 1;
        if n >= 0 {
            let len = (n as usize + 1) * size;
            out.extend_from_slice(&packed[i..i + len]);
            i += len;
        } else if n != -128 {
            for _ in 0..1 - i32::from(n) {
                out.extend_from_slice(&packed[i..i + size]);
            }
            i += size;
        }
    }
    out
}

#[test]
fn golden_bytes() {
    let raw = [Rgb565(0x1234), Rgb565(0xF800)];
    let packed = [0x80, 0x80, 0x80, 0x80, 0].map(Gray8);
    let mut hash = FrameHash::new();
    hash.add(RowHash::of(0, &[1, 2, 3, 4].map(Gray8)));
    hash.add(RowHash::of(1, &[9, 9, 9, 9].map(Gray8)));
    assert_eq!(hash.value(), 0xC713_8B60);

    assert_eq!(encoded(|b| encode_header(A_HEADER, b)), HEADER);
    assert_eq!(encoded(|b| encode_row(0x1234, 5, &raw, b)), ROW_RAW);
    assert_eq!(encoded(|b| encode_row(7, 258, &packed, b)), ROW_PACKED);
    assert_eq!(encoded(|b| encode_end(7, hash, b)), END);
    let encode = |part| encoded(|b| encode_request(request(part), b));
    assert_eq!(encode(Part::Header), REQUEST_HEADER);
    assert_eq!(encode(Part::Row(258)), REQUEST_ROW);
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
    check(HEADER, Packet::Header(A_HEADER));
    check(ROW_RAW, row(0x1234, 5, Encoding::Raw, &[0x34, 0x12, 0x00, 0xF8]));
    check(ROW_PACKED, row(7, 258, Encoding::PackBits, &[0xFD, 0x80, 0, 0]));
    let hash = FrameHash::from_value(0xC713_8B60);
    check(END, Packet::End { frame: 7, hash });
    check(REQUEST_HEADER, Packet::Request(request(Part::Header)));
    check(REQUEST_ROW, Packet::Request(request(Part::Row(258))));
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
    let header = [1, 1, 7, 0, 4, 0, 2, 0, 0];
    let with = |i: usize, value: u8| {
        let mut content = header;
        content[i] = value;
        sealed(&content)
    };
    assert_eq!(error(&with(1, 2)), PacketError::Version);
    assert_eq!(error(&with(4, 0)), PacketError::Size);
    assert_eq!(error(&with(6, 0)), PacketError::Size);
    assert_eq!(error(&with(8, 2)), PacketError::Format);
    assert_eq!(error(&with(0, 4)), PacketError::Kind);
    // Another version may be of another length, and is still named as what it is.
    assert_eq!(error(&sealed(&[1, 2])), PacketError::Version);
    assert_eq!(error(&sealed(&[2, 7, 0, 0, 0, 2, 9])), PacketError::Encoding);
    assert_eq!(error(&sealed(&[0x81, 7, 0, 3, 0, 0])), PacketError::Part);

    // Every kind, one byte short and (but for rows) one too long.
    let whole: [&[u8]; 5] = [
        &header,
        &[2, 7, 0, 0, 0, 0, 9],
        &[3, 7, 0, 1, 2, 3, 4],
        &[0x81, 7, 0, 0, 0, 0],
        &[0x82, 7, 0],
    ];
    for content in whole {
        assert_eq!(decode_all::<32>(&sealed(content)).len(), 1);
        assert!(decode_all::<32>(&sealed(content))[0].starts_with("Ok"));
        let short = sealed(&content[..content.len() - 1]);
        assert_eq!(error(&short), PacketError::Length, "{content:02X?}");
        let long = sealed(&[content, &[1]].concat());
        if content[0] != 2 {
            assert_eq!(error(&long), PacketError::Length, "{content:02X?}");
        }
    }
    assert_eq!(error(&sealed(&[])), PacketError::Length);
    assert_eq!(error(&[1, 0]), PacketError::Length);

    let mut damaged = ACK.to_vec();
    damaged[2] ^= 1;
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
    let flat = |width, height| FrameHeader { width, height, ..A_HEADER };
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
    check(HEADER, |b| encode_header(A_HEADER, b));
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
    fn check<P: WirePixel>(width: u16, pixel: impl Fn(u16) -> P) {
        let row: Vec<P> = (0..width).map(pixel).collect();
        let capacity = packet_capacity(width, P::FORMAT);
        let raw = usize::from(width) * P::FORMAT.bytes_per_pixel();
        let mut longest = 0;
        for salt in 1..=4 {
            let frame = u16::from_le_bytes([salt, salt]);
            longest = longest.max(encoded(|b| encode_row(frame, 0x0101, &row, b)).len());
        }
        let bound = 11 + raw + (raw + 10).div_ceil(254);
        assert!(longest <= bound, "{width}: {longest} > {bound}");
        assert_eq!(capacity, bound.max(CONTROL_CAPACITY), "{width}");
        // The encoding byte of a raw row is a zero, which splits a block, so that sometimes the bound
        // is missed by one.
        assert!(longest + 1 >= bound, "{width}: {longest} < {bound}");
    }
    for width in [1, 2, 3, 7, 120, 121, 122, 123, 243, 244, 245, 300, 509, 65_535] {
        check(width, |x| Gray8(1 + (x % 255) as u8));
        check(width, |x| Rgb565(0x0101 + (x % 255) * 0x0100));
    }
    assert_eq!(HEADER.len(), CONTROL_CAPACITY);
}

#[test]
fn worked_example_of_tn1023() {
    let packed =
        [0xFE, 0xAA, 0x02, 0x80, 0x00, 0x2A, 0xFD, 0xAA, 0x03, 0x80, 0x00, 0x2A, 0x22, 0xF7, 0xAA];
    let unpacked = [
        0xAA, 0xAA, 0xAA, 0x80, 0x00, 0x2A, 0xAA, 0xAA, 0xAA, 0xAA, 0x80, 0x00, 0x2A, 0x22, 0xAA,
        0xAA, 0xAA, 0xAA, 0xAA, 0xAA, 0xAA, 0xAA, 0xAA, 0xAA,
    ];
    assert_eq!(plain_unpack(&packed, 1), unpacked);
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

/// A packet with one bit flipped is refused or says what it said before; a packet cut short is refused.
#[test]
fn single_bit_flips_never_change_a_packet() {
    for packet in [HEADER, ROW_RAW, ROW_PACKED, END, REQUEST_HEADER, REQUEST_ROW, REQUEST_END, ACK]
    {
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

fn check_row<P: WirePixel>(pixels: &[P]) -> Result<(), TestCaseError> {
    let bytes: Vec<u8> = pixels.iter().flat_map(|p| p.to_le_bytes().as_ref().to_vec()).collect();
    let packet = encoded(|b| encode_row(3, 9, pixels, b));
    prop_assert!(packet.len() <= packet_capacity(pixels.len() as u16, P::FORMAT));
    let mut decoder = Decoder::<8192>::new();
    let Some(Ok(Packet::Row { frame, y, payload })) = decoder.feed(&mut &packet[..]) else {
        return Err(TestCaseError::fail("no row"));
    };
    prop_assert_eq!((frame, y), (3, 9));
    prop_assert!(payload.bytes.len() <= bytes.len());
    match payload.encoding {
        Encoding::Raw => prop_assert_eq!(payload.bytes, &bytes),
        Encoding::PackBits => {
            let size = P::FORMAT.bytes_per_pixel();
            prop_assert_eq!(&plain_unpack(payload.bytes, size), &bytes);
        }
        other => return Err(TestCaseError::fail(format!("{other:?}"))),
    }
    // The frame around it, by the plain encoder.
    let mut content = vec![2, 3, 0, 9, 0, payload.encoding.code()];
    content.extend_from_slice(payload.bytes);
    prop_assert_eq!(sealed(&content), packet);
    let mut row = vec![0; bytes.len()];
    prop_assert_eq!(payload.unpack(P::FORMAT, &mut row), Ok(()));
    prop_assert_eq!(row, bytes);
    Ok(())
}

proptest! {
    #[test]
    fn rows_round_trip(values in rows()) {
        let gray: Vec<_> = values.iter().copied().map(Gray8).collect();
        let rgb: Vec<_> = values.iter().map(|&v| Rgb565(u16::from(v) * 0x0101)).collect();
        check_row(&gray)?;
        check_row(&rgb)?;
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
        kind in prop_oneof![Just(1_u8), Just(2), Just(3), Just(0x81), Just(0x82), any::<u8>()],
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
        rgb in any::<bool>(),
    ) {
        let format = if rgb { PixelFormat::Rgb565 } else { PixelFormat::Gray8 };
        let mut row = vec![0xAA; len];
        match payload(&bytes).unpack(format, &mut row) {
            Ok(()) => prop_assert_eq!(row, plain_unpack(&bytes, format.bytes_per_pixel())),
            Err(UnpackError::Truncated) => prop_assert!(row.iter().all(|&b| b == 0xAA)),
            Err(error) => {
                prop_assert!(row.iter().all(|&b| b == 0xAA));
                let right = plain_unpack(&bytes, format.bytes_per_pixel()).len();
                let expected = if right > len { UnpackError::TooLong } else { UnpackError::TooShort };
                prop_assert!(right != len);
                prop_assert_eq!(error, expected);
                // With the right length it is the row.
                let mut row = vec![0; right];
                prop_assert_eq!(payload(&bytes).unpack(format, &mut row), Ok(()));
                prop_assert_eq!(row, plain_unpack(&bytes, format.bytes_per_pixel()));
            }
        }
    }
}
