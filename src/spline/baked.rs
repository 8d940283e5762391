//! Curves as polynomials, span by span.

use super::bake::{Bake, polynomial};
use super::blend::Blend;
use super::curve::{Curve, direction};
use super::domain::{Domain, Outside};
use super::long::Long;
use super::point::Point;
use super::shape::Shape;
use super::{CurveError, EvaluateError};
use crate::geom::Vec3;
use crate::scalar::{Check, FixedI32, Fraction};
use core::hint::select_unpredictable;

/// A B-spline curve of the order `K` as `SPANS` polynomials, one for each span of its domain that
/// is not empty: [`Knots::spans`](super::Knots::spans) counts them.
///
/// A value is a search for the span and Horner's rule about its middle: in fixed point in products of
/// 32 bits, and in floating point with a polynomial for each half of the span. Baking is done in double words of `f64`; in a constant, that costs
/// nothing. For errors see [`value`](Self::value) and [`derivative`](Self::derivative).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Baked<P: Point, const K: usize, const SPANS: usize> {
    /// Where the spans start.
    starts: [Key<P>; SPANS],
    end: Key<P>,
    pieces: [Parts<P, K>; SPANS],
}

type Key<P> = <<P as Point>::Scalar as Blend>::Key;

type Parts<P, const K: usize> = <<P as Point>::Scalar as Blend>::Parts<Piece<P, K>>;

/// The polynomial of a span, or of a part of it.
#[doc(hidden)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece<P: Point, const K: usize> {
    start: Key<P>,
    frame: <P::Scalar as Blend>::Frame,
    /// Of y^{k−1} first.
    coefficients: [P::Array<<P::Scalar as Blend>::Coefficient>; K],
    base: P::Array<<P::Scalar as Blend>::Base>,
}

macro_rules! bake {
    ([$($generics:tt)*] $Scalar:ty, $Point:ty, $D:expr, $PARTS:literal) => {
        impl<$($generics)* const K: usize, const C: usize, const N: usize> Curve<$Point, K, C, N> {
            /// The curve's polynomials, for a constant: they don't follow when a control point is
            /// moved.
            ///
            /// With twice as many `SPANS` as the curve has, each is divided into two polynomials,
            /// and so on: rounding errors become smaller.
            ///
            /// # Errors
            /// [`CurveError::SpanCount`] unless `SPANS` is the number of the curve's spans, or a
            /// multiple of it;
            /// [`CurveError::TooFar`] in fixed point, if a span goes so far that fewer than four
            /// guard bits are left: in `I16F16` control points some 150 units apart always
            /// are near enough for a cubic.
            pub const fn bake<const SPANS: usize>(
                &self,
            ) -> Result<Baked<$Point, K, SPANS>, CurveError> {
                const { assert!(SPANS > 0) };
                let knots = &self.knots;
                let spans = knots.spans();
                if spans == 0 || spans > SPANS || SPANS % spans != 0 {
                    return Err(CurveError::SpanCount);
                }
                let parts = SPANS / spans;
                let from = knots.knots[0];
                let mut end = Bake::<$Scalar>::key(from);
                let mut pieces = [[Piece {
                    start: end,
                    frame: Bake::<$Scalar>::EMPTY,
                    coefficients: [[Bake::<$Scalar>::ZERO; $D]; K],
                    base: [Bake::<$Scalar>::NO_BASE; $D],
                }; $PARTS]; SPANS];
                let mut starts = [end; SPANS];
                let (mut span, mut part, mut piece) = (K - 1, 0, 0);
                while piece < SPANS && span + K < knots.length && span + K < N {
                    let (low, high) = (knots.knots[span], knots.knots[span + 1]);
                    if part == parts || Bake::<$Scalar>::f64(low) >= Bake::<$Scalar>::f64(high) {
                        span += 1;
                        part = 0;
                        continue;
                    }
                    let mut i = 0;
                    while i < $PARTS {
                        let (at, count) =
                            (part * $PARTS + i, parts * $PARTS);
                        let start = Check::<$Scalar>::part(low, high, at, count);
                        let stop = Check::<$Scalar>::part(low, high, at + 1, count);
                        match self.piece(span, start, stop) {
                            Ok(made) => pieces[piece][i] = made,
                            Err(error) => return Err(error),
                        }
                        i += 1;
                    }
                    starts[piece] = pieces[piece][0].start;
                    piece += 1;
                    part += 1;
                    end = Bake::<$Scalar>::key(high);
                }
                Ok(Baked { starts, end, pieces })
            }

            const fn piece(
                &self,
                span: usize,
                start: $Scalar,
                stop: $Scalar,
            ) -> Result<Piece<$Point, K>, CurveError> {
                let knots = &self.knots.knots;
                let frame = Bake::<$Scalar>::frame(start, stop);
                let unit = Bake::<$Scalar>::unit(frame);
                let (mut low, mut high) = ([Long::ZERO; K], [Long::ZERO; K]);
                let mut points = [[0.0; K]; $D];
                let mut i = 0;
                while i < K {
                    low[i] = Bake::<$Scalar>::distance(knots[span + 1 + i - K], frame, start);
                    high[i] = Bake::<$Scalar>::distance(knots[span + 1 + i], frame, start);
                    let point = Shape::<$Point>::coordinates(self.points[span + 1 + i - K]);
                    let mut d = 0;
                    while d < $D {
                        points[d][i] = Bake::<$Scalar>::f64(point[d]);
                        d += 1;
                    }
                    i += 1;
                }
                let mut polynomials = [[Long::ZERO; K]; $D];
                let mut d = 0;
                while d < $D {
                    polynomials[d] = polynomial(low, high, points[d], unit);
                    d += 1;
                }
                match Bake::<$Scalar>::coefficients(polynomials, frame) {
                    Ok((frame, coefficients, base)) => {
                        let start = Bake::<$Scalar>::key(start);
                        Ok(Piece { start, frame, coefficients, base })
                    }
                    Err(error) => Err(error),
                }
            }
        }
    };
}

