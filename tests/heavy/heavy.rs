//! What takes so long unoptimised that compiling it with optimisation takes less: many rays, and few types.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

#[macro_use]
extern crate testkit;

use testkit::bspline as exact;
use testkit::{limits, number};

mod aim;
mod by_line;
#[allow(dead_code)] // it is for all tests of curves
#[path = "../splines/number.rs"]
mod numeric;
mod polylines;
mod poses;
mod shared_axis;
mod tiny_solids;
mod tori;
mod widest_spans;
