//! The slab: what lies between two parallel planes. Three slabs make a box.

mod orthographic;
mod perspective;

use crate::geom::{Axis, Direction, Line, Vec3};
use crate::quadric::{Planes, meet};
use crate::query::Solid;
use crate::scalar::{ConstOps, Scalar, per_scalar};
use crate::scan::leaf;
use crate::span::{Face, Shape, SpanStack};

/// The points p with `low ≤ normal · p ≤ high`.
///
/// The offsets are stored as they were given, so two slabs with a plane in common cross every
/// line at the same bits there.
///
/// Face 0 is the plane at `low`, face 1 the one at `high`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Slab<S: Scalar> {
    planes: Planes<S>,
}

crate::error_text! {
    /// Why a slab can't be made.
    pub enum SlabError {
        /// A coordinate or an offset is infinite or NaN.
        NotFinite => "a coordinate or an offset of the slab is infinite or not a number",
        /// The normal is zero.
        ZeroNormal => "the normal of the slab is zero",
        /// The low offset is not below the high one.
        Empty => "the low offset of the slab is not below the high one",
        /// An offset is larger than [`Scalar::MAX_COORDINATE`].
        TooFar => "the slab is too far away for its number type",
    }
}

per_scalar! { $S: impl[] Slab<$S> {
    /// The points with `low ≤ x ≤ high`.
    ///
    /// # Errors
    /// [`SlabError::NotFinite`], [`SlabError::Empty`], [`SlabError::TooFar`].
    pub const fn along_x(low: $S, high: $S) -> Result<Self, SlabError> {
        Self::with_normal(Direction::<$S>::X, low, high)
    }

    /// The points with `low ≤ y ≤ high`.
    ///
    /// # Errors
    /// As [`along_x`](Self::along_x).
    pub const fn along_y(low: $S, high: $S) -> Result<Self, SlabError> {
        Self::with_normal(Direction::<$S>::Y, low, high)
    }

    /// The points with `low ≤ z ≤ high`.
    ///
    /// # Errors
    /// As [`along_x`](Self::along_x).
    pub const fn along_z(low: $S, high: $S) -> Result<Self, SlabError> {
        Self::with_normal(Direction::<$S>::Z, low, high)
    }

    /// The points with `low ≤ n·p ≤ high`, where n is `normal` brought to length 1.
    ///
    /// That is computed in `f64` or in integers of 128 bits: better in a constant.
    ///
    /// # Errors
    /// As [`along_x`](Self::along_x), and [`SlabError::ZeroNormal`].
    pub const fn new(normal: Vec3<$S>, low: $S, high: $S) -> Result<Self, SlabError> {
        if !normal.has_finite_coordinates() {
            return Err(SlabError::NotFinite);
        }
        match ConstOps::<$S>::normalized(normal.to_array()) {
            Some(normal) => Self::with_normal(Direction::<$S>::new(normal), low, high),
            None => Err(SlabError::ZeroNormal),
        }
    }

    /// The slab of a normal.
    pub(crate) const fn with_normal(
        normal: Direction<$S>,
        low: $S,
        high: $S,
    ) -> Result<Self, SlabError> {
        type Ops<S> = ConstOps<S>;
        let is_near = Ops::<$S>::is_within_reach(low) && Ops::<$S>::is_within_reach(high);
        match () {
            () if !(Ops::<$S>::is_finite(low) && Ops::<$S>::is_finite(high)) => Err(SlabError::NotFinite),
            () if !Ops::<$S>::is_below(low, high) => Err(SlabError::Empty),
            () if !is_near => Err(SlabError::TooFar),
            () => Ok(Self { planes: Planes { normal, low, high } }),
        }
    }
} }

/// For any number type: what a type parameter can call. In constants, use the constructors above.
impl<S: Scalar> Slab<S> {
    /// The points whose coordinate along an axis is from `low` to `high`.
    ///
    /// # Errors
    /// As [`along_x`](Self::along_x).
    pub fn across(axis: Axis, low: S, high: S) -> Result<Self, SlabError> {
        Self::checked(Direction::along_axis(axis), low, high)
    }

    /// The points with `low ≤ n·p ≤ high`, where n is `normal` brought to length 1.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn facing(normal: Vec3<S>, low: S, high: S) -> Result<Self, SlabError> {
        if !normal.is_finite() {
            return Err(SlabError::NotFinite);
        }
        Self::checked(Direction::normalized(normal).ok_or(SlabError::ZeroNormal)?, low, high)
    }

    fn checked(normal: Direction<S>, low: S, high: S) -> Result<Self, SlabError> {
        match () {
            () if !(low.is_finite() && high.is_finite()) => Err(SlabError::NotFinite),
            () if low >= high => Err(SlabError::Empty),
            () if !(low.is_within_range() && high.is_within_range()) => Err(SlabError::TooFar),
            () => Ok(Self { planes: Planes { normal, low, high } }),
        }
    }
}

impl<S: Scalar> Shape for Slab<S> {
    type Scalar = S;
    const SPANS: usize = 1;
    const FACES: u16 = 2;
}

impl<S: Scalar> Solid for Slab<S> {
    fn spans(&self, line: &Line<S>, first: Face, stack: &mut SpanStack<'_, S>) {
        stack.put_all(meet::planes(&self.planes, line).span(), first);
    }

    fn onto(&self, face: Face, near: Vec3<S>) -> Vec3<S> {
        self.planes.onto_face(face, near)
    }

    fn normal(&self, face: Face, _: Vec3<S>) -> Vec3<S> {
        self.planes.face_normal(face)
    }

    fn cosine(&self, face: Face, _: impl FnOnce() -> Vec3<S>, to: Vec3<S>) -> S {
        self.planes.face_cosine(face, to)
    }
}

leaf!([S: Scalar] Slab<S>);
