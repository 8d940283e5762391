//! Integer arithmetic that fixed point is made of: rounded shifts, roots, quotients.

mod quotients;
mod roots;
mod rounding;

pub(crate) use quotients::{leading_zeros, long_quotient, normalized, quotient_by, reciprocal};
pub(crate) use roots::{long_root, root_with_40_digits, rough_root, sqrt};
pub(crate) use rounding::{divide, narrow, rounded_to_i32, shift_right, shift_right_wide};
