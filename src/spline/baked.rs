//! Curves as polynomials, span by span.

use super::bake::{polynomial, power_f32, power_f64, rounded};
use super::blend::Blend;
use super::curve::{Curve, Shape};
use super::domain::{Domain, Outside};
use super::fixed::FixedFrame;
use super::float::FloatFrame;
use super::point::Point;
use super::{CurveError, EvaluateError};
use crate::geom::Vec3;
use crate::scalar::{Check, FixedI32, Fraction, Number};

/// A B-spline curve of the order `K` as `SPANS` polynomials, one for each span of its domain that
/// is not empty: [`Knots::spans`](super::Knots::spans) counts them.
///
/// A value is a search for the span and Horner's rule about the span's middle. In `f32`, cubics
/// are within 3.1 units in the last place of the largest coordinate of the control points (5 where
/// control points at a clamped end alternate at full size, and 3.1 again with two polynomials to a
/// span); in fixed point within 0.6 units, in products of 32 bits. Baking is done in `f64`; in a
/// constant, that costs nothing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Baked<P: Point, const K: usize, const SPANS: usize> {
    pieces: [Piece<P, K>; SPANS],
    end: P::Scalar,
}

/// The polynomial of a span.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Piece<P: Point, const K: usize> {
    start: P::Scalar,
    frame: <P::Scalar as Blend>::Frame,
    base: P::Array<<P::Scalar as Blend>::Base>,
    /// Of y^{k−1} first.
    coefficients: [P::Array<<P::Scalar as Blend>::Coefficient>; K],
}

/// What baking a span needs to know of its number type.
struct Bake<S>(core::marker::PhantomData<S>);

macro_rules! floats {
    ($($Float:ident $power:path),+) => {$(
        impl Bake<$Float> {
            const EMPTY: FloatFrame<$Float> = FloatFrame { half: 0.0, scale: 0.0 };

            const fn f64(x: $Float) -> f64 {
                x as f64
            }

            /// The frame of a span, its middle, and the length of its local unit.
            const fn frame(start: $Float, end: $Float) -> (FloatFrame<$Float>, f64, f64) {
                let half = (end - start) / 2.0;
                let scale = $power(half);
                (FloatFrame { half, scale }, half as f64, 1.0 / (scale as f64))
            }

            /// Base and coefficients of the polynomials of some coordinates.
            #[allow(clippy::type_complexity)]
            const fn coefficients<const K: usize, const D: usize>(
                polynomials: [[f64; K]; D],
                frame: FloatFrame<$Float>,
            ) -> Result<([(); D], [[$Float; D]; K], FloatFrame<$Float>), CurveError> {
                let mut coefficients = [[0.0; D]; K];
                let mut d = 0;
                while d < D {
                    let mut i = 0;
                    while i < K {
                        coefficients[K - 1 - i][d] = polynomials[d][i] as $Float;
                        i += 1;
                    }
                    d += 1;
                }
                Ok(([(); D], coefficients, frame))
            }
        }
    )+};
}

floats!(f32 power_f32, f64 power_f64);

impl<F: Fraction> Bake<FixedI32<F>> {
    const EMPTY: FixedFrame = FixedFrame { half: 0, shift: 0, guard: 0 };

    const fn f64(x: FixedI32<F>) -> f64 {
        x.to_bits() as f64
    }

    const fn frame(start: FixedI32<F>, end: FixedI32<F>) -> (FixedFrame, f64, f64) {
        let width = end.to_bits().wrapping_sub(start.to_bits()).cast_unsigned();
        let shift = width.leading_zeros();
        // Rounded up, so that the end's local parameter fits 32 bits.
        let half = width.wrapping_shl(shift).div_ceil(2);
        let unit = 1.0 / (1u64 << shift) as f64;
        (
            FixedFrame { half, shift: shift as u8, guard: 0 },
            half as f64 * unit,
            unit * (1u64 << 32) as f64,
        )
    }

