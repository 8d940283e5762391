//! The pipe: a tube swept along a curve, as cylinders and pieces of balls.

mod lay;

use super::combine::{Intersection, Many, Union};
use super::wrap::Wrap;
use crate::primitive::{Cylinder, Slab, Sphere};
use crate::scalar::Scalar;

/// What fills the gap on the outside of a bend: the part of a ball beyond the end of one cylinder
/// and before the beginning of the next.
type Joint<S> = Intersection<Intersection<Sphere<S>, Slab<S>>, Slab<S>>;

/// What all the parts of a pipe are together.
type Parts<S, const SEGMENTS: usize> = Union<Many<Cylinder<S>, SEGMENTS>, Many<Joint<S>, SEGMENTS>>;

/// A tube swept along a B-spline or a polyline, with flat ends and room for `SEGMENTS` segments.
///
/// Each segment of the polyline is the axis of a cylinder. Where two segments meet, a ball of the
/// same radius closes the gap on the outside of the bend; what of it would stand out of the
/// cylinders' caps is cut off, so that the ends are flat also where segments are shorter than the
/// radius. Cylinders and balls have these planes in common, described by the same numbers. A
/// polyline that ends where it began has a ball there, too, and no ends.
///
/// Room that isn't used costs memory and no time. A [`SpanList`](crate::span::SpanList) needs room for
/// 4·`SEGMENTS` spans.
///
/// A hollow pipe is the difference of two along the same curve; their ends are flush.
///
/// ```
/// use scancsg::{constant, geom::{Vec3, vec3}, solid::Pipe, spline::{Curve, Knots}};
///
/// const KNOTS: Knots<f32, 4, 10> = constant!(Knots::<f32, 4, 10>::clamped_uniform(6, 0.0, 1.0));
/// const PATH: Curve<Vec3<f32>, 4, 6, 10> = constant!(Curve::<Vec3<f32>, 4, 6, 10>::new(KNOTS, [
///     vec3(-2.0, 0.0, 0.0), vec3(0.0, 0.0, 0.0), vec3(2.0, 0.0, 0.0),
///     vec3(2.0, 2.0, 0.0), vec3(0.0, 2.0, 0.0), vec3(0.0, 2.0, 2.0),
/// ]));
///
/// let outside = Pipe::<f32, 16>::along(&PATH, 0.4, 0.02)?;
/// let bore = Pipe::<f32, 16>::along(&PATH, 0.3, 0.02)?;
/// assert_eq!(outside.segments(), 13);
/// let hollow = outside - bore;
/// # let _ = hollow;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # How near it is to the tube
///
/// The polyline is nowhere farther from the curve than the tolerance τ, and the curve nowhere
/// farther from it ([`Curve::flatten`](crate::spline::Curve::flatten)). So the distances of any point
/// from both differ by up to τ, and but for rounding every point of the pipe's wall is from r − τ to
/// r + τ away from the curve: the wall is within τ of that of the tube around the curve itself. The
/// ends lie in the planes through the curve's ends across the first and last segment, whose
/// directions differ from the curve's own there by an angle of about 4τ/c for a segment of length c.
/// The end isn't flat if c is less than r·sin θ, θ being the angle of the bend next to it. There the
/// other cylinder of that bend stands out on the bend's inside, by up to r·sin θ − c, and shows its cap.
///
/// To see no more than a fraction f of a pixel of the difference, τ is f times the size of a pixel:
/// twice the [`half_pixel`](crate::geom::OrthographicRays::half_pixel) of the camera's rays, or frame height over
/// picture height; times the distance of the pipe's nearest point over that of the target for a
/// camera with perspective.
///
/// # Faces
///
/// The cylinder of the i-th segment has the faces 3i (its beginning), 3i + 1 (its end) and 3i + 2
/// (the wall). Those of the joints come behind 3·`SEGMENTS`, five to a segment, and only the first of
/// five can be seen.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Pipe<S: Scalar, const SEGMENTS: usize> {
    parts: Parts<S, SEGMENTS>,
    segments: usize,
}

crate::error_text! {
    /// Why a pipe can't be made.
    pub enum PipeError {
        /// A coordinate or the radius is infinite or NaN.
        NotFinite => "a coordinate or the radius of the pipe is infinite or not a number",
        /// The radius is zero, negative, or not between [`Scalar::MIN_RADIUS`] and [`Scalar::MAX_COORDINATE`].
        Radius => "the radius of the pipe is not positive, or out of its number type's range",
        /// A point is larger than [`Scalar::MAX_COORDINATE`], or is so within two radii, or the radius is
        /// lost in the rounding of the points.
        TooFar => "the pipe is too far away for its number type",
        /// The pipe has no length: there are not two different points.
        Empty => "the pipe has no length: there are not two different points",
        /// The tolerance is not positive and finite.
        Tolerance => "the tolerance is not a positive number",
        /// There are more segments than the type has room for.
        Capacity => "the pipe needs more segments than there is room for",
    }
}

impl<S: Scalar, const SEGMENTS: usize> Pipe<S, SEGMENTS> {
    /// How many segments are used.
    #[must_use]
    pub const fn segments(&self) -> usize {
        self.segments
    }
}

impl<S: Scalar, const SEGMENTS: usize> Wrap for Pipe<S, SEGMENTS> {
    type Inner = Parts<S, SEGMENTS>;

    #[inline]
    fn inner(&self) -> &Parts<S, SEGMENTS> {
        &self.parts
    }
}
