//! Numbers as integers in the same order.

use crate::scalar::{FixedI32, Fraction, Scalar};
use core::fmt::Debug;

/// What a number type says of its range and of the order of its numbers.
pub trait Ordered: Sized {
    /// An unsigned integer: how many numbers lie between two of the type's.
    type Key: Copy + Debug + Ord;

    /// The smallest and the largest coordinate of a control point.
    const RANGE: [Self; 2];

    /// How many numbers this is behind the one with the key `start`; before it, it is more than any
    /// number behind it is.
    fn after(self, start: Self::Key) -> Self::Key;

    /// The number with this key.
    fn from_key(key: Self::Key) -> Self;
}

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

macro_rules! floats {
    ($($Float:ident $Key:ident $order:path;)+) => {$(
        impl Ordered for $Float {
            type Key = $Key;

            const RANGE: [Self; 2] = [-Self::MAX_COORDINATE, Self::MAX_COORDINATE];

            #[inline]
            fn after(self, start: $Key) -> $Key {
                $order(self).cast_unsigned().wrapping_sub(start)
            }

            #[inline]
            fn from_key(key: $Key) -> Self {
                Self::from_bits($order(Self::from_bits(key)).cast_unsigned())
            }
        }
    )+};
}

floats! {
    f32 u32 order_f32;
    f64 u64 order_f64;
}

impl<F: Fraction> Ordered for FixedI32<F> {
    type Key = u32;

    const RANGE: [Self; 2] = [Self::MIN, Self::MAX];

    #[inline]
    fn after(self, start: u32) -> u32 {
        self.to_bits().cast_unsigned().wrapping_sub(start)
    }

    #[inline]
    fn from_key(key: u32) -> Self {
        Self::from_bits(key.cast_signed())
    }
}
