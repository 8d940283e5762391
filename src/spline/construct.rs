//! Constructors of knot sequences, for constants.

use super::KnotError;
use super::knots::Knots;
use crate::scalar::{ConstOps, FixedI32, Fraction};

/// The sums and quotients that constructors need.
impl<F: Fraction> ConstOps<FixedI32<F>> {
    /// `from + step·count`, if it can be represented.
    const fn step(from: FixedI32<F>, step: FixedI32<F>, count: usize) -> Option<FixedI32<F>> {
        let bits = from.to_bits() as i128 + step.to_bits() as i128 * count as i128;
        Self::exactly(bits)
    }

    /// `from + (to − from)·index/count`, rounded; for `index < count`.
    const fn divided(
        from: FixedI32<F>,
        to: FixedI32<F>,
        index: usize,
        count: usize,
    ) -> Option<FixedI32<F>> {
        let width = to.to_bits() as i128 - from.to_bits() as i128;
        let part = crate::scalar::integer::divide(width * index as i128, count as i128);
        Self::exactly(from.to_bits() as i128 + part)
    }

    /// As [`divided`](Self::divided), for `index ≤ count`, between numbers that are fit for it.
    pub(super) const fn part(
        from: FixedI32<F>,
        to: FixedI32<F>,
        index: usize,
        count: usize,
    ) -> FixedI32<F> {
        match Self::divided(from, to, index, count) {
            Some(at) => at,
            None => to,
        }
    }

    /// `low + (high − middle)`.
    const fn shifted(
        low: FixedI32<F>,
        high: FixedI32<F>,
        middle: FixedI32<F>,
    ) -> Option<FixedI32<F>> {
        Self::exactly(low.to_bits() as i128 + high.to_bits() as i128 - middle.to_bits() as i128)
    }

    const fn exactly(bits: i128) -> Option<FixedI32<F>> {
        if bits as i32 as i128 == bits { Some(FixedI32::from_bits(bits as i32)) } else { None }
    }

    const fn is_in_range_of_knots(_: FixedI32<F>, _: FixedI32<F>) -> bool {
        true
    }
}

