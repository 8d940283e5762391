//! The figures of one run, and how they are summed up over groups of sets.

use crate::accuracy::{self, Accuracy};
use crate::methods::Method;
use crate::rays::{Group, Set};
use crate::timing::{self, Cost, Pass};
use testkit::oracle::Truth;
use testkit::query::Query;

/// A method on a set.
pub struct Row {
    pub set: &'static Set,
    pub method: usize,
    pub accuracy: Accuracy,
    pub cost: Option<Cost>,
}

pub struct Results {
    pub methods: Vec<Method>,
    pub rows: Vec<Row>,
    pub rays: usize,
}

/// At most so many rays of a set are timed: they fit into a cache nearby.
const TIMED: usize = 2000;

/// A method on all sets of a group.
pub struct Summary {
    pub accuracy: Accuracy,
    /// The geometric mean of the sets' ratios to the textbook formula's time.
    pub ratio: Option<f64>,
}

impl Results {
    /// Measures all methods on `rays` rays of each set, timed in `rounds` rounds.
    pub fn measure(methods: Vec<Method>, sets: &'static [Set], rays: usize, rounds: usize) -> Self {
        let mut rows = Vec::new();
        for set in sets {
            let queries = set.queries(rays);
            let mut known: Vec<(&str, Vec<(Query, Truth)>)> = Vec::new();
            let mut answered = Vec::new();
            let mut accuracies = Vec::new();
            for method in &methods {
                let (accuracy, queries) =
                    accuracy::measure(method, cases(method, &queries, &mut known));
                let stride = queries.len().div_ceil(TIMED).max(1);
                accuracies.push(accuracy);
                answered.push(queries.into_iter().step_by(stride).collect());
            }
            // How fast a method finds out that a ray is none says nothing.
            let costs = match set.group {
                Group::Invalid => vec![None; methods.len()],
                _ => timing::compare(turns(&methods, &answered), rounds),
            };
            let figures = accuracies.into_iter().zip(costs).enumerate();
            rows.extend(figures.map(|(method, (accuracy, cost))| Row {
                set,
                method,
                accuracy,
                cost,
            }));
        }
        Self { methods, rows, rays }
    }

    /// Groups that any set is of, and their names.
    pub fn groups(&self) -> impl Iterator<Item = (Group, &'static str)> {
        let is_used = |group| self.rows.iter().any(|row| row.set.group == group);
        Group::ALL.into_iter().filter(move |&(group, _)| is_used(group))
    }

    pub fn summary(&self, method: usize, group: Group) -> Summary {
        let rows = || self.rows.iter().filter(|row| row.method == method && row.set.group == group);
        let mut accuracy = Accuracy::default();
        rows().for_each(|row| accuracy.merge(&row.accuracy));
        let logs: Vec<f64> = rows().filter_map(|row| Some(row.cost?.ratio.ln())).collect();
        let mean = logs.iter().sum::<f64>() / logs.len() as f64;
        Summary { accuracy, ratio: (!logs.is_empty()).then(|| mean.exp()) }
    }
}

/// What is timed: every method, on the queries that it answers.
fn turns(methods: &[Method], answered: &[Vec<Query>]) -> Vec<(Pass, usize)> {
    let turns = methods.iter().zip(answered);
    turns.map(|(method, queries)| ((method.prepare_pass)(queries), queries.len())).collect()
}

/// The queries in a method's numbers and what is true about them, found out once for each kind of
/// numbers.
fn cases<'a>(
    method: &Method,
    queries: &[Query],
    known: &'a mut Vec<(&'static str, Vec<(Query, Truth)>)>,
) -> &'a [(Query, Truth)] {
    let name = method.inputs.name;
    let index = known.iter().position(|(kind, _)| *kind == name).unwrap_or_else(|| {
        let taken = queries.iter().filter_map(method.inputs.take);
        known.push((name, taken.map(|query| (query, Truth::of(&query))).collect()));
        known.len() - 1
    });
    &known[index].1
}
