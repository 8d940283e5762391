//! Pixel formats and colours: what a shaded sample becomes in the caller's row.
//!
//! Everything here is integer arithmetic on eight-bit levels, so a pixel's bits depend on the
//! level and the colour alone, not on the number type of the scene.

/// A colour of eight bits per channel.
///
/// Where a format has fewer bits, channels are rounded to the nearest level.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rgb {
    /// Red, 0..=255.
    pub r: u8,
    /// Green, 0..=255.
    pub g: u8,
    /// Blue, 0..=255.
    pub b: u8,
}

impl Rgb {
    /// White: a solid without a colour of its own.
    pub const WHITE: Self = Self::new(255, 255, 255);

    /// A colour from its channels.
    #[must_use]
    pub const fn new(r: u8, g: u8, b: u8) -> Self {
        Self { r, g, b }
    }

    /// The luma of the colour, 0..=255: `0.299 R + 0.587 G + 0.114 B`
    /// (ITU-R BT.601-7, section 2.5.1).
    #[must_use]
    pub const fn luma(self) -> u8 {
        // The weights times 2^16; they add up to 2^16 exactly, so white stays 255.
        let sum = 19_595 * self.r as u32 + 38_470 * self.g as u32 + 7_471 * self.b as u32;
        ((sum + 32_768) >> 16) as u8
    }
}

/// The pixel formats that a frame can have, with their codes on the link.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
#[repr(u8)]
pub enum PixelFormat {
    /// One byte: linear grey, 0 black to 255 white.
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

    /// The pixel of a surface of colour `colour`, lit with `level` (0 dark to 255 full).
    fn shaded(colour: Rgb, level: u8) -> Self;

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

    fn shaded(colour: Rgb, level: u8) -> Self {
        Self(scale(colour.luma(), level))
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

    fn shaded(colour: Rgb, level: u8) -> Self {
        let r = narrow(scale(colour.r, level), 31);
        let g = narrow(scale(colour.g, level), 63);
        let b = narrow(scale(colour.b, level), 31);
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
