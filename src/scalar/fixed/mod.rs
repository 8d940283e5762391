//! [`Scalar`] for 32-bit fixed point.
//!
//! Products of two numbers are exact in 64 bits, so a difference of squares is exact too, and
//! whether it is positive is never a matter of rounding.

mod const_ops;
mod scale;
pub(super) mod wide;

pub use ::fixed::FixedI32;
pub use ::fixed::types::I16F16;
pub use scale::Scale;
pub use wide::Wide;

use super::const_ops::ConstOps;
use super::grid::Grid;
use super::kind::OfFixed;
use super::number::{Number, sealed::Sealed};
use super::rebase::Rebased;
use super::scalar::{FixedPoint, Formula, Inverse, Matrix, Roots, Scalar, Stretch};
use crate::numeric::integer::{
    divide, leading_zeros, narrow, normalized, quotient_by, reciprocal, root_with_40_digits,
    rounded_to_i32, shift_right, sqrt,
};
use crate::numeric::{product, unsigned_product};
use ::fixed::types::extra::{LeEqU32, U28};
use core::fmt::Debug;

/// A number of fraction bits from 8 to 28.
pub trait Fraction: LeEqU32 + 'static {
    #[doc(hidden)]
    const BITS: u32;
}

impl<T: LeEqU32 + 'static> Fraction for T {
    const BITS: u32 = {
        assert!(T::U32 >= 8 && T::U32 <= 28, "a scene needs from 8 to 28 fraction bits");
        T::U32
    };
}

/// Coordinates and directions.
type Unit = FixedI32<U28>;
const UNIT_BITS: u32 = 28;

impl<F: Fraction> Sealed for FixedI32<F> {}

impl<F: Fraction> Number for FixedI32<F> {
    const ZERO: Self = Self::from_bits(0);
    const ONE: Self = Self::from_bits(1 << F::BITS);

    fn from_int(integer: i32) -> Self {
        Self::from_bits(narrow(i64::from(integer) << F::BITS))
    }

    fn from_f64(number: f64) -> Self {
        ConstOps::<Self>::from_f64(number)
    }

    fn to_f64(self) -> f64 {
        ConstOps::<Self>::to_f64(self)
    }

    #[inline]
    fn plus(self, other: Self) -> Self {
        self.saturating_add(other)
    }

    #[inline]
    fn minus(self, other: Self) -> Self {
        self.saturating_sub(other)
    }

    #[inline]
    fn times(self, other: Self) -> Self {
        rounded(product(self.to_bits(), other.to_bits()), F::BITS)
    }

    #[inline]
    fn negated(self) -> Self {
        self.saturating_neg()
    }

    #[inline]
    fn abs(self) -> Self {
        self.saturating_abs()
    }

    #[inline]
    fn is_finite(self) -> bool {
        true
    }

    #[inline(never)] // for each kind of axis, and long on small cores
    fn dot(x: [Self; 3], y: [Self; 3]) -> Self {
        rounded(sum_of_products(x.map(Self::to_bits), y.map(Self::to_bits)), F::BITS)
    }
}

/// `x·y`; a sum that leaves the range of `i64` stays at its end.
#[inline]
fn sum_of_products<const N: usize>(x: [i32; N], y: [i32; N]) -> i64 {
    x.into_iter().zip(y).fold(0i64, |sum, (x, y)| sum.saturating_add(product(x, y)))
}

/// Numbers with all the digits that 31 bits have room for in the largest, and how many are dropped.
#[inline]
fn short<const N: usize>(x: [Wide; N]) -> ([i32; N], i32) {
    let all = x.iter().fold(0, |all, x| all | x.to_bits().unsigned_abs());
    let drop = (34 - leading_zeros(all) as i32).max(0);
    (x.map(|x| shift_right(x.to_bits(), drop) as i32), drop)
}

/// `|x|²`, for up to 3 coordinates.
#[inline]
fn sum_of_squares<const N: usize>(x: [i32; N]) -> u64 {
    const { assert!(N <= 3) };
    x.into_iter().fold(0u64, |sum, x| sum.wrapping_add(product(x, x).unsigned_abs()))
}

/// `bits / 2^shift` as a number; a shift by 1 to 31 bits.
#[inline]
fn rounded<F: Fraction>(bits: i64, shift: u32) -> FixedI32<F> {
    FixedI32::from_bits(rounded_to_i32(bits, shift))
}

/// The nearest whole number to the root of `square · 2^exponent`.
#[inline]
fn root(square: u64, exponent: i32) -> i64 {
    // An even exponent can be halved; the root has all its 32 bits if the square has 64.
    let zeros = square.leading_zeros() as i32;
    let spare = if (zeros + exponent) & 1 == 0 { zeros } else { zeros - 1 };
    let (square, shift) = if spare < 0 {
        (square >> 1, (exponent + 1) / 2)
    } else {
        (square.checked_shl(spare.unsigned_abs()).unwrap_or(0), (exponent - spare) / 2)
    };
    shift_right(i64::from(sqrt(square)), -shift)
}

