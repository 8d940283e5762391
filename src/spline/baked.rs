//! Curves as polynomials, span by span.

use super::bake::{Bake, polynomial};
use super::blend::{Blend, horner};
use super::curve::{Curve, direction};
use super::domain::{Domain, Outside};
use super::long::Long;
use super::point::Point;
use super::shape::Shape;
use super::{CurveError, EvaluateError, tree};
use crate::geom::Vec3;
use crate::scalar::{ConstOps, FixedI32, Fraction, Polynomial};

/// A B-spline curve of the order `K` as polynomials, for `SPANS` spans: those of its domain that are
/// not empty, which [`Knots::spans`](super::Knots::spans) counts.
///
/// A value is a search for the span and Horner's rule: in fixed point about the span's middle in
/// products of 32 bits, and in floating point with three polynomials to a span, the first and the last
/// one for a quarter of it. Baking is done in double words of `f64`; in a constant, that costs nothing. For
/// errors see [`value`](Self::value) and [`derivative`](Self::derivative).
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct Baked<P: Point, const K: usize, const SPANS: usize> {
    /// Where the pieces start: a [tree]. Keys are counted from `outside` on, so that all parameters
    /// outside of the domain are before those inside.
    nodes: Pieces<P, [Key<P>; 2], SPANS>,
    /// The key behind that of the end.
    outside: Key<P>,
    from: Key<P>,
    end: Key<P>,
    pieces: Pieces<P, Piece<P, K>, SPANS>,
}

type Key<P> = <<P as Point>::Scalar as Blend>::Key;

type Pieces<P, T, const SPANS: usize> = <<P as Point>::Scalar as Blend>::Pieces<T, SPANS>;

type Row<P> = <P as Point>::Array<<<P as Point>::Scalar as Blend>::Coefficient>;

/// The polynomials of a span, or of a part of it.
#[doc(hidden)]
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct Piece<P: Point, const K: usize> {
    polynomial: Polynomial<<P::Scalar as Blend>::Frame, Row<P>, K>,
    base: P::Array<<P::Scalar as Blend>::Base>,
}

macro_rules! bake {
    ([$($generics:tt)*] $Scalar:ty, $Point:ty, $D:expr, $cuts:expr) => {
        impl<$($generics)* const K: usize, const C: usize, const N: usize> Curve<$Point, K, C, N> {
            /// The curve's polynomials, for a constant: they don't follow when a control point is
            /// moved.
            ///
            /// With twice as many `SPANS` as the curve has, each is divided into two polynomials,
            /// and so on: rounding errors become smaller, and in fixed point there is room for control
            /// points that are farther apart.
            ///
            /// # Errors
            /// [`CurveError::SpanCount`] unless `SPANS` is the number of the curve's spans, or a
            /// multiple of it;
            /// [`CurveError::TooFar`] in fixed point, if a span goes so far that fewer than four
            /// guard bits are left. In `I16F16`, control points of a cubic within 25 units of some
            /// place always are near enough. That is for those that alternate, over spans of a power of
            /// two; most have room for some hundreds, and over halves of a span also those for 200.
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
                // What the pieces of a part begin with, and where they end, in quarters of it.
                const CUTS: &[usize] = &$cuts;
                const PIECES: usize = CUTS.len() - 1;
                let mut pieces = [[Piece {
                    polynomial: Polynomial {
                        coefficients: [[Bake::<$Scalar>::ZERO; $D]; K],
                        frame: Bake::<$Scalar>::EMPTY,
                    },
                    base: [Bake::<$Scalar>::NO_BASE; $D],
                }; PIECES]; SPANS];
                let mut starts = [[0; PIECES]; SPANS];
                let mut end = 0;
                let (mut span, mut part, mut at) = (K - 1, 0, 0);
                while at < SPANS && span + K < knots.length && span + K < N {
                    let (low, high) = (knots.knots[span], knots.knots[span + 1]);
                    if part == parts || Bake::<$Scalar>::f64(low) >= Bake::<$Scalar>::f64(high) {
                        span += 1;
                        part = 0;
                        continue;
                    }
                    let mut i = 0;
                    while i < PIECES {
                        let (first, count) = (4 * part, 4 * parts);
                        let start = ConstOps::<$Scalar>::part(low, high, first + CUTS[i], count);
                        let stop = ConstOps::<$Scalar>::part(low, high, first + CUTS[i + 1], count);
                        match self.piece(span, start, stop) {
                            Ok(made) => pieces[at][i] = made,
                            Err(error) => return Err(error),
                        }
                        starts[at][i] = Bake::<$Scalar>::key(start).cast_unsigned();
                        i += 1;
                    }
                    at += 1;
                    part += 1;
                    end = Bake::<$Scalar>::last_key(high).cast_unsigned();
                }
                let from = starts[0][0];
                let mut nodes = [[[0; 2]; PIECES]; SPANS];
                let outside = end.wrapping_add(1);
                let starts = starts.as_flattened();
                let mut node = 1;
                while node < 1 << tree::levels(starts.len()) {
                    if let Some(i) = tree::element(node, starts.len()) {
                        nodes.as_flattened_mut().as_flattened_mut()[node] =
                            starts[i].wrapping_sub(outside);
                    }
                    node += 1;
                }
                Ok(Baked { nodes, outside, from, end, pieces })
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
                    low[i] = Bake::<$Scalar>::distance(knots[span + 1 + i - K], frame);
                    high[i] = Bake::<$Scalar>::distance(knots[span + 1 + i], frame);
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
                match Bake::<$Scalar>::coefficients(polynomials, frame, [start, stop]) {
                    Ok((frame, coefficients, base)) => {
                        Ok(Piece { polynomial: Polynomial { coefficients, frame }, base })
                    }
                    Err(error) => Err(error),
                }
            }
        }
    };
}

