//! Arithmetic on plain numbers: error-free sums and products of floating-point numbers, and the
//! long products, roots and quotients of integers that fixed point is made of.
//!
//! Nothing here knows a scene's number type. Which body runs on which target is decided in `select`.

mod armv6m;
mod double;
mod error_free;
#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
mod fpu;
pub(crate) mod integer;
mod native;
mod products;
mod root;
mod select;
mod sine;

pub(crate) use double::Double;
pub(crate) use error_free::two_sum;
pub use native::{Loggable, Native};
pub(crate) use products::{add_product, dot3, product_difference};
pub(crate) use root::sqrt as const_sqrt;
pub(crate) use select::{
    SATURATES_TO_I32, long_product, product, short_product, steps, unsigned_product, upper_product,
};
pub(crate) use sine::{sin_cos_of_part, sin_cos_of_quarters};
