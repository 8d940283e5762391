//! What constructors check and compute in fixed point.

use super::scale::Scale;
use super::wide::Wide;
use super::{FixedI32, Fraction, Unit};
use crate::numeric::integer::{divide, narrow, shift_right};
use crate::scalar::const_ops::ConstOps;
use crate::scalar::grid::nearest_units;
use crate::scalar::scalar::{Scalar, Stretch};

impl<F: Fraction> ConstOps<FixedI32<F>> {
    pub(crate) const fn is_finite(_: FixedI32<F>) -> bool {
        true
    }

    pub(crate) const fn is_zero(x: FixedI32<F>) -> bool {
        x.to_bits() == 0
    }

    pub(crate) const fn is_below(x: FixedI32<F>, y: FixedI32<F>) -> bool {
        x.to_bits() < y.to_bits()
    }

    pub(crate) const fn sum(x: FixedI32<F>, y: FixedI32<F>) -> FixedI32<F> {
        x.saturating_add(y)
    }

    pub(crate) const fn difference(x: FixedI32<F>, y: FixedI32<F>) -> FixedI32<F> {
        x.saturating_sub(y)
    }

    pub(crate) const fn is_within_reach(x: FixedI32<F>) -> bool {
        x.to_bits().unsigned_abs()
            <= <FixedI32<F> as Scalar>::MAX_COORDINATE.to_bits().unsigned_abs()
    }

    pub(crate) const fn is_radius(x: FixedI32<F>) -> bool {
        x.to_bits() > 0 && Self::is_within_reach(x)
    }

    pub(crate) const fn inverse(radius: FixedI32<F>) -> Scale {
        Scale::inverse(Wide::from_bits(
            (radius.to_bits() as i64) << (Wide::FRACTION_BITS - F::BITS),
        ))
    }

    /// [`Number::to_f64`](crate::scalar::Number::to_f64).
    pub(crate) const fn to_f64(x: FixedI32<F>) -> f64 {
        x.to_bits() as f64 / (1u64 << F::BITS) as f64
    }

    /// [`Number::from_f64`](crate::scalar::Number::from_f64).
    pub(crate) const fn from_f64(x: f64) -> FixedI32<F> {
        FixedI32::from_bits(narrow(nearest_units(x, F::BITS)))
    }

    /// [`Scalar::normalized`].
    pub(crate) const fn normalized([x, y, z]: [FixedI32<F>; 3]) -> Option<[Unit; 3]> {
        unit([x.to_bits() as i64, y.to_bits() as i64, z.to_bits() as i64])
    }

    /// [`Scalar::stretch`].
    pub(crate) const fn stretch(
        from: [FixedI32<F>; 3],
        to: [FixedI32<F>; 3],
    ) -> Option<Stretch<FixedI32<F>>> {
        let [x, y, z] =
            [from[0].to_bits() as i64, from[1].to_bits() as i64, from[2].to_bits() as i64];
        let end = [to[0].to_bits() as i64, to[1].to_bits() as i64, to[2].to_bits() as i64];
        let Some(direction) = unit([end[0] - x, end[1] - y, end[2] - z]) else { return None };
        Some(Stretch {
            direction,
            low: along::<F>(direction, [x, y, z]),
            high: along::<F>(direction, end),
        })
    }
}

/// The vector of length 1 in the direction of one whose coordinates fit 33 bits.
const fn unit([x, y, z]: [i64; 3]) -> Option<[Unit; 3]> {
    let square = x as i128 * x as i128 + y as i128 * y as i128 + z as i128 * z as i128;
    if square == 0 {
        return None;
    }
    // The length, and with it the quotients, have at least 30 digits more than the coordinates.
    let length = ((square as u128) << 60).isqrt() as i128;
    const fn coordinate(x: i64, length: i128) -> Unit {
        let bits = divide((x as i128) << (30 + 28), length);
        Unit::from_bits(bits as i32)
    }
    Some([coordinate(x, length), coordinate(y, length), coordinate(z, length)])
}

/// The scalar product of a direction with a point of this many units, rounded.
const fn along<F: Fraction>([x, y, z]: [Unit; 3], point: [i64; 3]) -> FixedI32<F> {
    let [x, y, z] = [x.to_bits() as i64, y.to_bits() as i64, z.to_bits() as i64];
    let sum = x * point[0] + y * point[1] + z * point[2];
    FixedI32::from_bits(narrow(shift_right(sum, 28)))
}
