//! Grey pixels.

use super::{Blend, Pixel, mean, scale};
use crate::solid::Rgb;

/// A grey pixel of eight bits, 0 black to 255 white.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Gray8(pub u8);

impl Pixel for Gray8 {
    fn shaded(color: Rgb, level: u8) -> Self {
        Self(scale(color.luma(), level))
    }
}

impl Blend for Gray8 {
    type Sum = u16;
    const EMPTY: u16 = 0;

    fn add_to(self, sum: &mut u16) {
        *sum = sum.saturating_add(self.0.into());
    }

    fn mean(sum: u16, count: u16) -> Self {
        Self(mean(sum, count) as u8)
    }
}
