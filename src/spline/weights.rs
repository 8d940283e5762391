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
    /// The weights of the control points on all spans.
    type Cells<const K: usize, const C: usize>: Copy + Debug;
    /// How t becomes the local parameter of a span.
    type Local: Copy + Debug;
    /// A coefficient of a span's polynomial.
    type Whole: Copy + Debug + PartialEq;
    /// The unit of a coordinate's coefficients.
    type Grain: Copy + Debug + PartialEq;

    const NO_WHOLE: Self::Whole;
    const NO_GRAIN: Self::Grain;

    fn cells<const K: usize, const C: usize, const N: usize>(
        knots: &Knots<Self, K, N>,
    ) -> (Self::Cells<K, C>, [Self::Local; C]);

    /// The index of a span's first control point, if there is such a span.
    fn first<const K: usize, const C: usize>(
        cells: &Self::Cells<K, C>,
        span: usize,
    ) -> Option<usize>;

    /// The polynomial of a span in one coordinate of its control points, and its unit.
    fn lane<const K: usize, const C: usize>(
        cells: &Self::Cells<K, C>,
        span: usize,
        coordinates: [Self; K],
    ) -> ([Self::Whole; K], Self::Grain);

    /// The curve's point at a parameter, unless it is one that the polynomials are not for.
    fn at<P: Point<Scalar = Self>, const K: usize, const C: usize>(
        cells: &Self::Cells<K, C>,
        spans: &[SpanOf<P, K>; C],
        t: Self,
    ) -> Option<P>;
}

/// A polynomial of a curve: with a frame, units and coefficients.
#[doc(hidden)]
#[derive(Debug, Clone, Copy)]
pub struct Span<Frame, Grains, Wholes, const K: usize> {
    pub(super) frame: Frame,
    pub(super) grains: Grains,
    /// Of the highest power first.
    pub(super) coefficients: [Wholes; K],
}

#[doc(hidden)]
pub type SpanOf<P, const K: usize> = Span<
    <<P as Point>::Scalar as Weigh>::Local,
    <P as Point>::Array<<<P as Point>::Scalar as Weigh>::Grain>,
    <P as Point>::Array<<<P as Point>::Scalar as Weigh>::Whole>,
    K,
>;

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
    /// Their coefficients, of the highest power first, in units of 2^−[`digits`].
    weights: [[i32; K]; K],
}

/// The local parameter is `((t·lift − start)·scale − half)·factor/2²⁹`, from −2³¹ to 2³¹.
#[doc(hidden)]
#[derive(Debug, Clone, Copy)]
pub struct LocalFrame {
    /// 1, or 2⁶⁴ for a span so short that its scale were no number: it is near 0 then.
    lift: f32,
    /// Times `lift`.
    minus_start: f32,
    /// A power of two.
    scale: f32,
    /// The bits of [`ROUNDS`] are added to it.
    half: i32,
    factor: i32,
}

impl LocalFrame {
    const NONE: Self = Self { lift: 0.0, minus_start: 0.0, scale: 0.0, half: 0, factor: 0 };
}

/// The digits of a weight: coefficients, and sums in Horner's rule, are below 2^(K − 1).
const fn digits<const K: usize>() -> i32 {
    32 - K as i32
}

/// 2^exponent, from −126 to 127.
const fn power_of_two(exponent: i32) -> f32 {
    f32::from_bits((exponent + 127).cast_unsigned() << 23)
}

impl Bake<f32> {
    pub(super) const NO_WHOLE: i32 = 0;
    pub(super) const NO_GRAIN: f32 = 0.0;

    pub(super) const fn cells<const K: usize, const C: usize, const N: usize>(
        knots: &Knots<f32, K, N>,
    ) -> (Cells<K, C>, [LocalFrame; C]) {
        let empty = Cell { first: 0, weights: [[0; K]; K] };
        // For no parameter.
        let none = Cells { from: 1, to: 0, starts: [i32::MAX; C], cells: [empty; C] };
        let mut frames = [LocalFrame::NONE; C];
        let (points, all) = (knots.points(), &knots.knots);
        if K < 2 || K > HIGHEST || points < K || points + K > N || points > C {
            return (none, frames);
        }
        let mut made = none;
        let (mut span, mut count) = (K - 1, 0);
        while span < points && count < C {
            let (start, end) = (all[span], all[span + 1]);
            if start < end {
                made.starts[count] = Self::key(start);
                (made.cells[count], frames[count]) = Self::cell(all, span);
                count += 1;
            }
            span += 1;
        }
        let (from, to) = (all[K - 1], all[points]);
        made.from = if all[1] == from { Self::last_key(from) + 1 } else { Self::key(from) };
        made.to = if all[points + K - 2] == to { Self::key(to) - 1 } else { Self::last_key(to) };
        (made, frames)
    }

    const fn cell<const K: usize, const N: usize>(
        knots: &[f32; N],
        span: usize,
    ) -> (Cell<K>, LocalFrame) {
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
        let lift = if scale < power_of_two(127) as f64 { 1.0 } else { power_of_two(64) };
        let frame = LocalFrame {
            lift,
            minus_start: -start * lift,
            scale: (scale / lift as f64) as f32,
            half: (half as i32).wrapping_add(ROUNDS.to_bits().cast_signed()),
            factor: factor as i32,
        };
        (Cell { first: (span + 1 - K) as u32, weights }, frame)
    }

    pub(super) const fn first<const K: usize, const C: usize>(
        cells: &Cells<K, C>,
        span: usize,
    ) -> Option<usize> {
        if cells.starts[span] == i32::MAX { None } else { Some(cells.cells[span].first as usize) }
    }

