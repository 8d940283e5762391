//! Pixels that are their bytes, so that a row of them goes to a display or a file as it is.

use super::{Blend, Gray8, Pixel, Rgb565, Rgb888};
use crate::solid::Rgb;

/// A colour pixel of 16 bits as most displays take it: the bits of [`Rgb565`], the upper byte first.
///
/// A row of bytes needs no copy on its way to DMA:
///
/// ```
/// use scancsg::render::{Pixel, Rgb, Rgb565, Rgb565Be};
///
/// let row: [Rgb565Be; 2] = [Pixel::shaded(Rgb::WHITE, 255), Rgb565(0x1234).into()];
/// assert_eq!(row.as_flattened(), [0xFF, 0xFF, 0x12, 0x34]);
/// ```
///
/// `[u8; 1]` is a grey pixel in the same way, and `[u8; 3]` one of red, green and blue.
pub type Rgb565Be = [u8; 2];

macro_rules! bytes {
    ($($bytes:ty = $Pixel:ident, $to:expr, $from:expr;)+) => {$(
        impl From<$Pixel> for $bytes {
            fn from(pixel: $Pixel) -> Self {
                $to(pixel.0)
            }
        }

        impl From<$bytes> for $Pixel {
            fn from(bytes: $bytes) -> Self {
                Self($from(bytes))
            }
        }

        impl Pixel for $bytes {
            fn shaded(color: Rgb, level: u8) -> Self {
                $Pixel::shaded(color, level).into()
            }
        }

        impl Blend for $bytes {
            type Sum = <$Pixel as Blend>::Sum;
            const EMPTY: Self::Sum = $Pixel::EMPTY;

            fn add_to(self, sum: &mut Self::Sum) {
                $Pixel::from(self).add_to(sum);
            }

            fn mean(sum: Self::Sum, count: u16) -> Self {
                $Pixel::mean(sum, count).into()
            }
        }
    )+};
}

bytes! {
    [u8; 1] = Gray8, |level| [level], |[level]: [u8; 1]| level;
    [u8; 2] = Rgb565, u16::to_be_bytes, u16::from_be_bytes;
    [u8; 3] = Rgb888, |bytes| bytes, |bytes| bytes;
}
