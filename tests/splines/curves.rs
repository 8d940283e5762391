//! Curves against exact fractions: hard knots, big offsets, every order.

use super::exact::{self, Ratio};
use super::number::{Numeric, error};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use scancsg::geom::Vec3;
use scancsg::scalar::I16F16;
use scancsg::spline::{Curve, Outside};
use std::cell::Cell;
use testkit::limits;

pub const POINTS: usize = 9;
pub const KNOTS: usize = POINTS + 6;

/// Knots, control points and a parameter in the domain, as multiples of 2⁻¹⁶.
#[derive(Debug, Clone)]
pub struct Case {
    pub knots: Vec<f64>,
    pub points: Vec<[f64; 2]>,
    /// From 0 to 1.
    pub part: f64,
}

/// Steps from knot to knot: repeated, nearly coincident, or ordinary.
fn step() -> impl Strategy<Value = f64> {
    prop_oneof![
        2 => Just(0.0),
        1 => (1..4i32).prop_map(|units| f64::from(units) / 65536.0),
        4 => (1..40i32).prop_map(|quarters| f64::from(quarters) / 4.0),
        3 => (1..500_000i32).prop_map(|units| f64::from(units) / 65536.0),
    ]
}

fn part() -> impl Strategy<Value = f64> {
    prop_oneof![1 => Just(0.0), 1 => Just(1.0), 8 => 0.0..1.0]
}

pub fn case(order: usize, offset: f64, size: f64) -> impl Strategy<Value = Case> {
    let coordinate = move || (-1.0..1.0).prop_map(move |x: f64| offset + size * x);
    let count = order..=POINTS;
    let points = prop::collection::vec([coordinate(), coordinate()], count);
    let steps = prop::collection::vec(step(), KNOTS);
    (points, steps, -20..20i32, any::<bool>(), part()).prop_map(
        move |(points, steps, start, clamped, part)| {
            let count = points.len() + order;
            let mut knots: Vec<f64> = vec![f64::from(start)];
            for (i, step) in steps.iter().enumerate().take(count - 1).map(|(i, s)| (i + 1, s)) {
                let last = knots[i - 1];
                let at_end = clamped && (i < order || i > points.len());
                let mut next = if at_end { last } else { last + step };
                // Not more often than the order; no end of the domain meets the other one.
                let same = knots.iter().filter(|&&knot| knot == next).count();
                if same >= order || i == points.len() && next == last {
                    next = last + 0.75;
                }
                knots.push(next);
            }
            Case { knots, points, part }
        },
    )
}

/// Control points at full size everywhere, with random signs: the hardest for polynomials, most of
/// all at clamped ends.
pub fn full_size(order: usize, size: f64) -> impl Strategy<Value = Case> {
    case(order, 0.0, 1.0).prop_map(move |case| {
        let points = case.points.iter().map(|point| point.map(|x| size.copysign(x))).collect();
        Case { points, ..case }
    })
}

/// Knots and parameters with all digits of a float, and far apart or close; control points just
/// below a power of two, where a unit is smallest for the size.
fn hard(order: usize) -> impl Strategy<Value = Case> {
    let step = || prop_oneof![1 => Just(0.0), 2 => (-12.0..1.0).prop_map(f64::exp2), 1 => 0.9..1.1];
    let start = prop_oneof![Just(0.0), -3.0..3.0, -100.0..100.0];
    let steps = prop::collection::vec(step(), KNOTS);
    (full_size(order, 1.0), steps, start, 0.97..1.0).prop_map(move |(case, steps, start, size)| {
        let mut knots = vec![start];
        for (pair, step) in case.knots.windows(2).zip(steps) {
            // Where the case's knots repeat, so do these.
            let next = if pair[0] == pair[1] { 0.0 } else { f64::max(step, 1e-4) };
            knots.push(knots.last().unwrap() + next);
        }
        let points = case.points.iter().map(|point| point.map(|x| 2.0 * size * x)).collect();
        Case { knots, points, ..case }
    })
}

/// The case's exact numbers, as rounded to the type.
pub struct Rounded<S> {
    pub knots: Vec<S>,
    pub points: Vec<[S; 2]>,
    pub t: S,
}