bake!([] f32, f32, 1, 2);
bake!([] f32, Vec3<f32>, 3, 2);
bake!([const D: usize,] f32, [f32; D], D, 2);
bake!([] f64, f64, 1, 2);
bake!([] f64, Vec3<f64>, 3, 2);
bake!([const D: usize,] f64, [f64; D], D, 2);
bake!([F: Fraction,] FixedI32<F>, FixedI32<F>, 1, 1);
bake!([F: Fraction,] FixedI32<F>, Vec3<FixedI32<F>>, 3, 1);
bake!([F: Fraction, const D: usize,] FixedI32<F>, [FixedI32<F>; D], D, 1);

impl<P: Point, const K: usize, const SPANS: usize> Baked<P, K, SPANS> {
    /// The parameters of the curve.
    #[must_use]
    #[inline]
    pub fn domain(&self) -> Domain<P::Scalar> {
        let from = self.starts.first().copied().unwrap_or(self.end);
        Domain { from: P::Scalar::from_key(from), to: P::Scalar::from_key(self.end) }
    }

    /// The curve's point at a parameter.
    ///
    /// In floating point it is within 3.1 units in the last place of the largest coordinate of its
    /// control points, for orders up to 6; except that near a clamped end, where control points
    /// alternate at full size, a search finds 3.7 for order 4 and 6 for orders 5 and 6. In fixed point
    /// it is within 0.6 units.
    ///
    /// # Errors
    /// [`EvaluateError::NotFinite`]; [`EvaluateError::Outside`] if t is outside of the domain and
    /// the policy says so; [`EvaluateError::Overflow`] only outside of the domain.
    #[inline]
    pub fn value(&self, t: P::Scalar, outside: Outside) -> Result<P, EvaluateError> {
        if matches!(outside, Outside::Extrapolate) {
            return self.derivative(0, t, outside);
        }
        let key = t.key();
        let is_inside = self.starts.first().is_some_and(|from| *from <= key) && key <= self.end;
        let t = if is_inside { t } else { self.domain().place(t, outside)? };
        Ok(self.piece(t.key()).map_or(P::ORIGIN, |piece| piece.value(t)))
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
        let Some(piece) = self.piece(t.key()).filter(|_| order < K) else {
            return Ok(P::ORIGIN);
        };
        piece.derivative(order, t).ok_or(EvaluateError::Overflow)
    }

    /// The piece at a parameter, or nearest to it.
    #[inline]
    fn piece(&self, key: Key<P>) -> Option<&Piece<P, K>> {
        let mut spans = self.starts.iter().zip(&self.pieces);
        let (_, first) = spans.next()?;
        // Without a jump, and without an index that would have to be checked.
        let parts =
            spans.fold(first, |at, (start, parts)| select_unpredictable(*start <= key, parts, at));
        let (first, later) = parts.as_ref().split_first()?;
        Some(
            later
                .iter()
                .fold(first, |at, piece| select_unpredictable(piece.start <= key, piece, at)),
        )
    }
}

impl<S: Blend, const K: usize, const SPANS: usize> Baked<Vec3<S>, K, SPANS> {
    /// The direction of the curve at a parameter, as a vector of length 1.
    ///
    /// # Errors
    /// As [`derivative`](Self::derivative); [`EvaluateError::Stationary`] where the first derivative
    /// is zero.
    pub fn tangent(&self, t: S, outside: Outside) -> Result<Vec3<S::Unit>, EvaluateError> {
        direction(self.derivative(1, t, outside)?)
    }
}

impl<P: Point, const K: usize> Piece<P, K> {
    #[inline]
    fn value(&self, t: P::Scalar) -> P {
        let local = P::Scalar::local(t, &self.frame);
        let Some((first, rest)) = self.coefficients.split_first() else { return P::ORIGIN };
        let mut sums = *first;
        for coefficients in rest {
            for (sum, c) in sums.as_mut().iter_mut().zip(coefficients.as_ref()) {
                *sum = P::Scalar::horner(*sum, local, *c);
            }
        }
        let mut point = P::ORIGIN.coordinates();
        let values = sums.as_ref().iter().zip(self.base.as_ref());
        for (x, (sum, base)) in point.as_mut().iter_mut().zip(values) {
            *x = P::Scalar::baked(*sum, *base, &self.frame);
        }
        P::from_coordinates(point)
    }

    /// At any parameter.
    fn derivative(&self, order: usize, t: P::Scalar) -> Option<P> {
        let start = P::Scalar::from_key(self.start);
        let mut point = P::ORIGIN.coordinates();
        for (d, (x, base)) in point.as_mut().iter_mut().zip(self.base.as_ref()).enumerate() {
            let powers = self.coefficients.iter().rev().enumerate().rev();
            let terms = powers
                .take_while(|(power, _)| *power >= order)
                .filter_map(|(power, of)| Some((power, *of.as_ref().get(d)?)));
            *x = P::Scalar::extended(terms, *base, order, t, start, &self.frame)?;
        }
        Some(P::from_coordinates(point))
    }
}
