//! Unit vectors that know whether they point along a coordinate axis.

use super::vec3::Vec3;
use crate::scalar::{ConstOps, Number, Real, Scalar, Stretch, per_scalar};

/// A vector of length 1 (up to rounding).
///
/// Most axes and normals of a part point along a coordinate axis. For these, products with the
/// other coordinates' zeros are left out, and what is left is exact.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Direction<S: Scalar> {
    vector: Vec3<S::Unit>,
    along: Option<Axis>,
}

/// A coordinate axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Axis {
    /// The first.
    X,
    /// The second.
    Y,
    /// The third.
    Z,
}

per_scalar! { $S: impl[] Direction<$S> {
    /// As [`from_unit`](Self::from_unit), for constants.
    pub(crate) const fn new(vector: [<$S as Scalar>::Unit; 3]) -> Self {
        type Ops<S> = ConstOps<<S as Scalar>::Unit>;
        let [x, y, z] = vector;
        let zeros = [Ops::<$S>::is_zero(x), Ops::<$S>::is_zero(y), Ops::<$S>::is_zero(z)];
        Self { vector: Vec3 { x, y, z }, along: Axis::with(zeros) }
    }
} }

/// Whether a product of two vectors with lengths of about 1 is what it should be, up to their rounding:
/// to 2⁻²³ of each coordinate, or better. Not for NaN.
pub(super) fn is_rounded<T: Real>(product: T, exact: T) -> bool {
    (product - exact).abs() * T::from_int(1 << 20) <= T::ONE
}

impl<S: Scalar> Direction<S> {
    pub(crate) const X: Self = Self {
        vector: Vec3::new(S::Unit::ONE, S::Unit::ZERO, S::Unit::ZERO),
        along: Some(Axis::X),
    };
    pub(crate) const Y: Self = Self {
        vector: Vec3::new(S::Unit::ZERO, S::Unit::ONE, S::Unit::ZERO),
        along: Some(Axis::Y),
    };
    pub(crate) const Z: Self = Self {
        vector: Vec3::new(S::Unit::ZERO, S::Unit::ZERO, S::Unit::ONE),
        along: Some(Axis::Z),
    };

    /// The direction of an axis.
    pub(crate) const fn along_axis(axis: Axis) -> Self {
        match axis {
            Axis::X => Self::X,
            Axis::Y => Self::Y,
            Axis::Z => Self::Z,
        }
    }

    /// The direction of a vector that has length 1.
    pub(crate) fn from_unit(vector: [S::Unit; 3]) -> Self {
        let along = Axis::with(vector.map(|coordinate| coordinate == S::Unit::ZERO));
        Self { vector: Vec3::from(vector), along }
    }

    /// The direction of a vector, if its length is 1 up to rounding.
    pub(crate) fn of_length_1(vector: Vec3<S::Unit>) -> Option<Self> {
        let fine = vector.map(S::wide_unit);
        is_rounded(fine.dot_compensated(fine), S::Wide::ONE)
            .then(|| Self::from_unit(vector.to_array()))
    }

    /// The direction of a finite vector, or `None` for zero.
    pub(crate) fn normalized(vector: Vec3<S>) -> Option<Self> {
        S::normalized(vector.to_array()).map(Self::from_unit)
    }

    /// The direction from one point to another, and where along it they lie, or `None` if they coincide.
    pub(crate) fn between(from: Vec3<S>, to: Vec3<S>) -> Option<(Self, [S; 2])> {
        let Stretch { direction, low, high } = S::stretch(from.to_array(), to.to_array())?;
        Some((Self::from_unit(direction), [low, high]))
    }

    /// The vector.
    #[inline]
    pub(crate) const fn vector(&self) -> Vec3<S::Unit> {
        self.vector
    }

    /// The vector with more digits, for the set-up of views.
    pub(crate) fn wide(&self) -> Vec3<S::Wide> {
        self.vector.map(S::wide_unit)
    }

    /// The coordinate axis that it lies along, in either direction.
    #[inline]
    pub(crate) fn along(&self) -> Option<Axis> {
        self.along
    }

    /// The scalar product with a vector: exact along a coordinate axis, else in twice the working
    /// precision and rounded.
    #[inline]
    pub(crate) fn dot(&self, other: Vec3<S>) -> S {
        match self.along {
            Some(Axis::X) => other.x.times_unit(self.vector.x),
            Some(Axis::Y) => other.y.times_unit(self.vector.y),
            Some(Axis::Z) => other.z.times_unit(self.vector.z),
            None => S::dot_unit(other.to_array(), self.vector.to_array()),
        }
    }

    /// As [`dot`](Self::dot), with more digits.
    pub(crate) fn dot_wide(&self, other: Vec3<S::Wide>) -> S::Wide {
        let fine = self.wide();
        match self.along {
            Some(Axis::X) => fine.x * other.x,
            Some(Axis::Y) => fine.y * other.y,
            Some(Axis::Z) => fine.z * other.z,
            None => fine.dot_compensated(other),
        }
    }

    /// The point nearest to another one on the plane at `offset` that the direction is normal to.
    pub(crate) fn onto_plane(&self, offset: S, near: Vec3<S>) -> Vec3<S> {
        near + self.times(offset.minus(self.dot(near)))
    }

