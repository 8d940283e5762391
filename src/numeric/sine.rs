//! Sine and cosine in integers.

/// Sine and cosine, as multiples of 2^−62, of an angle in quarters of a turn, as multiples of 2^−62, too.
///
/// The angle is taken to within π/4 of a multiple of π/2, and the Taylor series is summed from
/// its eighth term on: what is left out is less than 10^−16.
pub(crate) const fn sin_cos_of_quarters(turned: i128) -> (i64, i64) {
    /// π/2 as a multiple of 2^−62.
    const QUARTER: i64 = 0x6487_ed51_10b4_611a;
    const fn times(a: i64, b: i64) -> i64 {
        ((a as i128 * b as i128) >> 62) as i64
    }
    const fn series(square: i64, mut factors: &[i64]) -> i64 {
        const ONE: i64 = 1 << 62;
        let mut sum = ONE;
        while let [factor, others @ ..] = factors {
            // No factor is zero, but whether the compiler sees that depends on what it inlines.
            let Some(part) = times(square, sum).checked_div(*factor) else { break };
            sum = ONE - part;
            factors = others;
        }
        sum
    }

    let quarter = (turned + (1 << 61)) >> 62;
    let angle = times((turned - (quarter << 62)) as i64, QUARTER);
    let square = times(angle, angle);
    let sin = times(angle, series(square, &[210, 156, 110, 72, 42, 20, 6]));
    let cos = series(square, &[182, 132, 90, 56, 30, 12, 2]);
    match quarter & 3 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// Sine and cosine of the `index`-th of `count` equal parts of a turn.
pub(crate) const fn sin_cos_of_part(index: usize, count: usize) -> (f64, f64) {
    const ONE: f64 = (1u64 << 62) as f64;
    let count = if count == 0 { 1 } else { count as i128 };
    // At 2^62 to a quarter of a turn.
    let (sin, cos) = sin_cos_of_quarters(((index as i128) << 64) / count);
    (sin as f64 / ONE, cos as f64 / ONE)
}
