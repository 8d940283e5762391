//! Pixels that are their bytes, so that a row of them goes to a display or a file as it is.

use super::same_bits::same_bits;
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

same_bits! {
    Gray8 = [u8; 1], |level| [level], |[level]: [u8; 1]| level;
    Rgb565 = [u8; 2], u16::to_be_bytes, u16::from_be_bytes;
    Rgb888 = [u8; 3], |bytes| bytes, |bytes| bytes;
}

macro_rules! bytes {
    ($($Pixel:ident = $bytes:ty;)+) => {$(
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
    Gray8 = [u8; 1];
    Rgb565 = [u8; 2];
    Rgb888 = [u8; 3];
}
