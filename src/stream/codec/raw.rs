//! The pixels' little-endian bytes, one after the other.

use crate::stream::pixel::{Units, WirePixel};

/// Gives the units' bytes to `put`, unit by unit.
pub(super) fn pack<P: WirePixel, E>(
    units: Units<'_, P>,
    put: &mut impl FnMut(&[u8]) -> Result<(), E>,
) -> Result<(), E> {
    units.iter().try_for_each(|unit| put(unit.as_ref()))
}
