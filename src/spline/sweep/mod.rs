//! Points at equal steps of the parameter, by additions of integers.

mod tick_basis;

use super::curve::Curve;
use super::error::SweepError;
use super::point::Point;
use crate::scalar::{FixedI32, Fraction};
use tick_basis::TickBasis;

/// A curve in fixed point, from point to point: one for every tick of a clock, whose knots are all
/// at ticks.
///
/// At a tick i of a span, a spline times a common divisor of its basis functions is a polynomial in i
/// with whole coefficients: over uniform knots T ticks apart, (k−1)! T^(k−1) for the order k. So its
/// differences are integers, and a step is k − 1 additions. Each number is kept as a whole part and
/// a remainder, which makes the result the exact value, rounded to nearest, without a division; no error
/// adds up however long a sweep is. Where a span begins, differences are computed anew, so that tick
/// takes longer.
///
/// ```
/// use scancsg::{scalar::I16F16, spline::Sweep};
///
/// // A quadratic through the middles between its control points.
/// let points = [0, 4, 4, 0].map(I16F16::from_num);
/// let path: Vec<f32> = Sweep::<I16F16, 3>::new(&points, 4)?.map(|x| x.to_num()).collect();
/// assert_eq!(path, [2.0, 2.875, 3.5, 3.875, 4.0, 3.875, 3.5, 2.875, 2.0]);
/// # Ok::<(), scancsg::spline::SweepError>(())
/// ```
///
/// A clamped curve begins and ends at its control points:
///
/// ```
/// use scancsg::{constant, scalar::I16F16, spline::{Curve, Knots, Sweep}};
///
/// const KNOTS: Knots<I16F16, 3, 7> =
///     constant!(Knots::<I16F16, 3, 7>::clamped_uniform(4, I16F16::ZERO, I16F16::ONE));
/// let curve = Curve::<I16F16, 3, 4, 7>::new(KNOTS, [0, 4, 4, 0].map(I16F16::from_num)).unwrap();
/// let quarter = I16F16::from_num(0.25);
/// let path: Vec<f32> = Sweep::along(&curve, quarter)?.map(|x| x.to_num()).collect();
/// assert_eq!(path, [0.0, 3.0, 4.0, 3.0, 0.0]);
/// # Ok::<(), scancsg::spline::SweepError>(())
/// ```
#[derive(Debug, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Sweep<'a, P: Point, const K: usize> {
    points: &'a [P],
    pace: Pace<'a, P::Scalar>,
    /// Of the basis functions of the span.
    divisor: u32,
    /// The next span.
    span: usize,
    /// How many points are left before it begins.
    left: u32,
    /// Of each coordinate, the value and its differences.
    differences: P::Array<[Quotient; K]>,
}

/// Where the knots are.
#[derive(Debug, Clone, Copy)]
enum Pace<'a, S> {
    /// So many ticks apart.
    Uniform { ticks: u32, is_closed: bool },
    /// At these parameters, with a tick at every multiple of the step.
    Given { knots: &'a [S], step: u32 },
}

/// `whole + rest/divisor`, with the whole part modulo 2³²: only that of the value has to fit.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Quotient {
    whole: i32,
    rest: u32,
}

impl Quotient {
    const ZERO: Self = Self { whole: 0, rest: 0 };

    #[inline]
    fn add(&mut self, other: Self, divisor: u32) {
        // Both are below the divisor, which is 2³¹ at most.
        self.rest = self.rest.wrapping_add(other.rest);
        self.whole = self.whole.wrapping_add(other.whole);
        if self.rest >= divisor {
            self.rest = self.rest.wrapping_sub(divisor);
            self.whole = self.whole.wrapping_add(1);
        }
    }

    fn subtract(&mut self, other: Self, divisor: u32) {
        let borrow = self.rest < other.rest;
        let more = if borrow { divisor } else { 0 };
        self.rest = self.rest.wrapping_sub(other.rest).wrapping_add(more);
        self.whole = self.whole.wrapping_sub(other.whole).wrapping_sub(i32::from(borrow));
    }
}

impl<'a, F: Fraction, P: Point<Scalar = FixedI32<F>>, const K: usize> Sweep<'a, P, K> {
    /// From the beginning to the end of the domain of the open curve with these control points:
    /// (n − k + 1)·`ticks` + 1 points.
    ///
    /// # Errors
    /// [`SweepError::TooFew`] for fewer control points than the order; [`SweepError::Ticks`].
    pub fn new(points: &'a [P], ticks: u32) -> Result<Self, SweepError> {
        Self::start(points, Pace::Uniform { ticks, is_closed: false })
    }

