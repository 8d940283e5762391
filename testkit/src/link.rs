//! The link's bytes by their definitions, written down a second time: pixels, checksum, framing, runs.

use scancsg::render::{Gray8, Mono, Rgb565, Rgb888};
use scancsg::stream::WirePixel;
use std::fmt::Debug;

/// A pixel of the link whose bytes are known here too.
pub trait Bytes: WirePixel<Wire = Self> + Debug {
    /// The bytes of a row on the link.
    fn bytes(row: &[Self]) -> Vec<u8>;
}

impl Bytes for Gray8 {
    fn bytes(row: &[Self]) -> Vec<u8> {
        row.iter().map(|pixel| pixel.0).collect()
    }
}

impl Bytes for Rgb565 {
    fn bytes(row: &[Self]) -> Vec<u8> {
        row.iter().flat_map(|pixel| [pixel.0 as u8, (pixel.0 >> 8) as u8]).collect()
    }
}

impl Bytes for Rgb888 {
    fn bytes(row: &[Self]) -> Vec<u8> {
        row.iter().flat_map(|pixel| pixel.0).collect()
    }
}

/// The leftmost of eight pixels is the highest bit, and zeros fill up the last byte.
impl Bytes for Mono {
    fn bytes(row: &[Self]) -> Vec<u8> {
        let mut bytes = vec![0; row.len().div_ceil(8)];
        for (x, pixel) in row.iter().enumerate() {
            bytes[x / 8] |= u8::from(pixel.0) << (7 - x % 8);
        }
        bytes
    }
}

/// CRC-32/ISO-HDLC bit by bit.
pub fn crc32(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0_u32, |crc, &byte| {
        (0..8).fold(crc ^ u32::from(byte), |crc, _| {
            (crc >> 1) ^ (0xEDB8_8320 & (crc & 1).wrapping_neg())
        })
    })
}

/// COBS: cut at zeros, and after 254 bytes without one.
pub fn cobs(bytes: &[u8]) -> Vec<u8> {
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
pub fn sealed(content: &[u8]) -> Vec<u8> {
    let mut bytes = content.to_vec();
    bytes.extend_from_slice(&crc32(content).to_le_bytes());
    let mut framed = cobs(&bytes);
    framed.push(0);
    framed
}

/// PackBits as in TIFF 6.0, section 9, with a unit of `size` bytes.
pub fn unpack(packed: &[u8], size: usize) -> Vec<u8> {
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
