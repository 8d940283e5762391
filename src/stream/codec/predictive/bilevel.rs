//! Rows of pixels of one bit: a decision for each, with the pixels around it as its context.
//!
//! The context are 4 pixels at the left and 5 above: the nine bits WWWW, WWW, WW, W, NWW, NW, N, NE, NEE. So
//! it sees the period of a 4 × 4 dither. Pixels outside the frame or the payload are 0.

use super::range::Bins;

/// Contexts.
pub(crate) const CONTEXTS: usize = 1 << 9;

/// Every probability at the start of a payload: an even area goes on, and nothing else is known.
pub(crate) const START: [u8; CONTEXTS] = {
    let mut start = [0x80; CONTEXTS];
    start[0] = 0x08;
    start[CONTEXTS - 1] = 0xF8;
    start
};

/// Codes a row of `width` pixels. `above` holds the row above, and then this one: 8 pixels a byte, the most
/// significant bit leftmost, and zero bits behind the last pixel.
pub(crate) fn code<C: Bins, T: Copy + From<u8> + Into<u32>>(
    coder: &mut C,
    above: &mut [T],
    width: usize,
    pixel: impl Fn(usize) -> bool,
) {
    let mut left = 0;
    let mut upper = above.first().map_or(0, |first| (*first).into());
    for at in 0..above.len() {
        // Two bytes from the row above, that at this place and the next, and the end of the one before.
        upper = upper << 8 | above.get(at + 1).map_or(0, |next| (*next).into());
        let mut byte = 0;
        for (bit, x) in (0..8).rev().zip(8 * at..width) {
            // From NWW down to NEE, which is two pixels to the right.
            let around = (upper >> (bit + 6) & 31) as usize;
            let is_set = coder.bin(left << 5 | around, pixel(x));
            left = (left << 1 | usize::from(is_set)) & 15;
            byte |= u8::from(is_set) << bit;
        }
        if let Some(kept) = above.get_mut(at) {
            *kept = byte.into();
        }
    }
}
