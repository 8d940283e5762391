//! Pixels that are lit or not.

use super::{Pixel, scale};
use crate::solid::Rgb;

/// A pixel of a display that is black and white: lit from half of the full level on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Mono(pub bool);

impl Pixel for Mono {
    fn shaded(color: Rgb, level: u8) -> Self {
        Self(scale(color.luma(), level) >= 128)
    }
}
