//! Constructors of knot sequences, for constants: one set for each number type.

use super::Knots;
use crate::scalar::{ConstOps, per_scalar};
use crate::spline::error::KnotError;
use crate::spline::scalar::constant::repeated;

per_scalar! { $S: impl[const K: usize, const N: usize] Knots<$S, K, N> {
    /// Any knots.
    ///
    /// # Errors
    /// A [`KnotError`] where these are no knots of order `K`.
    pub const fn new(knots: &[$S]) -> Result<Self, KnotError> {
        Self::checked(repeated(knots, 0, knots.len(), ConstOps::<$S>::ZERO), knots.len())
    }

    /// Knots at equal distances, `from`, `from + step` and so on: those of *cardinal*
    /// splines with so many control points.
    ///
    /// # Errors
    /// [`KnotError::TooMany`], [`KnotError::NotFinite`], [`KnotError::TooFar`];
    /// [`KnotError::TooFew`] without a control point; [`KnotError::Decreasing`] or
    /// [`KnotError::Multiplicity`] if `step` is not positive.
    pub const fn uniform(points: usize, from: $S, step: $S) -> Result<Self, KnotError> {
        if !ConstOps::<$S>::is_finite(from) || !ConstOps::<$S>::is_finite(step) {
            return Err(KnotError::NotFinite);
        }
        let length = points.saturating_add(K);
        let mut knots = [from; N];
        let mut i = 0;
        while i < N && i < length {
            let knot = ConstOps::<$S>::moved(from, [ConstOps::<$S>::ZERO, step], i);
            let Some(knot) = knot else { return Err(KnotError::TooFar) };
            knots[i] = knot;
            i += 1;
        }
        Self::checked(knots, length)
    }

    /// Knots of a curve that begins in the first of so many control points and ends in
    /// the last one: `K` times `from`, then at equal distances, then `K` times `to`.
    ///
    /// # Errors
    /// [`KnotError::TooMany`], [`KnotError::NotFinite`], [`KnotError::TooFar`];
    /// [`KnotError::TooFew`] with fewer control points than the order;
    /// [`KnotError::Decreasing`] unless `from < to`.
    pub const fn clamped_uniform(points: usize, from: $S, to: $S) -> Result<Self, KnotError> {
        if points < K {
            return Err(KnotError::TooFew);
        }
        if !ConstOps::<$S>::is_finite(from) || !ConstOps::<$S>::is_finite(to) {
            return Err(KnotError::NotFinite);
        }
        if !ConstOps::<$S>::is_below(from, to) {
            return Err(KnotError::Decreasing);
        }
        if !ConstOps::<$S>::is_finite(ConstOps::<$S>::difference(to, from)) {
            return Err(KnotError::TooFar);
        }
        let mut knots = [to; N];
        let mut i = 0;
        while i < N && i < points {
            let index = (i + 1).saturating_sub(K);
            knots[i] = ConstOps::<$S>::divided([from, to], index, points - K + 1);
            i += 1;
        }
        Self::checked(knots, points.saturating_add(K))
    }

    /// Knots of a closed curve, from where its polynomials meet: m + 1 breaks b₀ … b_m make
    /// m spans and m + 2K − 1 knots; the domain is from b₀ to b_m, the period its length. The
    /// curve has m + K − 1 control points, of which the last K − 1 repeat the first.
    ///
    /// # Errors
    /// As [`new`](Self::new); [`KnotError::TooFew`] for fewer than two breaks.
    pub const fn periodic(breaks: &[$S]) -> Result<Self, KnotError> {
        let length = breaks.len();
        if length > N || length + 2 * (K - 1) > N {
            return Err(KnotError::TooMany);
        }
        if length < 2 {
            return Err(KnotError::TooFew);
        }
        if let Err(error) = Self::check(breaks) {
            return Err(error);
        }
        let mut knots = repeated(breaks, K - 1, length, ConstOps::<$S>::ZERO);
        let (first, last) = (K - 1, K + length - 2);
        let mut i = 1;
        while i < K {
            let (start, end) = (knots[first], knots[last]);
            // As far outside of one end as others are inside of the other end.
            let before = ConstOps::<$S>::moved(start, [end, knots[last - i]], 1);
            let behind = ConstOps::<$S>::moved(end, [start, knots[first + i]], 1);
            let (Some(before), Some(behind)) = (before, behind) else {
                return Err(KnotError::TooFar);
            };
            (knots[first - i], knots[last + i]) = (before, behind);
            i += 1;
        }
        Self::checked(knots, length + 2 * (K - 1))
    }

    const fn checked(mut knots: [$S; N], length: usize) -> Result<Self, KnotError> {
        const { assert!(K >= 1 && K <= 32 && N > K) };
        if length <= K {
            return Err(KnotError::TooFew);
        }
        let Some((used, rest)) = knots.split_at_mut_checked(length) else {
            return Err(KnotError::TooMany);
        };
        if let Err(error) = Self::check(used) {
            return Err(error);
        }
        let &mut [first, .., last] = used else { return Err(KnotError::TooFew) };
        if !ConstOps::<$S>::is_finite(ConstOps::<$S>::difference(last, first)) {
            return Err(KnotError::TooFar);
        }
        // What isn't used is not below any parameter but the last, so a search needs no length.
        let mut i = 0;
        while i < rest.len() {
            rest[i] = last;
            i += 1;
        }
        Ok(Self { knots, length })
    }

    /// Whether these can be neighbours in a knot sequence.
    const fn check(knots: &[$S]) -> Result<(), KnotError> {
        let mut i = 0;
        while i < knots.len() {
            if !ConstOps::<$S>::is_finite(knots[i]) {
                return Err(KnotError::NotFinite);
            }
            if i > 0 && ConstOps::<$S>::is_below(knots[i], knots[i - 1]) {
                return Err(KnotError::Decreasing);
            }
            if i >= K && !ConstOps::<$S>::is_below(knots[i - K], knots[i]) {
                return Err(KnotError::Multiplicity);
            }
            i += 1;
        }
        Ok(())
    }

    /// How many spans of the domain are not empty: how many polynomials a curve has.
    #[must_use]
    pub const fn spans(&self) -> usize {
        let (mut spans, mut i) = (0, K);
        while i < N && i <= self.points() {
            spans += ConstOps::<$S>::is_below(self.knots[i - 1], self.knots[i]) as usize;
            i += 1;
        }
        spans
    }
} }
