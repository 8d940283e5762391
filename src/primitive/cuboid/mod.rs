//! The box along the coordinate axes.

mod orthographic;
mod perspective;

use crate::geom::{Axis, Line, Vec3};
use crate::quadric::{Corners, meet};
use crate::query::Solid;
use crate::scalar::{ConstOps, Scalar, per_scalar};
use crate::scan::bounds::Bounds;
use crate::scan::leaf;
use crate::span::{Face, Shape, SpanStack};
use core::ops::Range;

/// A box along the coordinate axes: the points between two corners. Turn it with a
/// [`Placed`](crate::solid::Placed).
///
/// ```
/// use scancsg::constant;
/// use scancsg::geom::vec3;
/// use scancsg::solid::Cuboid;
///
/// const PLATE: Cuboid<f32> =
///     constant!(Cuboid::<f32>::new(vec3(-2.0, -1.0, 0.0), vec3(2.0, 1.0, 0.25)));
/// # let _ = PLATE;
/// ```
///
/// A box without a thickness does not compile:
///
/// ```compile_fail,E0080
/// use scancsg::constant;
/// use scancsg::geom::vec3;
/// use scancsg::solid::Cuboid;
///
/// const PLATE: Cuboid<f32> =
///     constant!(Cuboid::<f32>::new(vec3(-2.0, -1.0, 0.0), vec3(2.0, 1.0, 0.0)));
/// # let _ = PLATE;
/// ```
///
/// Faces 0 and 1 are those at the lowest and the highest x, 2 and 3 those of y, 4 and 5 those of z. They
/// lie exactly at the given coordinates: a face that is flush with a slab's plane or a cylinder's cap
/// crosses every line at the same bits.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cuboid<S: Scalar> {
    corners: Corners<S>,
}

crate::error_text! {
    /// Why a box can't be made.
    pub enum CuboidError {
        /// A coordinate is infinite or NaN.
        NotFinite => "a coordinate of the box is infinite or not a number",
        /// A size is zero or negative: two corners have a coordinate in common, or are the wrong way round.
        Empty => "the box has no volume: a size is zero or negative",
        /// A coordinate is larger than [`Scalar::MAX_COORDINATE`].
        TooFar => "the box is too far away for its number type",
        /// Of a rounded box: the radius isn't positive, or twice of it isn't below the smallest size.
        Radius => "the radius of the rounded box is not positive, or half of its smallest size or more",
    }
}

per_scalar! { $S: impl[] Cuboid<$S> {
    /// A box from its lowest corner to its highest.
    ///
    /// # Errors
    /// [`CuboidError::NotFinite`], [`CuboidError::TooFar`], or [`CuboidError::Empty`] where a
    /// coordinate of `low` isn't below that of `high`.
    pub const fn new(low: Vec3<$S>, high: Vec3<$S>) -> Result<Self, CuboidError> {
        let has_volume = ConstOps::<$S>::is_below(low.x, high.x)
            && ConstOps::<$S>::is_below(low.y, high.y)
            && ConstOps::<$S>::is_below(low.z, high.z);
        let is_finite = low.has_finite_coordinates() && high.has_finite_coordinates();
        match () {
            () if !is_finite => Err(CuboidError::NotFinite),
            () if !has_volume => Err(CuboidError::Empty),
            () if !(low.is_within_reach() && high.is_within_reach()) => Err(CuboidError::TooFar),
            () => Ok(Self { corners: Corners { low, high } }),
        }
    }

    /// A box that spans a range of each coordinate.
    ///
    /// ```
    /// use scancsg::geom::vec3;
    /// use scancsg::solid::Cuboid;
    ///
    /// let plate = Cuboid::<f32>::spanning(0.0..4.0, 0.0..3.0, -0.1..0.1);
    /// assert_eq!(plate, Cuboid::<f32>::new(vec3(0.0, 0.0, -0.1), vec3(4.0, 3.0, 0.1)));
    /// ```
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub const fn spanning(x: Range<$S>, y: Range<$S>, z: Range<$S>) -> Result<Self, CuboidError> {
        Self::new(Vec3::new(x.start, y.start, z.start), Vec3::new(x.end, y.end, z.end))
    }
} }

