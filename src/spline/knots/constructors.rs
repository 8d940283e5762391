//! Constructors of knot sequences, for constants: one set for each number type.

use super::Knots;
use crate::scalar::{ConstOps, FixedI32, Fraction};
use crate::spline::error::KnotError;
use crate::spline::scalar::constant::{NOT_FINITE, are_finite, placed};

/// Whether keys of numbers are those of a knot sequence of an order.
const fn check(keys: &[i64], order: usize) -> Result<(), KnotError> {
    let (mut before, mut same) = (i64::MIN, 0);
    let mut rest = keys;
    while let [key, others @ ..] = rest {
        if *key == NOT_FINITE {
            return Err(KnotError::NotFinite);
        }
        if *key < before {
            return Err(KnotError::Decreasing);
        }
        same = if *key == before { same + 1 } else { 1 };
        if same > order {
            return Err(KnotError::Multiplicity);
        }
        (before, rest) = (*key, others);
    }
    Ok(())
}

/// How many spans between neighbours aren't empty.
const fn count(keys: &[i64]) -> usize {
    let mut spans = 0;
    let mut rest = keys;
    while let [low, others @ ..] = rest {
        if let [high, ..] = others
            && *low < *high
        {
            spans += 1;
        }
        rest = others;
    }
    spans
}

/// The elements of a slice from one index to another, as far as they exist.
const fn between<T>(all: &[T], from: usize, to: usize) -> &[T] {
    let to = if to < all.len() { to } else { all.len() };
    if from <= to { all.split_at(from).1.split_at(to - from).0 } else { &[] }
}

/// Which knots the j-th one of those around a period comes from: `knots[to]` is `knots[low]` and the
/// distance of `knots[from]` from `knots[high]`. First those before the period, then those behind it, both
/// outwards; `[to, low, from, high]`.
const fn outward(j: usize, order: usize, breaks: usize) -> [usize; 4] {
    let (first, last) = (order - 1, order + breaks - 2);
    if j < first {
        let to = first - 1 - j;
        [to, first, to + breaks - 1, last]
    } else {
        let from = j + 1;
        [from + breaks - 1, last, from, first]
    }
}

macro_rules! constructors {
    ($([$($generics:tt)*] $Scalar:ty),+) => {$(
        impl<$($generics)* const K: usize, const N: usize> Knots<$Scalar, K, N> {
            /// Any knots.
            ///
            /// # Errors
            /// A [`KnotError`] where these are no knots of order `K`.
            pub const fn new(knots: &[$Scalar]) -> Result<Self, KnotError> {
                if knots.len() > N {
                    return Err(KnotError::TooMany);
                }
                Self::checked(placed(knots, 0, ConstOps::<$Scalar>::ZERO), knots.len())
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
                Self::even(points, from, step, false)
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
                Self::even(points, from, to, true)
            }

            /// Knots at equal distances: from step to step, or up to a clamped end.
            const fn even(
                points: usize,
                from: $Scalar,
                last: $Scalar,
                is_clamped: bool,
            ) -> Result<Self, KnotError> {
                if points > N || points + K > N {
                    return Err(KnotError::TooMany);
                }
                if is_clamped && points < K {
                    return Err(KnotError::TooFew);
                }
                let [low, high] = ConstOps::<$Scalar>::keys(&[from, last]);
                if !are_finite(&[low, high]) {
                    return Err(KnotError::NotFinite);
                }
                if is_clamped && low >= high {
                    return Err(KnotError::Decreasing);
                }
                let mut knots = [from; N];
                let mut i = 0;
                while i < N && i < points + K {
                    let knot = if !is_clamped {
                        ConstOps::<$Scalar>::step(from, last, i)
                    } else if i >= points {
                        Some(last)
                    } else {
                        let index = (i + 1).saturating_sub(K);
                        ConstOps::<$Scalar>::divided(from, last, index, points + 1 - K)
                    };
                    let Some(knot) = knot else { return Err(KnotError::TooFar) };
                    knots[i] = knot;
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
                if length < 2 {
                    return Err(KnotError::TooFew);
                }
                let mut knots = placed(breaks, K - 1, ConstOps::<$Scalar>::ZERO);
                if !are_finite(&ConstOps::<$Scalar>::keys(&knots)) {
                    return Err(KnotError::NotFinite);
                }
                let mut j = 0;
                while j < 2 * (K - 1) {
                    let [to, low, from, high] = outward(j, K, length);
                    let knot = ConstOps::<$Scalar>::shifted(knots[low], knots[from], knots[high]);
                    let Some(knot) = knot else { return Err(KnotError::TooFar) };
                    knots[to] = knot;
                    j += 1;
                }
                Self::checked(knots, length + 2 * (K - 1))
            }

            const fn checked(mut knots: [$Scalar; N], length: usize) -> Result<Self, KnotError> {
                const { assert!(K >= 1 && K <= 32 && N > K) };
                if length <= K {
                    return Err(KnotError::TooFew);
                }
                if let Err(error) = check(between(&ConstOps::<$Scalar>::keys(&knots), 0, length), K) {
                    return Err(error);
                }
                if !ConstOps::<$Scalar>::is_in_range_of_knots(knots[0], knots[length - 1]) {
                    return Err(KnotError::TooFar);
                }
                // What isn't used is not below any parameter but the last, so a search needs no
                // length.
                let mut i = length;
                while i < N {
                    knots[i] = knots[length - 1];
                    i += 1;
                }
                Ok(Self { knots, length })
            }

            /// How many spans of the domain are not empty: how many polynomials a curve has.
            #[must_use]
            pub const fn spans(&self) -> usize {
                count(between(&ConstOps::<$Scalar>::keys(&self.knots), K - 1, self.points() + 1))
            }
        }
    )+};
}

constructors!([] f32, [] f64, [F: Fraction,] FixedI32<F>);
