//! Splines: methods of evaluating a curve in space, on curves that break some of them; and the basis
//! functions of the reference table.

mod basis;
#[path = "../../../tests/splines/exact.rs"]
#[allow(dead_code, clippy::unwrap_used)]
mod exact;
mod judge;
mod kind;
mod methods;
mod plot;
mod report;
mod sets;
#[path = "../../../tests/splines/table.rs"]
mod table;

pub use plot::draw;
pub use report::{csv, markdown, shortfalls, table};

use crate::timing::{self, Cost};
use judge::{Accuracy, Truth};
use kind::Kind;
use methods::METHODS;
use sets::{Case, SETS, Set};

/// A method on a set of curves of one order.
pub struct Row {
    pub set: &'static Set,
    pub order: usize,
    pub method: usize,
    pub accuracy: Accuracy,
    pub cost: Option<Cost>,
}

pub struct Results {
    pub rows: Vec<Row>,
    pub basis: Vec<basis::Row>,
    /// In each set of each order, or more.
    pub points: usize,
}

/// At most so many curves of a set are timed.
const TIMED: usize = 40;

impl Results {
    /// Measures all methods on `curves` curves of each set and order, timed in `rounds` rounds.
    pub fn measure(curves: usize, rounds: usize) -> Result<Self, String> {
        let mut rows = Vec::new();
        for (set, order) in SETS.iter().flat_map(|set| [3, 4].map(|order| (set, order))) {
            let cases = set.cases(order, curves);
            let known = [kind::F32, kind::GRID].map(|kind| known(&cases, kind));
            let (mut accuracies, mut turns) = (Vec::new(), Vec::new());
            for method in METHODS {
                let of_kind = known.iter().find(|(unit, _)| *unit == method.kind.unit);
                let (mut accuracy, mut timed) = (Accuracy::default(), Vec::new());
                for (case, truth) in of_kind.iter().flat_map(|(_, known)| known) {
                    if (method.asks)(case) {
                        let ready = (method.prepare)(case);
                        accuracy.judge(method.kind, case, truth, ready.as_ref());
                        timed.extend(ready);
                    }
                }
                timed.truncate(TIMED);
                let points = timed.iter().map(|ready| ready.points).sum();
                let pass = move || timed.iter().for_each(|ready| (ready.pass)());
                accuracies.push(accuracy);
                turns.push((Box::new(pass) as timing::Pass, points));
            }
            let costs = timing::compare(turns, rounds);
            let figures = accuracies.into_iter().zip(costs).enumerate();
            rows.extend(figures.map(|(method, (accuracy, cost))| Row {
                set,
                order,
                method,
                accuracy,
                cost,
            }));
        }
        Ok(Self { rows, basis: basis::measure()?, points: curves * sets::PARAMETERS })
    }
}

/// The curves in a kind of numbers, and what is true about them.
fn known(cases: &[Case], kind: Kind) -> (&'static str, Vec<(Case, Truth)>) {
    let taken = cases.iter().filter_map(|case| case.taken(kind));
    (kind.unit, taken.map(|case| (case.clone(), Truth::of(&case))).collect())
}
