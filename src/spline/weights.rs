//! Curves in `f32` by polynomials in whole numbers, which follow when a control point moves.
//!
//! On a span, the basis functions that are not zero are polynomials that depend on the knots alone. They
//! are computed when the curve is made, in double words of `f64`, and kept as whole numbers. Their sums,
//! weighted with the control points, are the curve's polynomials: whole numbers again, computed when
//! the curve is made and whenever a control point moves. So a point is Horner's rule in products of 32
//! bits, rounded once.
//!
//! De Boor's algorithm in `f32` rounds three times in each of its K(K − 1)/2 blends, and where a
//! parameter and a knot have different exponents, also when it takes their difference: that is up to 3
//! units in the last place for straight lines, and up to 5 for cubics, however it is arranged.

use super::bake::{Bake, polynomial};
use super::float::order_f32;
use super::knots::Knots;
use super::long::{Long, power};
use super::point::Point;
use crate::scalar::{FixedI32, Fraction, Scalar, two_sum};
use core::fmt::Debug;
use core::hint::select_unpredictable;

/// The highest order: of those above it, the coefficients have fewer digits than an `f32`.
const HIGHEST: usize = 6;

/// Its last digits are whole: added to a small number, it has that number's nearest whole one as its
/// last bits. (That is quicker than a conversion that has to look for infinity.)
const ROUNDS: f32 = 1.5 * (1u32 << 23) as f32;

/// What number types know of a curve in advance: nothing but in `f32`.
#[doc(hidden)]
pub trait Weigh: Scalar {
    /// The weights of the control points.
    type Cells<const K: usize, const C: usize>: Copy + Debug;
    /// A coefficient of a span's polynomial.
    type Whole: Copy + Debug + PartialEq;
    /// The unit of the coefficients.
    type Grain: Copy + Debug + PartialEq;

    fn cells<const K: usize, const C: usize, const N: usize>(
        knots: &Knots<Self, K, N>,
    ) -> Self::Cells<K, C>;

    /// The polynomials of all spans in one coordinate of the control points, and their unit.
    fn lane<const K: usize, const C: usize>(
        cells: &Self::Cells<K, C>,
        coordinates: [Self; C],
    ) -> Lane<Self, K, C>;

    /// The curve's point at a parameter, unless it is one that the polynomials are not for.
    fn at<P: Point<Scalar = Self>, const K: usize, const C: usize>(
        cells: &Self::Cells<K, C>,
        polynomials: &[[P::Array<Self::Whole>; K]; C],
        grains: P::Array<Self::Grain>,
        t: Self,
    ) -> Option<P>;
}

/// Polynomials in one coordinate, of the highest power first, and their unit.
pub(super) type Lane<S, const K: usize, const C: usize> =
    ([[<S as Weigh>::Whole; K]; C], <S as Weigh>::Grain);

/// The weights of the control points on all spans.
#[doc(hidden)]
#[derive(Debug, Clone, Copy)]
pub struct Cells<const K: usize, const C: usize> {
    /// The first and the last parameter that they are for, as keys: a clamped end is not among them,
    /// because there the curve is exactly a control point.
    from: i32,
    to: i32,
    /// Where spans start, and behind the last one the largest key.
    starts: [i32; C],
    cells: [Cell<K>; C],
}

/// The weights on a span.
#[derive(Debug, Clone, Copy)]
struct Cell<const K: usize> {
    /// The index of the first control point.
    first: u32,
    /// `((t − start)·scale − half)·factor/2²⁹` is from −2³¹ to 2³¹; the scale is a power of two, and
    /// the bits of [`ROUNDS`] are added to `half`.
    minus_start: f32,
    scale: f32,
    half: i32,
    factor: i32,
    /// Their coefficients, of the highest power first, in units of 2^−[`digits`].
    weights: [[i32; K]; K],
}

/// The digits of a weight: coefficients, and sums in Horner's rule, are below 2^(K − 1).
const fn digits<const K: usize>() -> i32 {
    32 - K as i32
}

/// The key of a knot as the last number.
const fn last_key(knot: f32) -> i32 {
    order_f32(knot + 0.0)
}

/// 2^exponent, if it is a normal number, or the least one.
const fn power_of_two(exponent: i32) -> f32 {
    let field = if exponent > -127 { exponent + 127 } else { 1 };
    f32::from_bits(field.cast_unsigned() << 23)
}

