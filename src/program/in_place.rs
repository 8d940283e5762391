//! A part of a program as a solid: its leaf, where it stands, with its colour.

use crate::geom::Pose;
use crate::solid::{Rgb, Wrap};
use crate::span::Shape;

/// A part of a program.
pub(super) struct InPlace<'a, L: Shape> {
    pub(super) leaf: &'a L,
    pub(super) pose: Option<&'a Pose<L::Scalar>>,
    pub(super) color: Option<Rgb>,
}

impl<L: Shape> Wrap for InPlace<'_, L> {
    type Inner = L;

    #[inline]
    fn inner(&self) -> &L {
        self.leaf
    }

    #[inline]
    fn pose(&self) -> Option<&Pose<L::Scalar>> {
        self.pose
    }

    fn color(&self, inner: Option<Rgb>) -> Option<Rgb> {
        inner.or(self.color)
    }
}
