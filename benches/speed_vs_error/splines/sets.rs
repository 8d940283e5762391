//! The curves: knots and control points that are easy, and such that are not.

use super::kind::Kind;
use crate::random::Random;

/// Control points of a curve.
pub const POINTS: usize = 8;

/// Parameters that a curve is evaluated at.
pub const PARAMETERS: usize = 25;

/// Ticks to a span of a sweep.
pub const TICKS: u32 = 16;

/// The unit of knots and parameters, which `f32` and `I16F16` both have.
const UNIT: f64 = 1.0 / 65536.0;

/// A curve and where it is evaluated; the numbers are exact.
#[derive(Debug, Clone)]
pub struct Case {
    pub order: usize,
    pub knots: Vec<f64>,
    pub points: [[f64; 3]; POINTS],
    pub parameters: Vec<f64>,
    pub is_uniform: bool,
}

impl Case {
    /// The curve in a method's numbers, or `None` outside of their range.
    pub fn taken(&self, kind: Kind) -> Option<Self> {
        let points = self.points.map(|point| point.map(kind.nearest));
        let is_taken = points.iter().flatten().all(|x| x.abs() <= kind.largest);
        is_taken.then(|| Self { points, ..self.clone() })
    }

    /// The largest coordinate of a control point.
    pub fn size(&self) -> f64 {
        self.points.iter().flatten().fold(0.0, |most, x| x.abs().max(most))
    }
}

/// How far it is from knot to knot.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Steps {
    Random,
    Repeated,
    Coincident,
    Uniform,
}

#[derive(Debug)]
pub struct Set {
    pub name: &'static str,
    steps: Steps,
    /// Always, or for one curve of two.
    is_clamped: bool,
    /// A coordinate of the i-th control point.
    coordinate: fn(&mut Random, usize) -> f64,
}

macro_rules! sets {
    ($($steps:ident $is_clamped:literal $name:literal $coordinate:expr;)+) => {
        &[$(Set {
            name: $name,
            steps: Steps::$steps,
            is_clamped: $is_clamped,
            coordinate: $coordinate,
        }),+]
    };
}

pub const SETS: &[Set] = sets! {
    Random false "random knots" |random, _| random.between(-10.0, 10.0);
    Uniform false "uniform knots" |random, _| random.between(-10.0, 10.0);
    Repeated false "repeated knots" |random, _| random.between(-10.0, 10.0);
    Coincident false "nearly coincident knots" |random, _| random.between(-10.0, 10.0);
    Random true "clamped, alternating at full size" alternating;
    Random false "points of 32,000 ± 75" |random, _| 32_000.0 + random.between(-75.0, 75.0);
    Random false "points of 10⁶" |random, _| random.between(-1e6, 1e6);
    Repeated false "points of 10⁶ ± 1" |random, _| 1e6 + random.between(-1.0, 1.0);
};

/// Just below a power of two, where a unit is smallest for the size.
fn alternating(random: &mut Random, i: usize) -> f64 {
    let sign = if i.is_multiple_of(2) { 1.0 } else { -1.0 };
    sign * 16.0 * random.between(0.97, 1.0)
}

impl Set {
    /// The same curves every time.
    pub fn cases(&self, order: usize, count: usize) -> Vec<Case> {
        let mut random = Random::named(self.name);
        (0..count).map(|_| self.case(order, &mut random)).collect()
    }

    fn case(&self, order: usize, random: &mut Random) -> Case {
        let is_uniform = self.steps == Steps::Uniform;
        let is_clamped = !is_uniform && (self.is_clamped || random.chance(0.5));
        let mut knots = vec![random.below(40) as f64 - 20.0];
        if is_uniform {
            knots = vec![0.0];
        }
        for i in 1..POINTS + order {
            let last = knots[i - 1];
            let is_end = is_clamped && (i < order || i > POINTS);
            let step = if is_end { 0.0 } else { self.steps.next(random) };
            // Not more often than the order; and no end of the domain meets the other one.
            let same = knots.iter().filter(|&&knot| knot == last).count();
            let is_too_often = step == 0.0 && (same >= order || i == POINTS);
            knots.push(last + if is_too_often { 0.75 } else { step });
        }
        let points = std::array::from_fn(|i| [(); 3].map(|()| (self.coordinate)(random, i)));
        let (from, to) = (knots[order - 1], knots[POINTS]);
        let ends = (from / UNIT, to / UNIT);
        let parameters = if is_uniform {
            let ticks = TICKS * (POINTS + 1 - order) as u32;
            (0..=ticks).map(|tick| from + f64::from(tick) / f64::from(TICKS)).collect()
        } else {
            let inside = |random: &mut Random| random.between(ends.0, ends.1).round() * UNIT;
            let inside: Vec<f64> = (2..PARAMETERS).map(|_| inside(random)).collect();
            [&[from, to], &inside[..]].concat()
        };
        Case { order, knots, points, parameters, is_uniform }
    }
}

impl Steps {
    fn next(self, random: &mut Random) -> f64 {
        let ordinary = (random.between(0.05, 4.0) / UNIT).round() * UNIT;
        match self {
            Self::Uniform => 1.0,
            Self::Repeated if random.chance(0.4) => 0.0,
            Self::Coincident if random.chance(0.4) => UNIT * (1 + random.below(3)) as f64,
            _ => ordinary,
        }
    }
}