impl Case {
    pub fn rounded<S: Numeric>(&self, order: usize) -> Rounded<S> {
        let knots: Vec<S> = self.knots.iter().map(|&x| S::of(x)).collect();
        let (from, to) = (self.knots[order - 1], self.knots[self.points.len()]);
        let t = S::of(from + (to - from) * self.part).min(S::of(to)).max(S::of(from));
        let points = self.points.iter().map(|point| point.map(S::of)).collect();
        Rounded { knots, points, t }
    }
}

pub fn ratios<S: Numeric>(numbers: &[S]) -> Vec<Ratio> {
    numbers.iter().map(|x| x.ratio()).collect()
}

/// One coordinate of control points.
pub fn lane<S: Numeric>(points: &[[S; 2]], i: usize) -> Vec<Ratio> {
    points.iter().map(|point| point[i].ratio()).collect()
}

pub fn largest<S: Numeric>(points: &[[S; 2]]) -> f64 {
    points.iter().flatten().fold(0.0, |most: f64, x| most.max(x.ratio().abs().to_f64()))
}

/// How many cases a test runs; more where `SCANCSG_CASES` says so.
pub fn config() -> Config {
    let cases = std::env::var("SCANCSG_CASES").ok().and_then(|text| text.parse().ok());
    Config { failure_persistence: None, cases: cases.unwrap_or(150), ..Config::default() }
}

/// The same cases every time: an error just beyond a limit is found once, not now and then.
pub fn runner() -> TestRunner {
    TestRunner::new_with_rng(config(), TestRng::deterministic_rng(RngAlgorithm::ChaCha))
}

#[derive(Debug, Clone, Copy)]
enum Form {
    Editable,
    /// With so many polynomials to a span.
    Baked(usize),
}

/// The largest error over random curves, in units of the largest control coordinate.
fn worst<S: Numeric, const K: usize>(offset: f64, size: f64, limit: f64, form: Form) {
    let name = std::any::type_name::<S>().split('<').next().unwrap();
    let most = worst_of::<S, K>(case(K, offset, size), limit, form);
    println!("{name} {form:?} order {K}, {offset} ± {size}: {most:.2} units");
    if offset == 0.0 {
        let most = worst_of::<S, K>(full_size(K, size), limit, form);
        println!("{name} {form:?} order {K}, all of size {size}: {most:.2} units");
    }
}

fn worst_of<S: Numeric, const K: usize>(
    cases: impl Strategy<Value = Case>,
    limit: f64,
    form: Form,
) -> f64 {
    let most = Cell::new(0f64);
    runner()
        .run(&cases, |case| {
            let Rounded { knots, points, t } = case.rounded::<S>(K);
            let Ok(sequence) = S::knots::<K, KNOTS>(&knots) else {
                return Err(TestCaseError::reject("coincident"));
            };
            let Ok(curve) = S::curve::<K, POINTS, KNOTS>(sequence, &points) else {
                return Err(TestCaseError::reject("empty"));
            };
            let got = match form {
                Form::Editable => curve.value(t, Outside::Error).unwrap(),
                Form::Baked(parts) => match S::at_baked(&curve, parts, 0, t, Outside::Error) {
                    Ok(got) => got.unwrap(),
                    Err(error) => return Err(TestCaseError::reject(error.as_str())),
                },
            };
            let knots = ratios(&knots);
            for (i, got) in got.into_iter().enumerate() {
                let exact = exact::curve(&knots, K, &lane(&points, i), &t.ratio(), 0);
                let error = error(got, &exact, largest(&points));
                most.set(most.get().max(error));
                prop_assert!(error <= limit, "{error} units: {got:?} for {:?}", exact.to_f64());
            }
            Ok(())
        })
        .unwrap();
    most.get()
}

#[test]
fn editable_quadratics_and_cubics() {
    for (offset, size) in [(0.0, 1.0), (0.0, 1e6), (1e6, 1.0), (1000.0, 300.0)] {
        worst::<f32, 3>(offset, size, limits::EDITABLE[3], Form::Editable);
        worst::<f32, 4>(offset, size, limits::EDITABLE[4], Form::Editable);
        worst::<f64, 4>(offset, size, limits::EDITABLE_F64, Form::Editable);
    }
}

#[test]
fn hard_curves() {
    fn worst<const K: usize>(limits: [f64; 2]) {
        for (limit, form) in limits.into_iter().zip([Form::Editable, Form::Baked(1)]) {
            let most = worst_of::<f32, K>(hard(K), limit, form);
            println!("f32 {form:?} order {K}, hard: {most:.2} units");
        }
    }
    worst::<2>([limits::EDITABLE[2], limits::BAKED]);
    worst::<3>([limits::EDITABLE[3], limits::BAKED]);
    worst::<4>([limits::EDITABLE[4], limits::BAKED]);
    worst::<5>([limits::EDITABLE[5], limits::BAKED]);
    worst::<6>([limits::EDITABLE[6], limits::BAKED]);
}

