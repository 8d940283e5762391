//! Turns about an axis, far more accurately than any number type under test.

use crate::oracle::whole;
use crate::vector::{V, length};
use dashu_int::ops::SquareRoot;
use dashu_int::{IBig, UBig};

/// Numbers are integers of 2⁻²⁵⁶.
const BITS: usize = 256;

/// The distance of a point from where a turn by `angle`, in radians, about an axis through `center`
/// takes `own`. By Rodrigues' formula: `p cos φ + (k × p) sin φ + k (k·p)(1 − cos φ)`.
pub fn miss([center, axis]: [V; 2], angle: f64, own: V, got: V) -> f64 {
    let [center, axis, own, got] = [center, axis, own, got].map(|v| v.map(number));
    let [p, got] = [own, got].map(|v| std::array::from_fn(|i| &v[i] - &center[i]));
    let square = UBig::try_from(dot(&axis, &axis)).unwrap();
    let long = IBig::from((square << BITS).sqrt());
    let k = axis.map(|x| (x << BITS) / &long);
    let [sin, cos] = sin_cos(&number(angle));
    let by_axis = product(&dot(&k, &p), &(number(1.0) - &cos));
    let off = std::array::from_fn(|i| {
        let [y, z] = [(i + 1) % 3, (i + 2) % 3];
        let across = product(&k[y], &p[z]) - product(&k[z], &p[y]);
        let turned = product(&p[i], &cos) + product(&across, &sin) + product(&k[i], &by_axis);
        (turned - &got[i]).to_f64().value() * 2f64.powi(-(BITS as i32))
    });
    length(off)
}

/// Exact, unless it has bits below 2⁻²⁵⁶.
fn number(x: f64) -> IBig {
    let ([mantissa], exponent) = whole([x]);
    let shift = BITS as i32 + exponent;
    if shift < 0 { mantissa >> shift.unsigned_abs() as usize } else { mantissa << shift as usize }
}

fn product(a: &IBig, b: &IBig) -> IBig {
    (a * b) >> BITS
}

fn dot(a: &[IBig; 3], b: &[IBig; 3]) -> IBig {
    product(&a[0], &b[0]) + product(&a[1], &b[1]) + product(&a[2], &b[2])
}

/// The sums of the Taylor series.
fn sin_cos(angle: &IBig) -> [IBig; 2] {
    let mut sums = [IBig::ZERO, IBig::ZERO];
    let (mut term, mut n) = (number(1.0), 0u32);
    while term != IBig::ZERO {
        // Cosines have the even powers; the sign changes with every second power.
        let sum = &mut sums[usize::from(n % 2 == 0)];
        if n % 4 < 2 {
            *sum += &term
        } else {
            *sum -= &term
        }
        n += 1;
        // Towards zero, which a shift of a negative number doesn't come to.
        term = (term * angle / IBig::from(n)) / (IBig::ONE << BITS);
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thirds_of_a_turn_change_axes() {
        let third = std::f64::consts::TAU / 3.0;
        let at = [[1.0, 2.0, 3.0], [2.0; 3]];
        let off = miss(at, third, [6.0, 2.0, 3.0], [1.0, 7.0, 3.0]);
        // By how much the angle is below 2π/3, as seen at the distance of 5·√(2/3) from the axis.
        let lost = 2.296_728_565_598_444e-16;
        assert!((off - lost * 5.0 * (2f64 / 3.0).sqrt()).abs() < 1e-30, "{off}");
        assert_eq!(miss(at, 0.0, [6.0, 2.0, 3.0], [6.0, 2.0, 7.0]), 4.0);
        let other = miss(at, -third, [6.0, 2.0, 3.0], [1.0, 2.0, 8.0]);
        assert!((off - other).abs() < 1e-30);
    }
}
