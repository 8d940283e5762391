//! Basis functions by the recurrence of Cox (1972) and de Boor (1972).
//!
//! With t_i ≤ t < t_{i+1} where N_{i,1} is 1 and not 0,
//!
//! ```text
//! N_{i,k}(t) = (t − t_i)/(t_{i+k−1} − t_i) N_{i,k−1}(t) + (t_{i+k} − t)/(t_{i+k} − t_{i+1}) N_{i+1,k−1}(t)
//! N'_{i,k}(t) = (k−1) (N_{i,k−1}(t)/(t_{i+k−1} − t_i) − N_{i+1,k−1}(t)/(t_{i+k} − t_{i+1}))
//! ```
//!
//! where a quotient whose divisor is 0 is 0. M. G. Cox, *The numerical evaluation of B-splines*, IMA
//! Journal of Applied Mathematics 10 (1972); C. de Boor, *On calculating with B-splines*, Journal of
//! Approximation Theory 6 (1972); the derivative is (4) of section X of his *A Practical Guide to
//! Splines* (1978). All terms of a value are positive, so nothing cancels.

use super::knots::Knots;
use super::scalar::SplineScalar;
use crate::scalar::Scalar;

/// The basis functions that are not zero on a span, or their derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NonZero<S: Scalar, const K: usize> {
    /// The index j of the span t_j ≤ t < t_{j+1}.
    pub span: usize,
    /// The index of the first basis function.
    pub first: usize,
    values: [S; K],
    skip: usize,
    count: usize,
}

impl<S: Scalar, const K: usize> NonZero<S, K> {
    /// The values of the basis functions `first`, `first + 1` and so on: K of them inside of the
    /// domain, and fewer outside.
    #[must_use]
    pub fn values(&self) -> &[S] {
        self.values.get(self.skip..self.skip.saturating_add(self.count)).unwrap_or_default()
    }
}

impl<S: SplineScalar, const K: usize, const N: usize> Knots<S, K, N> {
    /// The basis function N_{index,k} at a parameter, over all knots and not only in the domain of
    /// a curve.
    ///
    /// It is continuous from the right, and at the last knot from the left. It is 0 where t is not
    /// between the function's knots, and for an index that doesn't exist.
    ///
    /// ```
    /// use scancsg::spline::Knots;
    ///
    /// // Order 3. On [1, 2) the first function is (t−1)²/3, on [2, 4) it is
    /// // (4−t)(t−1)/6 + (t−2)(7−t)/10, on [4, 7) it is (7−t)²/15.
    /// let knots = Knots::<f64, 3, 7>::new(&[1.0, 2.0, 4.0, 7.0, 8.0, 10.0, 12.0])?;
    /// assert_eq!(knots.points(), 4);
    /// assert_eq!(knots.basis(0, 1.0), 0.0);
    /// assert_eq!(knots.basis(0, 2.0), 1.0 / 3.0);
    /// assert_eq!(knots.basis(0, 4.0), 3.0 / 5.0);
    /// assert_eq!(knots.basis(0, 7.0), 0.0);
    /// assert!(knots.basis(0, 7.0_f64.next_down()) > 0.0);
    /// # Ok::<(), scancsg::spline::KnotError>(())
    /// ```
    #[must_use]
    pub fn basis(&self, index: usize, t: S) -> S {
        self.basis_derivative(index, 0, t)
    }

    /// A derivative of the basis function N_{index,k}; of order 0 the function itself.
    ///
    /// Continuous from the right, at the last knot from the left. A derivative of order K or more
    /// is 0. One that leaves the number type's range, over knots that nearly coincide, is held inside
    /// it, but has no correct digit then.
    #[must_use]
    pub fn basis_derivative(&self, index: usize, order: usize, t: S) -> S {
        let Some(all) = self.non_zero_derivatives(order, t) else { return S::ZERO };
        let value = index.checked_sub(all.first).and_then(|i| all.values().get(i));
        value.copied().unwrap_or(S::ZERO)
    }

    /// All basis functions that are not zero around a parameter. `None` where t is not between
    /// the first and the last knot.
    #[must_use]
    pub fn non_zero(&self, t: S) -> Option<NonZero<S, K>> {
        self.non_zero_derivatives(0, t)
    }

    /// The derivatives of this order of all basis functions that are not zero around a parameter, as
    /// [`basis_derivative`](Self::basis_derivative). `None` where t is not between the first and the
    /// last knot.
    #[must_use]
    pub fn non_zero_derivatives(&self, order: usize, t: S) -> Option<NonZero<S, K>> {
        let knots = self.as_slice();
        let span = self.span(t)?;
        // The functions span − K + 1 to span, as far as they exist.
        let (first, skip) = match (span + 1).checked_sub(K) {
            Some(first) => (first, 0),
            None => (0, K - 1 - span),
        };
        let count = (span + 1).min(self.points()).saturating_sub(first);
        let values = triangle(knots, span, order, t);
        Some(NonZero { span, first, values, skip, count })
    }
}

/// The functions span − K + 1 to span. Knots that don't exist count as the first or the last one,
/// which has no influence on functions all of whose knots exist.
fn triangle<S: SplineScalar, const K: usize>(
    knots: &[S],
    span: usize,
    order: usize,
    t: S,
) -> [S; K] {
    if order >= K {
        return [S::ZERO; K];
    }
    let knot = |i: usize| knots.get(i).or(knots.last()).copied().unwrap_or(t);
    // The functions of a level in descending order: functions[i] is N_{span−i, level}.
    let mut functions = [S::NONE; K];
    if let Some(first) = functions.first_mut() {
        *first = S::FULL;
    }
    for level in 1..K {
        let differs = level >= K - order;
        // What a function gives to its right neighbour's place: none to the very first.
        let mut from_right = S::NONE;
        for (i, function) in functions.iter_mut().enumerate().take(level) {
            // N_{span−i, level}, whose knots are t_{span−i} to t_{span−i+level}.
            let (x, ends) = (*function, [knot(span.saturating_sub(i)), knot(span + level - i)]);
            let [own, left] = if differs {
                let slope = S::climb(x, level as u16, ends);
                [slope, -slope]
            } else {
                S::split(x, t, ends)
            };
            *function = S::add_weights(own, from_right);
            from_right = left;
        }
        if let Some(last) = functions.get_mut(level) {
            *last = S::add_weights(S::NONE, from_right);
        }
    }
    functions.reverse();
    functions.map(S::from_weight)
}
