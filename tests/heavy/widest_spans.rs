//! Knots at either end of the number type's range.

use scancsg::spline::{Curve, Knots, Outside};

/// Knots as far apart as they may be, and as near: what is computed of them on the way must not be
/// infinite, since differences of that are NaN.
#[test]
fn the_widest_and_the_narrowest_spans() {
    let mut checked = 0;
    for exponent in -148..=127 {
        for factor in [1.0, 1.1, 1.29, 1.5, 1.8] {
            let width = factor * 2f64.powi(exponent);
            for [low, high] in [
                [0.0, width],
                [-width / 2.0, width / 2.0],
                [-width, 0.0],
                [-width * 0.4, width * 0.6],
            ] {
                checked += check_span([low as f32, high as f32]);
            }
        }
    }
    assert!(checked > 5000, "{checked}");
}

/// Cubics and quintics over one span, if there can be such knots.
fn check_span([low, high]: [f32; 2]) -> u32 {
    let Ok(knots) = Knots::<f32, 4, 8>::new(&[low, low, low, low, high, high, high, high]) else {
        return 0;
    };
    let curve = Curve::<f32, 4, 4, 8>::new(knots, [1.0, -1.0, 1.0, -1.0]).unwrap();
    let baked = curve.bake::<1>().unwrap();
    let six: [f32; 12] = std::array::from_fn(|i| if i < 6 { low } else { high });
    let quintic = Knots::<f32, 6, 12>::new(&six).unwrap();
    for part in [0.0, 0.1, 0.25, 0.3, 0.5, 0.75, 0.9, 1.0] {
        let t = (f64::from(low) * (1.0 - part) + f64::from(high) * part) as f32;
        let [editable, in_flash] = [curve.value(t, Outside::Error), baked.value(t, Outside::Error)];
        let (editable, in_flash) = (editable.unwrap(), in_flash.unwrap());
        assert!(
            (editable - in_flash).abs() <= testkit::limits::FORMS as f32 * f32::EPSILON / 2.0,
            "{low} {high} {t}: {editable} {in_flash}"
        );
        for order in 0..7 {
            for i in 0..6 {
                let (cubic, quintic) =
                    (knots.basis_derivative(i, order, t), quintic.basis_derivative(i, order, t));
                assert!(i > 3 || cubic.is_finite(), "{order} of N_{i} at {t} of {low} to {high}");
                assert!(quintic.is_finite(), "{order} of N_{i} at {t} of {low} to {high}");
            }
        }
    }
    1
}
