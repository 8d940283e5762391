//! The fused difference `x² − y`.

#![allow(unsafe_code)]

use super::double::add_product;
use super::native::Native;

/// Numbers with a fused difference of a square and a number.
pub trait Fused: Native {
    /// `x² − y` with one rounding, unless that is subnormal: the product is fused with the
    /// difference. In `f64` it comes from a sum with twice the precision.
    fn square_less(x: Self, y: Self) -> Self;

    /// [`square_less`](Self::square_less), or `None`, rarely, where that takes longer: then whoever
    /// asks may turn to a function for rare cases, and keeps nothing for afterwards.
    #[inline]
    fn quick_square_less(x: Self, y: Self) -> Option<Self> {
        Some(Self::square_less(x, y))
    }
}

impl Fused for f64 {
    #[inline]
    fn square_less(x: Self, y: Self) -> Self {
        add_product(-y, x, x)
    }
}

#[cfg(all(target_arch = "arm", target_abi = "eabihf", not(target_has_atomic = "64")))]
impl Fused for f32 {
    /// By a fused product and sum.
    #[inline]
    fn square_less(x: Self, y: Self) -> Self {
        let mut bits = y.to_bits();
        // SAFETY: as in `fpu::two_product`.
        unsafe {
            core::arch::asm!(
                "vmov s14, s15, {x}, {y}",
                "vfnms.f32 s15, s14, s14", // x·x − y
                "vmov {y}, s15",
                x = in(reg) x.to_bits(),
                y = inout(reg) bits,
                out("s14") _,
                out("s15") _,
                options(pure, nomem, nostack, preserves_flags),
            );
        }
        Self::from_bits(bits)
    }
}

#[cfg(not(all(target_arch = "arm", target_abi = "eabihf", not(target_has_atomic = "64"))))]
impl Fused for f32 {
    #[inline]
    fn square_less(x: Self, y: Self) -> Self {
        product_less(x, x, y).unwrap_or_else(|| product_less_half_way(x, x, y))
    }

    #[inline]
    fn quick_square_less(x: Self, y: Self) -> Option<Self> {
        product_less(x, x, y)
    }
}

/// `a·b − c`, rounded once, unless the result is subnormal; `None`, rarely, where that takes a closer
/// look.
#[cfg(not(all(target_arch = "arm", target_abi = "eabihf", not(target_has_atomic = "64"))))]
#[inline]
fn product_less(a: f32, b: f32, c: f32) -> Option<f32> {
    let difference = f64::from(a) * f64::from(b) - f64::from(c);
    // Rounding twice is rounding once, unless the first one ends half-way between two `f32`.
    const BELOW: u32 = (1 << 29) - 1;
    (difference.to_bits() as u32 & BELOW != 1 << 28).then_some(difference as f32)
}

/// [`product_less`] where the difference is half-way between two numbers: what it was rounded by
/// decides.
#[cfg(not(all(target_arch = "arm", target_abi = "eabihf", not(target_has_atomic = "64"))))]
#[cold]
#[inline(never)]
fn product_less_half_way(a: f32, b: f32, c: f32) -> f32 {
    let (product, c) = (f64::from(a) * f64::from(b), f64::from(-c));
    let sum = product + c;
    let rest = sum - product;
    let error = (product - (sum - rest)) + (c - rest);
    let nudged = if error == 0.0 {
        sum
    } else if (error > 0.0) == (sum > 0.0) {
        f64::from_bits(sum.to_bits() + 1)
    } else {
        f64::from_bits(sum.to_bits() - 1)
    };
    nudged as f32
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn product_sum(a: f32, b: f32, c: f32) -> f32 {
        product_less(a, b, -c).unwrap_or_else(|| product_less_half_way(a, b, -c))
    }

    proptest! {
        #[test]
        fn fused_sums_have_the_bits_of_hardware(
            x in 1f32..2.0, y in -2f32..-1.0, z in 1f32..2.0,
            x_exponent in -60i32..60, y_exponent in -60i32..60, gap in -50i32..50,
        ) {
            let (a, b) = (x * 2f32.powi(x_exponent), y * 2f32.powi(y_exponent));
            let c = z * 2f32.powi((x_exponent + y_exponent + gap).clamp(-120, 120));
            let fused = a.mul_add(b, c);
            prop_assume!(fused == 0.0 || fused.is_normal());
            prop_assert_eq!(product_sum(a, b, c).to_bits(), fused.to_bits());
        }

        #[test]
        fn fused_sums_near_half_way(
            odd in 0u32..1 << 23, ulps in -2i32..=2, gap in 26i32..40, sign in any::<bool>(),
        ) {
            // c ends in a digit that the product's leading one halves, and its last one decides.
            let c = f32::from_bits(1f32.to_bits() | odd);
            let near_one = |ulps: i32| f32::from_bits(0x3f80_0000u32.wrapping_add_signed(ulps));
            let a = near_one(ulps) * 2f32.powi(-24) * if sign { 1.0 } else { -1.0 };
            for b in [1.0, near_one(1), near_one(-1), 1.0 + 2f32.powi(gap - 49)] {
                prop_assert_eq!(product_sum(a, b, c).to_bits(), a.mul_add(b, c).to_bits());
                prop_assert_eq!(f32::square_less(c, b).to_bits(), c.mul_add(c, -b).to_bits());
            }
        }
    }
}
