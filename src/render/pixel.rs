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

/// A pixel that can be the mean of others.
pub trait Blend: Pixel {
    /// Up to 256 pixels, added up.
    type Sum: Copy;
    /// No pixels.
    const EMPTY: Self::Sum;

    /// One pixel more.
    fn add_to(self, sum: &mut Self::Sum);

    /// The mean of `count` pixels, of each channel for itself: rounded to the nearest level, and
    /// upwards half-way between two.
    fn mean(sum: Self::Sum, count: u16) -> Self;
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

impl Blend for Gray8 {
    type Sum = u16;
    const EMPTY: u16 = 0;

    fn add_to(self, sum: &mut u16) {
        *sum = sum.saturating_add(self.0.into());
    }

    fn mean(sum: u16, count: u16) -> Self {
        Self(mean(sum, count) as u8)
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

impl Blend for Rgb565 {
    type Sum = [u16; 3];
    const EMPTY: [u16; 3] = [0; 3];

    fn add_to(self, sum: &mut [u16; 3]) {
        let channels = [self.0 >> 11, (self.0 >> 5) & 63, self.0 & 31];
        for (sum, channel) in sum.iter_mut().zip(channels) {
            *sum = sum.saturating_add(channel);
        }
    }

    fn mean(sum: [u16; 3], count: u16) -> Self {
        let [r, g, b] = sum.map(|sum| mean(sum, count));
        Self((r << 11) | (g << 5) | b)
    }
}

/// `sum / count`, rounded to nearest; 256 eight-bit channels fit.
const fn mean(sum: u16, count: u16) -> u16 {
    let (sum, count) = (sum as u32, count as u32);
    match (sum + count / 2).checked_div(count) {
        Some(mean) => mean as u16,
        None => 0,
    }
}

/// `channel · level / 255`, rounded to nearest.
#[inline]
const fn scale(channel: u8, level: u8) -> u8 {
    // Of white, which is what isn't painted: known while compiling.
    if channel == u8::MAX {
        return level;
    }
    // Exact division by 255 for every 16-bit product: (p + 128 + ((p + 128) >> 8)) >> 8.
    let p = channel as u32 * level as u32 + 128;
    ((p + (p >> 8)) >> 8) as u8
}

/// An eight-bit channel on the scale 0..=max, rounded to nearest.
const fn narrow(channel: u8, max: u16) -> u16 {
    ((channel as u32 * max as u32 + 127) / 255) as u16
}
