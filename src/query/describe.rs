//! What every solid says of itself.

use crate::geom::{Line, Vec3};
use crate::scan::bounds::Bounds;
use crate::span::{Face, Shape, SpanStack};

/// A solid: where lines are inside it, and what its surface is like.
///
/// Implement it for a solid of your own, wrap that in a [`ByLine`](crate::solid::ByLine), and it can be
/// combined, traced and rendered like the crate's solids. There is an example at
/// [`ByLine`](crate::solid::ByLine).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a solid",
    label = "not a solid",
    note = "all parts of a solid are solids, and of one number type"
)]
pub trait Solid: Shape {
    /// Pushes the spans of the line with the solid, in ascending order and regularised (every span
    /// has a length, and there is a gap between any two), with faces counted from `first` on.
    fn spans(
        &self,
        line: &Line<Self::Scalar>,
        first: Face,
        stack: &mut SpanStack<'_, Self::Scalar>,
    );

    /// The normal of length 1 that points out of the solid, at a point on one of its faces.
    ///
    /// On curved faces its relative error is that of the point over the radius: a point with a
    /// coordinate of 1,000 in `f32` is known to 3·10⁻⁵.
    fn normal(&self, face: Face, at: Vec3<Self::Scalar>) -> Vec3<Self::Scalar>;

    /// A ball or a box around the solid. A solid that says it is asked only where it may be seen.
    fn bounds(&self) -> Bounds<Self::Scalar> {
        Bounds::Unbounded
    }

    /// The point of a face nearest to a point that lies beside it by a rounding error.
    ///
    /// [`RayCast::hit`](crate::solid::RayCast::hit) reports such points, so that a ray that starts there
    /// starts on the surface.
    fn onto(&self, face: Face, near: Vec3<Self::Scalar>) -> Vec3<Self::Scalar> {
        let _ = face;
        near
    }

    /// The scalar product of the normal and a vector: for one of length 1, the cosine of the angle
    /// between them. The point on the face is asked for only where the normal depends on it.
    ///
    /// In fixed point it may be off by one unit from the product with [`normal`](Self::normal).
    #[inline]
    fn cosine(
        &self,
        face: Face,
        at: impl FnOnce() -> Vec3<Self::Scalar>,
        to: Vec3<Self::Scalar>,
    ) -> Self::Scalar {
        self.normal(face, at()).dot(to)
    }

    /// The colour of a face, or `None` where nothing painted it.
    fn color(&self, face: Face) -> Option<Rgb> {
        let _ = face;
        None
    }

    /// The lowest and the highest corner of a box around a polyhedron whose faces lie in the pool of a
    /// [`Program`](crate::program::Program); `None` for all other solids. An enum of solids passes it on.
    #[inline]
    fn pooled(&self) -> Option<[Vec3<Self::Scalar>; 2]> {
        None
    }
}

/// A colour of eight bits per channel.
///
/// Where a format has fewer bits, channels are rounded to the nearest level.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
