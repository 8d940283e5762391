//! A solid that stands somewhere else than where it was made.

use super::row::{Scan, project_as_within};
use super::{Rgb, Shape, Solid};
use crate::geom::{Line, Pose, Rays, Vec3};
use crate::span::{Face, SpanStack};

/// A solid moved by a rigid motion. The solid itself is borrowed, so one can stand in many places.
///
/// Nothing is moved but the rays: once per picture, or once per single ray.
///
/// To move what is placed already, put one pose after the other ([`Pose::then`]), which is checked. A
/// placed solid that is placed again has no such check: in fixed point, a ray that is out of range in
/// the innermost frame (farther than 2³⁰ units from its origin) meets nothing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placed<'a, T: Shape> {
    solid: &'a T,
    pose: Pose<T::Scalar>,
}

impl<'a, T: Shape> Placed<'a, T> {
    /// Puts `solid`, together with its own frame, to `pose`.
    #[must_use]
    pub const fn new(solid: &'a T, pose: Pose<T::Scalar>) -> Self {
        Self { solid, pose }
    }
}

impl<T: Shape> Shape for Placed<'_, T> {
    type Scalar = T::Scalar;
    const SPANS: usize = T::SPANS;
    const STACK: usize = T::STACK;
    const FACES: u16 = T::FACES;
}

impl<T: Solid> Solid for Placed<'_, T> {
    fn spans(
        &self,
        line: &Line<Self::Scalar>,
        first: Face,
        stack: &mut SpanStack<'_, Self::Scalar>,
    ) {
        self.solid.spans(&self.pose.line_back(line), first, stack);
    }

    fn onto(&self, face: Face, near: Vec3<Self::Scalar>) -> Vec3<Self::Scalar> {
        self.pose.point(self.solid.onto(face, self.pose.point_back(near)))
    }

    fn normal(&self, face: Face, at: Vec3<Self::Scalar>) -> Vec3<Self::Scalar> {
        self.pose.direction(self.solid.normal(face, self.pose.point_back(at)))
    }

    fn color(&self, face: Face) -> Option<Rgb> {
        self.solid.color(face)
    }
}

impl<R: Rays<Scalar = T::Scalar>, T: Scan<R>> Scan<R> for Placed<'_, T> {
    project_as_within!(solid: T, |placed, rays: R| &rays.back_from(&placed.pose));
}
