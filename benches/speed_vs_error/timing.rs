//! Nanoseconds per ray or point, and as a multiple of the first method's.

use crate::methods::Method;
use crate::rays::Query;
use std::time::{Duration, Instant};

/// Answers some queries once, for a clock around the call.
pub type Pass = Box<dyn Fn()>;

/// What every time is a multiple of: the first method.
const BASELINE: usize = 0;

#[derive(Debug, Clone, Copy)]
pub struct Cost {
    pub nanoseconds: f64,
    pub ratio: f64,
}

/// Times every method on the queries that it answers; `None` where it answers none.
///
/// In each round, all methods take their turn, and are compared within the round: what else the
/// machine does falls on all of them. Medians over the rounds leave single disturbances out.
pub fn measure(methods: &[Method], answered: &[Vec<Query>], rounds: usize) -> Vec<Option<Cost>> {
    let turns = methods.iter().zip(answered);
    let turns = turns.map(|(method, queries)| ((method.prepare_pass)(queries), queries.len()));
    compare(turns.collect(), rounds)
}

/// Times passes over so many things each, and compares them with the first one.
pub fn compare(passes: Vec<(Pass, usize)>, rounds: usize) -> Vec<Option<Cost>> {
    let turns: Vec<_> = passes.into_iter().map(|(run, count)| Turn::new(run, count)).collect();
    let times: Vec<Vec<f64>> =
        (0..rounds).map(|_| turns.iter().map(Turn::nanoseconds).collect()).collect();
    (0..turns.len())
        .map(|i| {
            (turns[i].count > 0 && turns[BASELINE].count > 0).then(|| Cost {
                nanoseconds: median(times.iter().map(|round| round[i])),
                ratio: median(times.iter().map(|round| round[i] / round[BASELINE])),
            })
        })
        .collect()
}

/// The shortest time that the clock is started for.
const SHORTEST: Duration = Duration::from_micros(30);

struct Turn {
    run: Pass,
    count: usize,
    /// Runs that take about [`SHORTEST`].
    repeats: u32,
}

impl Turn {
    fn new(run: Pass, count: usize) -> Self {
        run();
        let start = Instant::now();
        run();
        let once = start.elapsed().max(Duration::from_nanos(50));
        let repeats = SHORTEST.as_nanos().div_ceil(once.as_nanos()) as u32;
        Self { run, count, repeats }
    }

    fn nanoseconds(&self) -> f64 {
        let start = Instant::now();
        for _ in 0..self.repeats {
            (self.run)();
        }
        start.elapsed().as_nanos() as f64 / f64::from(self.repeats) / self.count as f64
    }
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut sorted: Vec<f64> = values.collect();
    sorted.sort_by(f64::total_cmp);
    sorted[sorted.len() / 2]
}
