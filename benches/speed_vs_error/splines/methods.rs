//! What is compared: ways to evaluate a curve.

use super::kind::{F32, GRID, Kind};
use super::sets::{Case, POINTS, TICKS};
use crate::timing::Pass;
use enterpolation::bspline::BSpline;
use enterpolation::{ConstSpace, Signal, Sorted};
use scancsg::geom::{Vec3, vec3};
use scancsg::scalar::I16F16;
use scancsg::spline::{Baked, Curve, Knots, Outside, Sweep};
use std::hint::black_box;
use std::ops::{Add, Mul};

/// A curve that is ready to be evaluated.
pub struct Ready {
    /// At all parameters; `None` where there is no value.
    pub values: Box<dyn Fn() -> Vec<Option<[f64; 3]>>>,
    /// The same for a clock.
    pub pass: Pass,
    pub points: usize,
}

impl Ready {
    fn new<T: Copy + 'static, P: 'static>(
        parameters: Vec<T>,
        solve: impl Fn(T) -> Option<P> + Clone + 'static,
        coordinates: fn(P) -> [f64; 3],
    ) -> Self {
        let (asked, solver) = (parameters.clone(), solve.clone());
        let points = parameters.len();
        let values = move || asked.iter().map(|&t| solver(t).map(coordinates)).collect();
        let pass = move || {
            for t in &parameters {
                black_box(solve(*black_box(t)));
            }
        };
        Self { values: Box::new(values), pass: Box::new(pass), points }
    }
}

pub struct Method {
    pub name: &'static str,
    pub number: &'static str,
    pub kind: Kind,
    /// Whether it is one for curves like this.
    pub asks: fn(&Case) -> bool,
    /// `None` if it doesn't take the curve.
    pub prepare: fn(&Case) -> Option<Ready>,
    /// The largest error that is promised.
    pub limit: Option<f64>,
}

impl Method {
    pub fn label(&self) -> String {
        format!("{} {}", self.name, self.number)
    }
}

macro_rules! methods {
    ($([$name:literal $number:literal $kind:ident $asks:expr, $prepare:path, $limit:expr])+) => {
        &[$(Method {
            name: $name,
            number: $number,
            kind: $kind,
            asks: $asks,
            prepare: $prepare,
            limit: $limit,
        }),+]
    };
}

/// The first one is what every time is a multiple of.
pub const METHODS: &[Method] = methods! {
    ["enterpolation" "f32" F32 |_| true, enterpolation, None]
    ["editable" "f32" F32 |_| true, single::editable, Some(5.0)]
    ["baked" "f32" F32 |_| true, single::baked, Some(3.1)]
    ["editable" "I16F16" GRID |_| true, fixed::editable, Some(0.6)]
    ["baked" "I16F16" GRID |_| true, fixed::baked, Some(0.6)]
    ["sweep" "I16F16" GRID |case| case.is_uniform, sweep, Some(0.6)]
};

/// A point as enterpolation takes it.
#[derive(Debug, Default, Clone, Copy)]
struct Point([f32; 3]);

impl Add for Point {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([a + x, b + y, c + z])
    }
}

impl Mul<f32> for Point {
    type Output = Self;
    fn mul(self, factor: f32) -> Self {
        Self(self.0.map(|x| x * factor))
    }
}

fn enterpolation(case: &Case) -> Option<Ready> {
    match case.order {
        3 => enterpolation_of::<3, { POINTS + 1 }>(case),
        4 => enterpolation_of::<4, { POINTS + 2 }>(case),
        _ => None,
    }
}

/// It has no use for the first and the last knot.
fn enterpolation_of<const K: usize, const N: usize>(case: &Case) -> Option<Ready> {
    let knots: [f32; N] = std::array::from_fn(|i| case.knots[i + 1] as f32);
    let points = case.points.map(|point| Point(point.map(|x| x as f32)));
    let knots = Sorted::new(knots).ok()?;
    let curve = BSpline::new(points, knots, ConstSpace::<Point, K>::new()).ok()?;
    let parameters = case.parameters.iter().map(|&t| t as f32).collect();
    let value = move |t: f32| Some(curve.eval(t));
    Some(Ready::new(parameters, value, |point: Point| point.0.map(f64::from)))
}

