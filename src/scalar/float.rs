//! [`Scalar`] for `f32` and `f64`.

use super::const_ops::{normalized, stretch};
use super::grid::Grid;
use super::kind::OfFloat;
use super::matrix::inverted;
use super::number::{Number, Real};
use super::rebase::{Rebased, rebased};
use super::scalar::{Formula, Inverse, Matrix, Roots, Scalar, Stretch};
use crate::numeric::{Double, Native, SATURATES_TO_I32, dot3, product_difference};
use core::fmt::Debug;

/// `x·y`, added up from the first coordinate on.
#[inline]
fn sum_of_products<S: Native, const N: usize>(x: [S; N], y: [S; N]) -> S {
    x.into_iter().zip(y).fold(S::ZERO, |sum, (x, y)| sum + x * y)
}

impl<S: Native> Number for S {
    const ZERO: Self = S::CONSTANTS.zero;
    const ONE: Self = S::CONSTANTS.one;

    #[inline]
    fn from_int(integer: i32) -> Self {
        S::from_i32(integer)
    }

    #[inline]
    fn from_f64(number: f64) -> Self {
        Native::from_double(number)
    }

    #[inline]
    fn to_f64(self) -> f64 {
        self.into()
    }

    #[inline]
    fn plus(self, other: Self) -> Self {
        self + other
    }

    #[inline]
    fn minus(self, other: Self) -> Self {
        self - other
    }

    #[inline]
    fn times(self, other: Self) -> Self {
        self * other
    }

    #[inline]
    fn negated(self) -> Self {
        -self
    }

    #[inline]
    fn abs(self) -> Self {
        self.magnitude()
    }

    #[inline]
    fn is_finite(self) -> bool {
        self.magnitude() < S::CONSTANTS.infinity
    }

    #[inline]
    fn dot(x: [Self; 3], y: [Self; 3]) -> Self {
        x[0] * y[0] + x[1] * y[1] + x[2] * y[2]
    }
}

impl<S: Native> Real for S {
    const PI: Self = S::CONSTANTS.pi;
    const HALF: Self = S::CONSTANTS.half;
    const EPSILON: Self = S::CONSTANTS.epsilon;
    const QUANTUM: Self = S::ZERO;

    #[inline]
    fn floor_to_i32(self) -> i32 {
        let whole = self.to_i32();
        if S::from_i32(whole) > self { whole.saturating_sub(1) } else { whole }
    }

    #[inline]
    fn ratio(self, divisor: Self) -> i32 {
        (self / divisor).to_i32()
    }

    #[inline]
    fn is_divisor(self) -> bool {
        (self * self).has_all_digits()
    }

    #[inline]
    fn sqrt(self) -> Self {
        self.root()
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        self.sine_and_cosine()
    }

    #[inline]
    fn normalizing_power(self) -> Self {
        self.inverse_power()
    }

    #[inline]
    fn after_steps(self, step: Self, count: i32) -> Self {
        self + step * S::from_i32(count)
    }

    #[inline]
    fn holds_steps(self, _: Self, _: i32) -> bool {
        true
    }

    #[inline]
    fn product_difference(a: Self, b: Self, c: Self, d: Self) -> Self {
        product_difference(a, b, c, d)
    }

    #[inline]
    fn dot3(x: [Self; 3], y: [Self; 3]) -> Self {
        dot3(x, y)
    }
}

impl<S: Native> Scalar for S {
    type Unit = Self;
    type Wide = Self;
    type Scale = Self;
    type OfKind<A: Copy + Debug, B: Copy + Debug> = OfFloat<A, B>;

    const LOWEST: Self = S::CONSTANTS.minus_infinity;
    const HIGHEST: Self = S::CONSTANTS.infinity;
    const MAX_COORDINATE: Self = S::CONSTANTS.lengths[1];
    const MIN_RADIUS: Self = S::CONSTANTS.lengths[0];
    const SHORTEST: Self = S::ZERO;
    const LONGEST: Self = S::CONSTANTS.largest;
    const ROUNDING: Self = S::ZERO;
    const NO_SCALE: Self = S::ZERO;
    const GRID: Grid = if size_of::<S>() < size_of::<f64>() { Grid::Single } else { Grid::Double };

    #[inline]
    fn from_ratio(numerator: i32, denominator: i32) -> Self {
        S::from_i32(numerator) / S::from_i32(denominator)
    }

    #[inline]
    fn inverse(self) -> Self {
        S::ONE / self
    }

    fn normalized(vector: [Self; 3]) -> Option<[Self; 3]> {
        Some(normalized(vector.map(S::into))?.map(S::from_double))
    }

