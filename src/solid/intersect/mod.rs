//! Where lines meet walls, balls and planes: the one thing that number types do in ways of their
//! own.
//!
//! Floating point computes in twice the working precision what would cancel; see `compensated`, and
//! `aligned` and `oblique` beside it.
//! Fixed point computes everything exactly, in whole numbers of 128 bits or 256, and rounds the
//! parameters once; see `exact`.

mod aligned;
mod compensated;
mod ends;
mod exact;
mod oblique;
mod quadratic;

use super::cylinder::Cylinder;
use super::slab::Slab;
use crate::geom::{Line, Vec3};
use crate::scalar::Scalar;
use crate::span::Span;

/// A number type that lines can be intersected in: every [`Scalar`].
pub trait Intersect: Scalar {
    /// The part of a line inside a cylinder.
    #[doc(hidden)]
    fn cut(cylinder: &Cylinder<Self>, line: &Line<Self>) -> Option<Span<Self>>;

    /// Where a line enters a cylinder's wall, and where it exits, as far as these points are
    /// between the caps or on a rim. A tangent has both, at the same parameter.
    #[doc(hidden)]
    fn meet_wall(cylinder: &Cylinder<Self>, line: &Line<Self>) -> [Option<Self>; 2];

    /// Where a line enters a ball, and where it exits; `None` also for a tangent.
    #[doc(hidden)]
    fn meet_ball(center: Vec3<Self>, radius: Self, line: &Line<Self>) -> Option<[Self; 2]>;

    /// Where a line passes the planes of a slab.
    #[doc(hidden)]
    fn pass(slab: &Slab<Self>, line: &Line<Self>) -> Passage<Self>;
}

/// How many units in the last place of the true number, or of `least` if that is larger, another one
/// is off.
#[cfg(test)]
fn units_off(got: f32, want: f64, least: f32) -> f64 {
    let size = (want as f32).abs().max(least);
    (f64::from(got) - want).abs() / (f64::from(size.next_up()) - f64::from(size))
}

/// Where a line meets the wall of a tube.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Meeting<S> {
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