    /// Once around the closed curve with these control points, and again without an end.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn closed(points: &'a [P], ticks: u32) -> Result<Self, SweepError> {
        Self::start(points, Pace::Uniform { ticks, is_closed: true })
    }

    /// From the beginning to the end of the domain of a curve, a point at every `step` of its parameter,
    /// both ends included. Where the curve is not continuous, it is the point to the right.
    ///
    /// # Errors
    /// [`SweepError::Step`]; [`SweepError::Ticks`].
    pub fn along<const C: usize, const N: usize>(
        curve: &'a Curve<P, K, C, N>,
        step: FixedI32<F>,
    ) -> Result<Self, SweepError> {
        let knots = curve.knots().as_slice();
        let step = u32::try_from(step.to_bits()).map_err(|_| SweepError::Step)?;
        let mut intervals = knots.iter().zip(knots.iter().skip(1));
        if !intervals.all(|(low, high)| distance(*low, *high).checked_rem(step) == Some(0)) {
            return Err(SweepError::Step);
        }
        Self::start(curve.points(), Pace::Given { knots, step })
    }

    fn start(points: &'a [P], pace: Pace<'a, FixedI32<F>>) -> Result<Self, SweepError> {
        const { assert!(K >= 1 && K <= 12) };
        if points.len() < K {
            return Err(SweepError::TooFew);
        }
        let mut sweep = Self {
            points,
            pace,
            divisor: 1,
            span: 0,
            left: 0,
            differences: P::filled([Quotient::ZERO; K]),
        };
        let is_given = matches!(pace, Pace::Given { .. });
        let different = if is_given { sweep.spans() } else { 1 };
        for (behind, ahead) in (0..different).map(|span| sweep.knots(span)) {
            let is_empty = is_given && ahead.first() == Some(&0);
            let ticks =
                TickBasis::new(behind, ahead).filter(|ticks| ticks.count() as usize >= K - 1);
            if ticks.is_none() && !is_empty {
                return Err(SweepError::Ticks);
            }
        }
        sweep.turn();
        Ok(sweep)
    }

    fn spans(&self) -> usize {
        match self.pace {
            Pace::Uniform { is_closed: true, .. } => self.points.len(),
            _ => (self.points.len() + 1).saturating_sub(K),
        }
    }

    /// How many ticks the knots of a span are behind its beginning, and ahead of it.
    fn knots(&self, span: usize) -> ([u32; K], [u32; K]) {
        match self.pace {
            Pace::Uniform { ticks, .. } => (
                core::array::from_fn(|i| ticks.saturating_mul((K - 1 - i) as u32)),
                core::array::from_fn(|i| ticks.saturating_mul(i as u32 + 1)),
            ),
            Pace::Given { knots, step } => {
                let knot = |i| knots.get(span + i).copied().unwrap_or(FixedI32::ZERO);
                let ticks = |low, high| distance(low, high).checked_div(step).unwrap_or(0);
                let start = knot(K - 1);
                (
                    core::array::from_fn(|i| ticks(knot(i), start)),
                    core::array::from_fn(|i| ticks(start, knot(K + i))),
                )
            }
        }
    }

    /// Goes on to the next span; at the end of an open curve to its last point, and then to nothing.
    #[cold]
    fn turn(&mut self) -> Option<()> {
        let spans = self.spans();
        if self.span == spans && matches!(self.pace, Pace::Uniform { is_closed: true, .. }) {
            self.span = 0;
        }
        // Empty spans have no ticks.
        while self.left == 0 && self.span < spans {
            self.enter();
        }
        if self.left == 0 && self.span == spans {
            (self.span, self.left) = (spans + 1, 1);
        }
        (self.left > 0).then_some(())
    }

    /// The value and its differences at the beginning of a span.
    fn enter(&mut self) {
        let (points, span) = (self.points, self.span);
        self.span += 1;
        let (behind, ahead) = self.knots(span);
        let Some(ticks) = TickBasis::new(behind, ahead) else { return };
        (self.left, self.divisor) = (ticks.count(), ticks.divisor);
        let divisor = i64::from(self.divisor);
        for tick in 0..K {
            let weights = ticks.weights(tick as u32);
            let from_span = points.iter().cycle().skip(span);
            let mut sums = P::filled(0i64);
            for (weight, point) in weights.iter().zip(from_span) {
                for (sum, x) in sums.as_mut().iter_mut().zip(point.coordinates().as_ref()) {
                    *sum = sum.wrapping_add(weight.wrapping_mul(i64::from(x.to_bits())));
                }
            }
            for (values, sum) in self.differences.as_mut().iter_mut().zip(sums.as_ref()) {
                // Halves are rounded upwards.
                let sum = sum.wrapping_add(divisor / 2);
                let whole = sum.checked_div_euclid(divisor).unwrap_or(0);
                let rest = sum.wrapping_sub(whole.wrapping_mul(divisor));
                if let Some(value) = values.get_mut(tick) {
                    *value = Quotient { whole: whole as i32, rest: rest as u32 };
                }
            }
        }
        // Values at ticks 0 … k−1 become differences at tick 0.
        for values in self.differences.as_mut() {
            for level in 1..K {
                for i in (level..K).rev() {
                    if let Some([before, value]) = values.get_mut(i - 1..=i) {
                        value.subtract(*before, self.divisor);
                    }
                }
            }
        }
    }

    /// Every difference becomes that of the next tick.
    #[inline]
    fn advance(&mut self) {
        for values in self.differences.as_mut() {
            let mut values = values.iter_mut();
            let Some(mut own) = values.next() else { continue };
            for next in values {
                own.add(*next, self.divisor);
                own = next;
            }
        }
    }
}

/// In units of the type, of knots in ascending order.
fn distance<F: Fraction>(low: FixedI32<F>, high: FixedI32<F>) -> u32 {
    high.to_bits().wrapping_sub(low.to_bits()).cast_unsigned()
}

impl<F: Fraction, P: Point<Scalar = FixedI32<F>>, const K: usize> Iterator for Sweep<'_, P, K> {
    type Item = P;

    #[inline]
    fn next(&mut self) -> Option<P> {
        if self.left == 0 {
            self.turn()?;
        }
        self.left -= 1;
        let mut point = P::ORIGIN.coordinates();
        for (x, values) in point.as_mut().iter_mut().zip(self.differences.as_ref()) {
            *x = FixedI32::from_bits(values.first()?.whole);
        }
        let next = Some(P::from_coordinates(point));
        self.advance();
        next
    }
}
