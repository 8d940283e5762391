//! Checksums: the CRC-32 of a packet and the hash of a frame.

use crc::{CRC_32_ISO_HDLC, Crc, Digest, Table};

use super::pixel::{Units, WirePixel};

// One table of 256 words: 1 KiB of flash, 0.4 % of a 256 KiB part, and no RAM. Without it every byte
// takes eight shift-and-xor steps, and each pixel byte goes through two checksums; with the 16-lane
// table of the same crate (16 KiB) the flash would cost more than the time is worth.
static CRC: Crc<u32, Table<1>> = Crc::<u32, Table<1>>::new(&CRC_32_ISO_HDLC);

/// A CRC-32/ISO-HDLC in progress: eight bytes of state on a 32-bit core.
pub(super) type Crc32 = Digest<'static, u32, Table<1>>;

/// Starts a CRC-32.
pub(super) const fn crc32_start() -> Crc32 {
    CRC.digest()
}

/// The CRC-32 of `bytes`.
pub(super) const fn crc32(bytes: &[u8]) -> u32 {
    CRC.checksum(bytes)
}

/// The hash of one row: the CRC-32/ISO-HDLC (reflected polynomial 0xEDB88320, as in zlib) of the row's
/// number `y` as a little-endian `u16`, then of the row's bytes as they go over the link.
///
/// ```
/// use scancsg::render::Gray8;
/// use scancsg::stream::RowHash;
///
/// let mut hash = RowHash::new(3);
/// hash.update(&[10]);
/// hash.update(&[20]);
/// assert_eq!(hash.finish(), RowHash::of(3, &[Gray8(10), Gray8(20)]));
/// ```
#[derive(Clone)]
pub struct RowHash(Crc32);

impl RowHash {
    /// The hash of row `y` before its first byte.
    #[must_use]
    pub const fn new(y: u16) -> Self {
        let mut crc = crc32_start();
        crc.update(&y.to_le_bytes());
        Self(crc)
    }

    /// Takes in the row's next bytes.
    pub const fn update(&mut self, bytes: &[u8]) {
        self.0.update(bytes);
    }

    /// The hash of the row that was taken in.
    #[must_use]
    pub const fn finish(self) -> u32 {
        self.0.finalize()
    }

    /// The hash of the whole row `y`.
    #[must_use]
    pub fn of<P: WirePixel>(y: u16, pixels: &[P]) -> u32 {
        let mut hash = Self::new(y);
        for unit in Units(pixels).iter() {
            hash.update(unit.as_ref());
        }
        hash.finish()
    }
}

/// The hash of a frame: the sum of its rows' hashes modulo 2^32.
///
/// A sum does not depend on the order of its terms, so rows that arrive late, after a repair, are
/// added when they come, and neither end needs a whole frame in memory. Each row's number is part of
/// its own hash, so two rows that change places do change the sum.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FrameHash(u32);

impl FrameHash {
    /// The hash of no rows.
    #[must_use]
    pub const fn new() -> Self {
        Self(0)
    }

    /// The hash with this value, as it came over the link.
    #[must_use]
    pub const fn from_value(value: u32) -> Self {
        Self(value)
    }

    /// The value that goes over the link.
    #[must_use]
    pub const fn value(self) -> u32 {
        self.0
    }

    /// Adds one row by its hash, [`RowHash::finish`]. Every row must be added once.
    pub const fn add(&mut self, row_hash: u32) {
        self.0 = self.0.wrapping_add(row_hash);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::{Gray8, Rgb565};

    #[test]
    fn crc_is_the_one_of_zlib() {
        // The check value of CRC-32/ISO-HDLC in the catalogue of CRC algorithms.
        assert_eq!(crc32(b"123456789"), 0xCBF4_3926);
    }

    #[test]
    fn row_hash_covers_the_number_and_the_little_endian_pixels() {
        // zlib.crc32(bytes([0x02, 0x01, 0x0A, 0x14]))
        assert_eq!(RowHash::of(0x0102, &[Gray8(10), Gray8(20)]), 0x6ABA_4157);
        // zlib.crc32(bytes([0x02, 0x01, 0x34, 0x12, 0x78, 0x56]))
        assert_eq!(RowHash::of(0x0102, &[Rgb565(0x1234), Rgb565(0x5678)]), 0xC46F_36CF);
    }

    #[test]
    fn frame_hash_ignores_the_order_of_rows_but_not_their_places() {
        let a = [Gray8(1), Gray8(2)];
        let b = [Gray8(3), Gray8(4)];
        let sum = |rows: [u32; 2]| {
            let mut hash = FrameHash::new();
            rows.into_iter().for_each(|row| hash.add(row));
            hash
        };
        let frame = sum([RowHash::of(0, &a), RowHash::of(1, &b)]);
        assert_eq!(frame, sum([RowHash::of(1, &b), RowHash::of(0, &a)]));
        assert_ne!(frame, sum([RowHash::of(0, &b), RowHash::of(1, &a)]));
    }
}