    fn stretch(from: [Self; 3], to: [Self; 3]) -> Option<Stretch<Self>> {
        let ends = [from, to].map(|end| end.map(S::into));
        let Stretch { direction, low, high } = stretch(ends[0], ends[1], size_of::<S>())?;
        let direction = direction.map(S::from_double);
        Some(Stretch { direction, low: S::from_double(low), high: S::from_double(high) })
    }

    fn inverted(matrix: Matrix<Self>) -> Option<Inverse<Self>> {
        let most = S::CONSTANTS.lengths[1].into();
        let exact = inverted(matrix.map(|row| row.map(S::into)), most)?;
        let high = exact.map(|row| row.map(|entry| S::from_double(entry.high)));
        let low = exact.map(|row| {
            row.map(|Double { high, low }| {
                S::from_double((high - S::from_double(high).into()) + low)
            })
        });
        Some([high, low])
    }

    #[inline]
    fn uncertainty(size: Self) -> Self {
        // Twice the four units that all sums and products together may be off.
        size * (S::from_i32(8) * S::EPSILON)
    }

    #[inline]
    fn wide(self) -> Self {
        self
    }

    #[inline]
    fn from_wide(fine: Self) -> Self {
        fine
    }

    #[inline]
    fn unit(fine: Self) -> Self {
        fine
    }

    #[inline]
    fn wide_unit(unit: Self) -> Self {
        unit
    }

    #[inline]
    fn times_unit(self, unit: Self) -> Self {
        self * unit
    }

    #[inline]
    fn dot_unit(vector: [Self; 3], direction: [Self; 3]) -> Self {
        dot3(vector, direction)
    }

    #[inline]
    fn scale(fine: Self) -> Self {
        fine
    }

    #[inline]
    fn scaled(self, factor: Self) -> Self {
        self * factor
    }

    #[inline]
    fn stretched(self, factor: Self) -> Self {
        self * factor
    }

    #[inline]
    fn quotients([one, other]: [Self; 2], denominator: Self) -> [Self; 2] {
        [one / denominator, other / denominator]
    }

    #[inline]
    fn leg(hypotenuse: Self, leg: Self) -> Option<Self> {
        (hypotenuse * hypotenuse - leg * leg).positive().map(S::root)
    }

    #[inline]
    fn moment(q: [Self; 2], m: [Self; 2]) -> Self {
        q[0] * m[1] - q[1] * m[0]
    }

    #[inline]
    fn chord<const K: usize, const N: usize>(
        radius: Self,
        k: [Self; K],
        q: [Self; N],
        m: [Self; N],
    ) -> Option<Roots<Self>> {
        let a = sum_of_products(m, m);
        if !a.has_all_digits() {
            return None;
        }
        let discriminant = radius * radius * a - sum_of_products(k, k);
        let Some(discriminant) = discriminant.positive() else { return Some(Roots::Outside) };
        let inverse = S::ONE / a;
        let middle = -sum_of_products(q, m) * inverse;
        let half = discriminant.root() * inverse;
        Some(Roots::Between(middle - half, middle + half))
    }

    #[inline]
    fn length(vector: [Self; 3]) -> Self {
        S::dot(vector, vector).root()
    }

    #[inline]
    fn with_length(vector: [Self; 3], length: Self) -> [Self; 3] {
        // A point that is moved onto a surface is as near as this square is exact.
        let square = dot3(vector, vector);
        let factor = if square > S::ZERO { length / square.root() } else { S::ZERO };
        vector.map(|coordinate| coordinate * factor)
    }

    #[inline]
    fn next_below(self) -> Self {
        self.predecessor()
    }

    #[inline]
    fn to_level(self) -> u8 {
        let level = self * S::from_i32(255) + S::HALF;
        // Arm converts to the range of `i32` by itself, and x86 to none.
        if SATURATES_TO_I32 { level.to_i32().clamp(0, 255) as u8 } else { level.to_u8() }
    }

    #[inline(always)]
    fn compute<A: Formula<Self>>(formula: A) -> A::Output {
        formula.float()
    }

    #[inline(always)]
    fn rebased(origin: [Self; 3], direction: [Self; 3]) -> Rebased<Self> {
        rebased(origin, direction)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn powers_normalize(x in proptest::num::f32::POSITIVE | proptest::num::f32::SUBNORMAL) {
            prop_assume!(x > 0.0);
            let scaled = x * x.normalizing_power();
            let limit = if x < f32::MAX / 2.0 { 2.0 } else { 4.0 };
            prop_assert!(scaled < limit, "{x} became {scaled}");
            prop_assert!(scaled >= 1.0 || x < f32::MIN_POSITIVE, "{x} became {scaled}");
        }
    }

    #[test]
    fn levels_clamp_and_round() {
        let cases = [(-1.0, 0), (0.0, 0), (0.5, 128), (1.0, 255), (9.0, 255), (f32::NAN, 0)];
        for (value, level) in cases {
            assert_eq!(value.to_level(), level, "{value}");
        }
    }
}
