//! `docs/link.md` says what the code does: its bytes, and its decoder in Python.

#![allow(clippy::unwrap_used, clippy::panic)]

use scancsg::render::{Gray8, Palette, Rgb, Rgb565};
use scancsg::stream::{
    Decoder, FrameHash, FrameHeader, Part, PixelFormat, Request, RowHash, encode_ack, encode_end,
    encode_header, encode_request, encode_row,
};

const DOCUMENT: &str = include_str!("../docs/link.md");

/// The block of code with this label.
fn block(label: &str) -> &'static str {
    let start = format!("```{label}\n");
    let (_, rest) = DOCUMENT.split_once(&start).unwrap_or_else(|| panic!("no block {label}"));
    rest.split_once("```").unwrap().0
}

/// The bytes of a block of hexadecimal numbers.
fn bytes(name: &str) -> Vec<u8> {
    let numbers = block(&format!("hex {name}"));
    numbers.split_whitespace().map(|number| u8::from_str_radix(number, 16).unwrap()).collect()
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect::<Vec<_>>().join(" ")
}

/// The document's bytes are these, and a decoder finds one packet in them.
#[track_caller]
fn check(name: &str, encode: impl FnOnce(&mut [u8]) -> usize) {
    let mut buffer = [0; 300];
    let len = encode(&mut buffer);
    assert_eq!(hex(&bytes(name)), hex(&buffer[..len]), "{name}");
    let mut decoder = Decoder::<300>::new();
    let packets = buffer[..len].iter().filter(|byte| decoder.push(**byte).is_some()).count();
    assert_eq!(packets, 1);
}

#[test]
fn packets_are_as_documented() {
    let palette: Palette =
        [Rgb::new(0x96, 0x9B, 0xA0), Rgb::new(0xC8, 0xA0, 0x50)].into_iter().collect();
    let format = PixelFormat::Rgb565;
    let header = FrameHeader { frame: 1, width: 160, height: 120, format, palette };
    check("header", |buffer| encode_header(header, buffer).unwrap());
    let pixels = [1, 2, 3, 4].map(Gray8);
    check("raw", |buffer| encode_row(1, 7, &pixels, buffer).unwrap());
    check("packbits", |buffer| encode_row(1, 8, &[Rgb565(0x1234); 160], buffer).unwrap());
    let mut hash = FrameHash::new();
    hash.add(RowHash::of(0, &pixels));
    hash.add(RowHash::of(1, &pixels));
    check("end", |buffer| encode_end(1, hash, buffer).unwrap());
    let part = Part::Rows { y: 7, count: 2, limit: 127 };
    check("request", |buffer| encode_request(Request { frame: 1, part }, buffer).unwrap());
    check("ack", |buffer| encode_ack(1, buffer).unwrap());
}
