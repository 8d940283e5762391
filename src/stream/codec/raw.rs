//! The pixels' little-endian bytes, one after the other.

use crate::stream::pixel::WirePixel;

/// The size of the pixels in bytes.
pub(super) const fn len<P: WirePixel>(pixels: &[P]) -> usize {
    pixels.len().saturating_mul(P::FORMAT.bytes_per_pixel())
}

/// Gives the pixels' bytes to `put`, pixel by pixel.
pub(super) fn pack<P: WirePixel, E>(
    pixels: &[P],
    put: &mut impl FnMut(&[u8]) -> Result<(), E>,
) -> Result<(), E> {
    pixels.iter().try_for_each(|pixel| put(pixel.to_le_bytes().as_ref()))
}
