//! Curves as polynomials, piece by piece.

mod fixed;
mod float;
mod layout;
pub(super) mod piece;
mod polynomial;
pub(super) mod search;

use super::domain::{Domain, Outside};
use super::error::EvaluateError;
use super::point::{Point, direction};
use super::scalar::order::Ordered;
use super::scalar::{Arithmetic, SplineScalar};
use crate::geom::Vec3;
use piece::PieceOf;

/// A B-spline curve of the order `K` as polynomials, for `SPANS` spans: those of its domain that are
/// not empty, which [`Knots::spans`](super::Knots::spans) counts.
///
/// A value is a search for the span and Horner's rule: in fixed point about the span's middle in
/// products of 32 bits, and in floating point with three polynomials to a span, the first and the last
/// one for a quarter of it. Baking is done in double words of `f64`; in a constant, that costs nothing. For
/// errors see [`value`](Self::value) and [`derivative`](Self::derivative).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Baked<P: Point, const K: usize, const SPANS: usize> {
    /// Where the pieces start: a [tree](search). Keys are counted from `outside` on, so that all parameters
    /// outside of the domain are before those inside.
    pub(super) nodes: Pieces<P, [Key<P>; 2], SPANS>,
    /// The key behind that of the end.
    pub(super) outside: Key<P>,
    pub(super) from: Key<P>,
    pub(super) end: Key<P>,
    pub(super) pieces: Pieces<P, PieceOf<P, K>, SPANS>,
}

type Key<P> = <<P as Point>::Scalar as Ordered>::Key;

type Pieces<P, T, const SPANS: usize> = <<P as Point>::Scalar as Arithmetic>::Pieces<T, SPANS>;

impl<P: Point, const K: usize, const SPANS: usize> Baked<P, K, SPANS> {
    /// The parameters of the curve.
    #[must_use]
    #[inline]
    pub fn domain(&self) -> Domain<P::Scalar> {
        Domain { from: P::Scalar::from_key(self.from), to: P::Scalar::from_key(self.end) }
    }

    /// The curve's point at a parameter.
    ///
    /// In floating point it is within 3.1 units in the last place of the largest coordinate of its
    /// control points, for orders up to 6: no long search for the worst curve has found more. In fixed
    /// point it is within 0.6 units.
    ///
    /// # Errors
    /// [`EvaluateError::NotFinite`]; [`EvaluateError::Outside`] if t is outside of the domain and
    /// the policy says so; [`EvaluateError::Overflow`] only outside of the domain.
    #[inline]
    pub fn value(&self, t: P::Scalar, outside: Outside) -> Result<P, EvaluateError> {
        if matches!(outside, Outside::Extrapolate) {
            return self.derivative(0, t, outside);
        }
        let (t, piece) = match self.piece(t.after(self.outside)) {
            Some(piece) => (t, Some(piece)),
            // For a parameter outside, and for NaN.
            None => self.moved(t, outside),
        };
        piece.map(|piece| piece::value::<P, K>(piece, t)).ok_or_else(|| self.refusal(t, outside))
    }

    /// The parameter to evaluate the curve at in place of one outside, and the piece that it belongs to.
    ///
    /// The error is left to another function: these two come back in registers, and the quick path needs
    /// no place on the stack.
    #[cold]
    #[inline(never)]
    fn moved(&self, t: P::Scalar, outside: Outside) -> (P::Scalar, Option<&PieceOf<P, K>>) {
        let t = self.domain().place(t, outside).unwrap_or(t);
        (t, self.piece(t.after(self.outside)))
    }

    #[cold]
    #[inline(never)]
    fn refusal(&self, t: P::Scalar, outside: Outside) -> EvaluateError {
        self.domain().place(t, outside).err().unwrap_or(EvaluateError::Outside)
    }

    /// A derivative of the curve by its parameter; of order 0 it is the value, of order `K` or more
    /// zero. At a knot where it jumps it is that of the span behind, at the end of the domain that of
    /// the span in front.
    ///
    /// It is Horner's rule with the derivative's coefficients. In floating point it is within 4
    /// units in the last place of the largest coordinate of the derivative's control points. In fixed
    /// point it is that of a polynomial with coefficients of at least four bits behind the type's last
    /// one: for cubics, the first derivative is within half a unit and 0.18/w units more, on a span
    /// of length w.
    ///
    /// # Errors
    /// As [`value`](Self::value), and [`EvaluateError::Overflow`] for a derivative too large for its
    /// type.
    #[inline(never)]
    pub fn derivative(
        &self,
        order: usize,
        t: P::Scalar,
        outside: Outside,
    ) -> Result<P, EvaluateError> {
        let t = self.domain().place(t, outside)?;
        let nearest = self.domain().place(t, Outside::Clamp)?;
        let Some(piece) = self.piece(nearest.after(self.outside)).filter(|_| order < K) else {
            return Ok(P::ORIGIN);
        };
        piece::derivative::<P, K>(piece, order, t).ok_or(EvaluateError::Overflow)
    }

    /// The piece that a parameter of the domain belongs to.
    #[inline(always)] // a call would cost the quick path registers
    fn piece(&self, key: Key<P>) -> Option<&PieceOf<P, K>> {
        let nodes = P::Scalar::pieces(&self.nodes).as_flattened();
        search::find(nodes, P::Scalar::pieces(&self.pieces), &key)
    }
}

impl<S: SplineScalar, const K: usize, const SPANS: usize> Baked<Vec3<S>, K, SPANS> {
    /// The direction of the curve at a parameter, as a vector of length 1.
    ///
    /// # Errors
    /// As [`derivative`](Self::derivative); [`EvaluateError::Stationary`] where the first derivative
    /// is zero.
    pub fn tangent(&self, t: S, outside: Outside) -> Result<Vec3<S::Unit>, EvaluateError> {
        direction(self.derivative(1, t, outside)?)
    }
}

#[cfg(feature = "defmt")]
impl<P: Point, const K: usize, const SPANS: usize> defmt::Format for Baked<P, K, SPANS> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "Baked of {} spans, order {}, {}", SPANS, K, self.domain());
    }
}
