//! Lines in fixed point: integers throughout, and one rounding at the end.
//!
//! A line `p + t·d` is at distance r from a point, or from an axis A, at the roots of
//! `a t² + 2 b t + c = 0`. All coefficients are integers, so the sign of the discriminant is known
//! exactly. So is on which side of a root any fraction lies, which makes correctly rounded parameters
//! out of approximate ones.
//!
//! Along a coordinate axis, and for balls, 128 bits hold everything; `aligned.rs` needs them seldom. Solids are within 2²⁸ units.
//! Rays start there too and have directions up to 2³⁰. Turned into a placed solid's frame they stay
//! below 2³⁰ with |d|² ≤ 2⁶², which is checked. So a ≤ 2⁶², |b| and |c| < 2⁶³, and with parameters of
//! 32 bits and a half `a t²` is at most 2¹²⁶. An oblique axis has 28 bits more and needs 256 bits. So does a
//! cone, whose own file has the bounds.

mod aligned;
mod ball;
mod between;
mod cone;
mod cylinder;
mod lines;
mod planes;
mod quadratic;
mod torus;

pub(super) use aligned::aligned_cylinder;
pub(super) use ball::ball;
pub(super) use cone::{cone, conic};
pub(super) use cylinder::{cylinder, open_cylinder};
pub(super) use planes::{cuboid, half_spaces, planes};
pub(super) use torus::{ready_torus, torus};
