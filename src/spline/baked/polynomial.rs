//! A curve's polynomial on a span: de Boor's algorithm with polynomials in place of numbers.
//!
//! In the blend `a + (b − a)·(t − low)/(high − low)` the fraction is linear in the span's local
//! parameter. Inside of the span all of it is between 0 and 1, so coefficients are of the size of the
//! control points, however close knots are. It is computed in double words of `f64`; in a constant that
//! costs nothing.
//!
//! The local parameter y is a power of two times t, counted from the middle of the span, or in
//! floating point from about the middle of a piece: control points at full size that alternate then
//! have coefficients below twice their size.

use crate::scalar::Double;

/// Twice the working precision.
pub(super) type Words = Double<f64>;

/// 0.
const ZERO: Words = Words { high: 0.0, low: 0.0 };

pub(super) const fn words(high: f64) -> Words {
    Words { high, low: 0.0 }
}

/// The [polynomials](polynomial) of all coordinates on a span. Distances from the origin are
/// `t·scale − origin`.
pub(super) const fn polynomials<const K: usize, const D: usize>(
    knots: &[f64],
    points: &[[f64; D]],
    span: usize,
    [scale, origin, unit]: [f64; 3],
) -> [[Words; K]; D] {
    let (mut low, mut high) = ([ZERO; K], [ZERO; K]);
    let mut lanes = [[0.0; K]; D];
    let mut i = 0;
    while i < K {
        low[i] = Words::of_sum(knots[span + 1 + i - K] * scale, -origin);
        high[i] = Words::of_sum(knots[span + 1 + i] * scale, -origin);
        let mut d = 0;
        while d < D {
            lanes[d][i] = points[span + 1 + i - K][d];
            d += 1;
        }
        i += 1;
    }
    let mut polynomials = [[ZERO; K]; D];
    let mut d = 0;
    while d < D {
        polynomials[d] = polynomial(low, high, lanes[d], unit);
        d += 1;
    }
    polynomials
}

/// The polynomial of a span as coefficients of 1, y, y² and so on, where y·`unit` is the
/// distance from the point that knots are measured from.
///
/// `low` holds t_{j−k+1} … t_j and `high` t_{j+1} … t_{j+k}; `points` the span's control points.
const fn polynomial<const K: usize>(
    low: [Words; K],
    high: [Words; K],
    points: [f64; K],
    unit: f64,
) -> [Words; K] {
    // blended[i] is a polynomial.
    let mut blended = [[ZERO; K]; K];
    let mut i = 0;
    while i < K {
        blended[i][0] = words(points[i]);
        i += 1;
    }
    let mut level = 1;
    while level < K {
        let mut i = 0;
        while i + level < K {
            // Near 1, so that nothing overflows.
            let width = high[i].sub(low[i + level]);
            let scale = power(width.high);
            let width = width.scaled(scale);
            // The fraction is constant + slope·y.
            let constant = ZERO.sub(low[i + level].scaled(scale)).div(width);
            let slope = words(unit * scale).div(width);
            let mut power = level + 1;
            while power > 0 {
                power -= 1;
                let mut more = blended[i + 1][power].sub(blended[i][power]).mul(constant);
                if power > 0 {
                    let below = blended[i + 1][power - 1].sub(blended[i][power - 1]);
                    more = more.add(below.mul(slope));
                }
                blended[i][power] = blended[i][power].add(more);
            }
            i += 1;
        }
        level += 1;
    }
    blended[0]
}

/// A power of two that brings a positive number to [1/2, 1), or as near as the range allows.
pub(super) const fn power(x: f64) -> f64 {
    let field = (x.to_bits() >> 52) & 0x7ff;
    // 2^(1022 − field); of subnormal numbers the largest power, which is not enough.
    let power = if field < 2045 { 2045 - field } else { 1 };
    f64::from_bits(if power > 2046 { 2046 << 52 } else { power << 52 })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cubic_in_bernsteins_form() {
        // x³ on [0, 2], about its middle: (1 + y)³.
        let (low, high) = ([words(-1.0); 4], [words(1.0); 4]);
        let cubic = polynomial(low, high, [0.0, 0.0, 0.0, 8.0], 1.0);
        assert_eq!(cubic.map(|x| x.high), [1.0, 3.0, 3.0, 1.0]);
    }

    #[test]
    fn powers_normalize() {
        for x in [1.0, 1.5, 0.75, 3e37, 1.2e-38, 1e-20, 1e-300] {
            assert!((0.5..1.0).contains(&(x * power(x))), "{x}");
        }
        assert!((1e-320 * power(1e-320)).is_finite());
        assert!((f64::MAX * power(f64::MAX)) < 4.0);
    }
}
