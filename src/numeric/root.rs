//! A square root for `const fn` constructors.

/// The square root of a finite number ≥ 0, within one unit in the last place.
///
/// Newton's iteration in products and sums only, because no library's root is a `const fn`. The
/// seed halves the exponent, which is within 6 %; five steps square that beyond 2⁻⁵³.
pub(crate) const fn sqrt(x: f64) -> f64 {
    if x < f64::MIN_POSITIVE {
        // Zero, or too small to matter for a length; also what a NaN falls through to.
        return if x > 0.0 { sqrt(x * 1.844_674_407_370_955_2e19) / 4_294_967_296.0 } else { 0.0 };
    }
    let mut root = f64::from_bits((x.to_bits() >> 1) + (1023 << 51));
    let mut step = 0;
    while step < 5 {
        root = 0.5 * (root + x / root);
        step += 1;
    }
    root
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn within_one_ulp(x in proptest::num::f64::POSITIVE) {
            let (got, want) = (super::sqrt(x), x.sqrt());
            prop_assert!(got.to_bits().abs_diff(want.to_bits()) <= 1, "{x}: {got} not {want}");
        }
    }

    #[test]
    fn zero_and_subnormals() {
        assert_eq!(super::sqrt(0.0), 0.0);
        let tiny = f64::from_bits(4);
        assert_eq!(super::sqrt(tiny), tiny.sqrt());
    }
}
