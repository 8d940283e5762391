//! What constructors of splines compute, for constants: traits have no `const` methods yet.

use super::order::{order_f32, order_f64};
use crate::scalar::integer::divide;
use crate::scalar::{ConstOps, FixedI32, Fraction};

/// So many elements of a list from an index on, over and over again, and others around them.
pub(in crate::spline) const fn repeated<T: Copy, const N: usize>(
    all: &[T],
    from: usize,
    count: usize,
    other: T,
) -> [T; N] {
    let mut copy = [other; N];
    let mut i = 0;
    while i < count && from + i < N && !all.is_empty() {
        copy[from + i] = all[i % all.len()];
        i += 1;
    }
    copy
}

macro_rules! floats {
    ($($Float:ident $Key:ident $order:path;)+) => {$(
        impl ConstOps<$Float> {
            /// `from + (to − from)·index/count`, rounded; for `index ≤ count`.
            pub(in crate::spline) const fn divided(
                [from, to]: [$Float; 2],
                index: usize,
                count: usize,
            ) -> $Float {
                if index == count {
                    return to;
                }
                let (width, index, count) = (to - from, index as $Float, count as $Float);
                let part = width * index / count;
                // The product of the widest spans overflows.
                let part = if part.is_finite() { part } else { width / count * index };
                (from + part).min(to)
            }

            /// `from + (high − low)·count`, if it can be represented.
            pub(in crate::spline) const fn moved(
                from: $Float,
                [low, high]: [$Float; 2],
                count: usize,
            ) -> Option<$Float> {
                let to = from + (high - low) * count as $Float;
                if to.is_finite() { Some(to) } else { None }
            }

            /// The same number, or of fixed point its units.
            pub(in crate::spline) const fn units(x: $Float) -> f64 {
                x as f64
            }

            /// The [key](crate::spline::scalar::order::Ordered::Key) of the first number that is equal to x: of
            /// two zeros −0.
            pub(in crate::spline) const fn first_key(x: $Float) -> $Key {
                $order(-(0.0 - x)).cast_unsigned()
            }

            /// The key of the last number that is equal to x.
            pub(in crate::spline) const fn last_key(x: $Float) -> $Key {
                $order(x + 0.0).cast_unsigned()
            }
        }
    )+};
}

floats! {
    f32 u32 order_f32;
    f64 u64 order_f64;
}

impl<F: Fraction> ConstOps<FixedI32<F>> {
    pub(in crate::spline) const fn divided(
        [from, to]: [FixedI32<F>; 2],
        index: usize,
        count: usize,
    ) -> FixedI32<F> {
        let width = to.to_bits() as i128 - from.to_bits() as i128;
        let part = divide(width * index as i128, count as i128);
        FixedI32::from_bits((from.to_bits() as i128 + part) as i32)
    }

    pub(in crate::spline) const fn moved(
        from: FixedI32<F>,
        [low, high]: [FixedI32<F>; 2],
        count: usize,
    ) -> Option<FixedI32<F>> {
        let step = high.to_bits() as i128 - low.to_bits() as i128;
        let bits = from.to_bits() as i128 + step * count as i128;
        if bits as i32 as i128 == bits { Some(FixedI32::from_bits(bits as i32)) } else { None }
    }

    pub(in crate::spline) const fn units(x: FixedI32<F>) -> f64 {
        x.to_bits() as f64
    }

    pub(in crate::spline) const fn first_key(x: FixedI32<F>) -> u32 {
        x.to_bits().cast_unsigned()
    }

    pub(in crate::spline) const fn last_key(x: FixedI32<F>) -> u32 {
        x.to_bits().cast_unsigned()
    }
}
