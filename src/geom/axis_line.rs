//! Lines that several solids have as their axis.

use super::direction::Direction;
use super::vec3::Vec3;
use crate::scalar::{ConstOps, Scalar, Stretch, per_scalar};

/// A line from one point to another that several solids are made along: their common axis, rounded once.
///
/// Solids that are made between points each have a rounded axis of their own, so caps that should be flush
/// may lie a rounding error apart, and a film shows. Solids on one `AxisLine` take their caps as positions
/// along it. The same position is the same plane, bit for bit.
///
/// Positions are lengths from the first point, in the units of the scene. They may lie before the first
/// point (below zero) or behind the last one (above [`length`](Self::length)).
///
/// A cup whose hollow is flush with its rim:
///
/// ```
/// use scancsg::geom::{AxisLine, vec3};
/// use scancsg::solid::Cylinder;
///
/// let axis = AxisLine::<f32>::between(vec3(0.1, 0.2, 0.3), vec3(1.0, -2.0, 1.5))?;
/// let body = Cylinder::<f32>::on(&axis, 1.0, 0.0, axis.length())?;
/// let hollow = Cylinder::<f32>::on(&axis, 0.8, 0.25, axis.length())?;
/// let cup = body - hollow;
/// # let _ = cup;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AxisLine<S: Scalar> {
    first: Vec3<S>,
    direction: Direction<S>,
    /// The scalar products of the direction with both points.
    ends: [S; 2],
    length: S,
}

crate::error_text! {
    /// Why two points make no axis.
    pub enum AxisLineError {
        /// A coordinate is infinite or NaN.
        NotFinite => "a coordinate of the axis is infinite or not a number",
        /// A coordinate is larger than [`Scalar::MAX_COORDINATE`].
        TooFar => "a point of the axis is too far away for its number type",
        /// The points coincide.
        Empty => "the points of the axis coincide",
    }
}

per_scalar! { $S: impl[] AxisLine<$S> {
    /// The line from one point to another.
    ///
    /// # Errors
    /// [`AxisLineError`].
    pub const fn between(first: Vec3<$S>, last: Vec3<$S>) -> Result<Self, AxisLineError> {
        if !(first.has_finite_coordinates() && last.has_finite_coordinates()) {
            return Err(AxisLineError::NotFinite);
        }
        if !(first.is_within_reach() && last.is_within_reach()) {
            return Err(AxisLineError::TooFar);
        }
        match ConstOps::<$S>::stretch(first.to_array(), last.to_array()) {
            Some(Stretch { direction, low, high }) => Ok(Self {
                first,
                direction: Direction::<$S>::new(direction),
                ends: [low, high],
                length: ConstOps::<$S>::difference(high, low),
            }),
            None => Err(AxisLineError::Empty),
        }
    }

    /// As [`offset`](Self::offset), for constants.
    pub(crate) const fn plane_at(&self, position: $S) -> $S {
        type Ops<S> = ConstOps<S>;
        let [low, high] = self.ends;
        let is_other = Ops::<$S>::is_below(position, self.length)
            || Ops::<$S>::is_below(self.length, position)
            || !Ops::<$S>::is_finite(position);
        if is_other { Ops::<$S>::sum(low, position) } else { high }
    }
} }

impl<S: Scalar> AxisLine<S> {
    /// The line from one point to another, for any number type: what a type parameter can call. In
    /// constants, use [`between`](Self::between).
    ///
    /// # Errors
    /// [`AxisLineError`].
    pub fn from_to(first: Vec3<S>, last: Vec3<S>) -> Result<Self, AxisLineError> {
        if !(first.is_finite() && last.is_finite()) {
            return Err(AxisLineError::NotFinite);
        }
        if !(first.is_within_range() && last.is_within_range()) {
            return Err(AxisLineError::TooFar);
        }
        let (direction, ends) = Direction::between(first, last).ok_or(AxisLineError::Empty)?;
        let [low, high] = ends;
        Ok(Self { first, direction, ends, length: high.minus(low) })
    }

    /// The position of the last point; that of the first is zero.
    #[must_use]
    pub const fn length(&self) -> S {
        self.length
    }

    /// A point of the line.
    pub(crate) const fn first(&self) -> Vec3<S> {
        self.first
    }

    /// The direction from the first point to the last one.
    pub(crate) const fn direction(&self) -> Direction<S> {
        self.direction
    }

    /// The plane across the line at a position, as the scalar product of its points with the direction.
    /// That of the last point is the one that solids between the two points have.
    pub(crate) fn offset(&self, position: S) -> S {
        let [low, high] = self.ends;
        if position == self.length { high } else { low.plus(position) }
    }
}
