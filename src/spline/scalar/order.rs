//! Floating-point numbers as integers in the same order.

/// An integer in the order of the numbers, −0 below 0. It is its own inverse.
#[inline]
pub(in crate::spline) const fn order_f32(x: f32) -> i32 {
    let bits = x.to_bits().cast_signed();
    bits ^ ((bits >> 31).cast_unsigned() >> 1).cast_signed()
}

/// As [`order_f32`].
#[inline]
pub(in crate::spline) const fn order_f64(x: f64) -> i64 {
    let bits = x.to_bits().cast_signed();
    bits ^ ((bits >> 63).cast_unsigned() >> 1).cast_signed()
}
