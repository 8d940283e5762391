//! The sphere (as a solid: the ball).

use super::row::{ConvexRow, Leaf, Project, View};
use super::silhouette::{ParallelBall, PencilBall};
use super::{Shape, Solid};
use crate::geom::{Line, Parallel, Pencil, Vec3};
use crate::scalar::Scalar;
use crate::span::{Crossing, Face, Span, SpanStack};

/// A solid sphere.
///
/// One face.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Sphere<S> {
    center: Vec3<S>,
    radius: S,
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
    ($($Float:ident),+) => {$(
        impl Sphere<$Float> {
            /// A sphere around `center`.
            ///
            /// # Errors
            /// [`SphereError::NotFinite`], [`SphereError::Radius`], [`SphereError::TooFar`].
            pub const fn new(center: Vec3<$Float>, radius: $Float) -> Result<Self, SphereError> {
                if !center.has_finite_coordinates() {
                    return Err(SphereError::NotFinite);
                }
                if !radius.is_finite() {
                    return Err(SphereError::NotFinite);
                }
                if !(<$Float>::FINEST <= radius && radius <= <$Float>::REACH) {
                    return Err(SphereError::Radius);
                }
                if !center.is_within_reach() {
                    return Err(SphereError::TooFar);
                }
                Ok(Self { center, radius })
            }
        }
    )+};
}

constructors!(f32, f64);

impl<S: Scalar> Shape for Sphere<S> {
    type Scalar = S;
    const SPANS: usize = 1;
    const STACK: usize = 1;
    const FACES: u16 = 1;
}

/// The span around `middle`, with a half-length whose square times `scale`² is given.
#[inline]
fn around<S: Scalar>(middle: S, discriminant: S, scale: S) -> Option<Span<S>> {
    let half = discriminant.positive()?.sqrt() * scale;
    let face = Face(0);
    Span::new(Crossing { t: middle - half, face }, Crossing { t: middle + half, face })
}

impl<S: Scalar> Solid for Sphere<S> {
    fn spans(&self, line: &Line<S>, first: Face, stack: &mut SpanStack<'_, S>) {
        // |u + t·d|² = r²  with the discriminant r²|d|² − |u × d|²: no large squares cancel.
        let u = line.origin - self.center;
        let inverse = S::ONE / line.direction.length_squared();
        let middle = -(u.dot_compensated(line.direction)) * inverse;
        let moment = u.cross(line.direction).length_squared();
        let discriminant = self.radius * self.radius * line.direction.length_squared() - moment;
        if let Some(span) = around(middle, discriminant, inverse) {
            stack.put(span.with_faces_from(first));
        }
    }

    fn onto(&self, _: Face, near: Vec3<S>) -> Vec3<S> {
        let u = near - self.center;
        self.center + u * (self.radius / u.length_squared().sqrt())
    }

    fn normal(&self, _: Face, at: Vec3<S>) -> Vec3<S> {
        (at - self.center) * (S::ONE / self.radius)
    }
}

impl<S: Scalar> Project<Parallel<S>> for Sphere<S> {
    type View<'a> = ParallelView<S>;

    fn view(&self, rays: &Parallel<S>) -> ParallelView<S> {
        ParallelView {
            ball: ParallelBall::new(self.center, self.radius, rays),
            middle: -(rays.center - self.center).dot_compensated(rays.forward),
        }
    }
}

/// A sphere, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct ParallelView<S> {
    ball: ParallelBall<S>,
    middle: S,
}

impl<S: Scalar> View for ParallelView<S> {
    type Scalar = S;
    type Row<'a> = Leaf<ParallelRow<S>>;

    fn row(&self, y: S) -> Self::Row<'_> {
        let across = self.ball.row_distance(y);
        Leaf {
            row: ParallelRow {
                half_chord_squared: S::product_difference(
                    self.ball.radius,
                    self.ball.radius,
                    across,
                    across,
                ),
                along: self.ball.along,
                pitch: self.ball.pitch[0],
                middle: self.middle,
            },
            extent: self.ball.extent(y),
        }
    }
}

/// A row of a sphere, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct ParallelRow<S> {
    half_chord_squared: S,
    along: S,
    pitch: S,
    middle: S,
}

impl<S: Scalar> ConvexRow for ParallelRow<S> {
    type Scalar = S;
    const FACES: u16 = 1;

    #[inline]
    fn span(&self, x: S) -> Option<Span<S>> {
        let along = self.along + self.pitch * x;
        around(self.middle, self.half_chord_squared - along * along, S::ONE)
    }
}

impl<S: Scalar> Project<Pencil<S>> for Sphere<S> {
    type View<'a> = PencilView<S>;

    fn view(&self, rays: &Pencil<S>) -> PencilView<S> {
        let from_center = rays.plane.center - self.center;
        PencilView {
            ball: PencilBall::new(self.center, self.radius, rays),
            approach: [rays.plane.forward, rays.plane.right, rays.plane.down]
                .map(|step| from_center.dot_compensated(step)),
            pitch_squared: [rays.plane.right, rays.plane.down].map(Vec3::length_squared),
            convergence: rays.convergence,
        }
    }
}

/// A sphere, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PencilView<S> {
    ball: PencilBall<S>,
    /// (p − c)·d without the part that is quadratic in the pixel: in the middle, and the steps.
    approach: [S; 3],
    pitch_squared: [S; 2],
    convergence: S,
}

impl<S: Scalar> View for PencilView<S> {
    type Scalar = S;
    type Row<'a> = Leaf<PencilRow<S>>;

    fn row(&self, y: S) -> Self::Row<'_> {
        // (p − c)·d = a·w + q (X a·U + Y a·V + X²|U|² + Y²|V|²) with a = centre − c, because U
        // and V are at right angles to w.
        let [forward, right, down] = self.approach;
        let [moment, direction] = self.ball.row(y);
        let of_row = y * (down + y * self.pitch_squared[1]);
        Leaf {
            row: PencilRow {
                moment,
                direction,
                approach: [
                    forward + self.convergence * of_row,
                    self.convergence * right,
                    self.convergence * self.pitch_squared[0],
                ],
                radius_squared: self.ball.radius * self.ball.radius,
            },
            extent: self.ball.extent(y),
        }
    }
}

/// A row of a sphere, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PencilRow<S> {
    moment: [Vec3<S>; 2],
    direction: [Vec3<S>; 2],
    approach: [S; 3],
    radius_squared: S,
}

impl<S: Scalar> ConvexRow for PencilRow<S> {
    type Scalar = S;
    const FACES: u16 = 1;

    #[inline]
    fn span(&self, x: S) -> Option<Span<S>> {
        let [middle, step] = self.direction;
        let length_squared = (middle + step * x).length_squared();
        let [middle, step] = self.moment;
        let moment_squared = (middle + step * x).length_squared();
        let inverse = S::ONE / length_squared;
        let approach = self.approach[0] + x * (self.approach[1] + x * self.approach[2]);
        let discriminant = self.radius_squared * length_squared - moment_squared;
        around(-approach * inverse, discriminant, inverse)
    }
}