    /// As many guard bits as the span's coefficients leave room for. Half a unit is added to make
    /// up for products that are cut off, and another for the result.
    #[allow(clippy::type_complexity)]
    const fn coefficients<const K: usize, const D: usize>(
        polynomials: [[f64; K]; D],
        frame: FixedFrame,
    ) -> Result<([i32; D], [[i32; D]; K], FixedFrame), CurveError> {
        // The largest that a sum on the way can be; |y| ≤ 1/2.
        let mut largest = 1.0;
        let mut d = 0;
        while d < D {
            let mut sum = 0.0;
            let mut i = K;
            while i > 0 {
                i -= 1;
                // The first coefficient's whole units are added at the end.
                let c = if i > 0 { polynomials[d][i].abs() } else { 1.0 };
                sum = c + sum / 2.0;
                if sum > largest {
                    largest = sum;
                }
            }
            d += 1;
        }
        let mut guard = 20;
        while guard > 0 && largest * (1u32 << guard) as f64 > (i32::MAX - 64) as f64 {
            guard -= 1;
        }
        if guard < 4 && K > 1 {
            return Err(CurveError::TooFar);
        }
        let one = (1u32 << guard) as f64;
        let mut base = [0; D];
        let mut coefficients = [[0; D]; K];
        let mut d = 0;
        while d < D {
            let whole = rounded(polynomials[d][0]);
            base[d] = crate::scalar::whole::narrow(whole);
            let mut i = 0;
            while i < K {
                let exact =
                    if i == 0 { polynomials[d][i] - whole as f64 } else { polynomials[d][i] };
                let cut_off = if i + 1 < K { 0.5 } else { 0.0 };
                let half = if i == 0 { one / 2.0 } else { 0.0 };
                coefficients[K - 1 - i][d] = rounded(exact * one + cut_off + half) as i32;
                i += 1;
            }
            d += 1;
        }
        Ok((base, coefficients, FixedFrame { guard, ..frame }))
    }
}

macro_rules! bake {
    ([$($generics:tt)*] $Scalar:ty, $Point:ty, $D:expr) => {
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
                let mut pieces = [Piece {
                    start: knots.knots[0],
                    frame: Bake::<$Scalar>::EMPTY,
                    base: [Bake::<$Scalar>::NO_BASE; $D],
                    coefficients: [[Bake::<$Scalar>::ZERO; $D]; K],
                }; SPANS];
                let mut end = knots.knots[0];
                let (mut span, mut part, mut piece) = (K - 1, 0, 0);
                while piece < SPANS && span + K < knots.length && span + K < N {
                    let (low, high) = (knots.knots[span], knots.knots[span + 1]);
                    if part == parts || Bake::<$Scalar>::f64(low) >= Bake::<$Scalar>::f64(high) {
                        span += 1;
                        part = 0;
                        continue;
                    }
                    let start = Check::<$Scalar>::part(low, high, part, parts);
                    let stop = Check::<$Scalar>::part(low, high, part + 1, parts);
                    match self.piece(span, start, stop) {
                        Ok(made) => pieces[piece] = made,
                        Err(error) => return Err(error),
                    }
                    piece += 1;
                    part += 1;
                    end = high;
                }
                Ok(Baked { pieces, end })
            }

            const fn piece(
                &self,
                span: usize,
                start: $Scalar,
                stop: $Scalar,
            ) -> Result<Piece<$Point, K>, CurveError> {
                let knots = &self.knots.knots;
                let (frame, middle, unit) = Bake::<$Scalar>::frame(start, stop);
                let zero = Bake::<$Scalar>::f64(start);
                let (mut low, mut high) = ([0.0; K], [0.0; K]);
                let mut points = [[0.0; K]; $D];
                let mut i = 0;
                while i < K {
                    low[i] = Bake::<$Scalar>::f64(knots[span + 1 + i - K]) - zero;
                    high[i] = Bake::<$Scalar>::f64(knots[span + 1 + i]) - zero;
                    let point = Shape::<$Point>::coordinates(self.points[span + 1 + i - K]);
                    let mut d = 0;
                    while d < $D {
                        points[d][i] = Bake::<$Scalar>::f64(point[d]);
                        d += 1;
                    }
                    i += 1;
                }
                let mut polynomials = [[0.0; K]; $D];
                let mut d = 0;
                while d < $D {
                    polynomials[d] = polynomial(low, high, points[d], middle, unit);
                    d += 1;
                }
                match Bake::<$Scalar>::coefficients(polynomials, frame) {
                    Ok((base, coefficients, frame)) => Ok(Piece { start, frame, base, coefficients }),
                    Err(error) => Err(error),
                }
            }
        }
    };
}

