//! Parameters of a curve, inside of its domain and outside.

use super::error::EvaluateError;
use super::scalar::SplineScalar;
use crate::scalar::Scalar;

/// What to do with a parameter outside of a curve's domain.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Outside {
    /// It is an error: [`EvaluateError::Outside`].
    Error,
    /// The nearer end of the domain is taken in its place.
    Clamp,
    /// The polynomial of the first or last span is continued.
    Extrapolate,
    /// The domain is the period of a closed curve. (One that isn't closed jumps where it begins anew.)
    Wrap,
}

/// The parameters of a curve: t_{k−1} to t_n. Both ends belong to it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Domain<S: Scalar> {
    /// Where the curve begins.
    pub from: S,
    /// Where it ends.
    pub to: S,
}

impl<S: SplineScalar> Domain<S> {
    /// Whether a parameter is inside.
    #[must_use]
    #[inline]
    pub fn contains(&self, t: S) -> bool {
        self.from <= t && t <= self.to
    }

    /// The parameter to evaluate a curve at.
    ///
    /// # Errors
    /// [`EvaluateError::Outside`] if that is what the policy says;
    /// [`EvaluateError::NotFinite`]; [`EvaluateError::Overflow`] where the distance of t from the
    /// domain is too large to be divided by the period.
    #[inline]
    pub fn place(&self, t: S, outside: Outside) -> Result<S, EvaluateError> {
        if self.contains(t) {
            return Ok(t);
        }
        if !t.is_finite() {
            return Err(EvaluateError::NotFinite);
        }
        match outside {
            Outside::Error => Err(EvaluateError::Outside),
            Outside::Clamp => Ok(if t < self.from { self.from } else { self.to }),
            Outside::Extrapolate => Ok(t),
            Outside::Wrap if !t.minus(self.from).is_finite() => Err(EvaluateError::Overflow),
            Outside::Wrap => Ok(S::wrap(t, self.from, self.to)),
        }
    }
}
