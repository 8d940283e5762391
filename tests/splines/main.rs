//! B-splines, in every number type, against exact arithmetic.

#![allow(clippy::unwrap_used)]

mod bad_input;
mod curves;
mod editing;
mod exact;
mod number;
mod properties;
mod reference;
mod search;
mod sweeps;
mod table;