#[test]
fn editable_curves_of_other_orders() {
    worst::<f32, 1>(0.0, 10.0, 0.0, Form::Editable);
    worst::<f32, 2>(0.0, 10.0, limits::EDITABLE[2], Form::Editable);
    worst::<f32, 5>(0.0, 10.0, limits::EDITABLE[5], Form::Editable);
    worst::<f32, 6>(0.0, 10.0, limits::EDITABLE[6], Form::Editable);
}

#[test]
fn editable_curves_in_fixed_point() {
    for (offset, size) in [(0.0, 1.0), (0.0, 32_767.0), (32_000.0, 700.0)] {
        worst::<I16F16, 1>(offset, size, 0.0, Form::Editable);
        worst::<I16F16, 2>(offset, size, limits::EDITABLE_FIXED, Form::Editable);
        worst::<I16F16, 3>(offset, size, limits::EDITABLE_FIXED, Form::Editable);
        worst::<I16F16, 4>(offset, size, limits::EDITABLE_FIXED, Form::Editable);
        worst::<I16F16, 6>(offset, size, limits::EDITABLE_FIXED, Form::Editable);
    }
}

#[test]
fn baked_curves() {
    for (offset, size) in [(0.0, 1.0), (0.0, 1.999), (0.0, 1e6), (1e6, 1.0), (1000.0, 300.0)] {
        worst::<f32, 3>(offset, size, limits::BAKED, Form::Baked(1));
        worst::<f32, 4>(offset, size, limits::BAKED, Form::Baked(1));
        worst::<f64, 4>(offset, size, limits::BAKED, Form::Baked(1));
        worst::<f32, 4>(offset, size, limits::BAKED, Form::Baked(2));
    }
}

#[test]
fn baked_curves_of_other_orders() {
    worst::<f32, 1>(0.0, 10.0, 0.0, Form::Baked(1));
    worst::<f32, 2>(0.0, 10.0, limits::BAKED, Form::Baked(1));
    worst::<f32, 5>(0.0, 10.0, limits::BAKED, Form::Baked(1));
    worst::<f32, 6>(0.0, 10.0, limits::BAKED, Form::Baked(1));
    worst::<f64, 6>(0.0, 10.0, limits::BAKED, Form::Baked(1));
}

#[test]
fn baked_curves_in_fixed_point() {
    for (offset, size) in [(0.0, 1.0), (0.0, 75.0), (32_000.0, 75.0)] {
        worst::<I16F16, 1>(offset, size, 0.0, Form::Baked(1));
        worst::<I16F16, 2>(offset, 4.0 * size, limits::BAKED_FIXED, Form::Baked(1));
        worst::<I16F16, 3>(offset, 2.0 * size, limits::BAKED_FIXED, Form::Baked(1));
        worst::<I16F16, 4>(offset, size, limits::BAKED_FIXED, Form::Baked(1));
    }
    worst::<I16F16, 6>(0.0, 20.0, limits::BAKED_FIXED, Form::Baked(1));
}

/// A line that jumps from 2 to 5 at zero.
fn jumps<S: Numeric>() {
    let knots = [-1.0, -1.0, 0.0, 0.0, 1.0, 1.0].map(S::of);
    let points = [1.0, 2.0, 5.0, 6.0].map(|x| [S::of(x); 2]);
    let curve =
        S::curve::<2, POINTS, KNOTS>(S::knots::<2, KNOTS>(&knots).unwrap(), &points).unwrap();
    for zero in [0.0, -0.0] {
        let zero = S::of(zero);
        assert_eq!(curve.value(zero, Outside::Error), Ok(points[2]));
        assert_eq!(S::at_baked(&curve, 1, 0, zero, Outside::Error), Ok(Ok(points[2])));
    }
}

#[test]
fn minus_zero_is_zero() {
    jumps::<f32>();
    jumps::<f64>();
    jumps::<I16F16>();
}

/// A curve holds its knots and control points, and nothing that is computed from them.
#[test]
fn an_editable_cubic_is_small() {
    assert!(size_of::<Curve<Vec3<f32>, 4, 8, 12>>() <= 200);
}
