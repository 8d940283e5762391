//! The sphere (as a solid: the ball).

use super::intersect::Intersect;
use super::row::{Leaf, leaf};
use super::silhouette::{ParallelBall, PencilBall};
use super::{Shape, Solid};
use crate::geom::{Affine, Extent, Line, Parallel, Pencil, Vec3};
use crate::scalar::{Check, Chord, FixedI32, Fraction, Scalar};
use crate::span::{Crossing, Face, Span, SpanStack};

/// A solid sphere.
///
/// One face.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Sphere<S: Scalar> {
    center: Vec3<S>,
    radius: S,
    /// 1/radius.
    curvature: S::Factor,
}

/// Why a sphere can't be made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SphereError {
    /// A coordinate or the radius is infinite or NaN.
    NotFinite,
    /// The radius is zero, negative, or not between [`Scalar::FINEST`] and [`Scalar::REACH`].
    Radius,
    /// A coordinate is larger than [`Scalar::REACH`].
    TooFar,
}

crate::error_text!(SphereError {
    NotFinite => "a coordinate or the radius of the sphere is infinite or not a number",
    Radius => "the radius of the sphere is not positive, or out of its number type's range",
    TooFar => "the sphere is too far away for its number type",
});

macro_rules! constructors {
    ($([$($generics:tt)*] $Scalar:ty),+) => {$(
        impl<$($generics)*> Sphere<$Scalar> {
            /// A sphere around `center`.
            ///
            /// # Errors
            /// [`SphereError::NotFinite`], [`SphereError::Radius`], [`SphereError::TooFar`].
            pub const fn new(
                center: Vec3<$Scalar>,
                radius: $Scalar,
            ) -> Result<Self, SphereError> {
                if !center.has_finite_coordinates() || !Check::<$Scalar>::is_finite(radius) {
                    return Err(SphereError::NotFinite);
                }
                if !Check::<$Scalar>::is_radius(radius) {
                    return Err(SphereError::Radius);
                }
                if !center.is_within_reach() {
                    return Err(SphereError::TooFar);
                }
                Ok(Self { center, radius, curvature: Check::<$Scalar>::inverse(radius) })
            }
        }
    )+};
}

constructors!([] f32, [] f64, [F: Fraction] FixedI32<F>);

impl<S: Scalar> Shape for Sphere<S> {
    type Scalar = S;
    const SPANS: usize = 1;
    const STACK: usize = 1;
    const FACES: u16 = 1;
}

#[inline]
fn span<S: Scalar>(enter: S, exit: S) -> Option<Span<S>> {
    let face = Face(0);
    Span::new(Crossing { t: enter, face }, Crossing { t: exit, face })
}

impl<S: Intersect> Solid for Sphere<S> {
    fn spans(&self, line: &Line<S>, first: Face, stack: &mut SpanStack<'_, S>) {
        let points = S::meet_ball(self.center, self.radius, line);
        if let Some(span) = points.and_then(|[enter, exit]| span(enter, exit)) {
            stack.put(span.with_faces_from(first));
        }
    }

    fn onto(&self, _: Face, near: Vec3<S>) -> Vec3<S> {
        let outward = S::with_length((near - self.center).to_array(), self.radius);
        self.center + Vec3::from(outward)
    }

    fn normal(&self, _: Face, at: Vec3<S>) -> Vec3<S> {
        (at - self.center).map(|coordinate| coordinate.scaled(self.curvature))
    }
}

impl<S: Scalar> Leaf<Parallel<S>> for Sphere<S> {
    type View = ParallelView<S>;
    type Row = ParallelRow<S>;

    fn seen_along(&self, rays: &Parallel<S>) -> ParallelView<S> {
        ParallelView {
            ball: ParallelBall::new(self.center.fine(), self.radius.fine(), rays),
            middle: -(rays.center - self.center.fine()).dot_compensated(rays.forward),
        }
    }

    fn in_row(&self, view: &ParallelView<S>, y: i32) -> (ParallelRow<S>, Extent) {
        let row = ParallelRow {
            // The radius of the circle that the row cuts out.
            radius: S::leg(S::from_fine(view.ball.radius), S::from_fine(view.ball.row_distance(y))),
            middle: S::from_fine(view.middle),
        };
        (row, view.ball.extent(y))
    }

    #[inline]
    fn span(&self, view: &ParallelView<S>, row: &ParallelRow<S>, x: i32) -> Option<Span<S>> {
        let half = S::leg(row.radius?, S::from_fine(view.ball.along.at(x)))?;
        span(row.middle.minus(half), row.middle.plus(half))
    }
}

/// A sphere, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct ParallelView<S: Scalar> {
    ball: ParallelBall<S>,
    middle: S::Fine,
}

/// A row of a sphere, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct ParallelRow<S: Scalar> {
    radius: Option<S>,
    middle: S,
}

impl<S: Scalar> Leaf<Pencil<S>> for Sphere<S> {
    type View = PencilBall<S>;
    type Row = PencilRow<S>;

    fn seen_along(&self, rays: &Pencil<S>) -> PencilBall<S> {
        PencilBall::new(self.center.fine(), self.radius.fine(), rays)
    }

    fn in_row(&self, view: &PencilBall<S>, y: i32) -> (PencilRow<S>, Extent) {
        let row = PencilRow {
            moment: view.moment(y),
            from_center: view.position(y),
            direction: view.direction(y),
        };
        (row, view.extent(y))
    }

    #[inline]
    fn span(&self, _: &PencilBall<S>, row: &PencilRow<S>, x: i32) -> Option<Span<S>> {
        let lengths = |of: [Affine<S::Fine>; 3]| of.map(|part| S::from_fine(part.at(x)));
        let direction = row.direction.map(|part| S::unit(part.at(x)));
        let (k, q) = (lengths(row.moment), lengths(row.from_center));
        match S::chord(self.radius, k, q, direction) {
            Chord::Between(enter, exit) => span(enter, exit),
            Chord::Beside | Chord::Along => None,
        }
    }
}

/// A row of a sphere, seen from an eye: in the camera's frame.
#[derive(Debug, Clone, Copy)]
pub struct PencilRow<S: Scalar> {
    /// c × d, p − c and d.
    moment: [Affine<S::Fine>; 3],
    from_center: [Affine<S::Fine>; 3],
    direction: [Affine<S::Fine>; 3],
}

leaf!([S: Scalar] Sphere<S>);
