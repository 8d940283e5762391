//! Pixel formats, as numbers of the caller's.

use crate::status::Status;
use scancsg::render::{Gray8, Mono, Pixel, Rgb, Rgb565, Rgb565Be, Rgb888};

/// What the bytes of a row are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Format {
    /// One byte a pixel: grey.
    Gray8 = 0,
    /// Two bytes a pixel, the lower one first: five bits of red, six of green, five of blue.
    Rgb565 = 1,
    /// Three bytes a pixel: red, green, blue.
    Rgb888 = 2,
    /// Eight pixels a byte, the leftmost one in the highest bit: 1 is lit. The last byte is filled up with zeros.
    /// Packets can't have it.
    Mono = 3,
    /// As `SCANCSG_FORMAT_RGB565`, the upper byte first: what most displays take.
    Rgb565Be = 4,
}

impl Format {
    const ALL: [Self; 5] = [Self::Gray8, Self::Rgb565, Self::Rgb888, Self::Mono, Self::Rgb565Be];

    pub(crate) fn of(number: u8) -> Result<Self, Status> {
        Self::ALL.into_iter().find(|format| *format as u8 == number).ok_or(Status::Format)
    }

    /// The bytes of so many pixels.
    pub(crate) fn bytes(self, pixels: usize) -> usize {
        match self {
            Self::Gray8 => pixels,
            Self::Rgb565 | Self::Rgb565Be => pixels.saturating_mul(2),
            Self::Rgb888 => pixels.saturating_mul(3),
            Self::Mono => pixels.div_ceil(8),
        }
    }

    /// Writes pixels as bytes, which are just as many as they need.
    pub(crate) fn write(self, pixels: &[Lit], bytes: &mut [u8]) {
        fn each<P: Into<[u8; N]> + Pixel, const N: usize>(pixels: &[Lit], bytes: &mut [u8]) {
            let (places, _) = bytes.as_chunks_mut();
            for (place, lit) in places.iter_mut().zip(pixels) {
                *place = lit.pixel::<P>().into();
            }
        }
        match self {
            Self::Gray8 => each::<Gray8, 1>(pixels, bytes),
            Self::Rgb565Be => each::<Rgb565Be, 2>(pixels, bytes),
            Self::Rgb888 => each::<Rgb888, 3>(pixels, bytes),
            Self::Rgb565 => {
                let (places, _) = bytes.as_chunks_mut();
                for (place, lit) in places.iter_mut().zip(pixels) {
                    *place = lit.pixel::<Rgb565>().0.to_le_bytes();
                }
            }
            Self::Mono => {
                for (byte, eight) in bytes.iter_mut().zip(pixels.chunks(8)) {
                    let bits = eight.iter().map(|lit| u8::from(lit.pixel::<Mono>().0));
                    *byte =
                        bits.zip((0..8).rev()).fold(0, |byte, (bit, place)| byte | bit << place);
                }
            }
        }
    }
}

/// A pixel before it has a format. So rows are rendered by the same code for all formats.
#[derive(Clone, Copy)]
pub(crate) struct Lit {
    color: Rgb,
    level: u8,
}

impl Lit {
    pub(crate) const BLACK: Self = Self { color: Rgb::new(0, 0, 0), level: 0 };

    fn pixel<P: Pixel>(self) -> P {
        P::shaded(self.color, self.level)
    }
}

impl Pixel for Lit {
    fn shaded(color: Rgb, level: u8) -> Self {
        Self { color, level }
    }
}
