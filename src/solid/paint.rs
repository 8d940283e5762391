//! Colours, and solids that have one.

use super::{Shape, Solid};
use crate::geom::{Line, Vec3};
use crate::solid::row::{Scan, project_as_within};
use crate::span::{Face, SpanStack};

/// A colour of eight bits per channel.
///
/// Where a format has fewer bits, channels are rounded to the nearest level.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rgb {
    /// Red, 0..=255.
    pub r: u8,
    /// Green, 0..=255.
    pub g: u8,
    /// Blue, 0..=255.
    pub b: u8,
}

impl Rgb {
    /// White: a solid without a colour of its own.
    pub const WHITE: Self = Self::new(255, 255, 255);

    /// A colour from its channels.
    #[must_use]
    pub const fn new(r: u8, g: u8, b: u8) -> Self {
        Self { r, g, b }
    }

    /// The luma of the colour, 0..=255: `0.299 R + 0.587 G + 0.114 B`
    /// (ITU-R BT.601-7, section 2.5.1).
    #[must_use]
    pub const fn luma(self) -> u8 {
        // The weights times 2^16; they add up to 2^16 exactly, so white stays 255.
        let sum = 19_595 * self.r as u32 + 38_470 * self.g as u32 + 7_471 * self.b as u32;
        ((sum + 32_768) >> 16) as u8
    }
}

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
    /// Paints what is not yet painted of `solid`.
    #[must_use]
    pub const fn new(solid: T, color: Rgb) -> Self {
        Self { solid, color }
    }
}

impl<T: Shape> Shape for Painted<T> {
    type Scalar = T::Scalar;
    const SPANS: usize = T::SPANS;
    const STACK: usize = T::STACK;
    const FACES: u16 = T::FACES;
}

impl<T: Solid> Solid for Painted<T> {
    fn spans(
        &self,
        line: &Line<Self::Scalar>,
        first: Face,
        stack: &mut SpanStack<'_, Self::Scalar>,
    ) {
        self.solid.spans(line, first, stack);
    }

    fn onto(&self, face: Face, near: Vec3<Self::Scalar>) -> Vec3<Self::Scalar> {
        self.solid.onto(face, near)
    }

    fn normal(&self, face: Face, at: Vec3<Self::Scalar>) -> Vec3<Self::Scalar> {
        self.solid.normal(face, at)
    }

    #[inline]
    fn cosine(
        &self,
        face: Face,
        at: impl FnOnce() -> Vec3<Self::Scalar>,
        to: Vec3<Self::Scalar>,
    ) -> Self::Scalar {
        self.solid.cosine(face, at, to)
    }

    fn color(&self, face: Face) -> Option<Rgb> {
        self.solid.color(face).or(Some(self.color))
    }
}

impl<R, T: Scan<R>> Scan<R> for Painted<T> {
    project_as_within!(solid: T, |_painted, rays: R| rays);
}
