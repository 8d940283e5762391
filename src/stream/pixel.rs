//! Pixels on the link: their formats, and the pixel types that can be sent.

use crate::render::{Gray8, Mono, Pixel, Rgb565, Rgb888};

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
    /// Three bytes: red, green, blue.
    Rgb888 = 2,
    /// One bit: 1 is lit. The leftmost of eight pixels is the highest bit of a byte. The last byte of a
    /// row is filled up with zeros.
    Mono = 3,
}

impl PixelFormat {
    /// The size of one pixel in bits.
    #[must_use]
    pub const fn bits_per_pixel(self) -> usize {
        match self {
            Self::Gray8 => 8,
            Self::Rgb565 => 16,
            Self::Rgb888 => 24,
            Self::Mono => 1,
        }
    }

    /// The size of a row of `width` pixels in bytes.
    #[must_use]
    pub const fn row_bytes(self, width: u16) -> usize {
        // Saturates only where usize has 16 bits; no slice is that long, so it still compares rightly.
        (width as usize).saturating_mul(self.bits_per_pixel()).div_ceil(8)
    }

    /// Whether pixels are coded by the colours of the scene.
    pub(super) const fn has_colors(self) -> bool {
        matches!(self, Self::Rgb565 | Self::Rgb888)
    }

    /// The unit of run-length coding, in bytes: a pixel, or eight pixels of one bit.
    pub(super) const fn unit_bytes(self) -> usize {
        self.bits_per_pixel().div_ceil(8)
    }

    /// The format with this code, if there is one.
    #[must_use]
    pub const fn from_code(code: u8) -> Option<Self> {
        match code {
            0 => Some(Self::Gray8),
            1 => Some(Self::Rgb565),
            2 => Some(Self::Rgb888),
            3 => Some(Self::Mono),
            _ => None,
        }
    }

    /// The code of this format on the link.
    #[must_use]
    pub const fn code(self) -> u8 {
        self as u8
    }
}

/// A pixel that can be sent: it says which of the link's pixels it is.
///
/// [`Gray8`], [`Rgb565`], [`Rgb888`], [`Mono`] and rows of bytes (`[u8; 2]`, the upper byte first) are such
/// pixels. A display's own type becomes one by
/// [`to_wire`](WirePixel::to_wire), in whatever order of bytes the display wants its colours:
///
/// ```
/// use scancsg::render::{Pixel, Rgb, Rgb565};
/// use scancsg::stream::{RowHash, WirePixel};
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
///     type Wire = Rgb565;
///
///     fn to_wire(self) -> Rgb565 {
///         Rgb565(u16::from_be_bytes(self.0))
///     }
/// }
///
/// let rows = ([Panel([0x12, 0x34])], [Rgb565(0x1234)]);
/// assert_eq!(RowHash::of(0, &rows.0), RowHash::of(0, &rows.1));
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` can't be sent: it doesn't say which of the link's pixels it is",
    note = "implement `WirePixel` with `type Wire` one of `Gray8`, `Rgb565`, `Rgb888`, `Mono`"
)]
pub trait WirePixel: Pixel + Eq {
    /// The pixel that it is on the link: [`Gray8`], [`Rgb565`], [`Rgb888`] or [`Mono`].
    type Wire: Wire;

    /// The pixel as it goes over the link.
    fn to_wire(self) -> Self::Wire;
}

/// One of the link's own pixels.
///
/// Other types can't be: the other end would not know them.
pub trait Wire: Pixel + Eq + sealed::Sealed {
    /// The format's name on the link.
    const FORMAT: PixelFormat;
    /// The bytes of one unit on the link: a pixel, or eight pixels of one bit.
    type Unit: AsRef<[u8]> + Copy + Eq;

    /// The unit that begins with `first`, the wire's pixel of each of the others in `rest`.
    #[doc(hidden)]
    fn unit<P: WirePixel<Wire = Self>>(pixels: &[P]) -> Self::Unit;
}

mod sealed {
    pub trait Sealed {}
}

/// A row as units of bytes.
#[derive(Clone, Copy)]
pub(super) struct Units<'a, P>(pub &'a [P]);

impl<'a, P: WirePixel> Units<'a, P> {
    /// How many pixels a unit has.
    const PIXELS: usize = if P::Wire::FORMAT.bits_per_pixel() < 8 { 8 } else { 1 };

    /// The number of units.
    pub const fn count(self) -> usize {
        self.0.len().div_ceil(Self::PIXELS)
    }

    /// The size of all units in bytes.
    pub const fn bytes(self) -> usize {
        self.count().saturating_mul(P::Wire::FORMAT.unit_bytes())
    }

    /// The row without its first `count` units.
    pub fn skip(self, count: usize) -> Self {
        Self(self.0.get(count.saturating_mul(Self::PIXELS)..).unwrap_or_default())
    }

    /// The row's first `count` units.
    pub fn take(self, count: usize) -> Self {
        let pixels = count.saturating_mul(Self::PIXELS).min(self.0.len());
        Self(self.0.get(..pixels).unwrap_or_default())
    }

    /// All units, from the left.
    #[inline]
    pub fn iter(self) -> impl Iterator<Item = <P::Wire as Wire>::Unit> + use<'a, P> {
        self.0.chunks(Self::PIXELS).map(P::Wire::unit)
    }
}

/// A pixel of the library as a pixel of the link: the bytes of one, from the first of a unit's pixels.
macro_rules! wire {
    ($pixel:ident, $bytes:literal, $to_bytes:expr) => {
        impl sealed::Sealed for $pixel {}

        impl Wire for $pixel {
            const FORMAT: PixelFormat = PixelFormat::$pixel;
            type Unit = [u8; $bytes];

            #[inline]
            fn unit<P: WirePixel<Wire = Self>>(pixels: &[P]) -> Self::Unit {
                let to_bytes: fn(&[P]) -> Self::Unit = $to_bytes;
                to_bytes(pixels)
            }
        }

        impl WirePixel for $pixel {
            type Wire = Self;

            #[inline]
            fn to_wire(self) -> Self {
                self
            }
        }
    };
}

wire!(Gray8, 1, |pixels| pixels.first().map_or([0], |pixel| [pixel.to_wire().0]));
wire!(Rgb565, 2, |pixels| pixels.first().map_or([0; 2], |pixel| pixel.to_wire().0.to_le_bytes()));
wire!(Rgb888, 3, |pixels| pixels.first().map_or([0; 3], |pixel| pixel.to_wire().0));
wire!(Mono, 1, |pixels| {
    let bits = pixels.iter().map(|pixel| u8::from(pixel.to_wire().0));
    [bits.zip((0..8).rev()).fold(0, |byte, (bit, place)| byte | bit << place)]
});

impl WirePixel for [u8; 1] {
    type Wire = Gray8;

    fn to_wire(self) -> Gray8 {
        let [level] = self;
        Gray8(level)
    }
}

impl WirePixel for [u8; 2] {
    type Wire = Rgb565;

    fn to_wire(self) -> Rgb565 {
        Rgb565(u16::from_be_bytes(self))
    }
}

impl WirePixel for [u8; 3] {
    type Wire = Rgb888;

    fn to_wire(self) -> Rgb888 {
        Rgb888(self)
    }
}
