//! Constructors of the half-space, and what it is as a solid.

mod orthographic;
mod perspective;

use crate::geom::{Axis, Direction, Line, Vec3};
use crate::quadric::{HalfSpace, meet};
use crate::query::Solid;
use crate::scalar::{ConstOps, Scalar, per_scalar};
use crate::scan::leaf;
use crate::span::{Face, Shape, SpanStack};

crate::error_text! {
    /// Why a half-space can't be made.
    pub enum HalfSpaceError {
        /// A coordinate or the offset is infinite or NaN.
        NotFinite => "a coordinate or the offset of the half-space is infinite or not a number",
        /// The normal is zero.
        ZeroNormal => "the normal of the half-space is zero",
        /// The offset is larger than [`Scalar::MAX_COORDINATE`].
        TooFar => "the half-space is too far away for its number type",
    }
}

per_scalar! { $S: impl[] HalfSpace<$S> {
    /// The points with `n·p ≤ offset`, where n is `normal` brought to length 1.
    ///
    /// That is computed in `f64` or in integers of 128 bits: better in a constant.
    ///
    /// # Errors
    /// [`HalfSpaceError::NotFinite`], [`HalfSpaceError::ZeroNormal`], [`HalfSpaceError::TooFar`].
    pub const fn new(normal: Vec3<$S>, offset: $S) -> Result<Self, HalfSpaceError> {
        if !(normal.has_finite_coordinates() && ConstOps::<$S>::is_finite(offset)) {
            return Err(HalfSpaceError::NotFinite);
        }
        if !ConstOps::<$S>::is_within_reach(offset) {
            return Err(HalfSpaceError::TooFar);
        }
        match ConstOps::<$S>::normalized(normal.to_array()) {
            Some(normal) => Ok(Self { normal: Direction::<$S>::new(normal), offset }),
            None => Err(HalfSpaceError::ZeroNormal),
        }
    }
} }

/// For any number type: what a type parameter can call. In constants, use [`new`](Self::new).
impl<S: Scalar> HalfSpace<S> {
    /// The points with `n·p ≤ offset`, where n is `normal` brought to length 1.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn facing(normal: Vec3<S>, offset: S) -> Result<Self, HalfSpaceError> {
        if !(normal.is_finite() && offset.is_finite()) {
            return Err(HalfSpaceError::NotFinite);
        }
        if !offset.is_within_range() {
            return Err(HalfSpaceError::TooFar);
        }
        let normal = Direction::normalized(normal).ok_or(HalfSpaceError::ZeroNormal)?;
        Ok(Self { normal, offset })
    }

    /// The points whose coordinate along an axis is at most `offset`.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn below(axis: Axis, offset: S) -> Result<Self, HalfSpaceError> {
        Self::facing(Vec3::from(axis.placed(S::ONE, [S::ZERO; 2])), offset)
    }

    /// The points whose coordinate along an axis is at least `offset`.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn above(axis: Axis, offset: S) -> Result<Self, HalfSpaceError> {
        let down = Vec3::from(axis.placed(S::ONE.negated(), [S::ZERO; 2]));
        Self::facing(down, offset.negated())
    }
}

impl<S: Scalar> Shape for HalfSpace<S> {
    type Scalar = S;
    const SPANS: usize = 1;
    const FACES: u16 = 1;
}

impl<S: Scalar> Solid for HalfSpace<S> {
    fn spans(&self, line: &Line<S>, first: Face, stack: &mut SpanStack<'_, S>) {
        stack.put_all(meet::half_spaces(core::slice::from_ref(self), line), first);
    }

    fn onto(&self, _: Face, near: Vec3<S>) -> Vec3<S> {
        self.onto_plane(near)
    }

    fn normal(&self, _: Face, _: Vec3<S>) -> Vec3<S> {
        self.outward()
    }

    fn cosine(&self, _: Face, _: impl FnOnce() -> Vec3<S>, to: Vec3<S>) -> S {
        self.outward().dot(to)
    }
}

leaf!([S: Scalar] HalfSpace<S>);