/// For any number type: what a type parameter can call. In constants, use [`new`](Self::new).
impl<S: Scalar> Cuboid<S> {
    /// A box from its lowest corner to its highest.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn between(low: Vec3<S>, high: Vec3<S>) -> Result<Self, CuboidError> {
        let has_volume = Axis::ALL.into_iter().all(|axis| axis.of(low) < axis.of(high));
        match () {
            () if !(low.is_finite() && high.is_finite()) => Err(CuboidError::NotFinite),
            () if !has_volume => Err(CuboidError::Empty),
            () if !(low.is_within_range() && high.is_within_range()) => Err(CuboidError::TooFar),
            () => Ok(Self { corners: Corners { low, high } }),
        }
    }

    /// A box with its lowest corner at (0, 0, 0).
    ///
    /// ```
    /// use scancsg::geom::vec3;
    /// use scancsg::solid::Cuboid;
    ///
    /// let plate = Cuboid::<f32>::of_size(vec3(4.0, 3.0, 0.2))?;
    /// assert_eq!(plate, Cuboid::around(vec3(2.0, 1.5, 0.1), vec3(2.0, 1.5, 0.1))?);
    /// # Ok::<(), scancsg::solid::CuboidError>(())
    /// ```
    ///
    /// # Errors
    /// As [`new`](Self::new), with [`CuboidError::Empty`] where a size isn't above zero.
    pub fn of_size(size: Vec3<S>) -> Result<Self, CuboidError> {
        Self::between(Vec3::ZERO, size)
    }

    /// A box around a point, with half of its size in each direction.
    ///
    /// # Errors
    /// As [`of_size`](Self::of_size).
    pub fn around(center: Vec3<S>, half_size: Vec3<S>) -> Result<Self, CuboidError> {
        Self::between(center - half_size, center + half_size)
    }

    /// The corner with the smallest coordinates, and the one with the largest.
    #[must_use]
    pub fn corners(&self) -> [Vec3<S>; 2] {
        [self.corners.low, self.corners.high]
    }
}

impl<S: Scalar> Shape for Cuboid<S> {
    type Scalar = S;
    const SPANS: usize = 1;
    const FACES: u16 = 6;
}

impl<S: Scalar> Solid for Cuboid<S> {
    fn spans(&self, line: &Line<S>, first: Face, stack: &mut SpanStack<'_, S>) {
        stack.put_all(meet::cuboid(&self.corners, line), first);
    }

    fn bounds(&self) -> Bounds<S> {
        let Corners { low, high } = self.corners;
        Bounds::Box { low, high }
    }

    fn onto(&self, face: Face, near: Vec3<S>) -> Vec3<S> {
        let (axis, side) = Corners::<S>::across(face);
        let inside = |axis: Axis| {
            let Corners { low, high } = self.corners;
            axis.of(near).max(axis.of(low)).min(axis.of(high))
        };
        let held = Vec3::new(inside(Axis::X), inside(Axis::Y), inside(Axis::Z));
        self.corners.planes(axis).onto_face(side, held)
    }

    fn normal(&self, face: Face, _: Vec3<S>) -> Vec3<S> {
        let (axis, side) = Corners::<S>::across(face);
        self.corners.planes(axis).face_normal(side)
    }

    #[inline]
    fn cosine(&self, face: Face, _: impl FnOnce() -> Vec3<S>, to: Vec3<S>) -> S {
        let (axis, side) = Corners::<S>::across(face);
        let along = axis.of(to);
        if side.0 == 0 { along.negated() } else { along }
    }
}

leaf!([S: Scalar] Cuboid<S>);
