//! Points at equal steps of the parameter, by additions of whole numbers.

use super::SweepError;
use super::point::Point;
use crate::scalar::{FixedI32, Fraction};

/// A curve over uniform knots in fixed point, from point to point: one for every tick of a clock,
/// so many ticks to a span.
///
/// At a tick i of a span of T ticks, a cardinal spline of the order k times (k−1)! T^(k−1) is a
/// polynomial in i with whole coefficients. So its differences are whole numbers, and a step is
/// k − 1 additions. Each number is kept as a whole part and a remainder, which makes the result the
/// exact value, rounded to nearest, without a division; no error adds up however long a sweep is.
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
#[derive(Debug, Clone)]
pub struct Sweep<'a, P: Point, const K: usize> {
    points: &'a [P],
    is_closed: bool,
    ticks: u32,
    /// (k−1)! T^(k−1).
    divisor: u32,
    /// The next span.
    pub(super) span: usize,
    /// How many points are left before it begins.
    pub(super) left: u32,
    /// Of each coordinate, the value and its differences.
    differences: P::Array<[Quotient; K]>,
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
        // Both are below the divisor, which is below 2³¹.
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
        if points.len() < K {
            return Err(SweepError::TooFew);
        }
        Self::start(points, ticks, false)
    }

    /// Once around the closed curve with these control points, and again without an end.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn closed(points: &'a [P], ticks: u32) -> Result<Self, SweepError> {
        if points.len() < K {
            return Err(SweepError::TooFew);
        }
        Self::start(points, ticks, true)
    }

    fn start(points: &'a [P], ticks: u32, is_closed: bool) -> Result<Self, SweepError> {
        const { assert!(K >= 1 && K <= 12) };
        let mut divisor = 1u64;
        for degree in 1..K as u64 {
            divisor = divisor.saturating_mul(degree).saturating_mul(u64::from(ticks));
        }
        if divisor > 1 << 31 || (ticks as usize) < K - 1 || ticks == 0 {
            return Err(SweepError::Ticks);
        }
        let mut sweep = Self {
            points,
            is_closed,
            ticks,
            divisor: divisor as u32,
            span: 0,
            left: 0,
            differences: P::map(P::ORIGIN.coordinates(), |_| [Quotient::ZERO; K]),
        };
        sweep.enter();
        Ok(sweep)
    }

    /// Goes on to the next span; at the end of an open curve to its last point, and then to nothing.
    #[cold]
    fn turn(&mut self) -> Option<()> {
        let spans = if self.is_closed { self.points.len() } else { self.points.len() + 1 - K };
        if self.span < spans {
            self.enter();
        } else if self.is_closed {
            self.span = 0;
            self.enter();
        } else {
            self.left = u32::from(self.span == spans);
            self.span = spans + 1;
        }
        (self.left > 0).then_some(())
    }

    /// The value and its differences at the beginning of a span.
    fn enter(&mut self) {
        let (points, span) = (self.points, self.span);
        (self.span, self.left) = (span + 1, self.ticks);
        let divisor = i64::from(self.divisor);
        for tick in 0..K {
            let weights = weights::<K>(i64::from(self.ticks), tick as i64);
            let from_span = points.iter().cycle().skip(span);
            let mut sums = P::map(P::ORIGIN.coordinates(), |_| 0i64);
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
                let mut before: Option<Quotient> = None;
                for (i, value) in values.iter_mut().enumerate() {
                    let own = *value;
                    if let Some(before) = before.filter(|_| i >= level) {
                        value.subtract(before, self.divisor);
                    }
                    before = Some(own);
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

/// The basis functions of a span of T ticks at a tick, from 0 to T, times (k−1)! T^(k−1).
///
/// The recurrence over whole knots, without its divisors.
fn weights<const K: usize>(ticks: i64, at: i64) -> [i64; K] {
    let mut weights = [0i64; K];
    if let Some(last) = weights.last_mut() {
        *last = 1;
    }
    for level in 1..K {
        // weights[i] is the function that began K − 1 − i spans ago.
        for i in 0..K {
            let age = (K - 1 - i) as i64;
            let own = weights.get(i).copied().unwrap_or(0);
            let right = weights.get(i + 1).copied().unwrap_or(0);
            let rise = own.wrapping_mul(at + age * ticks);
            let fall = right.wrapping_mul((level as i64 + 1 - age) * ticks - at);
            if let Some(weight) = weights.get_mut(i) {
                *weight = rise.wrapping_add(fall);
            }
        }
    }
    weights
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