macro_rules! bakes {
    ($($Float:ident),+) => {$(
        bake!([] $Float, $Float, 1);
        bake!([] $Float, Vec3<$Float>, 3);
        bake!([const D: usize,] $Float, [$Float; D], D);

        impl Bake<$Float> {
            const NO_BASE: () = ();
            const ZERO: $Float = 0.0;
        }
    )+};
}

bakes!(f32, f64);
bake!([F: Fraction,] FixedI32<F>, FixedI32<F>, 1);
bake!([F: Fraction,] FixedI32<F>, Vec3<FixedI32<F>>, 3);
bake!([F: Fraction, const D: usize,] FixedI32<F>, [FixedI32<F>; D], D);

impl<F: Fraction> Bake<FixedI32<F>> {
    const NO_BASE: i32 = 0;
    const ZERO: i32 = 0;
}

impl<P: Point, const K: usize, const SPANS: usize> Baked<P, K, SPANS> {
    /// The parameters of the curve.
    #[must_use]
    #[inline]
    pub fn domain(&self) -> Domain<P::Scalar> {
        let from = self.pieces.first().map_or(self.end, |piece| piece.start);
        Domain { from, to: self.end }
    }

    /// The curve's point at a parameter.
    ///
    /// # Errors
    /// [`EvaluateError::NotFinite`]; [`EvaluateError::Outside`] if t is outside of the domain and
    /// the policy says so, and in fixed point also where it says [`Outside::Extrapolate`];
    /// [`EvaluateError::Overflow`] only outside of the domain.
    #[inline]
    pub fn value(&self, t: P::Scalar, outside: Outside) -> Result<P, EvaluateError> {
        let domain = self.domain();
        let t = if domain.contains(t) { t } else { self.place_outside(t, outside)? };
        let point = self.at(t);
        if matches!(outside, Outside::Extrapolate) {
            let is_finite = |x: &P::Scalar| x.is_finite();
            if !point.coordinates().as_ref().iter().all(is_finite) {
                return Err(EvaluateError::Overflow);
            }
        }
        Ok(point)
    }

    #[inline]
    fn place_outside(&self, t: P::Scalar, outside: Outside) -> Result<P::Scalar, EvaluateError> {
        if matches!(outside, Outside::Extrapolate) && !P::Scalar::EXTENDS {
            return Err(EvaluateError::Outside);
        }
        self.domain().place(t, outside)
    }

    #[inline]
    fn at(&self, t: P::Scalar) -> P {
        let Some((first, later)) = self.pieces.split_first() else { return P::ORIGIN };
        // Without a jump, and without an index that would have to be checked.
        let piece = later.iter().fold(first, |at, piece| if piece.start <= t { piece } else { at });

        let local = P::Scalar::local(t, piece.start, &piece.frame);
        let Some((first, rest)) = piece.coefficients.split_first() else { return P::ORIGIN };
        let mut sums = *first;
        for coefficients in rest {
            for (sum, c) in sums.as_mut().iter_mut().zip(coefficients.as_ref()) {
                *sum = P::Scalar::horner(*sum, local, *c);
            }
        }
        let mut point = P::ORIGIN.coordinates();
        let values = sums.as_ref().iter().zip(piece.base.as_ref());
        for (x, (sum, base)) in point.as_mut().iter_mut().zip(values) {
            *x = P::Scalar::baked(*sum, *base, &piece.frame);
        }
        P::from_coordinates(point)
    }
}