#[inline]
fn quotients<F: Fraction, const N: usize>(
    numerators: [Wide; N],
    denominator: Wide,
) -> [FixedI32<F>; N] {
    let inverse = Scale::inverse(denominator.abs());
    let is_negative = denominator < Wide::ZERO;
    let exponent = F::BITS as i32 - Wide::FRACTION_BITS as i32;
    numerators.map(|numerator| {
        let numerator = if is_negative { -numerator } else { numerator };
        FixedI32::from_bits(narrow(inverse.times_wide(numerator.to_bits(), exponent)))
    })
}

impl<F: Fraction> Scalar for FixedI32<F> {
    type Unit = Unit;
    type Wide = Wide;
    type Scale = Scale;
    type OfKind<A: Copy + Debug, B: Copy + Debug> = OfFixed<A, B>;

    const LOWEST: Self = Self::MIN;
    const HIGHEST: Self = Self::MAX;
    const MAX_COORDINATE: Self = Self::from_bits(1 << 28);
    const MIN_RADIUS: Self = Self::from_bits(1);
    const SHORTEST: Self = Self::from_bits(1 << (F::BITS - 1));
    const LONGEST: Self = Self::from_bits(1 << 30);
    const ROUNDING: Self = Self::from_bits(2);
    const NO_SCALE: Scale = Scale::NONE;
    const GRID: Grid = Grid::Fixed(F::BITS);

    fn from_ratio(numerator: i32, denominator: i32) -> Self {
        let bits = divide(i128::from(numerator) << F::BITS, denominator.into());
        Self::from_bits(narrow(bits as i64))
    }

    fn inverse(self) -> Scale {
        ConstOps::<Self>::inverse(self)
    }

    fn normalized(vector: [Self; 3]) -> Option<[Unit; 3]> {
        ConstOps::<Self>::normalized(vector)
    }

    fn stretch(from: [Self; 3], to: [Self; 3]) -> Option<Stretch<Self>> {
        ConstOps::<Self>::stretch(from, to)
    }

    fn inverted(matrix: Matrix<Wide>) -> Option<Inverse<Wide>> {
        ConstOps::<Self>::inverted(matrix)
    }

    #[inline]
    fn uncertainty(_: Wide) -> Wide {
        // Each of two is rounded to a unit, and so is their sum.
        Self::from_bits(4).wide()
    }

    #[inline]
    fn wide(self) -> Wide {
        Wide::from_bits(i64::from(self.to_bits()) << (Wide::FRACTION_BITS - F::BITS))
    }

    #[inline]
    fn from_wide(fine: Wide) -> Self {
        rounded(fine.to_bits(), Wide::FRACTION_BITS - F::BITS)
    }

    #[inline]
    fn unit(fine: Wide) -> Unit {
        rounded(fine.to_bits(), Wide::FRACTION_BITS - UNIT_BITS)
    }

    #[inline]
    fn wide_unit(unit: Unit) -> Wide {
        unit.wide()
    }

    #[inline]
    fn times_unit(self, unit: Unit) -> Self {
        rounded(product(self.to_bits(), unit.to_bits()), UNIT_BITS)
    }

    #[inline]
    fn dot_unit(vector: [Self; 3], direction: [Unit; 3]) -> Self {
        let sum = sum_of_products(vector.map(Self::to_bits), direction.map(Unit::to_bits));
        rounded(sum, UNIT_BITS)
    }

    #[inline(never)]
    fn scale(fine: Wide) -> Scale {
        Scale::new(fine)
    }

    #[inline(never)] // in several places of a normal
    fn scaled(self, factor: Scale) -> Self {
        Self::from_bits(narrow(factor.times(self.to_bits(), 0)))
    }

    #[inline]
    fn stretched(self, factor: Scale) -> Wide {
        let exponent = (Wide::FRACTION_BITS - F::BITS) as i32;
        Wide::from_bits(factor.times(self.to_bits(), exponent))
    }

    #[inline(never)]
    fn quotients(numerators: [Wide; 2], denominator: Wide) -> [Self; 2] {
        quotients(numerators, denominator)
    }

    #[inline]
    fn leg(hypotenuse: Self, leg: Self) -> Option<Self> {
        let (hypotenuse, leg) = (hypotenuse.to_bits().unsigned_abs(), leg.to_bits().unsigned_abs());
        // Below 2^62, so the root is below 2^31.
        let difference = hypotenuse.checked_sub(leg).filter(|&difference| difference > 0)?;
        let square = unsigned_product(difference, hypotenuse + leg);
        Some(Self::from_bits(sqrt(square).min(i32::MAX as u32) as i32))
    }

