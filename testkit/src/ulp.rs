//! Units in the last place, and the statistics of errors.

/// The unit in the last place of an `f32`: the distance from it to the next larger one.
pub fn ulp_at(t: f64) -> f64 {
    let near = (t as f32).abs();
    f64::from(near.next_up() - near)
}

/// The distance from `exact` in units in the last place of an `f32` there.
pub fn ulps(got: f64, exact: f64) -> f64 {
    (got - exact).abs() / ulp_at(exact)
}

/// The unit of numbers of a size, with `epsilon` the unit of 1: that of the binade which the size
/// is in.
pub fn unit_of(size: f64, epsilon: f64) -> f64 {
    size.log2().floor().exp2() * epsilon
}

/// Median, 99th percentile (by nearest rank) and maximum; `None` of nothing.
pub fn percentiles(errors: &[f64]) -> Option<[f64; 3]> {
    let mut sorted = errors.to_vec();
    sorted.sort_by(f64::total_cmp);
    let rank = |percent: usize| (sorted.len() * percent).div_ceil(100).checked_sub(1);
    Some([sorted[rank(50)?], sorted[rank(99)?], sorted[rank(100)?]])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_double_with_every_binade() {
        for (size, unit) in [(1.0, 1.0), (1.999, 1.0), (2.0, 2.0), (0.75, 0.5)] {
            assert_eq!(unit_of(size, 1.0), unit);
            assert_eq!(ulp_at(size), unit * f64::from(f32::EPSILON));
        }
        assert_eq!(ulps(1.0 + 3.0 * f64::from(f32::EPSILON), 1.0), 3.0);
    }

    #[test]
    fn percentiles_are_by_nearest_rank() {
        assert_eq!(percentiles(&[]), None);
        assert_eq!(percentiles(&[5.0]), Some([5.0; 3]));
        let errors: Vec<f64> = (1..=200).rev().map(f64::from).collect();
        assert_eq!(percentiles(&errors), Some([100.0, 198.0, 200.0]));
    }
}