macro_rules! floats {
    ($($Float:ident),+) => {$(
        impl ConstOps<$Float> {
            const fn step(from: $Float, step: $Float, count: usize) -> Option<$Float> {
                Self::finite(from + step * count as $Float)
            }

            const fn divided(
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

            pub(super) const fn part(
                from: $Float,
                to: $Float,
                index: usize,
                count: usize,
            ) -> $Float {
                match Self::divided(from, to, index, count) {
                    Some(at) if index < count => at,
                    _ => to,
                }
            }

            const fn shifted(low: $Float, high: $Float, middle: $Float) -> Option<$Float> {
                Self::finite(low + (high - middle))
            }

            const fn finite(x: $Float) -> Option<$Float> {
                if x.is_finite() { Some(x) } else { None }
            }

            const fn is_in_range_of_knots(first: $Float, last: $Float) -> bool {
                (last - first).is_finite()
            }
        }
    )+};
}

floats!(f32, f64);

macro_rules! constructors {
    ($([$($generics:tt)*] $Scalar:ty),+) => {$(
        impl<$($generics)* const K: usize, const N: usize> Knots<$Scalar, K, N> {
            /// Any knots.
            ///
            /// # Errors
            /// A [`KnotError`] where these are no knots of order `K`.
            pub const fn new(knots: &[$Scalar]) -> Result<Self, KnotError> {
                let mut copy = [ConstOps::<$Scalar>::ZERO; N];
                if knots.len() > N {
                    return Err(KnotError::TooMany);
                }
                let mut i = 0;
                let mut rest = knots;
                while i < N && let [knot, others @ ..] = rest {
                    copy[i] = *knot;
                    rest = others;
                    i += 1;
                }
                Self::checked(copy, knots.len())
            }

            /// Knots at equal distances, `from`, `from + step` and so on: those of *cardinal*
            /// splines with so many control points.
            ///
            /// # Errors
            /// [`KnotError::TooMany`], [`KnotError::NotFinite`], [`KnotError::TooFar`];
            /// [`KnotError::TooFew`] without a control point; [`KnotError::Decreasing`] or
            /// [`KnotError::Multiplicity`] if `step` is not positive.
            pub const fn uniform(
                points: usize,
                from: $Scalar,
                step: $Scalar,
            ) -> Result<Self, KnotError> {
                if points > N || points + K > N {
                    return Err(KnotError::TooMany);
                }
                if !(ConstOps::<$Scalar>::is_finite(from) && ConstOps::<$Scalar>::is_finite(step)) {
                    return Err(KnotError::NotFinite);
                }
                let mut knots = [ConstOps::<$Scalar>::ZERO; N];
                let mut i = 0;
                while i < N && i < points + K {
                    match ConstOps::<$Scalar>::step(from, step, i) {
                        Some(knot) => knots[i] = knot,
                        None => return Err(KnotError::TooFar),
                    }
                    i += 1;
                }
                Self::checked(knots, points + K)
            }

            /// Knots of a curve that begins in the first of so many control points and ends in
            /// the last one: `K` times `from`, then at equal distances, then `K` times `to`.
            ///
            /// # Errors
            /// [`KnotError::TooMany`], [`KnotError::NotFinite`], [`KnotError::TooFar`];
            /// [`KnotError::TooFew`] with fewer control points than the order;
            /// [`KnotError::Decreasing`] unless `from < to`.
            pub const fn clamped_uniform(
                points: usize,
                from: $Scalar,
                to: $Scalar,
            ) -> Result<Self, KnotError> {
                if points > N || points + K > N {
                    return Err(KnotError::TooMany);
                }
                if points < K {
                    return Err(KnotError::TooFew);
                }
                if !(ConstOps::<$Scalar>::is_finite(from) && ConstOps::<$Scalar>::is_finite(to)) {
                    return Err(KnotError::NotFinite);
                }
                if !ConstOps::<$Scalar>::is_below(from, to) {
                    return Err(KnotError::Decreasing);
                }
                let mut knots = [ConstOps::<$Scalar>::ZERO; N];
                let mut i = 0;
                while i < N && i < points + K {
                    knots[i] = if i < K {
                        from
                    } else if i >= points {
                        to
                    } else {
                        match ConstOps::<$Scalar>::divided(from, to, i + 1 - K, points + 1 - K) {
                            Some(knot) => knot,
                            None => return Err(KnotError::TooFar),
                        }
                    };
                    i += 1;
                }
                Self::checked(knots, points + K)
            }

            /// Knots of a closed curve, from where its polynomials meet: m + 1 breaks b₀ … b_m make
            /// m spans and m + 2K − 1 knots; the domain is from b₀ to b_m, the period its length. The
            /// curve has m + K − 1 control points, of which the last K − 1 repeat the first.
            ///
            /// # Errors
            /// As [`new`](Self::new); [`KnotError::TooFew`] for fewer than two breaks.
            pub const fn periodic(breaks: &[$Scalar]) -> Result<Self, KnotError> {
                let length = breaks.len();
                if length > N || length + 2 * (K - 1) > N {
                    return Err(KnotError::TooMany);
                }
                let [first, _, ..] = breaks else { return Err(KnotError::TooFew) };
                let mut knots = [ConstOps::<$Scalar>::ZERO; N];
                let mut i = K - 1;
                let mut rest = breaks;
                let mut last = *first;
                while i < N && let [knot, others @ ..] = rest {
                    if !ConstOps::<$Scalar>::is_finite(*knot) {
                        return Err(KnotError::NotFinite);
                    }
                    knots[i] = *knot;
                    last = *knot;
                    rest = others;
                    i += 1;
                }
                let first = *first;
                // Outwards, each knot from one that is a period away.
                let mut j = 1;
                while j < K {
                    let (low, high) = (K - 1 - j, K - 1 + length - 1 + j);
                    if high < N && low < N {
                        match ConstOps::<$Scalar>::shifted(first, knots[low + length - 1], last) {
                            Some(knot) => knots[low] = knot,
                            None => return Err(KnotError::TooFar),
                        }
                    }
                    j += 1;
                }
                let mut j = 1;
                while j < K {
                    let high = K - 1 + length - 1 + j;
                    if high < N && high + 1 >= length {
                        match ConstOps::<$Scalar>::shifted(last, knots[high + 1 - length], first) {
                            Some(knot) => knots[high] = knot,
                            None => return Err(KnotError::TooFar),
                        }
                    }
                    j += 1;
                }
                Self::checked(knots, length + 2 * (K - 1))
            }

            const fn checked(
                mut knots: [$Scalar; N],
                length: usize,
            ) -> Result<Self, KnotError> {
                const { assert!(K >= 1 && K <= 32 && N > K) };
                if length <= K {
                    return Err(KnotError::TooFew);
                }
                let mut i = 0;
                let mut same = 0;
                while i < N && i < length {
                    if !ConstOps::<$Scalar>::is_finite(knots[i]) {
                        return Err(KnotError::NotFinite);
                    }
                    if i > 0 && ConstOps::<$Scalar>::is_below(knots[i], knots[i - 1]) {
                        return Err(KnotError::Decreasing);
                    }
                    let rises = i == 0 || ConstOps::<$Scalar>::is_below(knots[i - 1], knots[i]);
                    same = if rises { 1 } else { same + 1 };
                    if same > K {
                        return Err(KnotError::Multiplicity);
                    }
                    i += 1;
                }
                if length > 0 && length <= N
                    && !ConstOps::<$Scalar>::is_in_range_of_knots(knots[0], knots[length - 1])
                {
                    return Err(KnotError::TooFar);
                }
                // What isn't used is not below any parameter but the last, so a search needs no
                // length.
                while i < N && i > 0 {
                    knots[i] = knots[i - 1];
                    i += 1;
                }
                Ok(Self { knots, length })
            }

            /// How many spans of the domain are not empty: how many polynomials a curve has.
            #[must_use]
            pub const fn spans(&self) -> usize {
                let mut spans = 0;
                let mut i = K - 1;
                while i + 1 < N && i + K < self.length {
                    if ConstOps::<$Scalar>::is_below(self.knots[i], self.knots[i + 1]) {
                        spans += 1;
                    }
                    i += 1;
                }
                spans
            }
        }
    )+};
}

constructors!([] f32, [] f64, [F: Fraction,] FixedI32<F>);
