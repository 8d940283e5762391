//! Colour pixels of 24 bits.

use super::{Blend, Pixel, mean, scale};
use crate::solid::Rgb;

/// A colour pixel of 24 bits: red, green, blue.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Rgb888(pub [u8; 3]);

impl Pixel for Rgb888 {
    fn shaded(color: Rgb, level: u8) -> Self {
        Self([color.r, color.g, color.b].map(|channel| scale(channel, level)))
    }
}

impl Blend for Rgb888 {
    type Sum = [u16; 3];
    const EMPTY: [u16; 3] = [0; 3];

    fn add_to(self, sum: &mut [u16; 3]) {
        for (sum, channel) in sum.iter_mut().zip(self.0) {
            *sum = sum.saturating_add(channel.into());
        }
    }

    fn mean(sum: [u16; 3], count: u16) -> Self {
        Self(sum.map(|sum| mean(sum, count) as u8))
    }
}