    /// The direction times a length.
    #[inline]
    pub(crate) fn times(&self, length: S) -> Vec3<S> {
        self.vector.map(|coordinate| length.times_unit(coordinate))
    }
}

impl Axis {
    /// All three, in order.
    pub const ALL: [Self; 3] = [Self::X, Self::Y, Self::Z];

    /// A vector from its coordinate along the axis and the other two, in the order x, y, z.
    pub(crate) const fn placed<T: Copy>(self, along: T, [u, v]: [T; 2]) -> [T; 3] {
        match self {
            Self::X => [along, u, v],
            Self::Y => [u, along, v],
            Self::Z => [u, v, along],
        }
    }

    /// The coordinate of a vector along the axis.
    #[inline]
    pub(crate) const fn of<T: Copy>(self, v: Vec3<T>) -> T {
        let [first, ..] = self.turned(v);
        first
    }

    /// The axis of a vector, of which some coordinates are zero.
    const fn with(zeros: [bool; 3]) -> Option<Self> {
        match zeros {
            [_, true, true] => Some(Self::X),
            [true, _, true] => Some(Self::Y),
            [true, true, _] => Some(Self::Z),
            _ => None,
        }
    }

    /// The coordinates of a vector, this axis's first and the others in any order: two change places.
    #[inline]
    pub(crate) const fn turned<T: Copy>(self, v: Vec3<T>) -> [T; 3] {
        match self {
            Self::X => [v.x, v.y, v.z],
            Self::Y => [v.y, v.x, v.z],
            Self::Z => [v.z, v.y, v.x],
        }
    }

    /// The other two coordinates of a vector, in cyclic order.
    #[inline]
    pub(crate) fn across<T: Copy>(self, v: Vec3<T>) -> [T; 2] {
        match self {
            Self::X => [v.y, v.z],
            Self::Y => [v.z, v.x],
            Self::Z => [v.x, v.y],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{FixedI32, I16F16};
    use fixed::types::extra::U28;
    use proptest::prelude::*;

    /// What constants have, a type parameter has, too.
    macro_rules! same {
        ($S:ty, $from:expr, $to:expr) => {{
            let (from, to): ([$S; 3], [$S; 3]) = ($from, $to);
            let constant = ConstOps::<$S>::normalized(to).map(Direction::<$S>::new);
            prop_assert_eq!(Direction::normalized(Vec3::from(to)), constant);
            let constant = ConstOps::<$S>::stretch(from, to)
                .map(|it| (Direction::<$S>::new(it.direction), [it.low, it.high]));
            prop_assert_eq!(Direction::between(Vec3::from(from), Vec3::from(to)), constant);
            for x in to {
                prop_assert_eq!(x.is_within_range(), ConstOps::<$S>::is_within_reach(x));
                prop_assert_eq!(x.is_radius(), ConstOps::<$S>::is_radius(x));
                if x.is_radius() {
                    prop_assert_eq!(x.inverse(), ConstOps::<$S>::inverse(x));
                }
            }
        }};
    }

    fn numbers() -> impl Strategy<Value = [i32; 3]> {
        let number = prop_oneof![any::<i32>(), -2..=2, Just(1 << 28), Just((1 << 28) + 1)];
        [number.clone(), number.clone(), number]
    }

    proptest! {
        #[test]
        fn all_number_types(from in numbers(), to in numbers()) {
            same!(I16F16, from.map(I16F16::from_bits), to.map(I16F16::from_bits));
            type Fine = FixedI32<U28>;
            same!(Fine, from.map(Fine::from_bits), to.map(Fine::from_bits));
            same!(f64, from.map(f64::from), to.map(f64::from));
            same!(f32, from.map(|x| x as f32 * 1e7), to.map(|x| x as f32 * 1e7));
            same!(f32, from.map(|x| x as f32), to.map(|x| x as f32 * 1e-12));
        }

        #[test]
        fn quotients_are_rounded(numerator: i32, denominator: i32, drop in 0..31u32) {
            let (numerator, denominator) = (numerator >> drop, denominator >> (30 - drop));
            prop_assume!(denominator != 0);
            let exact = f64::from(numerator) / f64::from(denominator);
            prop_assert_eq!(f64::from_ratio(numerator, denominator), exact);
            let fixed = I16F16::from_ratio(numerator, denominator);
            let bits = (exact * 65_536.0).clamp(i32::MIN.into(), i32::MAX.into());
            prop_assert!((f64::from(fixed.to_bits()) - bits).abs() <= 0.5);
            if numerator.abs() <= 1 << 24 && denominator.abs() <= 1 << 24 {
                prop_assert_eq!(f32::from_ratio(numerator, denominator), exact as f32);
            }
            prop_assert_eq!(I16F16::from_ratio(numerator, 1), I16F16::from_int(numerator));
        }
    }

    #[test]
    fn axes() {
        for (axis, unit) in
            [(Axis::X, [1.0, 0.0, 0.0]), (Axis::Y, [0.0, 1.0, 0.0]), (Axis::Z, [0.0, 0.0, 1.0])]
        {
            assert_eq!(Direction::<f32>::along_axis(axis), Direction::from_unit(unit));
        }
    }
}
