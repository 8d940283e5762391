//! Which body runs on which target: all decisions are here.
//!
//! All bodies of one operation give the same bits.

use super::armv6m;

/// What a core multiplies and divides in hardware.
pub(super) enum Core {
    /// 32 by 32 bits to 32, and no quotient: ARMv6-M.
    Narrow,
    /// 32 by 32 bits to 64, and quotients of 32 bits.
    Word,
    /// Products and quotients of 64 bits.
    Long,
}

/// The core that is compiled for. ARMv6-M is the one Arm without atomic exchange.
pub(super) const CORE: Core = if cfg!(all(target_arch = "arm", not(target_has_atomic = "32"))) {
    Core::Narrow
} else if cfg!(target_pointer_width = "64") {
    Core::Long
} else {
    Core::Word
};

/// Whether one instruction converts to an integer and keeps it inside the range of `i32`.
pub(crate) const SATURATES_TO_I32: bool = cfg!(target_arch = "arm");

// Any target that passes floats in the unit's registers (`eabihf`) has `vsqrt.f32`. Fused products
// came later: all Cortex-M with a unit have them, some Cortex-R, -A and Arm11 don't. Of the `eabihf`
// targets, those for Cortex-M are the ones without 64-bit atomics; that a compiler can tell.

#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
pub(super) use super::fpu::sqrt as sqrt_f32;
#[cfg(not(all(target_arch = "arm", target_abi = "eabihf")))]
pub(super) use libm::sqrtf as sqrt_f32;

#[cfg(not(any(
    target_pointer_width = "64",
    all(target_arch = "arm", target_abi = "eabihf", not(target_has_atomic = "64"))
)))]
pub(super) use super::error_free::two_product_soft as two_product_f32;
#[cfg(target_pointer_width = "64")]
pub(super) use super::error_free::two_product_wide as two_product_f32;
#[cfg(all(target_arch = "arm", target_abi = "eabihf", not(target_has_atomic = "64")))]
pub(super) use super::fpu::two_product as two_product_f32;

/// `a · b`.
#[inline]
pub(crate) const fn product(a: i32, b: i32) -> i64 {
    match CORE {
        Core::Narrow => armv6m::signed_product(a, b),
        _ => a as i64 * b as i64,
    }
}

/// `a · b`.
#[inline]
pub(crate) const fn unsigned_product(a: u32, b: u32) -> u64 {
    match CORE {
        Core::Narrow => armv6m::unsigned_product(a, b),
        _ => a as u64 * b as u64,
    }
}

/// `a · b`.
#[inline]
pub(crate) const fn short_product(a: i32, b: u16) -> i64 {
    match CORE {
        Core::Narrow => armv6m::short_product(a, b),
        _ => a as i64 * b as i64,
    }
}

/// `a · b / 2¹⁶`, cut off, for b below 2¹⁶.
#[inline]
pub(crate) const fn upper_product(a: u32, b: u32) -> u32 {
    match CORE {
        Core::Narrow => armv6m::upper_product(a, b),
        _ => ((a as u64 * (b << 16) as u64) >> 32) as u32,
    }
}

/// `a · b`.
#[inline]
pub(crate) const fn long_product(a: i64, b: i64) -> i128 {
    match CORE {
        Core::Narrow => armv6m::long_product(a, b),
        _ => a as i128 * b as i128,
    }
}

/// `step · count`, modulo 2⁶⁴.
#[inline]
pub(crate) const fn steps(step: i64, count: i32) -> i64 {
    match CORE {
        Core::Narrow => armv6m::steps(step, count),
        _ => step.wrapping_mul(count as i64),
    }
}

/// `value >> by`, for shifts by less than 64 bits.
#[inline]
pub(super) const fn shifted(value: i64, by: u32) -> i64 {
    match CORE {
        Core::Narrow => armv6m::shifted(value, by),
        _ => value >> by,
    }
}
