//! What constructors of splines compute, for constants: traits have no `const` methods yet.
//!
//! Where an order is all that counts, they work with keys: integers in the order of the numbers.

use super::order::{order_f32, order_f64};
use crate::scalar::integer::divide;
use crate::scalar::{ConstOps, FixedI32, Fraction, Scalar};

/// The key of what is infinite or NaN.
pub(in crate::spline) const NOT_FINITE: i64 = i64::MAX;

pub(in crate::spline) const fn are_finite(mut keys: &[i64]) -> bool {
    while let [key, others @ ..] = keys {
        if *key == NOT_FINITE {
            return false;
        }
        keys = others;
    }
    true
}

/// So many elements of a list, over and over again, and behind them others.
pub(in crate::spline) const fn repeated<T: Copy, const C: usize>(
    all: &[T],
    count: usize,
    other: T,
) -> [T; C] {
    let mut copy = [other; C];
    let mut rest = all;
    let mut i = 0;
    while i < C && i < count {
        if rest.is_empty() {
            rest = all;
        }
        if let [first, others @ ..] = rest {
            (copy[i], rest) = (*first, others);
        }
        i += 1;
    }
    copy
}

/// Elements from an index on, as far as there is room for them, and others around them.
pub(in crate::spline) const fn placed<T: Copy, const N: usize>(
    elements: &[T],
    from: usize,
    other: T,
) -> [T; N] {
    let mut copy = [other; N];
    let mut i = 0;
    while i < elements.len() && from + i < N {
        copy[from + i] = elements[i];
        i += 1;
    }
    copy
}

macro_rules! keys {
    ($([$($generics:tt)*] $Scalar:ty, |$x:ident| $key:expr;)+) => {$(
        impl<$($generics)*> ConstOps<$Scalar> {
            /// Integers in the order of the numbers; −0 is as large as 0.
            pub(in crate::spline) const fn keys<const N: usize>(numbers: &[$Scalar; N]) -> [i64; N] {
                let mut keys = [0; N];
                let mut i = 0;
                while i < N {
                    let $x = numbers[i];
                    keys[i] = $key;
                    i += 1;
                }
                keys
            }
        }
    )+};
}

keys! {
    [] f32, |x| if x.is_finite() { order_f32(x + 0.0) as i64 } else { NOT_FINITE };
    [] f64, |x| if x.is_finite() { order_f64(x + 0.0) } else { NOT_FINITE };
    [F: Fraction,] FixedI32<F>, |x| x.to_bits() as i64;
}

macro_rules! floats {
    ($($Float:ident),+) => {$(
        impl ConstOps<$Float> {
            /// The smallest and the largest key of a control point's coordinate.
            pub(in crate::spline) const REACH: [i64; 2] =
                Self::keys(&[-<$Float>::MAX_COORDINATE, <$Float>::MAX_COORDINATE]);

            /// `from + step·count`, if it can be represented.
            pub(in crate::spline) const fn step(
                from: $Float,
                step: $Float,
                count: usize,
            ) -> Option<$Float> {
                Self::finite(from + step * count as $Float)
            }

            /// `from + (to − from)·index/count`, rounded; for `index < count`.
            pub(in crate::spline) const fn divided(
                from: $Float,
                to: $Float,
                index: usize,
                count: usize,
            ) -> Option<$Float> {
                let (width, index, count) = (to - from, index as $Float, count as $Float);
                let part = width * index / count;
                // The product of the widest spans overflows.
                let part = if part.is_finite() { part } else { width / count * index };
                let at = from + part;
                Self::finite(if at > to { to } else { at })
            }

            /// `low + (high − middle)`.
            pub(in crate::spline) const fn shifted(
                low: $Float,
                high: $Float,
                middle: $Float,
            ) -> Option<$Float> {
                Self::finite(low + (high - middle))
            }

            const fn finite(x: $Float) -> Option<$Float> {
                if x.is_finite() { Some(x) } else { None }
            }

            pub(in crate::spline) const fn is_in_range_of_knots(first: $Float, last: $Float) -> bool {
                (last - first).is_finite()
            }
        }
    )+};
}

floats!(f32, f64);

impl<F: Fraction> ConstOps<FixedI32<F>> {
    pub(in crate::spline) const REACH: [i64; 2] = [i32::MIN as i64, i32::MAX as i64];

    pub(in crate::spline) const fn step(
        from: FixedI32<F>,
        step: FixedI32<F>,
        count: usize,
    ) -> Option<FixedI32<F>> {
        Self::exactly(from.to_bits() as i128 + step.to_bits() as i128 * count as i128)
    }

    pub(in crate::spline) const fn divided(
        from: FixedI32<F>,
        to: FixedI32<F>,
        index: usize,
        count: usize,
    ) -> Option<FixedI32<F>> {
        let width = to.to_bits() as i128 - from.to_bits() as i128;
        let part = divide(width * index as i128, count as i128);
        Self::exactly(from.to_bits() as i128 + part)
    }

    pub(in crate::spline) const fn shifted(
        low: FixedI32<F>,
        high: FixedI32<F>,
        middle: FixedI32<F>,
    ) -> Option<FixedI32<F>> {
        Self::exactly(low.to_bits() as i128 + high.to_bits() as i128 - middle.to_bits() as i128)
    }

    const fn exactly(bits: i128) -> Option<FixedI32<F>> {
        if bits as i32 as i128 == bits { Some(FixedI32::from_bits(bits as i32)) } else { None }
    }

    pub(in crate::spline) const fn is_in_range_of_knots(_: FixedI32<F>, _: FixedI32<F>) -> bool {
        true
    }
}
