//! The sphere (as a solid: the ball).

mod orthographic;
mod perspective;

use crate::geom::{Line, Vec3};
use crate::quadric::{Ball, meet};
use crate::query::Solid;
use crate::scalar::{ConstOps, Scalar, per_scalar};
use crate::scan::bounds::Bounds;
use crate::scan::leaf;
use crate::span::{Crossing, Face, Shape, Span, SpanStack};

/// A solid sphere.
///
/// One face.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Sphere<S: Scalar> {
    ball: Ball<S>,
    /// 1/radius.
    curvature: S::Scale,
}

crate::error_text! {
    /// Why a sphere can't be made.
    pub enum SphereError {
        /// A coordinate or the radius is infinite or NaN.
        NotFinite => "a coordinate or the radius of the sphere is infinite or not a number",
        /// The radius is zero, negative, or not between [`Scalar::MIN_RADIUS`] and [`Scalar::MAX_COORDINATE`].
        Radius => "the radius of the sphere is not positive, or out of its number type's range",
        /// A coordinate is larger than [`Scalar::MAX_COORDINATE`].
        TooFar => "the sphere is too far away for its number type",
    }
}

per_scalar! { $S: impl[] Sphere<$S> {
    /// A sphere around `center`.
    ///
    /// # Errors
    /// [`SphereError::NotFinite`], [`SphereError::Radius`], [`SphereError::TooFar`].
    pub const fn new(center: Vec3<$S>, radius: $S) -> Result<Self, SphereError> {
        type Ops<S> = ConstOps<S>;
        let is_finite = center.has_finite_coordinates() && Ops::<$S>::is_finite(radius);
        match () {
            () if !is_finite => Err(SphereError::NotFinite),
            () if !Ops::<$S>::is_radius(radius) => Err(SphereError::Radius),
            () if !center.is_within_reach() => Err(SphereError::TooFar),
            () => Ok(Self { ball: Ball { center, radius }, curvature: Ops::<$S>::inverse(radius) }),
        }
    }
} }

/// For any number type: what a type parameter can call. In constants, use [`new`](Self::new).
impl<S: Scalar> Sphere<S> {
    /// A sphere around `center`.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn around(center: Vec3<S>, radius: S) -> Result<Self, SphereError> {
        match () {
            () if !(center.is_finite() && radius.is_finite()) => Err(SphereError::NotFinite),
            () if !radius.is_radius() => Err(SphereError::Radius),
            () if !center.is_within_range() => Err(SphereError::TooFar),
            () => Ok(Self { ball: Ball { center, radius }, curvature: radius.inverse() }),
        }
    }
}

impl<S: Scalar> Shape for Sphere<S> {
    type Scalar = S;
    const SPANS: usize = 1;
    const FACES: u16 = 1;
}

/// A span that may have no length: then it is none.
#[inline]
fn span<S: Scalar>(enter: S, exit: S) -> Option<Span<S>> {
    let face = Face(0);
    Span::new(Crossing { t: enter, face }, Crossing { t: exit, face })
}

impl<S: Scalar> Solid for Sphere<S> {
    fn spans(&self, line: &Line<S>, first: Face, stack: &mut SpanStack<'_, S>) {
        let ends = meet::ball(&self.ball, line).ends();
        stack.put_all(ends.and_then(|(enter, exit)| span(enter, exit)), first);
    }

    fn bounds(&self) -> Bounds<S> {
        let Ball { center, radius } = self.ball;
        Bounds::Ball { center, radius }
    }

    fn onto(&self, _: Face, near: Vec3<S>) -> Vec3<S> {
        self.ball.onto(near)
    }

    fn normal(&self, _: Face, at: Vec3<S>) -> Vec3<S> {
        (at - self.ball.center).map(|coordinate| coordinate.scaled(self.curvature))
    }
}

leaf!([S: Scalar] Sphere<S>);
