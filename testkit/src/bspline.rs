//! B-splines in exact fractions, straight from the definitions.

use dashu_int::IBig;
use dashu_int::ops::{Abs, Gcd};
use std::ops::{Add, Div, Mul, Sub};

/// A fraction with a positive denominator, in lowest terms.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Ratio {
    numerator: IBig,
    denominator: IBig,
}

impl Ratio {
    pub fn new(numerator: impl Into<IBig>, denominator: impl Into<IBig>) -> Self {
        let (n, d) = (numerator.into(), denominator.into());
        assert_ne!(d, IBig::ZERO);
        let (n, d) = if d < IBig::ZERO { (-n, -d) } else { (n, d) };
        let common = if n == IBig::ZERO { d.clone() } else { IBig::from((&n).gcd(&d)) };
        Self { numerator: n / &common, denominator: d / &common }
    }

    pub fn whole(x: i64) -> Self {
        Self::new(x, 1)
    }

    pub fn zero() -> Self {
        Self::whole(0)
    }

    pub fn is_zero(&self) -> bool {
        self.numerator == IBig::ZERO
    }

    pub fn parse(text: &str) -> Self {
        let (numerator, denominator) = text.split_once('/').unwrap_or((text, "1"));
        let number = |text: &str| text.trim().parse::<IBig>().unwrap();
        Self::new(number(numerator), number(denominator))
    }

    /// A float as it is.
    pub fn of(x: f64) -> Self {
        let bits = x.to_bits();
        let field = ((bits >> 52) & 0x7ff) as i32;
        let mantissa = (bits & ((1 << 52) - 1)) | if field == 0 { 0 } else { 1 << 52 };
        let exponent = field.max(1) - 1075;
        let mantissa = IBig::from(mantissa) * if x < 0.0 { -1 } else { 1 };
        let power = IBig::ONE << exponent.unsigned_abs() as usize;
        if exponent < 0 { Self::new(mantissa, power) } else { Self::new(mantissa * power, 1) }
    }

    /// Correct to about 2⁻⁶⁰ of itself.
    pub fn to_f64(&self) -> f64 {
        let bits = |x: &IBig| x.clone().abs().to_string().len() as i32 * 10 / 3;
        let shift = 62 - (bits(&self.numerator) - bits(&self.denominator));
        let up = IBig::ONE << shift.unsigned_abs() as usize;
        let quotient = if shift >= 0 {
            &self.numerator * up / &self.denominator
        } else {
            &self.numerator / (&self.denominator * up)
        };
        let quotient = i128::try_from(quotient).unwrap() as f64;
        // In two steps, for powers beyond the range.
        let half = shift / 2;
        quotient * 2f64.powi(-half) * 2f64.powi(half - shift)
    }

    pub fn abs(&self) -> Self {
        Self { numerator: self.numerator.clone().abs(), denominator: self.denominator.clone() }
    }
}

impl PartialOrd for Ratio {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some((&self.numerator * &other.denominator).cmp(&(&other.numerator * &self.denominator)))
    }
}

macro_rules! operator {
    ($Trait:ident $method:ident |$a:ident, $b:ident| $numerator:expr, $denominator:expr) => {
        impl $Trait for &Ratio {
            type Output = Ratio;
            fn $method(self, other: Self) -> Ratio {
                let ($a, $b) = (self, other);
                Ratio::new($numerator, $denominator)
            }
        }
    };
}

operator!(Add add |a, b| &a.numerator * &b.denominator + &b.numerator * &a.denominator, &a.denominator * &b.denominator);
operator!(Sub sub |a, b| &a.numerator * &b.denominator - &b.numerator * &a.denominator, &a.denominator * &b.denominator);
operator!(Mul mul |a, b| &a.numerator * &b.numerator, &a.denominator * &b.denominator);
operator!(Div div |a, b| &a.numerator * &b.denominator, &a.denominator * &b.numerator);

fn quotient(a: &Ratio, b: &Ratio) -> Ratio {
    if b.is_zero() { Ratio::zero() } else { a / b }
}

/// The span that a parameter is in, of all knots.
pub fn span(knots: &[Ratio], t: &Ratio) -> Option<usize> {
    let last = knots.last().unwrap();
    (0..knots.len() - 1).rev().find(|&i| {
        let (low, high) = (&knots[i], &knots[i + 1]);
        low < high && low <= t && (t < high || t == last && high == last)
    })
}

/// A derivative of a basis function, and the sum of its terms' sizes, with the recurrence of the
/// definition; `at` is the span that t is taken to be in.
pub fn basis(
    knots: &[Ratio],
    at: Option<usize>,
    order: usize,
    i: usize,
    t: &Ratio,
    derivative: usize,
) -> (Ratio, Ratio) {
    if order == 1 {
        let one = Ratio::whole(i64::from(derivative == 0 && Some(i) == at));
        return (one.clone(), one);
    }
    let less = derivative.saturating_sub(1);
    let (left, left_size) = basis(knots, at, order - 1, i, t, less);
    let (right, right_size) = basis(knots, at, order - 1, i + 1, t, less);
    let (low, high) = (&knots[i + order - 1] - &knots[i], &knots[i + order] - &knots[i + 1]);
    let (rise, fall) = if derivative == 0 {
        (&(t - &knots[i]), &(&knots[i + order] - t))
    } else {
        let degree = Ratio::whole(order as i64 - 1);
        (&degree.clone(), &(&Ratio::zero() - &degree))
    };
    let (rise, fall) = (quotient(rise, &low), quotient(fall, &high));
    let value = &(&rise * &left) + &(&fall * &right);
    let size = &(&rise.abs() * &left_size) + &(&fall.abs() * &right_size);
    (value, size)
}

/// The span of the domain whose polynomial a curve has at a parameter: the last one at its end.
pub fn span_of_domain(knots: &[Ratio], order: usize, t: &Ratio) -> Option<usize> {
    let mut spans = (order - 1..knots.len() - order).filter(|&i| knots[i] < knots[i + 1]);
    spans.clone().rfind(|&i| &knots[i] <= t).or(spans.next())
}

/// A curve's derivative, coordinate by coordinate, at a parameter inside of the domain or outside.
pub fn curve(
    knots: &[Ratio],
    order: usize,
    points: &[Ratio],
    t: &Ratio,
    derivative: usize,
) -> Ratio {
    let span = span_of_domain(knots, order, t);
    let first = span.unwrap() + 1 - order;
    (first..first + order).fold(Ratio::zero(), |sum, i| {
        let (weight, _) = basis(knots, span, order, i, t, derivative);
        &sum + &(&weight * &points[i])
    })
}
