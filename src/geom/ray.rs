//! A line with a parameter, and the ray that a caller asks about.

use super::vec3::Vec3;
use crate::scalar::{Real, Rebased, Scalar};

/// A line `p(t) = origin + t · direction`, t from −∞ to +∞: what a solid is asked about.
///
/// The direction need not have length 1. Lines come out of [`Ray::new`] or out of a camera, which
/// both keep the numbers in a range where the solids' formulas lose nothing.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Line<S> {
    /// The point at t = 0.
    pub origin: Vec3<S>,
    /// The way from t = 0 to t = 1; not zero.
    pub direction: Vec3<S>,
}

impl<S: Scalar> Line<S> {
    /// The point at parameter `t`.
    #[must_use]
    pub fn at(&self, t: S) -> Vec3<S> {
        self.origin + self.direction * t
    }

    /// About the parameter of the point nearest to another one: for choosing where to count from.
    pub(crate) fn parameter_near(&self, point: Vec3<S>) -> S {
        S::from_wide(nearest(point.wide() - self.origin.wide(), self.direction.wide()))
    }
}

/// How many times a direction takes one to the end of a way, or as near to there as it comes.
pub(super) fn nearest<T: Real>(way: Vec3<T>, direction: Vec3<T>) -> T {
    // Of a length that neither overflows nor loses digits.
    let power = direction.max_abs().normalizing_power();
    let direction = direction * power;
    way.dot(direction) / direction.length_squared() * power
}

crate::error_text! {
    /// Why a ray can't be used.
    pub enum RayError {
        /// A coordinate is infinite or NaN.
        NotFinite => "a coordinate of the ray is infinite or not a number",
        /// The direction is zero.
        ZeroDirection => "the direction of the ray is zero",
        /// The origin is farther from the scene's than [`Scalar::MAX_COORDINATE`].
        TooFar => "the ray starts too far away for its number type",
        /// The largest coordinate of the direction is not between [`Scalar::SHORTEST`] and
        /// [`Scalar::LONGEST`]. In fixed point, parameters would not fit the number type; floating point
        /// takes every length.
        DirectionLength => "the direction of the ray is too short or too long for its number type",
    }
}

/// A ray `p(t) = origin + t · direction`, t ≥ 0, checked and made ready for any number of solids.
///
/// In floating point two things are done once for all solids: the direction is scaled by a power of
/// two to a length between 1 and 4, so that directions of length 10⁻³⁰ or 10³⁰ are ordinary; and
/// where the ray starts 256 times farther from the scene's origin than it comes near it, its
/// parameter is counted from the point nearest to there instead, so that the distance doesn't use up
/// the digits that the solids need. It is counted [`from_start`](Self::from_start) again where a solid
/// turns out to be nearer to the start than to that point. Fixed point needs none of this.
///
/// Parameters handed to the caller are always those of the ray as it was given.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ray<S> {
    line: Line<S>,
    /// Where the ray starts.
    origin: Vec3<S>,
    /// The line's parameter at the ray's start is −`offset`.
    offset: S,
    /// Of the caller's parameter for one of the line's.
    scale: S,
}

impl<S: Scalar> Ray<S> {
    /// A ray from `origin` along `direction`, which may have any length but zero; in fixed point,
    /// its largest coordinate must be 1/2 or more.
    ///
    /// # Errors
    /// [`RayError::NotFinite`] for infinite or NaN coordinates, [`RayError::ZeroDirection`],
    /// [`RayError::TooFar`], [`RayError::DirectionLength`].
    // Always inline: a ray that is written to memory in pieces, and read from there by whoever
    // traces it, costs more than making it.
    #[inline(always)]
    pub fn new(origin: Vec3<S>, direction: Vec3<S>) -> Result<Self, RayError> {
        // A sum is NaN or infinite if a coordinate is: one test for three. What fails may still be
        // a ray, if barely.
        let sum = |v: Vec3<S>| v.x.abs().plus(v.y.abs()).plus(v.z.abs());
        let (reach, size) = (sum(origin), sum(direction));
        let any_length = S::SHORTEST <= S::ZERO;
        if !(reach <= S::MAX_COORDINATE && size > S::ZERO && size.is_finite() && any_length) {
            check(Vec3 { ..origin }, Vec3 { ..direction })?;
        }
        let Rebased { origin: nearest, direction, offset, scale } =
            S::rebased(origin.to_array(), direction.to_array());
        let line = Line { origin: Vec3::from(nearest), direction: Vec3::from(direction) };
        Ok(Self { line, origin, offset, scale })
    }

    /// The line that the ray lies on, with a parameter of its own.
    #[must_use]
    #[inline]
    pub fn line(&self) -> &Line<S> {
        &self.line
    }

    /// The line's parameter at the start of the ray.
    #[must_use]
    #[inline]
    pub fn start(&self) -> S {
        self.offset.negated()
    }

    /// The ray's parameter for a parameter of its line.
    #[must_use]
    #[inline]
    pub fn parameter(&self, of_line: S) -> S {
        self.scaled(self.since_start(of_line))
    }

    /// The line's parameter, counted from the start of the ray.
    #[inline]
    pub(crate) fn since_start(&self, of_line: S) -> S {
        of_line.plus(self.offset)
    }

    /// The ray's parameter for one of its line that is counted from its start.
    #[inline]
    pub(crate) fn scaled(&self, from_start: S) -> S {
        from_start.times(self.scale)
    }

    /// The same ray, its parameter counted from its start.
    ///
    /// For solids just before a start that is far from the scene's origin: those smaller than 10⁻⁷ of that
    /// distance may be missed where the ray passes near the origin, if nothing else is near the start.
    #[must_use]
    #[inline]
    pub fn from_start(&self) -> Self {
        Self { line: Line { origin: self.origin, ..self.line }, offset: S::ZERO, ..*self }
    }

    /// Whether a point, given by the line's parameter, is nearer to the start of the ray than to where
    /// its parameter is counted from.
    #[inline]
    pub(crate) fn is_near_start(&self, of_line: S) -> bool {
        self.since_start(of_line).abs() < of_line.abs()
    }

    /// Whether its parameter is counted from elsewhere than its start.
    #[inline]
    pub(crate) fn is_moved(&self) -> bool {
        // Known without looking in fixed point, which never does that.
        S::SHORTEST <= S::ZERO && self.offset != S::ZERO
    }
}

/// What is wrong with a ray, if anything.
#[cold]
#[inline(never)]
fn check<S: Scalar>(origin: Vec3<S>, direction: Vec3<S>) -> Result<(), RayError> {
    let largest = direction.max_abs();
    match () {
        () if !(origin.is_finite() && direction.is_finite()) => Err(RayError::NotFinite),
        () if origin.max_abs() > S::MAX_COORDINATE => Err(RayError::TooFar),
        () if largest <= S::ZERO => Err(RayError::ZeroDirection),
        () if S::SHORTEST <= largest && largest <= S::LONGEST => Ok(()),
        () => Err(RayError::DirectionLength),
    }
}
