//! Pixels on the link: their formats, and the pixel types that have one.

use crate::render::{Gray8, Pixel, Rgb565};

/// The pixel formats that a frame can have, with their codes on the link.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
#[repr(u8)]
pub enum PixelFormat {
    /// One byte: grey, 0 black to 255 white.
    Gray8 = 0,
    /// Two bytes, little-endian: red in bits 15..11, green in 10..5, blue in 4..0.
    Rgb565 = 1,
}

impl PixelFormat {
    /// The size of one pixel in bytes.
    #[must_use]
    pub const fn bytes_per_pixel(self) -> usize {
        match self {
            Self::Gray8 => 1,
            Self::Rgb565 => 2,
        }
    }

    /// The format with this code, if there is one.
    #[must_use]
    pub const fn from_code(code: u8) -> Option<Self> {
        match code {
            0 => Some(Self::Gray8),
            1 => Some(Self::Rgb565),
            _ => None,
        }
    }

    /// The code of this format on the link.
    #[must_use]
    pub const fn code(self) -> u8 {
        self as u8
    }
}

/// A pixel that can be sent: it has one of the link's formats.
///
/// [`Gray8`] and [`Rgb565`] are such pixels. A display's own type is one if its colours are in one of the
/// formats, in whatever order of bytes the display wants them:
///
/// ```
/// use scancsg::render::{Pixel, Rgb, Rgb565};
/// use scancsg::stream::{PixelFormat, RowHash, WirePixel};
///
/// /// RGB565 as the display's controller takes it: the upper byte first.
/// #[derive(Clone, Copy, PartialEq, Eq)]
/// struct Panel([u8; 2]);
///
/// impl Pixel for Panel {
///     fn shaded(color: Rgb, level: u8) -> Self {
///         Self(Rgb565::shaded(color, level).0.to_be_bytes())
///     }
/// }
///
/// impl WirePixel for Panel {
///     const FORMAT: PixelFormat = PixelFormat::Rgb565;
///     type Bytes = [u8; 2];
///
///     fn to_le_bytes(self) -> [u8; 2] {
///         u16::from_be_bytes(self.0).to_le_bytes()
///     }
/// }
///
/// let rows = ([Panel([0x12, 0x34])], [Rgb565(0x1234)]);
/// assert_eq!(RowHash::of(0, &rows.0), RowHash::of(0, &rows.1));
/// ```
pub trait WirePixel: Pixel + Eq {
    /// The format's name on the link.
    const FORMAT: PixelFormat;
    /// The bytes of one pixel: as many as [`PixelFormat::bytes_per_pixel`] says.
    type Bytes: AsRef<[u8]> + Copy;

    /// The pixel as it goes over the link, the lower byte first.
    fn to_le_bytes(self) -> Self::Bytes;
}

impl WirePixel for Gray8 {
    const FORMAT: PixelFormat = PixelFormat::Gray8;
    type Bytes = [u8; 1];

    fn to_le_bytes(self) -> [u8; 1] {
        [self.0]
    }
}

impl WirePixel for Rgb565 {
    const FORMAT: PixelFormat = PixelFormat::Rgb565;
    type Bytes = [u8; 2];

    fn to_le_bytes(self) -> [u8; 2] {
        self.0.to_le_bytes()
    }
}
