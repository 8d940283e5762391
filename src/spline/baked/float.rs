//! Pieces of baked curves in floating point.
//!
//! All is computed in `f64`, and rounded to `f32` after each operation where that is the number type: so
//! the bits are those of `f32`.

use super::piece::Piece;
use super::polynomial::{Words, ZERO, lane, polynomial, power, words};
use crate::scalar::ConstOps;
use crate::spline::error::CurveError;
use crate::spline::scalar::float::FloatMap;

/// A floating-point type.
#[derive(Clone, Copy)]
pub(super) struct Float {
    pub(super) is_single: bool,
    epsilon: f64,
    /// The smallest number with all digits.
    least: f64,
}

pub(super) const SINGLE: Float =
    Float { is_single: true, epsilon: f32::EPSILON as f64, least: f32::MIN_POSITIVE as f64 };

pub(super) const DOUBLE: Float =
    Float { is_single: false, epsilon: f64::EPSILON, least: f64::MIN_POSITIVE };

/// Polynomials in all coordinates.
type FloatPiece<S, const K: usize, const D: usize> = Piece<FloatMap<S>, [S; D], [(); D], K>;

impl Float {
    /// The nearest number of the type.
    pub(super) const fn round(self, x: f64) -> f64 {
        if self.is_single { x as f32 as f64 } else { x }
    }

    /// How the parameters of a piece become local ones.
    const fn map(self, start: f64, end: f64) -> FloatMap<f64> {
        let half = self.round(self.round(end - start) / 2.0);
        let middle = self.round(start + half);
        // A span of a unit in the last place has no other number than its start.
        let origin = if middle < end { middle } else { start };
        // A piece without a length has some scale, with which nothing overflows.
        let least = (origin.abs() * (self.epsilon / 2.0)).max(self.least);
        let far = self.round(origin - start).max(self.round(end - origin)).max(least);
        let scale = self.round(power(far));
        let origin = self.moved(start, origin, end, scale);
        FloatMap { scale, shift: self.round(-origin * scale) }
    }

    /// The origin at a distance of 1/2 from the end that is nearer to 0, where that pays.
    ///
    /// With t below half of the origin, the difference of the two is rounded, and twice as much
    /// from 1/2 on. Where the middle is little farther away, the other end may be so instead.
    const fn moved(self, start: f64, middle: f64, end: f64, scale: f64) -> f64 {
        let is_start_near = start.abs() < end.abs();
        let near = if is_start_near { start } else { end };
        let far = self.round(middle - start).max(self.round(end - middle));
        let far = self.round(far * scale);
        // Below 1/2 are pieces that are too short for a scale.
        if far < 0.5 || far > 0.7 || self.round(near / middle) >= 0.5 {
            return middle;
        }
        // A multiple of 2⁻¹², so that t above it has exact differences; up to 1/2 away when rounded.
        let half = self.round((0.5 - 1.0 / 4096.0) / scale);
        let origin = self.round(if is_start_near { start + half } else { end - half });
        let coarse = self.round(self.round(1.5 / self.epsilon) / 4096.0 / scale);
        let moved = self.round(self.round(origin + coarse) - coarse);
        // Of the widest pieces, that overflows.
        if moved.is_finite() { moved } else { middle }
    }

    /// The piece of a span from one parameter to another.
    ///
    /// What rounding leaves of the coefficient of yⁱ is carried to that of yⁱ⁻²: for |y| ≤ h,
    /// yⁱ is (i/4)h²yⁱ⁻² and little else, by Chebyshev's polynomials (Lanczos, *Applied Analysis*,
    /// 1956).
    const fn piece<const K: usize, const D: usize, const C: usize, const N: usize>(
        self,
        knots: &[f64; N],
        points: &[[f64; D]; C],
        span: usize,
        [start, stop]: [f64; 2],
    ) -> FloatPiece<f64, K, D> {
        let map = self.map(start, stop);
        let (mut low, mut high) = ([ZERO; K], [ZERO; K]);
        let mut i = 0;
        while i < K {
            low[i] = Words::of_sum(knots[span + 1 + i - K], map.shift / map.scale);
            high[i] = Words::of_sum(knots[span + 1 + i], map.shift / map.scale);
            i += 1;
        }
        let square = square_of_half(map, [start, stop]);
        let mut coefficients = [[0.0; D]; K];
        let mut d = 0;
        while d < D {
            let mut rest = polynomial(low, high, lane(points, span, d), 1.0 / map.scale);
            let mut i = K;
            while i > 0 {
                i -= 1;
                let rounded = self.round(rest[i].high);
                coefficients[K - 1 - i][d] = rounded;
                if i > 1 {
                    let left = rest[i].sub(words(rounded));
                    rest[i - 2] = rest[i - 2].add(left.scaled(i as f64 / 4.0 * square));
                }
            }
            d += 1;
        }
        Piece { coefficients, map, base: [(); D] }
    }
}

/// h², where a piece's local parameters are from about −h to h. 0 for a piece of a few units, whose
/// origin is at an end of it: large coefficients don't make up for one another there.
const fn square_of_half(FloatMap { scale, shift }: FloatMap<f64>, [start, stop]: [f64; 2]) -> f64 {
    let (low, high) = ((start * scale + shift).abs(), (stop * scale + shift).abs());
    let half = low.max(high);
    if low.min(high) > 0.25 { half * half } else { 0.0 }
}

impl ConstOps<f64> {
    pub(super) const fn piece<const K: usize, const D: usize, const C: usize, const N: usize>(
        knots: &[f64; N],
        points: &[[f64; D]; C],
        (span, ends): (usize, [f64; 2]),
    ) -> Result<FloatPiece<f64, K, D>, CurveError> {
        Ok(DOUBLE.piece(knots, points, span, ends))
    }
}

impl ConstOps<f32> {
    pub(super) const fn piece<const K: usize, const D: usize, const C: usize, const N: usize>(
        knots: &[f64; N],
        points: &[[f64; D]; C],
        (span, ends): (usize, [f64; 2]),
    ) -> Result<FloatPiece<f32, K, D>, CurveError> {
        let Piece { coefficients: wide, map, base } =
            SINGLE.piece::<K, D, C, N>(knots, points, span, ends);
        let mut coefficients = [[0.0; D]; K];
        let mut i = 0;
        while i < K * D {
            coefficients[i / D][i % D] = wide[i / D][i % D] as f32;
            i += 1;
        }
        let map = FloatMap { scale: map.scale as f32, shift: map.shift as f32 };
        Ok(Piece { coefficients, map, base })
    }
}
