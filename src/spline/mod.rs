//! B-splines: knots, basis functions, curves.
//!
//! [`Knots`] hold a knot sequence and the order k of the splines over it: polynomials of degree
//! k − 1 from knot to knot. Over N knots there are n = N − k basis functions ([`Knots::basis`]), and a
//! curve has as many control points. The basis functions cover all knots; a curve has a *domain*,
//! t_{k−1} to t_n, in which the basis functions add up to 1. Both ends belong to the domain, and what
//! happens outside of it is the caller's choice: [`Outside`].
//!
//! A curve of numbers or vectors ([`Point`]) comes in two forms. [`Curve`] has control points that
//! can be changed. [`Baked`] is its polynomials, for each span of knots, computed while compiling; it
//! takes less time. For motion, with a point at every tick of a clock, [`Sweep`] needs
//! additions only. [`Curve::flatten`] approximates a curve by a polyline, [`Curve::lengths`]
//! measures it, [`Curve::insert`] adds knots.
//!
//! ```
//! use scancsg::{constant, geom::{Vec3, vec3}, spline::{Baked, Curve, Knots, Outside}};
//!
//! // A cubic with five control points: order 4, nine knots.
//! const KNOTS: Knots<f32, 4, 9> = constant!(Knots::<f32, 4, 9>::clamped_uniform(5, 0.0, 2.0));
//! const PATH: Curve<Vec3<f32>, 4, 5, 9> = constant!(Curve::<Vec3<f32>, 4, 5, 9>::new(KNOTS, [
//!     vec3(0.0, 0.0, 0.0), vec3(1.0, 0.0, 0.0), vec3(1.0, 1.0, 0.0), vec3(0.0, 1.0, 0.0), vec3(0.0, 0.0, 1.0),
//! ]));
//! const BAKED: Baked<Vec3<f32>, 4, { KNOTS.spans() }> = constant!(PATH.bake());
//!
//! let middle = PATH.value(1.0, Outside::Error)?;
//! assert_eq!(middle, vec3(0.75, 0.75, 0.0));
//! assert_eq!(BAKED.value(2.5, Outside::Clamp)?, vec3(0.0, 0.0, 1.0));
//! # Ok::<(), scancsg::spline::EvaluateError>(())
//! ```
//!
//! Every number type works; in fixed point, values are within 0.6 units in the last place of the
//! exact ones.

mod baked;
mod basis;
mod curve;
mod domain;
mod error;
mod knots;
mod point;
mod scalar;
mod sweep;

pub use baked::Baked;
pub use basis::NonZero;
pub use curve::Curve;
pub use curve::flatten::{Flatten, Lengths, Vertex};
pub use domain::{Domain, Outside};
pub use error::{CurveError, EvaluateError, FlattenError, KnotError, SweepError};
pub use knots::Knots;
pub use point::Point;
pub use scalar::SplineScalar;
pub use sweep::Sweep;