    pub(super) const fn lane<const K: usize, const C: usize>(
        cells: &Cells<K, C>,
        span: usize,
        coordinates: [f32; K],
    ) -> ([i32; K], f32) {
        let mut largest = 0.0f32;
        let mut i = 0;
        while i < K {
            largest = largest.max(coordinates[i].abs());
            i += 1;
        }
        // So that they are whole numbers below 2³¹; with a little room, because a coefficient of the
        // highest power can be the sum of rounded weights times all of 2³¹.
        largest *= 1.0 + 1.0 / (1u32 << 20) as f32;
        let exponent = (largest.to_bits() >> 23).cast_signed() - 127;
        // Down to where the inverse of their unit is a number.
        let exponent = if exponent < -96 { -96 } else { exponent };
        let scale = power_of_two(30 - exponent);
        let mut wholes = [0; K];
        i = 0;
        while i < K {
            wholes[i] = (coordinates[i] * scale) as i32;
            i += 1;
        }
        let mut coefficients = [0; K];
        let mut power = 0;
        while power < K {
            let weights = &cells.cells[span].weights[power];
            // Halves are rounded upwards.
            let mut sum = 1i64 << 30;
            i = 0;
            while i < K {
                sum += weights[i] as i64 * wholes[i] as i64;
                i += 1;
            }
            coefficients[power] = (sum >> 31) as i32;
            power += 1;
        }
        (coefficients, power_of_two(exponent + 1 - digits::<K>()))
    }
}

impl Weigh for f32 {
    type Cells<const K: usize, const C: usize> = Cells<K, C>;
    type Local = LocalFrame;
    type Whole = i32;
    type Grain = Self;

    const NO_WHOLE: i32 = Bake::<Self>::NO_WHOLE;
    const NO_GRAIN: Self = Bake::<Self>::NO_GRAIN;

    fn cells<const K: usize, const C: usize, const N: usize>(
        knots: &Knots<Self, K, N>,
    ) -> (Cells<K, C>, [LocalFrame; C]) {
        Bake::<Self>::cells(knots)
    }

    fn first<const K: usize, const C: usize>(cells: &Cells<K, C>, span: usize) -> Option<usize> {
        (span < C).then(|| Bake::<Self>::first(cells, span)).flatten()
    }

    fn lane<const K: usize, const C: usize>(
        cells: &Cells<K, C>,
        span: usize,
        coordinates: [Self; K],
    ) -> ([i32; K], Self) {
        Bake::<Self>::lane(cells, span, coordinates)
    }

    #[inline(always)]
    fn at<P: Point<Scalar = Self>, const K: usize, const C: usize>(
        cells: &Cells<K, C>,
        spans: &[SpanOf<P, K>; C],
        t: Self,
    ) -> Option<P> {
        let key = order_f32(t);
        if !(cells.from <= key && key <= cells.to) {
            return None;
        }
        // Without a jump, and without an index that would have to be checked.
        let mut spans = cells.starts.iter().zip(spans).take(C.saturating_sub(K - 1));
        let (_, first) = spans.next()?;
        let Span { frame, grains, coefficients } =
            spans.fold(first, |at, (start, span)| select_unpredictable(*start <= key, span, at));

        // The difference's rounding error, too: it can be more than a unit of the curve.
        let (high, low) = two_sum(t * frame.lift, frame.minus_start);
        let rest = (low * frame.scale + ROUNDS).to_bits().cast_signed();
        let offset = ((high * frame.scale) as i32).wrapping_add(rest).wrapping_sub(frame.half);
        let local = ((i64::from(offset) * i64::from(frame.factor)) >> 29) as i32;
        let (first, rest) = coefficients.split_first()?;
        let mut sums = *first;
        for coefficients in rest {
            for (sum, c) in sums.as_mut().iter_mut().zip(coefficients.as_ref()) {
                *sum = c.wrapping_add(((i64::from(*sum) * i64::from(local)) >> 32) as i32);
            }
        }
        let mut point = *grains;
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
            ) -> ((), [(); C]) {
                ((), [(); C])
            }

            pub(super) const fn first<const K: usize, const C: usize>(
                (): &(),
                _: usize,
            ) -> Option<usize> {
                None
            }

            pub(super) const fn lane<const K: usize, const C: usize>(
                (): &(),
                _: usize,
                _: [$Scalar; K],
            ) -> ([(); K], ()) {
                ([(); K], ())
            }
        }

        impl<$($generics)*> Weigh for $Scalar {
            type Cells<const K: usize, const C: usize> = ();
            type Local = ();
            type Whole = ();
            type Grain = ();

            const NO_WHOLE: () = ();
            const NO_GRAIN: () = ();

            fn cells<const K: usize, const C: usize, const N: usize>(
                knots: &Knots<Self, K, N>,
            ) -> ((), [(); C]) {
                Bake::<Self>::cells(knots)
            }

            fn first<const K: usize, const C: usize>((): &(), _: usize) -> Option<usize> {
                None
            }

            fn lane<const K: usize, const C: usize>(
                (): &(),
                _: usize,
                _: [Self; K],
            ) -> ([(); K], ()) {
                ([(); K], ())
            }

            #[inline]
            fn at<P: Point<Scalar = Self>, const K: usize, const C: usize>(
                (): &(),
                _: &[SpanOf<P, K>; C],
                _: Self,
            ) -> Option<P> {
                None
            }
        }
    )+};
}

without_weights!([] f64, [F: Fraction,] FixedI32<F>);
