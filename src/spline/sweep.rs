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
    /// The span, and the next tick in it.
    span: usize,
    tick: u32,
    /// The value and its differences.
    differences: [P::Array<Quotient>; K],
}

/// `whole + rest/divisor`, with the whole part modulo 2³²: only that of the value has to fit.
#[doc(hidden)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quotient {
    whole: i32,
    rest: u32,
}

impl Quotient {
    #[inline]
    fn add(&mut self, other: Self, divisor: u32) {
        // Both are below the divisor, which is below 2³¹.
        let rest = self.rest.wrapping_add(other.rest);
        let carry = rest >= divisor;
        self.rest = if carry { rest.wrapping_sub(divisor) } else { rest };
        self.whole = self.whole.wrapping_add(other.whole).wrapping_add(i32::from(carry));
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
        let nothing = P::map(P::ORIGIN.coordinates(), |_| Quotient { whole: 0, rest: 0 });
        let mut sweep = Self {
            points,
            is_closed,
            ticks,
            divisor: divisor as u32,
            span: 0,
            tick: 0,
            differences: [nothing; K],
        };
        sweep.enter();
        Ok(sweep)
    }

    /// The value and its differences at the beginning of a span.
    fn enter(&mut self) {
        self.tick = 0;
        let divisor = i64::from(self.divisor);
        let (points, span) = (self.points, self.span);
        for (at, value) in self.differences.iter_mut().enumerate() {
            let weights = weights::<K>(i64::from(self.ticks), at as i64);
            let from_span = points.iter().cycle().skip(span);
            let mut sums = P::map(P::ORIGIN.coordinates(), |_| 0i64);
            for (weight, point) in weights.iter().zip(from_span) {
                for (sum, x) in sums.as_mut().iter_mut().zip(point.coordinates().as_ref()) {
                    *sum = sum.wrapping_add(weight.wrapping_mul(i64::from(x.to_bits())));
                }
            }
            *value = P::map(sums, |sum| {
                // Halves are rounded upwards.
                let sum = sum.wrapping_add(divisor / 2);
                let whole = sum.checked_div_euclid(divisor).unwrap_or(0);
                let rest = sum.wrapping_sub(whole.wrapping_mul(divisor));
                Quotient { whole: whole as i32, rest: rest as u32 }
            });
        }
        // Values at ticks 0 … k−1 become differences at tick 0.
        for level in 1..K {
            let mut before: Option<P::Array<Quotient>> = None;
            for (i, value) in self.differences.iter_mut().enumerate() {
                let own = *value;
                if let Some(before) = before.filter(|_| i >= level) {
                    subtract::<P>(value, before, self.divisor);
                }
                before = Some(own);
            }
        }
    }

    /// Every difference becomes that of the next tick.
    #[inline]
    fn advance(&mut self) {
        let divisor = self.divisor;
        let mut later = self.differences.iter_mut();
        let Some(mut own) = later.next() else { return };
        for next in later {
            for (x, difference) in own.as_mut().iter_mut().zip(next.as_ref()) {
                x.add(*difference, divisor);
            }
            own = next;
        }
    }
}

fn subtract<P: Point>(value: &mut P::Array<Quotient>, other: P::Array<Quotient>, divisor: u32) {
    for (x, y) in value.as_mut().iter_mut().zip(other.as_ref()) {
        let borrow = x.rest < y.rest;
        x.rest = x.rest.wrapping_sub(y.rest).wrapping_add(if borrow { divisor } else { 0 });
        x.whole = x.whole.wrapping_sub(y.whole).wrapping_sub(i32::from(borrow));
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
        if self.tick == self.ticks {
            let spans = if self.is_closed { self.points.len() } else { self.points.len() + 1 - K };
            let next = self.span + 1;
            if next < spans {
                self.span = next;
                self.enter();
            } else if self.is_closed {
                self.span = 0;
                self.enter();
            }
        } else if self.tick > self.ticks {
            return None;
        }
        self.tick += 1;
        let value = *self.differences.first()?;
        self.advance();
        Some(P::from_coordinates(P::map(value, |x| FixedI32::from_bits(x.whole))))
    }
}
