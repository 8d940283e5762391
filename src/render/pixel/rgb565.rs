//! Colour pixels of 16 bits.

use super::{Blend, Pixel, mean, narrow, scale};
use crate::solid::Rgb;

/// A colour pixel of 16 bits: red in bits 15..11, green in 10..5, blue in 4..0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Rgb565(pub u16);

impl Pixel for Rgb565 {
    fn shaded(color: Rgb, level: u8) -> Self {
        let r = narrow(scale(color.r, level), 31);
        let g = narrow(scale(color.g, level), 63);
        let b = narrow(scale(color.b, level), 31);
        Self((r << 11) | (g << 5) | b)
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
