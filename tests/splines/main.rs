//! B-splines, in every number type, against exact arithmetic.

#![allow(clippy::unwrap_used)]

mod curves;
mod exact;
mod number;
mod reference;
