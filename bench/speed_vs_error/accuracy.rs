//! Answers against the oracle.
//!
//! - A *class* is whether the ray, t ≥ 0, meets the solid. It is judged where it is robust. A line
//!   that a method says to leave the solid at t < 0 is a miss; an answer of NaN is a hit. Where exact
//!   classes are promised, it is whether the whole line is inside the solid for some length, and it is
//!   judged always.
//! - *Errors* are taken of the span's ends on the whole line, negative ones too, wherever method
//!   and oracle have a span. A method that gives the first crossing only is asked about rays that
//!   start robustly inside or outside: its answer is compared with the exit or with the entry.

use crate::methods::{Answer, Gives, Inputs, Method, ULP};
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use testkit::oracle::Truth;
use testkit::query::Query;
use testkit::ulp::{percentiles, ulp_at};

/// What was found out about a method on some rays.
#[derive(Debug, Clone, Default)]
pub struct Accuracy {
    /// Of t_in and t_out, in the method's unit.
    pub errors: [Vec<f64>; 2],
    /// The same in ulps of an `f32`, if the method's unit is another one.
    converted: [Vec<f64>; 2],
    /// Ends that are not the nearest number to the exact one, though they could be: the exact ends
    /// are not nearest to one number both.
    pub misrounded: usize,
    /// How far the point that is seen lies off its face, in the inputs' unit for that.
    pub points: Vec<f64>,
    /// Rays that the number type can hold.
    pub asked: usize,
    /// Rays whose class was judged.
    pub judged: usize,
    pub false_hits: usize,
    pub false_misses: usize,
    pub nans: usize,
    pub panics: usize,
    /// Valid rays that the method doesn't take.
    pub refused: usize,
}

/// The accuracy on a set, and the queries that the method can be timed with.
pub fn measure(method: &Method, cases: &[(Query, Truth)]) -> (Accuracy, Vec<Query>) {
    let mut accuracy = Accuracy::default();
    let mut answered = Vec::new();
    // Panics are counted; their messages would drown the report.
    let hook = take_hook();
    set_hook(Box::new(|_| {}));
    for (query, truth) in cases {
        accuracy.asked += 1;
        match catch_unwind(AssertUnwindSafe(|| (method.answer)(query))) {
            Err(_) => accuracy.panics += 1,
            Ok(Answer::Refused) => accuracy.refused += usize::from(truth.valid),
            Ok(answer) => {
                answered.push(*query);
                accuracy.judge(method, query, truth, answer);
            }
        }
    }
    set_hook(hook);
    (accuracy, answered)
}

impl Accuracy {
    fn judge(&mut self, method: &Method, query: &Query, truth: &Truth, answer: Answer) {
        let span = if let Answer::Hit(span) = answer { Some(span) } else { None };
        let is_nan = span.is_some_and(|[t_in, t_out]| t_in.is_nan() || t_out.is_nan());
        self.nans += usize::from(is_nan);
        let hits = span.is_some_and(|[_, t_out]| is_nan || t_out >= 0.0);
        let (hits, truly_hits) = if method.inputs.is_exact && truth.valid {
            (span.is_some(), Some(truth.is_inside_somewhere))
        } else {
            (hits, truth.robust_hit)
        };
        if let Some(truly_hits) = truly_hits {
            self.judged += 1;
            self.false_hits += usize::from(hits && !truly_hits);
            self.false_misses += usize::from(truly_hits && !hits);
        }
        if let (Some(got), Some(want), false) = (span, truth.span, is_nan) {
            let compared = match (method.gives, truth.starts_inside) {
                (Gives::Span, _) => [true, true],
                (Gives::First, Some(inside)) if want[1] >= 0.0 => [!inside, inside],
                (Gives::First, _) => [false, false],
            };
            for end in (0..2).filter(|&end| compared[end]) {
                self.compare(method.inputs, end, got[end], want[end]);
                let (error, unit) =
                    ((got[end] - want[end]).abs(), (method.inputs.unit_at)(want[end]));
                let nearest = want.map(|t| (t / unit).round());
                // The exact end itself was rounded to an f64.
                let is_nearest = error <= (0.5 + 1e-6) * unit;
                self.misrounded += usize::from(!is_nearest && nearest[0] < nearest[1]);
            }
        }
        // A ray that truly misses has no place where its point should be.
        let truly_hits = truth.span.is_some_and(|[_, t_out]| t_out >= 0.0);
        if let (Some(point), true) = (method.point, truly_hits) {
            let unit = (method.inputs.point_unit)(query);
            let is_fixed = method.inputs.is_exact;
            self.points.extend(point(query).map(|at| off_surface(query, at, is_fixed) / unit));
        }
    }

    /// Notes how far an end of a span is off.
    pub fn compare(&mut self, inputs: &Inputs, end: usize, got: f64, want: f64) {
        let error = (got - want).abs();
        self.errors[end].push(error / (inputs.unit_at)(want));
        if inputs.unit != ULP {
            self.converted[end].push(error / ulp_at(want));
        }
    }

    pub fn merge(&mut self, other: &Self) {
        for (all, more) in
            [(&mut self.errors, &other.errors), (&mut self.converted, &other.converted)]
        {
            for (all, more) in all.iter_mut().zip(more) {
                all.extend(more);
            }
        }
        self.points.extend(&other.points);
        for (all, more) in [
            (&mut self.asked, other.asked),
            (&mut self.judged, other.judged),
            (&mut self.misrounded, other.misrounded),
            (&mut self.false_hits, other.false_hits),
            (&mut self.false_misses, other.false_misses),
            (&mut self.nans, other.nans),
            (&mut self.panics, other.panics),
            (&mut self.refused, other.refused),
        ] {
            *all += more;
        }
    }
}

impl Accuracy {
    /// Answers of NaN, panics, and valid rays not taken.
    pub fn other(&self) -> usize {
        self.nans + self.panics + self.refused
    }

    /// The 99th percentile in ulps of an `f32`, of the end that is farther off.
    pub fn p99_ulps(&self) -> Option<f64> {
        let p99 = |end| percentiles(self.in_ulps(end)).map(|[_, p99, _]| p99);
        [p99(0), p99(1)].into_iter().flatten().reduce(f64::max)
    }

    /// The errors of t_in or t_out in ulps of an `f32`, whatever the method counts in.
    pub fn in_ulps(&self, end: usize) -> &[f64] {
        if self.converted[end].is_empty() { &self.errors[end] } else { &self.converted[end] }
    }
}

/// The distance of a point from the face that it is said to lie on: in fixed point, from the wall or
/// plane that the face is of, because along it a unit of the parameter is as long as the direction.
fn off_surface(query: &Query, (point, on_wall): ([f64; 3], bool), is_fixed: bool) -> f64 {
    let [x, y, z] = std::array::from_fn(|i| point[i] - query.base[i]);
    if query.is_ball {
        return (x.hypot(y).hypot(z) - query.radius).abs();
    }
    let (outside_wall, beyond_cap) = (y.hypot(z) - query.radius, x.abs() - query.half_length);
    let (off, beyond) =
        if on_wall { (outside_wall, beyond_cap) } else { (beyond_cap, outside_wall) };
    if is_fixed { off.abs() } else { off.hypot(beyond.max(0.0)) }
}
