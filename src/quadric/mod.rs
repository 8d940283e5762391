//! Where lines meet cylinder walls, cones, balls, tori, planes and what planes bound.
//!
//! Formulas know numbers, not solids. `meet.rs` has the questions. It takes the body for the kind of
//! number:
//!
//! | family | numbers | floating point | fixed point |
//! |---|---|---|---|
//! | cylinder | [`Wall`], cut by [`Planes`] | `float/cylinder.rs`; `aligned.rs`, `oblique.rs` by axis | `fixed/cylinder.rs`; `aligned.rs` by axis |
//! | cone | [`Taper`], cut by [`Planes`]; [`Conic`] in pictures | `float/cone.rs` | `fixed/cone.rs` |
//! | ball | [`Ball`] | `float/ball.rs` | `fixed/ball.rs` |
//! | torus | [`Ring`] | `quartic.rs`, in `f64` | the same |
//! | two parallel planes | [`Planes`] | `float/planes.rs` | `fixed/planes.rs` |
//! | box | [`Corners`] | `float/planes.rs` | `fixed/planes.rs` |
//! | half-spaces | slices of [`HalfSpace`] | `float/planes.rs` | `fixed/planes.rs` |
//!
//! Tori are computed in `f64` for all number types. For the other families, floating point computes in twice
//! the working precision what would cancel. Fixed point computes in integers of 128 or 256 bits and rounds
//! each parameter once; an aligned cylinder's in words, where these are enough for the same bits.

mod ball;
mod corners;
mod fixed;
mod float;
mod half_space;
pub(crate) mod meet;
mod planes;
mod quartic;
mod ring;
mod taper;
mod wall;

pub(crate) use ball::Ball;
pub(crate) use corners::Corners;
pub use half_space::HalfSpace;
pub(crate) use planes::{PlaneRoots, Planes};
pub(crate) use quartic::ReadyTorus;
pub(crate) use ring::{Ring, regular};
pub(crate) use taper::{Conic, Taper};
pub(crate) use wall::{WALL, Wall};
