//! Knot sequences.

mod constructors;

use super::domain::Domain;
use super::scalar::SplineScalar;
use crate::scalar::Scalar;

/// A knot sequence with room for `N` knots, of splines of the order `K`: of degree `K − 1`.
///
/// Knots are in ascending order; equal ones are allowed, up to `K` of them. No tolerance says when
/// knots are equal: they are, or they aren't.
///
/// Bad knots of a constant are found while compiling, and at run time they are a
/// [`KnotError`](super::KnotError):
///
/// ```compile_fail,E0080
/// use scancsg::{constant, spline::Knots};
///
/// const KNOTS: Knots<f32, 3, 6> = constant!(Knots::<f32, 3, 6>::new(&[0.0, 0.0, 0.0, 1.0, 0.5, 2.0]));
/// # let _ = KNOTS;
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Knots<S: Scalar, const K: usize, const N: usize> {
    /// The knots, and behind them the last one again.
    pub(in crate::spline) knots: [S; N],
    pub(in crate::spline) length: usize,
}

impl<S: Scalar, const K: usize, const N: usize> Knots<S, K, N> {
    /// The degree + 1 of the splines.
    pub const ORDER: usize = K;

    /// How many knots there are.
    #[must_use]
    #[allow(clippy::len_without_is_empty)] // there is always more than one
    pub const fn len(&self) -> usize {
        self.length
    }

    /// How many basis functions there are, and control points of a curve.
    #[must_use]
    pub const fn points(&self) -> usize {
        self.length.saturating_sub(K)
    }

    /// The knots in ascending order.
    #[must_use]
    #[inline]
    pub fn as_slice(&self) -> &[S] {
        self.knots.get(..self.length).unwrap_or(&self.knots)
    }
}

impl<S: SplineScalar, const K: usize, const N: usize> Knots<S, K, N> {
    /// From t_{k−1} to t_n, both included: where K basis functions add up to 1. `None` if there
    /// are fewer than K basis functions or if it has no length.
    #[must_use]
    #[inline]
    pub fn domain(&self) -> Option<Domain<S>> {
        let knots = self.as_slice();
        let (from, to) = (*knots.get(K - 1)?, *knots.get(self.points())?);
        (from < to).then_some(Domain { from, to })
    }

    /// The index j of the span t_j ≤ t < t_{j+1} that a parameter is in, or of the last one that is
    /// not empty for the last knot itself. `None` outside of all knots.
    #[must_use]
    pub fn span(&self, t: S) -> Option<usize> {
        let knots = self.as_slice();
        let (first, last) = (*knots.first()?, *knots.last()?);
        if !(first <= t && t <= last) {
            return None;
        }
        let after = if t < last {
            knots.partition_point(|&knot| knot <= t)
        } else {
            knots.partition_point(|&knot| knot < last)
        };
        after.checked_sub(1)
    }

    /// The index j of the span of a domain up to `end` that t is in or nearest to, of those that
    /// aren't empty.
    #[inline]
    pub(in crate::spline) fn span_of_domain(&self, t: S, end: S) -> usize {
        // Between the domain's ends t_{k−1} and t_n, and what is not used.
        let inside = self.knots.get(K..N.saturating_sub(K)).unwrap_or_default();
        let before = if t < end {
            // A few comparisons without a jump are faster than a search.
            if N - K <= K + 16 {
                inside.iter().map(|knot| usize::from(*knot <= t)).sum()
            } else {
                inside.partition_point(|knot| *knot <= t)
            }
        } else {
            // Spans that begin at the end are empty, or behind it.
            inside.partition_point(|knot| *knot < end)
        };
        K - 1 + before
    }
}
