//! Pixel formats and colours: what a shaded sample becomes in the caller's row.
//!
//! Everything here is integer arithmetic on eight-bit levels, so a pixel's bits depend on the
//! level and the colour alone, not on the number type of the scene.

use crate::solid::Rgb;

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

/// A pixel that a row can be made of.
pub trait Pixel: Copy + Eq {
    /// The format's name on the link.
    const FORMAT: PixelFormat;
    /// The little-endian bytes of one pixel: `[u8; 1]` or `[u8; 2]`.
    type Bytes: AsRef<[u8]> + Copy;

    /// The pixel of a surface of this colour, lit with `level` (0 dark to 255 full).
    fn shaded(color: Rgb, level: u8) -> Self;

    /// The pixel as it goes over the link.
    fn to_le_bytes(self) -> Self::Bytes;
}

/// A grey pixel: [`PixelFormat::Gray8`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Gray8(pub u8);

impl Pixel for Gray8 {
    const FORMAT: PixelFormat = PixelFormat::Gray8;
    type Bytes = [u8; 1];

    fn shaded(color: Rgb, level: u8) -> Self {
        Self(scale(color.luma(), level))
    }

    fn to_le_bytes(self) -> [u8; 1] {
        [self.0]
    }
}

/// A colour pixel of 16 bits: [`PixelFormat::Rgb565`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rgb565(pub u16);

impl Pixel for Rgb565 {
    const FORMAT: PixelFormat = PixelFormat::Rgb565;
    type Bytes = [u8; 2];

    fn shaded(color: Rgb, level: u8) -> Self {
        let r = narrow(scale(color.r, level), 31);
        let g = narrow(scale(color.g, level), 63);
        let b = narrow(scale(color.b, level), 31);
        Self((r << 11) | (g << 5) | b)
    }

    fn to_le_bytes(self) -> [u8; 2] {
        self.0.to_le_bytes()
    }
}

/// `channel · level / 255`, rounded to nearest.
const fn scale(channel: u8, level: u8) -> u8 {
    // Exact division by 255 for every 16-bit product: (p + 128 + ((p + 128) >> 8)) >> 8.
    let p = channel as u32 * level as u32 + 128;
    ((p + (p >> 8)) >> 8) as u8
}

/// An eight-bit channel on the scale 0..=max, rounded to nearest.
const fn narrow(channel: u8, max: u16) -> u16 {
    ((channel as u32 * max as u32 + 127) / 255) as u16
}
