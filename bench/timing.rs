//! Nanoseconds per ray, point or pixel, and as a multiple of what something else takes.

use std::time::{Duration, Instant};

/// Answers some queries once, for a clock around the call.
pub type Pass = Box<dyn Fn()>;

/// Times of passes: of each in every round.
///
/// In each round, all passes take their turn, and are compared within the round: what else the machine
/// does falls on all of them. Medians over the rounds leave single disturbances out.
pub struct Rounds(Vec<Vec<f64>>);

impl Rounds {
    /// Times passes over so many things each.
    pub fn of(passes: Vec<(Pass, usize)>, rounds: usize) -> Self {
        let turns: Vec<_> = passes.into_iter().map(|(run, count)| Turn::new(run, count)).collect();
        Self((0..rounds).map(|_| turns.iter().map(Turn::nanoseconds).collect()).collect())
    }

    /// What a pass takes for each of its things, round by round.
    pub fn of_pass(&self, pass: usize) -> impl Iterator<Item = f64> {
        self.0.iter().map(move |round| round[pass])
    }

    /// The median of that.
    pub fn nanoseconds(&self, pass: usize) -> f64 {
        median(self.of_pass(pass))
    }

    /// What a pass takes as a multiple of what another takes.
    pub fn ratio(&self, pass: usize, to: usize) -> f64 {
        median(self.0.iter().map(|round| round[pass] / round[to]))
    }
}

/// What every time is a multiple of, in tables of methods: the first one's.
const BASELINE: usize = 0;

#[derive(Debug, Clone, Copy)]
pub struct Cost {
    pub nanoseconds: f64,
    pub ratio: f64,
}

/// Times passes over so many things each, and compares them with the first one; `None` where there are
/// none.
pub fn compare(passes: Vec<(Pass, usize)>, rounds: usize) -> Vec<Option<Cost>> {
    let counts: Vec<usize> = passes.iter().map(|(_, count)| *count).collect();
    let times = Rounds::of(passes, rounds);
    let cost = |i| Cost { nanoseconds: times.nanoseconds(i), ratio: times.ratio(i, BASELINE) };
    (0..counts.len()).map(|i| (counts[i] > 0 && counts[BASELINE] > 0).then(|| cost(i))).collect()
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
