//! What a number type of scenes can do.

use super::fixed::wide::Wide;
use super::grid::Grid;
use super::kind::ByKind;
use super::number::{Number, Real};
use super::rebase::Rebased;
use crate::numeric::{Native, add_product};
use core::fmt::Debug;

/// A number type that scenes, cameras and rows can be made of: coordinates, lengths and the
/// parameters of lines.
///
/// What else a picture needs are numbers of other sizes. In floating point they are all of the
/// scene's own type; in fixed point each has its own.
pub trait Scalar: Number {
    /// A number of about the size of 1: a coordinate of a direction.
    type Unit: Number;
    /// A number with more digits behind the point: for the set-up of views, and for what is added
    /// up from pixel to pixel.
    type Wide: Real;
    /// A positive factor of any size.
    type Scale: Copy + Debug + PartialEq;
    /// `A` in floating point, `B` in fixed point.
    #[doc(hidden)]
    type OfKind<A: Copy + Debug, B: Copy + Debug>: ByKind<A, B>;

    /// Below every parameter of a crossing: −∞ where the type has it.
    const LOWEST: Self;
    /// Above every parameter of a crossing: +∞ where the type has it.
    const HIGHEST: Self;
    /// The largest coordinate and radius: 10¹⁵ for `f32`, 10⁶⁰ for `f64`, 4096 for [`I16F16`](super::I16F16) and
    /// 2²⁸ units for all fixed point. Up to there nothing overflows. Beyond, constructors return
    /// errors.
    const MAX_COORDINATE: Self;
    /// The smallest radius: 10⁻¹² for `f32`, 10⁻⁶⁰ for `f64`, one unit in fixed point. Below,
    /// constructors return errors.
    const MIN_RADIUS: Self;
    /// The largest coordinate of a ray's direction must be at least this: 0 in floating point,
    /// 1/2 in fixed point, so that the parameters of everything within reach can be represented.
    const SHORTEST: Self;
    /// The largest coordinate of a ray's direction may be this: 2³⁰ units in fixed point.
    const LONGEST: Self;

    /// How far off a length in a pixel may be because it is rounded to this type: 0 in floating
    /// point, whose errors are relative, 2 units in fixed point.
    const ROUNDING: Self;

    #[doc(hidden)]
    const GRID: Grid;

    /// `numerator / denominator`, for a denominator other than 0: how generic code writes a number.
    ///
    /// In fixed point the quotient is rounded to nearest and held inside the type's range. In floating point
    /// it is rounded to nearest where neither of the two is larger than 2²⁴ in size.
    ///
    /// ```
    /// use scancsg::scalar::{I16F16, Scalar};
    ///
    /// fn a_third<S: Scalar>() -> S {
    ///     S::from_ratio(1, 3)
    /// }
    /// assert_eq!(a_third::<f32>(), 1.0 / 3.0);
    /// assert_eq!(a_third::<I16F16>(), I16F16::from_bits(21_845));
    /// ```
    #[must_use]
    fn from_ratio(numerator: i32, denominator: i32) -> Self;

    /// Whether a coordinate is not larger than [`MAX_COORDINATE`](Self::MAX_COORDINATE); not for NaN.
    #[must_use]
    fn is_within_range(self) -> bool {
        self.abs() <= Self::MAX_COORDINATE
    }

    /// Whether a solid may have the number as its radius: it is from [`MIN_RADIUS`](Self::MIN_RADIUS) to
    /// [`MAX_COORDINATE`](Self::MAX_COORDINATE).
    #[must_use]
    fn is_radius(self) -> bool {
        Self::MIN_RADIUS <= self && self <= Self::MAX_COORDINATE
    }

    /// 1/`self`, for a radius.
    fn inverse(self) -> Self::Scale;

    /// The vector of length 1 in the direction of a finite one, or `None` for zero.
    ///
    /// It is computed in `f64` or in integers of 128 bits.
    fn normalized(vector: [Self; 3]) -> Option<[Self::Unit; 3]>;

    /// The direction from one point to another, and where along it they lie; `None` if they coincide.
    #[doc(hidden)]
    fn stretch(from: [Self; 3], to: [Self; 3]) -> Option<Stretch<Self>>;

    /// The inverse of a matrix; `None` if there is none, or if it or the matrix has too large an entry.
    #[doc(hidden)]
    fn inverted(matrix: Matrix<Self::Wide>) -> Option<Inverse<Self::Wide>>;

    /// How far off a length in a pixel may be that is a sum of up to six lengths, `size` together,
    /// or of two of these, one of them times the column.
    fn uncertainty(size: Self::Wide) -> Self::Wide;

    /// The same number with more digits; exact.
    fn wide(self) -> Self::Wide;

