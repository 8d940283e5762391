//! Instructions of Arm cores with a floating-point unit that stable Rust has no name for.
//!
//! `core` has neither a square root nor a fused product, and `libm`'s root is 43 instructions
//! where the unit needs one. Assembly takes no floating-point registers as operands on these
//! targets, so numbers go in and out as bits, through core registers.

#![allow(unsafe_code)]

use core::arch::asm;

/// The product of two numbers and its rounding error, by a fused product and sum.
///
/// The error is rounded once, as by a product of twice the width: where its last digits are below
/// the smallest subnormal number, too.
#[cfg(not(target_has_atomic = "64"))]
#[inline]
pub(super) fn two_product(a: f32, b: f32) -> (f32, f32) {
    let (mut x, mut y) = (a.to_bits(), b.to_bits());
    // SAFETY: the instructions are there on this target, all registers written are declared, and
    // neither memory nor the stack is touched. The flags of the unit's exceptions, which they may
    // set, are read by no Rust code.
    unsafe {
        asm!(
            "vmov s14, s15, {x}, {y}",
            "vmul.f32 s12, s14, s15",
            "vmov.f32 s13, s12",
            "vfnms.f32 s13, s14, s15", // a·b − product
            "vmov {x}, {y}, s12, s13",
            x = inout(reg) x,
            y = inout(reg) y,
            out("s12") _,
            out("s13") _,
            out("s14") _,
            out("s15") _,
            options(pure, nomem, nostack, preserves_flags),
        );
    }
    (f32::from_bits(x), f32::from_bits(y))
}

/// The square root, correctly rounded; NaN below zero.
#[inline]
pub(super) fn sqrt(x: f32) -> f32 {
    let mut bits = x.to_bits();
    // SAFETY: the unit is there on this target, the only register written besides the operand is
    // declared, and neither memory nor the stack is touched. The flags of the unit's exceptions,
    // which it may set, are read by no Rust code.
    unsafe {
        asm!(
            "vmov s15, {bits}",
            "vsqrt.f32 s15, s15",
            "vmov {bits}, s15",
            bits = inout(reg) bits,
            out("s15") _,
            options(pure, nomem, nostack, preserves_flags),
        );
    }
    f32::from_bits(bits)
}