/// A baked curve's type has the number of its spans.
macro_rules! of_spans {
    ($curve:ident, $case:ident, $K:ident, $($SPANS:literal)+) => {
        match $curve.knots().spans() {
            $($SPANS => {
                let baked: Baked<_, $K, $SPANS> = $curve.bake().ok()?;
                Some(ready($case, move |t| baked.value(t, Outside::Clamp).ok()))
            })+
            _ => None,
        }
    };
}

macro_rules! forms {
    ($module:ident, $Scalar:ty, $nearest:expr) => {
        mod $module {
            use super::*;

            fn number(x: f64) -> $Scalar {
                $nearest(x)
            }

            fn curve<const K: usize, const N: usize>(
                case: &Case,
            ) -> Option<Curve<Vec3<$Scalar>, K, POINTS, N>> {
                let knots: Vec<$Scalar> = case.knots.iter().copied().map(number).collect();
                let knots = Knots::<$Scalar, K, N>::new(&knots).ok()?;
                Curve::<Vec3<$Scalar>, K, POINTS, N>::new(knots, points(case)).ok()
            }

            pub(super) fn points(case: &Case) -> [Vec3<$Scalar>; POINTS] {
                case.points.map(|point| {
                    let [x, y, z] = point.map(number);
                    vec3(x, y, z)
                })
            }

            fn ready(
                case: &Case,
                value: impl Fn($Scalar) -> Option<Vec3<$Scalar>> + Clone + 'static,
            ) -> Ready {
                let parameters = case.parameters.iter().copied().map(number).collect();
                Ready::new(parameters, value, coordinates)
            }

            pub(super) fn coordinates(point: Vec3<$Scalar>) -> [f64; 3] {
                point.to_array().map(f64::from)
            }

            pub(super) fn editable(case: &Case) -> Option<Ready> {
                match case.order {
                    3 => editable_of::<3, { POINTS + 3 }>(case),
                    4 => editable_of::<4, { POINTS + 4 }>(case),
                    _ => None,
                }
            }

            fn editable_of<const K: usize, const N: usize>(case: &Case) -> Option<Ready> {
                let curve = curve::<K, N>(case)?;
                Some(ready(case, move |t| curve.value(t, Outside::Clamp).ok()))
            }

            pub(super) fn baked(case: &Case) -> Option<Ready> {
                match case.order {
                    3 => baked_of::<3, { POINTS + 3 }>(case),
                    4 => baked_of::<4, { POINTS + 4 }>(case),
                    _ => None,
                }
            }

            fn baked_of<const K: usize, const N: usize>(case: &Case) -> Option<Ready> {
                let curve = curve::<K, N>(case)?;
                of_spans!(curve, case, K, 1 2 3 4 5 6)
            }
        }
    };
}

forms!(single, f32, |x| x as f32);
forms!(fixed, I16F16, |x: f64| I16F16::from_bits((x * 65536.0) as i32));

fn sweep(case: &Case) -> Option<Ready> {
    match case.order {
        3 => sweep_of::<3>(case),
        4 => sweep_of::<4>(case),
        _ => None,
    }
}

fn sweep_of<const K: usize>(case: &Case) -> Option<Ready> {
    let points = fixed::points(case);
    Sweep::<_, K>::new(&points, TICKS).ok()?;
    let values = move || {
        let sweep = Sweep::<_, K>::new(&points, TICKS).into_iter().flatten();
        sweep.map(|point| Some(fixed::coordinates(point))).collect()
    };
    let pass = move || {
        let sweep = Sweep::<_, K>::new(black_box(&points), TICKS);
        sweep.into_iter().flatten().for_each(|point| _ = black_box(point));
    };
    let count = case.parameters.len();
    Some(Ready { values: Box::new(values), pass: Box::new(pass), points: count })
}
