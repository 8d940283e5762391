//! Formulas that floating point and fixed point compute in ways of their own.

use super::{Float, Scalar};

/// Where a line is inside a solid, in the line's parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Roots<S> {
    /// Nowhere.
    Outside,
    /// Everywhere: the line never crosses the surface.
    Everywhere,
    /// From the first parameter to the second. They are equal for a tangent.
    Between(S, S),
}

impl<S: Scalar> Roots<S> {
    /// The two parameters: the ends of the number range where the line never crosses the surface.
    #[inline(always)]
    pub(crate) fn ends(self) -> Option<(S, S)> {
        match self {
            Self::Outside => None,
            Self::Everywhere => Some((S::LOWEST, S::HIGHEST)),
            Self::Between(enter, exit) => Some((enter, exit)),
        }
    }
}

/// A computation with a body for each kind of number: [`Scalar::compute`] takes the right one.
///
/// So the number types know no formula, and a new formula stands in its own file.
pub trait Formula<S: Scalar> {
    /// The result.
    type Output;

    /// In floating point.
    fn float(self) -> Self::Output
    where
        S: Float;

    /// In fixed point.
    fn fixed(self) -> Self::Output
    where
        S: FixedPoint;
}

/// A fixed-point number, as integers.
pub trait FixedPoint: Scalar {
    /// The number of bits behind the point.
    const BITS: u32;

    /// The number in units of its last bit.
    fn to_bits(self) -> i32;

    /// The number of so many units.
    fn from_bits(bits: i32) -> Self;

    /// A coordinate of a direction, in units of 2⁻²⁸.
    fn unit_bits(unit: Self::Unit) -> i32;
}
