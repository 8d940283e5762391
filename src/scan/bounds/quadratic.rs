//! The columns in which rays from an eye can meet a solid, from where a quadratic in X is not
//! negative.

use crate::geom::{Affine, Extent, signed};
use crate::scalar::Real;

/// The columns of a row in which `Σ plus² ≥ Σ minus²` may hold, for lengths that are affine in X.
///
/// With X from −1 to 1 over the row, and lengths scaled so that the largest is between 1 and 2, the
/// rounding errors of coefficients and discriminant are at most some 16 units of the terms that
/// they were summed from; 64 are allowed for, and a column on either side for the roots' own
/// rounding. What fixed point lost when the lengths were rounded is added. Where the quadratic
/// isn't clearly concave, or the errors' bound itself vanishes, all columns are returned.
#[inline(never)] // once a row is seldom, and the code is long
pub(crate) fn extent<T: Real>(plus: &[Affine<T>], minus: &[Affine<T>], columns: u32) -> Extent {
    let all = Extent::all(columns);
    let reach = T::from_int(signed(columns));
    let lengths = || plus.iter().chain(minus);
    let largest = lengths()
        .map(|length| length.middle.abs() + length.step.abs() * reach)
        .fold(T::ZERO, T::max);
    if largest <= T::ZERO || !largest.is_finite() {
        return all;
    }
    let scale = largest.normalizing_power();

    let mut sum = [T::ZERO; 3];
    let mut size = [T::ZERO; 3];
    for (i, length) in lengths().enumerate() {
        let (middle, way) = (length.middle * scale, length.step * reach * scale);
        let cross = middle * way;
        let terms = [middle * middle, cross + cross, way * way];
        for ((sum, size), term) in sum.iter_mut().zip(&mut size).zip(terms) {
            *sum = if i < plus.len() { *sum + term } else { *sum - term };
            *size = *size + term.abs();
        }
    }
    let unit = T::EPSILON * T::from_int(64);
    // Middle and step are off by 2 quanta; their squares, by 4 times as much for each of 4 lengths.
    let blur = T::QUANTUM * scale * (reach + T::ONE) * T::from_int(32);
    let [c0, c1, c2] = sum;
    let [s0, s1, s2] = size;

    let most = c0 + c1.abs() + c2.max(T::ZERO);
    let error = (s0 + s1 + s2) * unit + blur;
    if most + error < T::ZERO && error > T::ZERO {
        return Extent::EMPTY;
    }
    // Quotients by c2 must be good to a fraction of a column.
    if c2 + s2 * unit + (blur + T::QUANTUM * T::from_int(256)) * T::from_int(4096) >= T::ZERO {
        return all;
    }
    let half_c1 = c1 * T::HALF;
    let quarter = half_c1 * half_c1 - c0 * c2;
    let rounding = (s1 * s1 + s0 * s2) * unit;
    let quarter_error = rounding + (s0 + s1 + s2) * blur + T::QUANTUM * T::from_int(8);
    if (rounding * T::EPSILON + T::QUANTUM).positive().is_none() {
        return all;
    }
    if quarter + quarter_error < T::ZERO {
        return Extent::EMPTY;
    }
    let root = (quarter + quarter_error).sqrt();
    let column = |x: T| (x + T::ONE) * reach * T::HALF - T::HALF;
    let left = column((half_c1 - root) / -c2);
    let right = column((half_c1 + root) / -c2);
    if !left.is_finite() || !right.is_finite() {
        return all;
    }
    let start = left.floor_to_i32().saturating_sub(1).max(0) as u32;
    let end = right.floor_to_i32().saturating_add(2).max(0) as u32;
    all.overlap(Extent { start, end })
}

/// A length that is the same in all columns.
pub(crate) fn constant<T: Real>(length: T) -> Affine<T> {
    Affine { middle: length, step: T::ZERO }
}
