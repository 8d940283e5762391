//! The number types that everything else is generic over.
//!
//! [`Scalar`] is sealed: `f32` is what firmware with a floating-point unit (and most hosts) should
//! use; [`FixedI32`], and of its formats [`I16F16`] first of all, is for cores without one; `f64`
//! is there for reference runs on hosts. All always compile side by side; a scene chooses by the
//! type of its numbers.
//!
//! Results have the same bits on every target. So nothing here calls a platform's maths library,
//! contracts a product and a sum, or leaves the order of operations open.

mod const_ops;
mod fixed;
mod float;
mod grid;
mod kind;
mod matrix;
mod number;
mod per_scalar;
mod rebase;
#[allow(clippy::module_inception)] // the trait that the folder is named after
mod scalar;

pub use fixed::{FixedI32, I16F16, Scale, Wide};
#[doc(hidden)]
pub use grid::Grid;
#[doc(hidden)]
pub use kind::{ByKind, OfFixed, OfFloat};
pub use number::{Number, Real};
pub(crate) use scalar::Float;
pub use scalar::{FixedPoint, Formula, Roots, Scalar};

pub(crate) use crate::numeric::{Double, integer, sin_cos_of_part, two_sum};
pub(crate) use const_ops::{ConstOps, normalized};
pub(crate) use fixed::Fraction;
pub(crate) use per_scalar::per_scalar;
pub(crate) use rebase::Rebased;
pub(crate) use scalar::{Inverse, Matrix, Stretch};
