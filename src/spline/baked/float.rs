//! Pieces of baked curves in floating point.
//!
//! All is computed in `f64`, and rounded to `f32` after each operation where that is the number type: so
//! the bits are those of `f32`.

use super::layout::Place;
use super::piece::Piece;
use super::polynomial::{polynomials, power, words};
use crate::scalar::ConstOps;
use crate::spline::scalar::float::FloatMap;

/// A floating-point type.
#[derive(Clone, Copy)]
struct Float {
    is_single: bool,
    epsilon: f64,
    /// The smallest number with all digits.
    least: f64,
}

const SINGLE: Float =
    Float { is_single: true, epsilon: f32::EPSILON as f64, least: f32::MIN_POSITIVE as f64 };

const DOUBLE: Float = Float { is_single: false, epsilon: f64::EPSILON, least: f64::MIN_POSITIVE };

impl Float {
    /// The nearest number of the type.
    const fn round(self, x: f64) -> f64 {
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

    /// The coefficients of the piece of a span from one parameter to another, and the map to its local ones.
    ///
    /// What rounding leaves of the coefficient of yⁱ is carried to that of yⁱ⁻²: for |y| ≤ h,
    /// yⁱ is (i/4)h²yⁱ⁻² and little else, by Chebyshev's polynomials (Lanczos, *Applied Analysis*,
    /// 1956).
    const fn piece<const K: usize, const D: usize>(
        self,
        knots: &[f64],
        points: &[[f64; D]],
        span: usize,
        [start, stop]: [f64; 2],
    ) -> ([[f64; D]; K], FloatMap<f64>) {
        let map = self.map(start, stop);
        let distances = [1.0, -map.shift / map.scale, 1.0 / map.scale];
        let mut polynomials = polynomials::<K, D>(knots, points, span, distances);
        let square = square_of_half(map, [start, stop]);
        let mut coefficients = [[0.0; D]; K];
        let mut i = K * D;
        while i > 0 {
            i -= 1;
            let (power, d) = (i / D, i % D);
            let rest = &mut polynomials[d];
            let rounded = self.round(rest[power].high);
            coefficients[K - 1 - power][d] = rounded;
            if power > 1 {
                let left = rest[power].sub(words(rounded));
                rest[power - 2] = rest[power - 2].add(left.scaled(power as f64 / 4.0 * square));
            }
        }
        (coefficients, map)
    }
}

/// h², where a piece's local parameters are from about −h to h. 0 for a piece of a few units, whose
/// origin is at an end of it: large coefficients don't make up for one another there.
const fn square_of_half(FloatMap { scale, shift }: FloatMap<f64>, [start, stop]: [f64; 2]) -> f64 {
    let (low, high) = ((start * scale + shift).abs(), (stop * scale + shift).abs());
    let half = low.max(high);
    if low.min(high) > 0.25 { half * half } else { 0.0 }
}

macro_rules! pieces {
    ($($Float:ident $kind:expr;)+) => {$(
        impl ConstOps<$Float> {
            /// The piece of a span from one parameter to another.
            pub(in crate::spline) const fn piece<const K: usize, const D: usize>(
                knots: &[f64],
                points: &[[f64; D]],
                (span, [start, stop]): Place<$Float>,
            ) -> Option<Piece<FloatMap<$Float>, [$Float; D], [(); D], K>> {
                let (wide, map) = $kind.piece::<K, D>(knots, points, span, [start as f64, stop as f64]);
                let mut coefficients = [[0.0; D]; K];
                let mut i = 0;
                while i < K * D {
                    coefficients[i / D][i % D] = wide[i / D][i % D] as $Float;
                    i += 1;
                }
                let map = FloatMap { scale: map.scale as $Float, shift: map.shift as $Float };
                Some(Piece { coefficients, map, base: [(); D] })
            }
        }
    )+};
}

pieces! {
    f32 SINGLE;
    f64 DOUBLE;
}
