//! The polynomials of a baked curve, computed while compiling.
//!
//! De Boor's algorithm with polynomials in place of numbers: in the blend
//! `a + (b − a)·(t − low)/(high − low)` the fraction is linear in the span's local parameter. Inside
//! of the span all of it is between 0 and 1, so coefficients are of the size of the control points,
//! however close knots are. It is computed in `f64`, which is exact enough for 32-bit numbers of both
//! kinds; in a constant that costs nothing.

/// The polynomial of a span as coefficients of 1, y, y² and so on, where t = `start` + `middle` +
/// y·`unit`.
///
/// `low` holds t_{j−k+1} … t_j and `high` t_{j+1} … t_{j+k}, all less `start`; `points` the span's
/// control points.
pub(super) const fn polynomial<const K: usize>(
    low: [f64; K],
    high: [f64; K],
    points: [f64; K],
    middle: f64,
    unit: f64,
) -> [f64; K] {
    // blended[i] is a polynomial.
    let mut blended = [[0.0; K]; K];
    let mut i = 0;
    while i < K {
        blended[i][0] = points[i];
        i += 1;
    }
    let mut level = 1;
    while level < K {
        let mut i = 0;
        while i + level < K {
            let width = high[i] - low[i + level];
            // The fraction is constant + slope·y.
            let (constant, slope) = ((middle - low[i + level]) / width, unit / width);
            let mut power = level + 1;
            while power > 0 {
                power -= 1;
                let difference = blended[i + 1][power] - blended[i][power];
                let below =
                    if power > 0 { blended[i + 1][power - 1] - blended[i][power - 1] } else { 0.0 };
                blended[i][power] += difference * constant + below * slope;
            }
            i += 1;
        }
        level += 1;
    }
    blended[0]
}

/// A power of two that brings a positive number to [1/2, 1), or as near as the range allows.
pub(super) const fn power_f64(x: f64) -> f64 {
    let field = (x.to_bits() >> 52) & 0x7ff;
    // 2^(1022 − field); of subnormal numbers the largest power, which is not enough.
    let power = if field < 2045 { 2045 - field } else { 1 };
    f64::from_bits(if power > 2046 { 2046 << 52 } else { power << 52 })
}

/// As [`power_f64`].
pub(super) const fn power_f32(x: f32) -> f32 {
    let field = (x.to_bits() >> 23) & 0xff;
    let power = if field < 253 { 253 - field } else { 1 };
    f32::from_bits(if power > 254 { 254 << 23 } else { power << 23 })
}

/// The nearest whole number, halves upwards; for numbers below 2⁶².
pub(super) const fn rounded(x: f64) -> i64 {
    let whole = x as i64;
    let rest = x - whole as f64;
    if rest >= 0.5 {
        whole + 1
    } else if rest < -0.5 {
        whole - 1
    } else {
        whole
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_normalize() {
        for x in [1.0, 1.5, 0.75, 3e37, 1.2e-38, 1e-20] {
            let scaled = x * power_f32(x);
            assert!((0.5..1.0).contains(&scaled), "{x}: {scaled}");
            let (x, scaled) = (f64::from(x), f64::from(x) * power_f64(f64::from(x)));
            assert!((0.5..1.0).contains(&scaled), "{x}: {scaled}");
        }
        assert!((1e-44 * power_f32(1e-44)).is_finite());
        assert!((f64::MAX * power_f64(f64::MAX)) < 4.0);
    }

    #[test]
    fn whole_numbers_are_nearest() {
        let cases =
            [(0.5, 1), (-0.5, 0), (-0.6, -1), (2.4, 2), (-2.4, -2), (1e15, 1_000_000_000_000_000)];
        for (x, whole) in cases {
            assert_eq!(rounded(x), whole, "{x}");
        }
    }

    #[test]
    fn a_cubic_in_bernsteins_form() {
        // x³ on [0, 2], about its middle, in halves: (1 + y)³.
        let cubic = polynomial([0.0; 4], [2.0; 4], [0.0, 0.0, 0.0, 8.0], 1.0, 1.0);
        assert_eq!(cubic, [1.0, 3.0, 3.0, 1.0]);
    }
}
