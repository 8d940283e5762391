//! Lines in floating point: error-free sums and products where something cancels.
//!
//! With u = p − base, m = d × axis and q = u × axis, a line's points at distance r from the axis
//! are the roots of `a t² + 2 b t + c = 0` with a = |m|², b = q·m and c = |q|² − r². The
//! discriminant b² − ac is computed as `r²a − k²`, k = u·m: no squares of large distances cancel.
//! With s = |b| + √D the roots are s/a and c/s, up to a sign: no roots of equal size cancel.
//! (W. Kahan, *On the cost of floating-point computation without extra-precise arithmetic*, 2004.)
//! A ball is the same quadratic with q = u, m = d and k² = |u × d|².
//!
//! The axis is never normalised away, and `|d × axis|²` is never 1 − d²: a line along the axis
//! gives m = 0 exactly.

mod aligned;
mod ball;
mod cone;
mod cylinder;
mod doubles;
mod oblique;
mod planes;
mod sums;
mod torus;
#[cfg(test)]
mod units;

pub(super) use ball::ball;
pub(super) use cone::{cone, conic};
pub(super) use cylinder::{cylinder, cylinder as aligned_cylinder, open_cylinder};
pub(super) use planes::{cuboid, half_spaces, planes};
pub(super) use torus::{ready_torus, torus};
