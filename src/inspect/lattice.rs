//! Points spread evenly over a square.

use crate::scalar::Real;

/// Point `index` of `count` in a unit square around 0: `(k/count, {k·φ})`, the golden lattice. Each of three
/// axes has one of its own, moved by a third.
///
/// Any strip along a side has as many points as its width says, but for a few. So a face across an axis is met
/// neither by too many points nor by too few, wherever it lies. (H. Niederreiter, *Random Number Generation
/// and Quasi-Monte Carlo Methods*, 1992, chapter 3.)
pub(super) fn point<T: Real>(index: u32, count: u32, axis: u8) -> [T; 2] {
    /// 2³² over the golden ratio.
    const GOLDEN: u32 = 0x9e37_79b9;
    const THIRD: u32 = 0x5555_5555;
    let part = ((2 * u64::from(index) + 1) << 31).checked_div(count.into()).unwrap_or(0);
    // The upper 24 bits: all number types have them.
    let centered =
        |part: u32| T::from_int((part >> 8).cast_signed() - (1 << 23)) / T::from_int(1 << 24);
    [
        centered(part as u32),
        centered(index.wrapping_mul(GOLDEN).wrapping_add(u32::from(axis) * THIRD)),
    ]
}
