//! What is measured of one kind of solids.

use super::method::{Method, Query};
use super::subject::{GROWTH, Kind, Spans, Subject};
use crate::accuracy::Accuracy;
use crate::methods::Gives;
use crate::rays::MAX_COORDINATE;
use crate::results::Summary;
use crate::timing::{self, Cost, Pass};
use scancsg::scalar::I16F16;
use testkit::limits::SolidLimits;
use testkit::number::{Tested, coordinates, vector};
use testkit::random::Random;

/// A method by its names.
pub struct Label {
    pub name: &'static str,
    pub number: &'static str,
    pub unit: &'static str,
    pub is_shipped: bool,
}

impl Label {
    pub fn label(&self) -> String {
        format!("{} {}", self.name, self.number)
    }
}

/// A method on rays of a kind.
pub struct Row {
    pub kind: Kind,
    pub method: usize,
    pub accuracy: Accuracy,
    pub cost: Option<Cost>,
}

/// All methods on all rays at one kind of solids.
pub struct Part {
    pub name: &'static str,
    pub limits: SolidLimits,
    pub methods: Vec<Label>,
    pub rows: Vec<Row>,
}

impl Row {
    pub fn summary(&self) -> Summary {
        Summary { accuracy: self.accuracy.clone(), ratio: self.cost.map(|cost| cost.ratio) }
    }
}

/// What is true about a query.
#[derive(Clone, Copy)]
struct Truth {
    spans: Spans<f64>,
    /// How many spans end at t ≥ 0, or are on the whole line, if that is the same for the solid grown and
    /// shrunk.
    ahead: Option<usize>,
    on_line: Option<usize>,
    /// Whether the ray starts inside; likewise.
    starts_inside: Option<bool>,
}

fn count(spans: &Spans<f64>, is_counted: impl Fn([f64; 2]) -> bool) -> usize {
    spans.iter().flatten().filter(|span| is_counted(**span)).count()
}

fn ahead(spans: &Spans<f64>) -> usize {
    count(spans, |[_, exit]| exit >= 0.0)
}

fn on_line(spans: &Spans<f64>) -> usize {
    count(spans, |_| true)
}

impl Truth {
    fn of<Q: Subject>(Query { solid, ray }: &Query<Q>, growth: f64) -> Self {
        let [grown, spans, shrunk] = [growth, 0.0, -growth].map(|by| solid.spans(*ray, by));
        // A torus grown may lose a gap, and one shrunk a span: each has one span less than the torus itself.
        let all = |ask: fn(&Spans<f64>) -> usize| {
            let [grown, exact, shrunk] = [&grown, &spans, &shrunk].map(ask);
            (grown == exact && exact == shrunk).then_some(exact)
        };
        let inside = |spans: &Spans<f64>| count(spans, |[enter, exit]| enter < 0.0 && exit > 0.0);
        let starts_inside = all(inside).map(|count| count > 0);
        Self { spans, ahead: all(ahead), on_line: all(on_line), starts_inside }
    }
}

/// Queries by the numbers of a type that can hold them.
fn rounded<S: Tested, Q: Subject>(queries: &[Query<Q>]) -> Vec<(Query<Q>, Truth)> {
    let growth = if S::IS_FIXED { Q::FIXED_GROWTH } else { GROWTH };
    let largest = if S::IS_FIXED { MAX_COORDINATE } else { f64::INFINITY };
    let reached = |query: &&Query<Q>| query.ray[0].iter().all(|x| x.abs() <= largest);
    let held = |query: &Query<Q>| Query {
        solid: query.solid.rounded::<S>(),
        ray: query.ray.map(|v| coordinates(vector::<S>(v))),
    };
    let taken = queries.iter().filter(reached).map(held);
    taken.map(|query| (query, Truth::of(&query, growth))).collect()
}

/// Solids per kind of rays.
const SOLIDS: usize = 32;

pub fn drawn<Q: Subject>(kind: Kind, name: &str, rays: usize) -> Vec<Query<Q>> {
    let mut random = Random::named(&format!("{} {name}", Q::NAME));
    let mut queries = Vec::new();
    for i in 0..SOLIDS {
        let solid = Q::drawn(&mut random);
        while queries.len() < rays * (i + 1) / SOLIDS {
            queries.push(Query { solid, ray: kind.ray(&solid, &mut random) });
        }
    }
    queries
}

