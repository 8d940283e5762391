//! The sphere (as a solid: the ball).

use super::intersect::Intersect;
use super::leaf::{Leaf, leaf};
use super::silhouette::PerspectiveBall;
use super::strip::Steps;
use super::{Shape, Solid};
use crate::geom::{Affine, Extent, Line, OrthographicRays, PerspectiveRays, Vec3};
use crate::scalar::{Chord, ConstOps, FixedI32, Fraction, Real, Scalar};
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
    curvature: S::Scale,
}

/// Why a sphere can't be made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SphereError {
    /// A coordinate or the radius is infinite or NaN.
    NotFinite,
    /// The radius is zero, negative, or not between [`Scalar::MIN_RADIUS`] and [`Scalar::MAX_COORDINATE`].
    Radius,
    /// A coordinate is larger than [`Scalar::MAX_COORDINATE`].
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
                if !center.has_finite_coordinates() || !ConstOps::<$Scalar>::is_finite(radius) {
                    return Err(SphereError::NotFinite);
                }
                if !ConstOps::<$Scalar>::is_radius(radius) {
                    return Err(SphereError::Radius);
                }
                if !center.is_within_reach() {
                    return Err(SphereError::TooFar);
                }
                Ok(Self { center, radius, curvature: ConstOps::<$Scalar>::inverse(radius) })
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

/// In the image plane the ball is a disc, and a row cuts a chord out of it.
impl<S: Scalar> Leaf<OrthographicRays<S>> for Sphere<S> {
    type View = Option<OrthographicView<S>>;
    type Row = Option<OrthographicRow<S>>;

    fn seen_along(&self, rays: &OrthographicRays<S>) -> Self::View {
        let from_center = rays.center - self.center.wide();
        Some(OrthographicView {
            along: from_center.dot_compensated(rays.right),
            across: from_center.dot_compensated(rays.down),
            half_pixel: rays.half_pixel,
            middle: S::from_wide(-from_center.dot_compensated(rays.forward)),
        })
    }

    fn in_row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        *row = None;
        let Some(view) = view else { return Extent::EMPTY };
        let across = S::from_wide(view.across.after_steps(view.half_pixel, y));
        let Some(radius) = S::leg(self.radius, across) else { return Extent::EMPTY };
        *row = Some(OrthographicRow { radius });
        let along = Affine { middle: view.along, step: view.half_pixel };
        Steps::within::<S>(along, radius.wide()).columns(columns)
    }

    #[inline]
    fn span(&self, view: &Self::View, row: &Self::Row, x: i32) -> Option<Span<S>> {
        let (Some(view), Some(row)) = (view, row) else { return None };
        let half = S::leg(row.radius, S::from_wide(view.along.after_steps(view.half_pixel, x)))?;
        span(view.middle.minus(half), view.middle.plus(half))
    }
}

/// A sphere, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct OrthographicView<S: Scalar> {
    /// The middle of the picture, seen from the sphere's centre, to the right and down.
    along: S::Wide,
    across: S::Wide,
    /// The size of half a pixel.
    half_pixel: S::Wide,
    /// The parameter in the middle of chords.
    middle: S,
}

/// A row of a sphere, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct OrthographicRow<S: Scalar> {
    /// Of the circle that the row cuts out.
    radius: S,
}

impl<S: Scalar> Leaf<PerspectiveRays<S>> for Sphere<S> {
    type View = Option<PerspectiveView<S>>;
    type Row = Option<PerspectiveRow<S>>;

    fn seen_along(&self, rays: &PerspectiveRays<S>) -> Self::View {
        let ball = PerspectiveBall::new(self.center.wide(), self.radius.wide(), rays);
        Some(PerspectiveView { ball })
    }

    #[inline]
    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        view.as_ref().is_some_and(|view| view.ball.is_in_rows(rows))
    }

    fn in_row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        *row = None;
        let Some(view) = view else { return Extent::EMPTY };
        *row = Some(PerspectiveRow {
            moment: view.ball.moment(y),
            from_center: view.ball.position(y),
            direction: view.ball.direction(y),
        });
        view.ball.extent(y, columns)
    }

    #[inline]
    fn span(&self, _: &Self::View, row: &Self::Row, x: i32) -> Option<Span<S>> {
        let Some(row) = row else { return None };
        let direction = row.direction.map(|part| S::unit(part.at(x)));
        let (k, q) = (
            row.moment.map(|part| part.at(x)),
            row.from_center.map(|part| S::from_wide(part.at(x))),
        );
        match S::chord(self.radius, k, q, direction) {
            Chord::Between(enter, exit) => span(enter, exit),
            Chord::Beside | Chord::Along => None,
        }
    }
}

/// A sphere, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PerspectiveView<S: Scalar> {
    ball: PerspectiveBall<S>,
}

/// A row of a sphere, seen from an eye: in the camera's frame.
#[derive(Debug, Clone, Copy)]
pub struct PerspectiveRow<S: Scalar> {
    /// c × d, p − c and d.
    moment: [Affine<S::Wide>; 3],
    from_center: [Affine<S::Wide>; 3],
    direction: [Affine<S::Wide>; 3],
}

leaf!([S: Scalar] Sphere<S>);
