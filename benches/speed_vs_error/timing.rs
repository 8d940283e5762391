//! Nanoseconds per ray, and as a multiple of the textbook formula's.

use crate::methods::{self, BASELINE, Method};
use crate::rays::Query;
use std::time::{Duration, Instant};

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
    let turns: Vec<_> = methods
        .iter()
        .zip(answered)
        .map(|(method, queries)| Turn::new((method.prepare_pass)(queries), queries.len()))
        .collect();
    let times: Vec<Vec<f64>> =
        (0..rounds).map(|_| turns.iter().map(Turn::nanoseconds_per_ray).collect()).collect();
    (0..methods.len())
        .map(|i| {
            (turns[i].rays > 0 && turns[BASELINE].rays > 0).then(|| Cost {
                nanoseconds: median(times.iter().map(|round| round[i])),
                ratio: median(times.iter().map(|round| round[i] / round[BASELINE])),
            })
        })
        .collect()
}

/// The shortest time that the clock is started for.
const SHORTEST: Duration = Duration::from_micros(30);

struct Turn {
    run: methods::Pass,
    rays: usize,
    /// Runs that take about [`SHORTEST`].
    repeats: u32,
}

impl Turn {
    fn new(run: methods::Pass, rays: usize) -> Self {
        run();
        let start = Instant::now();
        run();
        let once = start.elapsed().max(Duration::from_nanos(50));
        let repeats = SHORTEST.as_nanos().div_ceil(once.as_nanos()) as u32;
        Self { run, rays, repeats }
    }

    fn nanoseconds_per_ray(&self) -> f64 {
        let start = Instant::now();
        for _ in 0..self.repeats {
            (self.run)();
        }
        start.elapsed().as_nanos() as f64 / f64::from(self.repeats) / self.rays as f64
    }
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut sorted: Vec<f64> = values.collect();
    sorted.sort_by(f64::total_cmp);
    sorted[sorted.len() / 2]
}
