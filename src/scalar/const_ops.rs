//! What constructors check and compute, for constants: traits have no `const` methods yet.

use super::fixed::{FixedI32, Fraction, Scale, Wide};
use super::scalar::Scalar;
use crate::numeric::{const_sqrt, integer};
use core::marker::PhantomData;

/// The constant functions of a number type.
pub(crate) struct ConstOps<S>(PhantomData<S>);

/// The ends of a line, as offsets along its rounded direction.
pub(crate) struct Stretch<S: Scalar> {
    pub(crate) direction: [S::Unit; 3],
    pub(crate) low: S,
    pub(crate) high: S,
}

macro_rules! floats {
    ($($Float:ident),+) => {$(
        impl ConstOps<$Float> {
            pub(crate) const ZERO: $Float = 0.0;

            pub(crate) const fn is_finite(x: $Float) -> bool {
                x.is_finite()
            }

            pub(crate) const fn is_below(x: $Float, y: $Float) -> bool {
                x < y
            }

            pub(crate) const fn sum(x: $Float, y: $Float) -> $Float {
                x + y
            }

            pub(crate) const fn difference(x: $Float, y: $Float) -> $Float {
                x - y
            }

            pub(crate) const fn is_within_reach(x: $Float) -> bool {
                x.abs() <= <$Float>::MAX_COORDINATE
            }

            pub(crate) const fn is_radius(x: $Float) -> bool {
                <$Float>::MIN_RADIUS <= x && x <= <$Float>::MAX_COORDINATE
            }

            pub(crate) const fn inverse(radius: $Float) -> $Float {
                1.0 / radius
            }

            /// The coordinate axis, 0 to 2, that a direction lies along, if it does.
            pub(crate) const fn axis([x, y, z]: [$Float; 3]) -> Option<u8> {
                match (x == 0.0, y == 0.0, z == 0.0) {
                    (_, true, true) => Some(0),
                    (true, _, true) => Some(1),
                    (true, true, _) => Some(2),
                    _ => None,
                }
            }

            /// The vector of length 1 in the direction of a finite one, or `None` for zero.
            pub(crate) const fn normalized([x, y, z]: [$Float; 3]) -> Option<[$Float; 3]> {
                match normalized([x as f64, y as f64, z as f64]) {
                    Some([x, y, z]) => Some([x as $Float, y as $Float, z as $Float]),
                    None => None,
                }
            }

            /// The direction from one point to another, and where along it they lie.
            pub(crate) const fn stretch(
                from: [$Float; 3],
                to: [$Float; 3],
            ) -> Option<Stretch<$Float>> {
                let start = [from[0] as f64, from[1] as f64, from[2] as f64];
                let end = [to[0] as f64, to[1] as f64, to[2] as f64];
                let way = [end[0] - start[0], end[1] - start[1], end[2] - start[2]];
                let Some([x, y, z]) = normalized(way) else { return None };
                let direction = [x as $Float, y as $Float, z as $Float];
                // Along the direction as it was rounded, which is what lines will be held against.
                let [x, y, z] = [direction[0] as f64, direction[1] as f64, direction[2] as f64];
                let low = (x * start[0] + y * start[1] + z * start[2]) as $Float;
                let high = (x * end[0] + y * end[1] + z * end[2]) as $Float;
                Some(Stretch { direction, low, high })
            }
        }
    )+};
}

floats!(f32, f64);

const fn normalized([x, y, z]: [f64; 3]) -> Option<[f64; 3]> {
    let largest = x.abs().max(y.abs()).max(z.abs());
    if largest == 0.0 {
        return None;
    }
    // Scaled by the largest coordinate, no square can overflow or vanish.
    let (x, y, z) = (x / largest, y / largest, z / largest);
    let length = const_sqrt(x * x + y * y + z * z);
    Some([x / length, y / length, z / length])
}

type Unit<F> = <FixedI32<F> as Scalar>::Unit;

impl<F: Fraction> ConstOps<FixedI32<F>> {
    pub(crate) const ZERO: FixedI32<F> = FixedI32::from_bits(0);

    pub(crate) const fn is_finite(_: FixedI32<F>) -> bool {
        true
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

    /// The coordinate axis, 0 to 2, that a direction lies along, if it does.
    pub(crate) const fn axis([x, y, z]: [Unit<F>; 3]) -> Option<u8> {
        match (x.to_bits() == 0, y.to_bits() == 0, z.to_bits() == 0) {
            (_, true, true) => Some(0),
            (true, _, true) => Some(1),
            (true, true, _) => Some(2),
            _ => None,
        }
    }

    /// The vector of length 1 in the direction of another one, or `None` for zero.
    pub(crate) const fn normalized([x, y, z]: [FixedI32<F>; 3]) -> Option<[Unit<F>; 3]> {
        unit::<F>([x.to_bits() as i64, y.to_bits() as i64, z.to_bits() as i64])
    }

    /// The direction from one point to another, and where along it they lie.
    pub(crate) const fn stretch(
        from: [FixedI32<F>; 3],
        to: [FixedI32<F>; 3],
    ) -> Option<Stretch<FixedI32<F>>> {
        let [x, y, z] =
            [from[0].to_bits() as i64, from[1].to_bits() as i64, from[2].to_bits() as i64];
        let end = [to[0].to_bits() as i64, to[1].to_bits() as i64, to[2].to_bits() as i64];
        let Some(direction) = unit::<F>([end[0] - x, end[1] - y, end[2] - z]) else { return None };
        Some(Stretch {
            direction,
            low: along::<F>(direction, [x, y, z]),
            high: along::<F>(direction, end),
        })
    }
}

/// The vector of length 1 in the direction of one whose coordinates fit 33 bits.
const fn unit<F: Fraction>([x, y, z]: [i64; 3]) -> Option<[Unit<F>; 3]> {
    let square = x as i128 * x as i128 + y as i128 * y as i128 + z as i128 * z as i128;
    if square == 0 {
        return None;
    }
    // The length, and with it the quotients, have at least 30 digits more than the coordinates.
    let length = ((square as u128) << 60).isqrt() as i128;
    const fn coordinate<F: Fraction>(x: i64, length: i128) -> Unit<F> {
        let bits = integer::divide((x as i128) << (30 + 28), length);
        Unit::<F>::from_bits(bits as i32)
    }
    Some([coordinate::<F>(x, length), coordinate::<F>(y, length), coordinate::<F>(z, length)])
}

/// The scalar product of a direction with a point of this many units, rounded.
const fn along<F: Fraction>([x, y, z]: [Unit<F>; 3], point: [i64; 3]) -> FixedI32<F> {
    let [x, y, z] = [x.to_bits() as i64, y.to_bits() as i64, z.to_bits() as i64];
    let sum = x * point[0] + y * point[1] + z * point[2];
    FixedI32::from_bits(integer::narrow(integer::shift_right(sum, 28)))
}
