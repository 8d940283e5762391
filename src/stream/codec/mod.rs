//! How a row's pixels are written down: one file for each encoding, and the choice between them.

mod coding;
mod packbits;
mod predictive;
mod raw;

pub use coding::{Coding, Plain, RowCoding};
pub(super) use predictive::unpack;
pub use predictive::{Predictable, Predictive, PredictiveMono};

use super::error::UnpackError;
use super::pixel::{PixelFormat, Units, WirePixel};

/// How a row's pixels are written down.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
#[repr(u8)]
pub enum Encoding {
    /// The pixels' little-endian bytes, one after the other.
    Raw = 0,
    /// PackBits runs in units of pixels.
    PackBits = 1,
}

impl Encoding {
    /// The encoding with this code, if there is one.
    #[must_use]
    pub const fn from_code(code: u8) -> Option<Self> {
        match code {
            0 => Some(Self::Raw),
            1 => Some(Self::PackBits),
            _ => None,
        }
    }

    /// The code of this encoding on the link.
    #[must_use]
    pub const fn code(self) -> u8 {
        self as u8
    }

    /// The encoding in which these pixels are shortest; of two that are equally short, the simpler one.
    pub(super) fn shortest<P: WirePixel>(pixels: &[P]) -> Self {
        let units = Units(pixels);
        if packbits::len(units) < units.bytes() { Self::PackBits } else { Self::Raw }
    }

    /// Gives the pixels, in this encoding, to `put`, some bytes at a time and never none.
    pub(super) fn pack<P: WirePixel, E>(
        self,
        pixels: &[P],
        put: &mut impl FnMut(&[u8]) -> Result<(), E>,
    ) -> Result<(), E> {
        match self {
            Self::Raw => raw::pack(Units(pixels), put),
            Self::PackBits => packbits::pack(Units(pixels), put),
        }
    }

    /// Takes the next run off `bytes`: its bytes, and how often they stand in the row.
    fn take_run<'a>(
        self,
        bytes: &mut &'a [u8],
        format: PixelFormat,
    ) -> Result<Option<(&'a [u8], usize)>, UnpackError> {
        match self {
            Self::Raw => Ok(Some((core::mem::take(bytes), 1)).filter(|(run, _)| !run.is_empty())),
            Self::PackBits => packbits::take_run(bytes, format),
        }
    }
}

/// A row's pixels as they came over the link.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RowPayload<'a> {
    /// How the bytes are to be read.
    pub encoding: Encoding,
    /// The bytes, in that encoding.
    pub bytes: &'a [u8],
}

impl RowPayload<'_> {
    /// Writes the row's pixels, as little-endian bytes, into the whole of `row`.
    ///
    /// # Errors
    ///
    /// [`UnpackError`] if the payload is not exactly one row of `row.len()` bytes in `format`. Nothing is
    /// written then.
    ///
    /// ```
    /// use scancsg::stream::{Encoding, PixelFormat, RowPayload};
    ///
    /// // Three copies of one RGB565 pixel: control byte 1 - 3 = -2.
    /// let payload = RowPayload { encoding: Encoding::PackBits, bytes: &[0xFE, 0x34, 0x12] };
    /// let mut row = [0; 6];
    /// assert_eq!(payload.unpack(PixelFormat::Rgb565, &mut row), Ok(()));
    /// assert_eq!(row, [0x34, 0x12, 0x34, 0x12, 0x34, 0x12]);
    /// ```
    pub fn unpack(&self, format: PixelFormat, row: &mut [u8]) -> Result<(), UnpackError> {
        let mut length: usize = 0;
        let mut walk = self.bytes;
        while let Some((pixels, count)) = self.encoding.take_run(&mut walk, format)? {
            length = length.saturating_add(pixels.len().saturating_mul(count));
        }
        if length > row.len() {
            return Err(UnpackError::TooLong);
        }
        if length < row.len() {
            return Err(UnpackError::TooShort);
        }

        let mut rest = row.iter_mut();
        let mut walk = self.bytes;
        while let Some((pixels, count)) = self.encoding.take_run(&mut walk, format)? {
            for _ in 0..count {
                for (from, to) in pixels.iter().zip(&mut rest) {
                    *to = *from;
                }
            }
        }
        Ok(())
    }
}
