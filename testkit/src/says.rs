//! A solid of a user's own, with the bounds that it says.

use scancsg::geom::{Line, Vec3};
use scancsg::solid::{Bounds, Solid};
use scancsg::span::{Face, Shape, SpanStack};

/// A solid that says other bounds than its own, or none.
#[derive(Debug, Clone, Copy)]
pub struct Says<T: Shape>(pub T, pub Bounds<T::Scalar>);

impl<T: Shape> Shape for Says<T> {
    type Scalar = T::Scalar;
    const SPANS: usize = T::SPANS;
    const STACK: usize = T::STACK;
    const FACES: u16 = T::FACES;
}

impl<T: Solid> Solid for Says<T> {
    fn spans(&self, line: &Line<T::Scalar>, first: Face, stack: &mut SpanStack<'_, T::Scalar>) {
        self.0.spans(line, first, stack);
    }

    fn normal(&self, face: Face, at: Vec3<T::Scalar>) -> Vec3<T::Scalar> {
        self.0.normal(face, at)
    }

    fn bounds(&self) -> Bounds<T::Scalar> {
        self.1
    }
}