bake!([] f32, f32, 1, [0, 1, 3, 4]);
bake!([] f32, Vec3<f32>, 3, [0, 1, 3, 4]);
bake!([const D: usize,] f32, [f32; D], D, [0, 1, 3, 4]);
bake!([] f64, f64, 1, [0, 1, 3, 4]);
bake!([] f64, Vec3<f64>, 3, [0, 1, 3, 4]);
bake!([const D: usize,] f64, [f64; D], D, [0, 1, 3, 4]);
bake!([F: Fraction,] FixedI32<F>, FixedI32<F>, 1, [0, 4]);
bake!([F: Fraction,] FixedI32<F>, Vec3<FixedI32<F>>, 3, [0, 4]);
bake!([F: Fraction, const D: usize,] FixedI32<F>, [FixedI32<F>; D], D, [0, 4]);

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
        piece.map(|piece| piece.value(t)).ok_or_else(|| self.refusal(t, outside))
    }

    /// The parameter to evaluate the curve at in place of one outside, and the piece that it belongs to.
    ///
    /// The error is left to another function: these two come back in registers, and the quick path needs
    /// no place on the stack.
    #[cold]
    #[inline(never)]
    fn moved(&self, t: P::Scalar, outside: Outside) -> (P::Scalar, Option<&Piece<P, K>>) {
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
        piece.derivative(order, t).ok_or(EvaluateError::Overflow)
    }

    /// The piece that a parameter of the domain belongs to.
    #[inline(always)] // a call would cost the quick path registers
    fn piece(&self, key: Key<P>) -> Option<&Piece<P, K>> {
        let nodes = P::Scalar::pieces(&self.nodes).as_flattened();
        tree::find(nodes, P::Scalar::pieces(&self.pieces), &key)
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
        let Some(sums) = horner(&self.polynomial, t) else { return P::ORIGIN };
        let mut point = P::ORIGIN.coordinates();
        let values = sums.as_ref().iter().zip(self.base.as_ref());
        for (x, (sum, base)) in point.as_mut().iter_mut().zip(values) {
            *x = P::Scalar::baked(*sum, *base, &self.polynomial.frame);
        }
        P::from_coordinates(point)
    }

    /// At any parameter.
    fn derivative(&self, order: usize, t: P::Scalar) -> Option<P> {
        let Polynomial { coefficients, frame } = &self.polynomial;
        let mut point = P::ORIGIN.coordinates();
        for (d, (x, base)) in point.as_mut().iter_mut().zip(self.base.as_ref()).enumerate() {
            let powers = coefficients.iter().rev().enumerate().rev();
            let terms = powers
                .take_while(|(power, _)| *power >= order)
                .filter_map(|(power, of)| Some((power, *of.as_ref().get(d)?)));
            *x = P::Scalar::extended(terms, *base, order, t, frame)?;
        }
        Some(P::from_coordinates(point))
    }
}
