//! Solids that have a colour.

use super::wrapping::Wrap;
use crate::solid::Rgb;
use crate::span::Shape;

/// A solid with a colour.
///
/// All faces of it that have no colour yet get this one, so the innermost paint wins: a part can
/// be painted as a whole, and one of its bores before that.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Painted<T> {
    solid: T,
    color: Rgb,
}

impl<T> Painted<T> {
    /// Gives a colour to all faces of `solid` that have none yet.
    #[must_use]
    pub const fn new(solid: T, color: Rgb) -> Self {
        Self { solid, color }
    }
}

impl<T: Shape> Wrap for Painted<T> {
    type Inner = T;

    #[inline]
    fn inner(&self) -> &T {
        &self.solid
    }

    fn color(&self, inner: Option<Rgb>) -> Option<Rgb> {
        inner.or(Some(self.color))
    }
}