impl Bake<f32> {
    pub(super) const NO_WHOLE: i32 = 0;
    pub(super) const NO_GRAIN: f32 = 0.0;

    pub(super) const fn cells<const K: usize, const C: usize, const N: usize>(
        knots: &Knots<f32, K, N>,
    ) -> Cells<K, C> {
        let empty = Cell {
            first: 0,
            minus_start: 0.0,
            scale: 0.0,
            half: 0,
            factor: 0,
            weights: [[0; K]; K],
        };
        // For no parameter.
        let none = Cells { from: 1, to: 0, starts: [i32::MAX; C], cells: [empty; C] };
        let (points, all) = (knots.points(), &knots.knots);
        if K < 2 || K > HIGHEST || points < K || points + K > N || points > C {
            return none;
        }
        let mut made = none;
        let (mut span, mut count) = (K - 1, 0);
        while span < points && count < C {
            let (start, end) = (all[span], all[span + 1]);
            if start < end {
                // Shorter ones would need a scale beyond the range.
                if end - start < 1e-28 {
                    return none;
                }
                made.starts[count] = Self::key(start);
                made.cells[count] = Self::cell(all, span);
                count += 1;
            }
            span += 1;
        }
        let (from, to) = (all[K - 1], all[points]);
        made.from = if all[1] == from { last_key(from) + 1 } else { Self::key(from) };
        made.to = if all[points + K - 2] == to { Self::key(to) - 1 } else { last_key(to) };
        made
    }

    const fn cell<const K: usize, const N: usize>(knots: &[f32; N], span: usize) -> Cell<K> {
        let (start, end) = (knots[span], knots[span + 1]);
        let width = Long::sum(end as f64, -(start as f64));
        // Half of the width times the scale is above 2²⁹, and 2³⁰ for a power of two. Then numbers are
        // exact where they can be, and the end of the span is cut off at 2³¹ − 1.
        let mut scale = power(width.round()) * (1u64 << 31) as f64;
        if width.scaled(scale).round() == (1u64 << 30) as f64 {
            scale *= 2.0;
        }
        let half = width.scaled(scale / 2.0).whole();
        // Elsewhere the end is rounded, perhaps upwards.
        let most = if half == 1 << 30 { half } else { half + 1 };
        let factor = (1u64 << 60) / most.unsigned_abs();
        // What −1/2 to 1/2 times 2³² stands for.
        let unit = (1u64 << 61) as f64 / (scale * factor as f64);
        let middle = Long::from(half as f64).scaled(1.0 / scale);
        let (mut low, mut high) = ([Long::ZERO; K], [Long::ZERO; K]);
        let mut i = 0;
        while i < K {
            let (below, above) = (knots[span + 1 + i - K], knots[span + 1 + i]);
            low[i] = Long::sum(below as f64, -(start as f64)).minus(middle);
            high[i] = Long::sum(above as f64, -(start as f64)).minus(middle);
            i += 1;
        }
        let mut weights = [[0; K]; K];
        let mut function = 0;
        while function < K {
            let mut points = [0.0; K];
            points[function] = 1.0;
            let weight = polynomial(low, high, points, unit);
            let mut i = 0;
            while i < K {
                let one = (1u64 << digits::<K>()) as f64;
                weights[K - 1 - i][function] = Long::whole(weight[i].scaled(one)) as i32;
                i += 1;
            }
            function += 1;
        }
        Cell {
            first: (span + 1 - K) as u32,
            minus_start: -start,
            scale: scale as f32,
            half: (half as i32).wrapping_add(ROUNDS.to_bits().cast_signed()),
            factor: factor as i32,
            weights,
        }
    }

    pub(super) const fn lane<const K: usize, const C: usize>(
        cells: &Cells<K, C>,
        coordinates: [f32; C],
    ) -> Lane<f32, K, C> {
        let mut largest = 0.0f32;
        let mut i = 0;
        while i < C {
            largest = largest.max(coordinates[i].abs());
            i += 1;
        }
        // So that they are whole numbers below 2³¹.
        // And a little more than 2³¹ would be too much for the highest power.
        largest *= 1.0 + 1.0 / (1u32 << 20) as f32;
        let exponent = (largest.to_bits() >> 23).cast_signed() - 127;
        let unit = power_of_two(exponent - 30);
        let grain = power_of_two(exponent - 30) * power_of_two(31 - digits::<K>());
        let mut wholes = [0i64; C];
        i = 0;
        while i < C {
            wholes[i] = (coordinates[i] / unit) as i64;
            i += 1;
        }
        let mut polynomials = [[0; K]; C];
        let mut span = 0;
        while span < C {
            let cell = &cells.cells[span];
            let first = cell.first as usize;
            let mut power = 0;
            while power < K {
                // Halves are rounded upwards.
                let mut sum = 1 << 30;
                let mut i = 0;
                while i < K && first + i < C {
                    sum += cell.weights[power][i] as i64 * wholes[first + i];
                    i += 1;
                }
                polynomials[span][power] = (sum >> 31) as i32;
                power += 1;
            }
            span += 1;
        }
        (polynomials, grain)
    }
}

