//! What the tests need to know of a number type.

use super::exact::Ratio;
use scancsg::scalar::I16F16;
use scancsg::spline::{Curve, CurveError, EvaluateError, KnotError, Knots, Outside, SplineScalar};
use testkit::ulp::unit_of;

pub trait Numeric: SplineScalar {
    /// The nearest number.
    fn of(x: f64) -> Self;
    /// Exactly.
    fn ratio(self) -> Ratio;
    /// The distance to the next number, for numbers of this size.
    fn ulp(size: f64) -> f64;
    fn knots<const K: usize, const N: usize>(
        knots: &[Self],
    ) -> Result<Knots<Self, K, N>, KnotError>;
    fn curve<const K: usize, const C: usize, const N: usize>(
        knots: Knots<Self, K, N>,
        points: &[[Self; 2]],
    ) -> Result<Curve<[Self; 2], K, C, N>, CurveError>;
    /// A derivative of the baked curve, or its value, with so many polynomials to a span: 1 or 2.
    fn at_baked<const K: usize, const C: usize, const N: usize>(
        curve: &Curve<[Self; 2], K, C, N>,
        parts: usize,
        order: usize,
        t: Self,
        outside: Outside,
    ) -> Result<Result<[Self; 2], EvaluateError>, CurveError>;
}

macro_rules! of_spans {
    ($curve:expr, $parts:expr, $order:expr, $t:expr, $outside:expr, $($SPANS:literal),+) => {
        match $curve.knots().spans() * $parts {
            $($SPANS => {
                let baked = $curve.bake::<$SPANS>()?;
                Ok(match $order {
                    0 => baked.value($t, $outside),
                    order => baked.derivative(order, $t, $outside),
                })
            })+
            spans => panic!("{spans} spans"),
        }
    };
}

macro_rules! constructors {
    () => {
        fn knots<const K: usize, const N: usize>(
            knots: &[Self],
        ) -> Result<Knots<Self, K, N>, KnotError> {
            Knots::<Self, K, N>::new(knots)
        }

        fn curve<const K: usize, const C: usize, const N: usize>(
            knots: Knots<Self, K, N>,
            points: &[[Self; 2]],
        ) -> Result<Curve<[Self; 2], K, C, N>, CurveError> {
            Curve::<[Self; 2], K, C, N>::from_slice(knots, points)
        }

        fn at_baked<const K: usize, const C: usize, const N: usize>(
            curve: &Curve<[Self; 2], K, C, N>,
            parts: usize,
            order: usize,
            t: Self,
            outside: Outside,
        ) -> Result<Result<[Self; 2], EvaluateError>, CurveError> {
            of_spans!(
                curve, parts, order, t, outside, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 16, 18
            )
        }
    };
}

impl Numeric for f32 {
    fn of(x: f64) -> Self {
        x as f32
    }

    fn ratio(self) -> Ratio {
        Ratio::of(f64::from(self))
    }

    fn ulp(size: f64) -> f64 {
        let size = (size.abs() as f32).max(f32::MIN_POSITIVE);
        // Of the binade that the size is in.
        unit_of(size.into(), f32::EPSILON.into())
    }

    constructors!();
}

impl Numeric for f64 {
    fn of(x: f64) -> Self {
        x
    }

    fn ratio(self) -> Ratio {
        Ratio::of(self)
    }

    fn ulp(size: f64) -> f64 {
        unit_of(size.abs().max(f64::MIN_POSITIVE), f64::EPSILON)
    }

    constructors!();
}

impl Numeric for I16F16 {
    fn of(x: f64) -> Self {
        Self::from_bits((x * 65536.0).round_ties_even() as i32)
    }

    fn ratio(self) -> Ratio {
        Ratio::new(i64::from(self.to_bits()), 1 << 16)
    }

    fn ulp(_: f64) -> f64 {
        1.0 / 65536.0
    }

    constructors!();
}

/// How many units a number is off.
pub fn error<S: Numeric>(got: S, exact: &Ratio, size: f64) -> f64 {
    (&got.ratio() - exact).abs().to_f64() / S::ulp(size)
}