    #[inline]
    fn moment(q: [Self; 2], m: [Unit; 2]) -> Wide {
        let [q, m] = [q.map(Self::to_bits), m.map(Unit::to_bits)];
        let moment = product(q[0], m[1]) - product(q[1], m[0]);
        Wide::from_bits(shift_right(moment, (F::BITS + UNIT_BITS - Wide::FRACTION_BITS) as i32))
    }

    fn chord<const K: usize, const N: usize>(
        radius: Self,
        k: [Wide; K],
        q: [Self; N],
        m: [Unit; N],
    ) -> Option<Roots<Self>> {
        // Bits of a and b have 2·28 and F + 28 digits behind the point; r² has 2F.
        let m = m.map(Unit::to_bits);
        let (a, exponent) = normalized(sum_of_squares(m));
        // |m| below 2^-14 has less than 14 bits.
        if a == 0 || exponent < 2 * (UNIT_BITS as i32 - 14) - 31 {
            return None;
        }
        // 1/a = inverse · 2^(−63 − exponent + 56)
        let inverse = u64::from(reciprocal(a));
        let one_over_a = 2 * UNIT_BITS as i32 - 63 - exponent;

        let (k, drop) = short(k);
        let (squared, to_k) = normalized(sum_of_squares(k));
        let to_k = to_k + one_over_a + 2 * (drop + F::BITS as i32 - Wide::FRACTION_BITS as i32);
        if squared > 0 && to_k > 0 {
            // Far more than the square of any radius.
            return Some(Roots::Outside);
        }
        let distance_squared =
            (u64::from(squared) * inverse).checked_shr(to_k.unsigned_abs()).unwrap_or(0);
        let square = product(radius.to_bits(), radius.to_bits()).unsigned_abs();
        let Some(square) = square.checked_sub(distance_squared).filter(|&square| square > 0) else {
            return Some(Roots::Outside);
        };
        let (square, exponent) = normalized(square);
        let half = root(u64::from(square) * inverse, exponent + one_over_a);

        let b = sum_of_products(q.map(Self::to_bits), m);
        let drop = (33 - b.unsigned_abs().leading_zeros() as i32).max(0);
        let product = shift_right(b, drop).saturating_mul((inverse >> 1) as i64);
        // Half of the inverse, and one of the 28 digits twice that b has too many.
        let shift = UNIT_BITS as i32 - (drop + one_over_a + 1);
        // Only the ends are held inside the range: far outside, both parts may be beyond it.
        let middle = -shift_right(product, shift);
        let [enter, exit] = [middle.saturating_sub(half), middle.saturating_add(half)];
        Some(Roots::Between(Self::from_bits(narrow(enter)), Self::from_bits(narrow(exit))))
    }

    #[inline(never)]
    fn length(vector: [Self; 3]) -> Self {
        Self::from_bits(narrow(root(sum_of_squares(vector.map(Self::to_bits)), 0)))
    }

    fn with_length(vector: [Self; 3], length: Self) -> [Self; 3] {
        let bits = vector.map(Self::to_bits);
        // The vector's length has 20 more digits than it shows.
        let long = root_with_40_digits(sum_of_squares(bits));
        let (mantissa, exponent) = normalized(long);
        let inverse = reciprocal(mantissa);
        bits.map(|bits| {
            let numerator = product(bits, length.to_bits());
            let bits = if long == 0 { 0 } else { quotient_by(inverse, exponent, long, numerator) };
            Self::from_bits(narrow(bits))
        })
    }

    fn next_below(self) -> Self {
        self.saturating_sub(Self::from_bits(1))
    }

    #[inline]
    fn to_level(self) -> u8 {
        let level = rounded_to_i32(product(self.to_bits(), 255), F::BITS);
        level.clamp(0, 255) as u8
    }

    #[inline(always)]
    fn compute<A: Formula<Self>>(formula: A) -> A::Output {
        formula.fixed()
    }

    #[inline]
    fn rebased(origin: [Self; 3], direction: [Self; 3]) -> Rebased<Self> {
        Rebased::unchanged(origin, direction)
    }
}

impl<F: Fraction> FixedPoint for FixedI32<F> {
    const BITS: u32 = F::BITS;

    #[inline]
    fn to_bits(self) -> i32 {
        Self::to_bits(self)
    }

    #[inline]
    fn from_bits(bits: i32) -> Self {
        Self::from_bits(bits)
    }

    #[inline]
    fn unit_bits(unit: Unit) -> i32 {
        unit.to_bits()
    }

    #[inline]
    fn unit_from_bits(bits: i32) -> Unit {
        Unit::from_bits(bits)
    }

    #[inline(never)]
    fn quotient(numerator: Wide, denominator: Wide) -> Self {
        let [quotient] = quotients([numerator], denominator);
        quotient
    }
}
