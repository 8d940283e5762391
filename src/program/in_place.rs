//! A part of a program as a solid: its leaf with its faces, where it stands, with its colour.

use super::pool::Pool;
use crate::geom::{Line, Pose, Vec3};
use crate::quadric::HalfSpace;
use crate::solid::{Bounds, Polyhedron, Rgb, Solid, Wrap};
use crate::span::{Face, Shape, SpanStack};

/// A part of a program.
pub(super) struct InPlace<'a, L: Shape, const POOL: usize> {
    pub(super) leaf: Whole<'a, L, POOL>,
    pub(super) pose: Option<&'a Pose<L::Scalar>>,
    pub(super) color: Option<Rgb>,
}

impl<'a, L: Shape, const POOL: usize> Wrap for InPlace<'a, L, POOL> {
    type Inner = Whole<'a, L, POOL>;

    #[inline]
    fn inner(&self) -> &Self::Inner {
        &self.leaf
    }

    #[inline]
    fn pose(&self) -> Option<&Pose<L::Scalar>> {
        self.pose
    }

    fn color(&self, inner: Option<Rgb>) -> Option<Rgb> {
        inner.or(self.color)
    }
}

/// A polyhedron of faces that lie in a pool.
type Facetted<'a, S, const N: usize> = Polyhedron<S, N, &'a [HalfSpace<S>]>;

/// A leaf, and the faces that it has in the pool.
pub(super) struct Whole<'a, L: Shape, const POOL: usize> {
    pub(super) leaf: &'a L,
    pub(super) pool: &'a Pool<L::Scalar, POOL>,
    pub(super) part: usize,
}

impl<'a, L: Solid, const POOL: usize> Whole<'a, L, POOL> {
    /// The polyhedron that the leaf stands for. It is known at compile time that one without a pool stands for
    /// none.
    #[inline(always)]
    fn polyhedron(&self) -> Option<Facetted<'a, L::Scalar, POOL>> {
        if POOL == 0 {
            return None;
        }
        let ([low, high], faces) = (self.leaf.pooled()?, self.pool.of(self.part));
        (!faces.is_empty()).then_some(Polyhedron { faces, count: faces.len() as u16, low, high })
    }
}

impl<L: Shape, const POOL: usize> Shape for Whole<'_, L, POOL> {
    type Scalar = L::Scalar;
    const SPANS: usize = L::SPANS;
    const STACK: usize = L::STACK;
    const FACES: u16 = L::FACES;
}

impl<L: Solid, const POOL: usize> Solid for Whole<'_, L, POOL> {
    #[inline]
    fn spans(&self, line: &Line<L::Scalar>, first: Face, stack: &mut SpanStack<'_, L::Scalar>) {
        match self.polyhedron() {
            Some(polyhedron) => polyhedron.spans(line, first, stack),
            None => self.leaf.spans(line, first, stack),
        }
    }

    #[inline]
    fn bounds(&self) -> Bounds<L::Scalar> {
        self.leaf.bounds()
    }

    #[inline]
    fn normal(&self, face: Face, at: Vec3<L::Scalar>) -> Vec3<L::Scalar> {
        match self.polyhedron() {
            Some(polyhedron) => polyhedron.normal(face, at),
            None => self.leaf.normal(face, at),
        }
    }

    #[inline]
    fn onto(&self, face: Face, near: Vec3<L::Scalar>) -> Vec3<L::Scalar> {
        match self.polyhedron() {
            Some(polyhedron) => polyhedron.onto(face, near),
            None => self.leaf.onto(face, near),
        }
    }

    #[inline]
    fn cosine(
        &self,
        face: Face,
        at: impl FnOnce() -> Vec3<L::Scalar>,
        to: Vec3<L::Scalar>,
    ) -> L::Scalar {
        match self.polyhedron() {
            Some(polyhedron) => polyhedron.cosine(face, at, to),
            None => self.leaf.cosine(face, at, to),
        }
    }

    #[inline]
    fn color(&self, face: Face) -> Option<Rgb> {
        self.leaf.color(face)
    }
}
