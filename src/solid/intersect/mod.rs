//! Where lines meet walls, balls and planes: the one thing that number types do in ways of their
//! own.
//!
//! Floating point computes in twice the working precision what would cancel; see `compensated`.
//! Fixed point computes everything exactly, in whole numbers of 128 bits or 256, and rounds the
//! parameters once; see `exact`.

mod compensated;
mod exact;
mod quadratic;

use super::cylinder::{Cylinder, Tube};
use super::slab::Slab;
use crate::geom::{Direction, Line, Vec3};
use crate::scalar::Scalar;
use crate::span::Span;

/// A number type that lines can be intersected in: every [`Scalar`].
pub trait Intersect: Scalar {
    /// Where a line meets the wall of a tube with this axis.
    #[doc(hidden)]
    fn meet_tube(tube: &Tube<Self>, axis: &Direction<Self>, line: &Line<Self>) -> Meeting<Self>;

    /// Where a line enters a ball, and where it exits; `None` also for a tangent.
    #[doc(hidden)]
    fn meet_ball(center: Vec3<Self>, radius: Self, line: &Line<Self>) -> Option<[Self; 2]>;

    /// Where a line passes the planes of a slab.
    #[doc(hidden)]
    fn pass(slab: &Slab<Self>, line: &Line<Self>) -> Passage<Self>;

    /// Whether a line is between the planes of a slab, or on one, at a parameter.
    #[doc(hidden)]
    fn is_between(slab: &Slab<Self>, line: &Line<Self>, t: Self) -> bool;

    /// The part of a line inside a cylinder.
    #[doc(hidden)]
    fn cut(cylinder: &Cylinder<Self>, line: &Line<Self>) -> Option<Span<Self>>;
}

/// Where a line meets the wall of a tube.
#[doc(hidden)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Meeting<S> {
    /// Nowhere: the line passes it by.
    Beside,
    /// At two parameters in ascending order, which are the same for a tangent.
    Points(S, S),
    /// Nowhere: the line is parallel to the axis, inside the wall.
    Within,
    /// The line is parallel to the axis, outside the wall or on it.
    Along,
}

/// Where a line passes two planes.
#[doc(hidden)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Passage<S> {
    /// Nowhere: the line is parallel to them, and inside or not.
    Along {
        /// Whether it is between them.
        inside: bool,
    },
    /// At these parameters of the low and the high plane.
    Across {
        /// Of the low plane and of the high one.
        at: [S; 2],
        /// Whether the low plane comes first.
        upwards: bool,
    },
}