/// At most so many rays of a set are timed: they fit into a cache nearby.
const TIMED: usize = 1000;

/// Measures all methods on `rays` rays of each kind, timed in `rounds` rounds.
pub fn part<Q: Subject>(rays: usize, rounds: usize) -> Part {
    let methods = Method::<Q>::all();
    let mut rows = Vec::new();
    for (kind, name) in Kind::ALL {
        let queries = drawn::<Q>(kind, name, rays);
        let floats = rounded::<f32, Q>(&queries);
        let fixed = rounded::<I16F16, Q>(&queries);
        let mut accuracies = Vec::new();
        let mut turns: Vec<(Pass, usize)> = Vec::new();
        for method in &methods {
            let cases = if method.inputs.is_exact { &fixed } else { &floats };
            let (accuracy, answered) = judged(method, cases);
            let stride = answered.len().div_ceil(TIMED).max(1);
            let timed: Vec<Query<Q>> = answered.into_iter().step_by(stride).collect();
            turns.push(((method.prepare_pass)(&timed), timed.len()));
            accuracies.push(accuracy);
        }
        let costs = timing::compare(turns, rounds);
        let figures = accuracies.into_iter().zip(costs).enumerate();
        rows.extend(figures.map(|(method, (accuracy, cost))| Row { kind, method, accuracy, cost }));
    }
    let label = |method: Method<Q>| Label {
        name: method.name,
        number: method.number,
        unit: method.inputs.unit,
        is_shipped: method.is_shipped(),
    };
    let methods = methods.into_iter().map(label).collect();
    Part { name: Q::NAME, limits: Q::LIMITS, methods, rows }
}

/// The accuracy on some rays, and the queries that the method can be timed with.
fn judged<Q: Subject>(
    method: &Method<Q>,
    cases: &[(Query<Q>, Truth)],
) -> (Accuracy, Vec<Query<Q>>) {
    let mut accuracy = Accuracy::default();
    let mut answered = Vec::new();
    for (query, truth) in cases {
        match (method.answer)(query) {
            Some(spans) => {
                accuracy.asked += 1;
                judge(&mut accuracy, method, truth, &spans);
                answered.push(*query);
            }
            // Others' methods aren't asked about solids that they don't have.
            None if method.is_shipped() => {
                accuracy.asked += 1;
                accuracy.refused += 1;
            }
            None => {}
        }
    }
    (accuracy, answered)
}

/// As of cylinders: a class is how often the ray, t ≥ 0, meets the solid, and of `I16F16` the whole line.
fn judge<Q>(accuracy: &mut Accuracy, method: &Method<Q>, truth: &Truth, got: &Spans<f64>) {
    accuracy.nans += usize::from(got.iter().flatten().flatten().any(|t| t.is_nan()));
    let (hits, truly) = match method.gives {
        Gives::First => (on_line(got), truth.ahead.map(|count| count.min(1))),
        Gives::Span if method.inputs.is_exact => (on_line(got), truth.on_line),
        Gives::Span => (ahead(got), truth.ahead),
    };
    if let Some(truly) = truly {
        accuracy.judged += 1;
        accuracy.false_hits += usize::from(hits > truly);
        accuracy.false_misses += usize::from(hits < truly);
    }
    match method.gives {
        Gives::Span if on_line(got) == on_line(&truth.spans) => {
            for (got, want) in got.iter().flatten().zip(truth.spans.iter().flatten()) {
                for end in 0..2 {
                    accuracy.compare(method.inputs, end, got[end], want[end]);
                }
            }
        }
        Gives::First => {
            let seen = truth.spans.iter().flatten().find(|[_, exit]| *exit >= 0.0);
            if let ([Some(got), _], Some(want), Some(inside)) = (got, seen, truth.starts_inside) {
                let end = usize::from(inside);
                accuracy.compare(method.inputs, end, got[end], want[end]);
            }
        }
        Gives::Span => {}
    }
}
