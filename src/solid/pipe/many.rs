//! Up to so many solids of one kind: their union, as that of an array.

use crate::geom::{Line, Vec3};
use crate::scalar::Number;
use crate::solid::group::{faces_of_group, project_as_group, stack_of_group, unite};
use crate::solid::{Rgb, Shape, Solid};
use crate::span::{Face, SpanStack};

/// From one to `N` solids.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Many<T, const N: usize> {
    /// Behind the last one, the first one again and again.
    items: [T; N],
    count: usize,
}

impl<T: Copy, const N: usize> Many<T, N> {
    pub(super) const fn of(first: T) -> Self {
        const { assert!(N > 0, "a group of solids needs at least one") };
        Self { items: [first; N], count: 1 }
    }

    /// Adds one more, if there is room.
    pub(super) const fn push(&mut self, item: T) -> bool {
        if self.count >= N {
            return false;
        }
        self.items[self.count] = item;
        self.count += 1;
        true
    }

    pub(super) const fn replace_first(&mut self, item: T) {
        self.items[0] = item;
    }

    pub(super) const fn first(&self) -> &T {
        &self.items[0]
    }
}

impl<T, const N: usize> Many<T, N> {
    pub(super) const fn count(&self) -> usize {
        self.count
    }

    fn items(&self) -> &[T] {
        self.items.get(..self.count).unwrap_or(&self.items)
    }
}

impl<T: Shape, const N: usize> Many<T, N> {
    /// The item that a face belongs to, and the face within that item.
    fn owner(&self, face: Face) -> Option<(&T, Face)> {
        let index = face.0.checked_div(T::FACES)?;
        Some((self.items().get(usize::from(index))?, Face(face.0 % T::FACES)))
    }
}

impl<T: Shape, const N: usize> Shape for Many<T, N> {
    type Scalar = T::Scalar;
    const SPANS: usize = N * T::SPANS;
    const STACK: usize = stack_of_group(N, T::SPANS, T::STACK);
    const FACES: u16 = faces_of_group(N, T::FACES);
}

impl<T: Solid, const N: usize> Solid for Many<T, N> {
    fn spans(
        &self,
        line: &Line<Self::Scalar>,
        first: Face,
        stack: &mut SpanStack<'_, Self::Scalar>,
    ) {
        unite(0..self.count as u16, T::FACES, first, stack, |index, face, stack| {
            if let Some(solid) = self.items.get(index) {
                solid.spans(line, face, stack);
            }
        });
    }

    fn onto(&self, face: Face, near: Vec3<Self::Scalar>) -> Vec3<Self::Scalar> {
        self.owner(face).map_or(near, |(solid, face)| solid.onto(face, near))
    }

    fn normal(&self, face: Face, at: Vec3<Self::Scalar>) -> Vec3<Self::Scalar> {
        self.owner(face).map_or(Vec3::ZERO, |(solid, face)| solid.normal(face, at))
    }

    #[inline]
    fn cosine(
        &self,
        face: Face,
        at: impl FnOnce() -> Vec3<Self::Scalar>,
        to: Vec3<Self::Scalar>,
    ) -> Self::Scalar {
        self.owner(face).map_or(T::Scalar::ZERO, |(solid, face)| solid.cosine(face, at, to))
    }

    fn color(&self, face: Face) -> Option<Rgb> {
        self.owner(face).and_then(|(solid, face)| solid.color(face))
    }
}

project_as_group!(Many<T, N>, items);
