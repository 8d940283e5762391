//! What every number type has to do: each test is one function, and runs for `f32`, `f64`, `I16F16` and
//! `I20F12`, as a format of fixed point with another number of digits. What only floating or only fixed
//! point can get wrong is in `floats` and `fixed_point`.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

#[macro_use]
extern crate testkit;

use testkit::{caster, limits, number};

#[path = "../heavy/aim.rs"]
mod aim;
mod bad_input;
mod compound;
mod cones;
mod constructors;
mod cylinders;
mod fixed_point;
mod floats;
mod hard_cases;
mod hits;
mod laws;
mod links;
mod pictures;
mod planes;
mod rows;
mod secondary;
mod smooth;
mod spans;
mod telephoto;
mod walks;
