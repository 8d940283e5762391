//! What every number type has to do: each test is one function, and runs for `f32`, `f64` and
//! `I16F16`. What only floating or only fixed point can get wrong is in `floats` and `fixed_point`.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

#[path = "../caster/mod.rs"]
mod caster;
#[path = "../number/mod.rs"]
mod number;

/// Makes tests of functions with a number type as their parameter.
macro_rules! for_every_number {
    ($($test:ident),+ $(,)?) => {
        mod f32 {
            $(#[test] fn $test() { super::$test::<f32>(); })+
        }
        mod f64 {
            $(#[test] fn $test() { super::$test::<f64>(); })+
        }
        mod i16f16 {
            $(#[test] fn $test() { super::$test::<scancsg::scalar::I16F16>(); })+
        }
    };
}

mod bad_input;
mod cylinders;
mod fixed_point;
mod floats;
mod hard_cases;
mod laws;
mod links;
mod pictures;
mod rows;
mod spans;