    /// The nearest number, within the range of parameters.
    fn from_wide(fine: Self::Wide) -> Self;

    /// The nearest number of the size of 1.
    fn unit(fine: Self::Wide) -> Self::Unit;

    /// The same number with more digits; exact.
    fn wide_unit(unit: Self::Unit) -> Self::Wide;

    /// `self · unit`, rounded once.
    #[must_use]
    fn times_unit(self, unit: Self::Unit) -> Self;

    /// The scalar product with a direction: in twice the working precision, then rounded.
    fn dot_unit(vector: [Self; 3], direction: [Self::Unit; 3]) -> Self;

    /// The factor 0.
    const NO_SCALE: Self::Scale;

    /// A number ≥ 0 as a factor.
    fn scale(fine: Self::Wide) -> Self::Scale;

    /// `self · factor`.
    #[must_use]
    fn scaled(self, factor: Self::Scale) -> Self;

    /// `self · factor`, with more digits and a larger range.
    fn stretched(self, factor: Self::Scale) -> Self::Wide;

    /// `numerators / denominator`; not for a denominator of 0.
    fn quotients(numerators: [Self::Wide; 2], denominator: Self::Wide) -> [Self; 2];

    /// A leg of a right triangle: `√(hypotenuse² − leg²)`, or `None` if that is not positive.
    fn leg(hypotenuse: Self, leg: Self) -> Option<Self>;

    /// `q₀m₁ − q₁m₀`, the vector product in two dimensions.
    fn moment(q: [Self; 2], m: [Self::Unit; 2]) -> Self::Wide;

    /// Where the line `q + t·m` is within `radius` of the origin.
    ///
    /// `k` is the vector product of q and m; in two dimensions it has one coordinate, their
    /// [`moment`](Self::moment). It has more digits, because |k|/|m| is the distance of the line, however
    /// small m is. With a = |m|² the middle is t = −q·m/a, and the
    /// half-chord `√(r²a − |k|²)/a`.
    ///
    /// `None` if the line has no direction here: m is zero, or too small to divide by its square.
    fn chord<const K: usize, const N: usize>(
        radius: Self,
        k: [Self::Wide; K],
        q: [Self; N],
        m: [Self::Unit; N],
    ) -> Option<Roots<Self>>;

    /// The length of a vector.
    fn length(vector: [Self; 3]) -> Self;

    /// The vector of this length in the direction of another one; zero if that is zero.
    fn with_length(vector: [Self; 3], length: Self) -> [Self; 3];

    /// The next smaller number, or [`LOWEST`](Self::LOWEST) if there is none.
    #[must_use]
    fn next_below(self) -> Self;

    /// `self` on the scale 0..=255, rounded to nearest; below 0 is 0, above 1 is 255, NaN is 0.
    fn to_level(self) -> u8;

    /// The formula's result, by the body for this kind of number.
    #[doc(hidden)]
    fn compute<F: Formula<Self>>(formula: F) -> F::Output
    where
        Self: Sized;

    /// A line with another parameter, in which the numbers stay small; see [`Rebased`].
    #[doc(hidden)]
    fn rebased(origin: [Self; 3], direction: [Self; 3]) -> Rebased<Self>;
}

/// A binary floating-point number.
pub trait Float: Native + Real + Scalar<Unit = Self, Wide = Self, Scale = Self> {
    /// `a + b·c` with the product's rounding error added back: the result's only error is the
    /// rounding of the sums.
    #[inline]
    fn add_product(a: Self, b: Self, c: Self) -> Self {
        add_product(a, b, c)
    }
}

impl<S: Native> Float for S {}

/// Where a line is inside a solid, in the line's parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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
pub trait FixedPoint: Scalar<Wide = Wide> {
    /// The number of bits behind the point.
    const BITS: u32;

    /// The number in units of its last bit.
    fn to_bits(self) -> i32;

    /// The number of so many units.
    fn from_bits(bits: i32) -> Self;

    /// A coordinate of a direction, in units of 2⁻²⁸.
    fn unit_bits(unit: Self::Unit) -> i32;

    /// The coordinate of a direction that has so many units of 2⁻²⁸.
    fn unit_from_bits(bits: i32) -> Self::Unit;

    /// One of [`quotients`](Scalar::quotients).
    fn quotient(numerator: Wide, denominator: Wide) -> Self;
}

/// A matrix, by its rows.
pub type Matrix<T> = [[T; 3]; 3];

/// An inverse as the sum of two matrices. The second one is what the first one's rounding lost in floating
/// point; in fixed point it is zero.
pub type Inverse<T> = [Matrix<T>; 2];

/// The ends of a line, as offsets along its rounded direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch<S: Scalar> {
    pub(crate) direction: [S::Unit; 3],
    pub(crate) low: S,
    pub(crate) high: S,
}
