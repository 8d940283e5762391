//! Numbers as bytes: their bits, little-endian.

use crate::scalar::{FixedPoint, Float, Formula, Scalar};

/// The number type: 32 for `f32`, 64 for `f64`, or how many bits of 32 are fraction.
pub(super) fn format<S: Scalar>() -> u8 {
    S::compute(Format)
}

struct Format;

impl<S: Scalar> Formula<S> for Format {
    type Output = u8;

    fn float(self) -> u8
    where
        S: Float,
    {
        8 * size_of::<S>() as u8
    }

    fn fixed(self) -> u8
    where
        S: FixedPoint,
    {
        S::BITS as u8
    }
}

/// The bits of a number.
pub(super) struct ToBits<S>(pub(super) S);

impl<S: Scalar> Formula<S> for ToBits<S> {
    type Output = [u8; 8];

    fn float(self) -> [u8; 8]
    where
        S: Float,
    {
        let number = self.0.to_f64();
        if size_of::<S>() == 4 {
            u64::from((number as f32).to_bits()).to_le_bytes()
        } else {
            number.to_bits().to_le_bytes()
        }
    }

    fn fixed(self) -> [u8; 8]
    where
        S: FixedPoint,
    {
        u64::from(self.0.to_bits() as u32).to_le_bytes()
    }
}

/// The number of some bits.
pub(super) struct FromBits(pub(super) [u8; 8]);

impl<S: Scalar> Formula<S> for FromBits {
    type Output = S;

    fn float(self) -> S
    where
        S: Float,
    {
        let bits = u64::from_le_bytes(self.0);
        let number = if size_of::<S>() == 4 {
            f32::from_bits(bits as u32).into()
        } else {
            f64::from_bits(bits)
        };
        S::from_f64(number)
    }

    fn fixed(self) -> S
    where
        S: FixedPoint,
    {
        S::from_bits(u64::from_le_bytes(self.0) as i32)
    }
}

/// The bits of a coordinate of a direction.
pub(super) struct UnitToBits<S: Scalar>(pub(super) S::Unit);

impl<S: Scalar> Formula<S> for UnitToBits<S> {
    type Output = [u8; 8];

    fn float(self) -> [u8; 8]
    where
        S: Float,
    {
        ToBits(self.0).float()
    }

    fn fixed(self) -> [u8; 8]
    where
        S: FixedPoint,
    {
        u64::from(S::unit_bits(self.0) as u32).to_le_bytes()
    }
}

/// The coordinate of a direction of some bits.
pub(super) struct UnitFromBits(pub(super) [u8; 8]);

impl<S: Scalar> Formula<S> for UnitFromBits {
    type Output = S::Unit;

    fn float(self) -> S::Unit
    where
        S: Float,
    {
        Formula::<S>::float(FromBits(self.0))
    }

    fn fixed(self) -> S::Unit
    where
        S: FixedPoint,
    {
        S::unit_from_bits(u64::from_le_bytes(self.0) as i32)
    }
}