impl Weigh for f32 {
    type Cells<const K: usize, const C: usize> = Cells<K, C>;
    type Whole = i32;
    type Grain = Self;

    fn cells<const K: usize, const C: usize, const N: usize>(
        knots: &Knots<Self, K, N>,
    ) -> Cells<K, C> {
        Bake::<Self>::cells(knots)
    }

    fn lane<const K: usize, const C: usize>(
        cells: &Cells<K, C>,
        coordinates: [Self; C],
    ) -> Lane<Self, K, C> {
        Bake::<Self>::lane(cells, coordinates)
    }

    #[inline(always)]
    fn at<P: Point<Scalar = Self>, const K: usize, const C: usize>(
        cells: &Cells<K, C>,
        polynomials: &[[P::Array<i32>; K]; C],
        grains: P::Array<Self>,
        t: Self,
    ) -> Option<P> {
        let key = order_f32(t);
        if !(cells.from <= key && key <= cells.to) {
            return None;
        }
        // Without a jump, and without an index that would have to be checked.
        let later = cells.starts.iter().take(C.saturating_sub(K - 1));
        let mut spans = later.zip(cells.cells.iter().zip(polynomials));
        let (_, first) = spans.next()?;
        let (cell, polynomial) =
            spans.fold(first, |at, (start, span)| select_unpredictable(*start <= key, span, at));

        // The difference's rounding error, too: it can be half a unit of the curve.
        let (high, low) = two_sum(t, cell.minus_start);
        let rest = (low * cell.scale + ROUNDS).to_bits().cast_signed();
        let offset = ((high * cell.scale) as i32).wrapping_add(rest).wrapping_sub(cell.half);
        let local = ((i64::from(offset) * i64::from(cell.factor)) >> 29) as i32;
        let (first, rest) = polynomial.split_first()?;
        let mut sums = *first;
        for coefficients in rest {
            for (sum, c) in sums.as_mut().iter_mut().zip(coefficients.as_ref()) {
                *sum = c.wrapping_add(((i64::from(*sum) * i64::from(local)) >> 32) as i32);
            }
        }
        let mut point = grains;
        for (x, sum) in point.as_mut().iter_mut().zip(sums.as_ref()) {
            *x *= *sum as Self;
        }
        Some(P::from_coordinates(point))
    }
}

macro_rules! without_weights {
    ($([$($generics:tt)*] $Scalar:ty),+) => {$(
        impl<$($generics)*> Bake<$Scalar> {
            pub(super) const NO_WHOLE: () = ();
            pub(super) const NO_GRAIN: () = ();

            pub(super) const fn cells<const K: usize, const C: usize, const N: usize>(
                _: &Knots<$Scalar, K, N>,
            ) {
            }

            pub(super) const fn lane<const K: usize, const C: usize>(
                (): &(),
                _: [$Scalar; C],
            ) -> Lane<$Scalar, K, C> {
                ([[(); K]; C], ())
            }
        }

        impl<$($generics)*> Weigh for $Scalar {
            type Cells<const K: usize, const C: usize> = ();
            type Whole = ();
            type Grain = ();

            fn cells<const K: usize, const C: usize, const N: usize>(_: &Knots<Self, K, N>) {}

            fn lane<const K: usize, const C: usize>(
                (): &(),
                coordinates: [Self; C],
            ) -> Lane<Self, K, C> {
                Bake::<Self>::lane(&(), coordinates)
            }

            #[inline]
            fn at<P: Point<Scalar = Self>, const K: usize, const C: usize>(
                (): &(),
                _: &[[P::Array<()>; K]; C],
                _: P::Array<()>,
                _: Self,
            ) -> Option<P> {
                None
            }
        }
    )+};
}

without_weights!([] f64, [F: Fraction,] FixedI32<F>);
