//! B-splines, in every number type, against exact arithmetic.

#![allow(clippy::unwrap_used)]

use testkit::bspline as exact;
use testkit::bspline_table as table;

mod bad_input;
mod curves;
mod editing;
mod ends_of_range;
mod number;
mod properties;
mod reference;
mod search;
mod sweeps;
