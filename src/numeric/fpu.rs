//! Instructions of Arm cores with a floating-point unit that stable Rust has no name for.
//!
//! `core` has neither a square root nor a fused product, and `libm`'s root is 43 instructions
//! where the unit needs one. Assembly takes no floating-point registers as operands on these
//! targets, so numbers go in and out as bits, through core registers.

#![allow(unsafe_code)]

use crate::scalar::{FloatFrame, Polynomial};
use core::arch::asm;
use core::mem::offset_of;

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

/// Horner's rule for the three coordinates of a cubic, with all numbers in one load, where a compiler has
/// fourteen. `vmla` rounds the product, and then the sum.
#[inline]
pub(crate) fn cubic(polynomial: &Polynomial<FloatFrame<f32>, [f32; 3], 4>, t: f32) -> [f32; 3] {
    const {
        type Cubic = Polynomial<FloatFrame<f32>, [f32; 3], 4>;
        assert!(size_of::<Cubic>() == 14 * size_of::<f32>());
        assert!(offset_of!(Cubic, frame.scale) == 12 * size_of::<f32>());
        assert!(offset_of!(Cubic, frame.shift) == 13 * size_of::<f32>());
    }
    let (x, y, z): (u32, u32, u32);
    // SAFETY: the pointer is that of a reference, so it is aligned, and valid for reading the fourteen
    // numbers that are asserted to be there without a gap, in the order of their fields, and that all
    // have a value. Nothing else is read, and nothing written. The instructions are there on this target,
    // all registers written are declared, the results are written after both operands were read, and
    // neither the stack nor the condition flags are touched. The flags of the unit's exceptions, which
    // they may set, are read by no Rust code.
    unsafe {
        asm!(
            // The coefficients to s11, the scale and the shift.
            "vldmia {polynomial}, {{s0-s13}}",
            "vmov s14, {t}",
            "vmla.f32 s13, s14, s12",
            "vmla.f32 s3, s0, s13",
            "vmla.f32 s4, s1, s13",
            "vmla.f32 s5, s2, s13",
            "vmla.f32 s6, s3, s13",
            "vmla.f32 s7, s4, s13",
            "vmla.f32 s8, s5, s13",
            "vmla.f32 s9, s6, s13",
            "vmla.f32 s10, s7, s13",
            "vmla.f32 s11, s8, s13",
            "vmov r1, r2, s9, s10",
            "vmov r3, s11",
            polynomial = in(reg) polynomial,
            t = in(reg) t.to_bits(),
            lateout("r1") x, lateout("r2") y, lateout("r3") z,
            out("s0") _, out("s1") _, out("s2") _, out("s3") _, out("s4") _,
            out("s5") _, out("s6") _, out("s7") _, out("s8") _, out("s9") _,
            out("s10") _, out("s11") _, out("s12") _, out("s13") _, out("s14") _,
            options(pure, readonly, nostack, preserves_flags),
        );
    }
    [x, y, z].map(f32::from_bits)
}

/// The leaf of a binary tree that a key belongs to: to the right of a node that is as large or smaller.
///
/// The root is node 1, and the children of node n are 2n and 2n + 1: twice the number and the carry of a
/// comparison are one instruction, which no compiler finds. Without enough nodes it is `usize::MAX`.
#[inline]
pub(crate) fn leaf(nodes: &[u32], levels: u32, key: u32) -> usize {
    const { assert!(size_of::<usize>() == size_of::<u32>()) };
    if nodes.len().checked_shr(levels).is_none_or(|enough| enough == 0) {
        return usize::MAX;
    }
    let mut node = 1usize;
    for _ in 0..levels {
        // SAFETY: before the n-th of these steps, from the 0-th on, `node` is from 2^n to 2^(n + 1) − 1,
        // n is less than `levels`, and the slice has 2^levels elements at least, as was checked, so one of
        // that index, which is read. Nothing else is read, and nothing written. The instructions are there
        // on this target, all registers written are declared, the flags are not said to be kept, and the
        // stack is not touched.
        unsafe {
            asm!(
                "ldr {other}, [{nodes}, {node}, lsl #2]",
                "cmp {key}, {other}",
                "adc {node}, {node}, {node}",
                nodes = in(reg) nodes.as_ptr(),
                key = in(reg) key,
                node = inout(reg) node,
                other = out(reg) _,
                options(pure, readonly, nostack),
            );
        }
    }
    // SAFETY: `node` began as 1, and each of `levels` steps, fewer than `node` has digits, wrote one more
    // digit behind it.
    unsafe { core::hint::assert_unchecked(node >> levels == 1) };
    node
}
