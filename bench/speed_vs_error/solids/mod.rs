//! The other solids: boxes, polyhedra, cones, ellipsoids and tori, each with rays of every kind and with what
//! it is compared with.

mod check;
mod cone;
mod ellipsoid;
mod measure;
mod method;
mod planes;
mod quartic;
mod report;
mod subject;
mod torus;

pub use check::check_references;
pub use measure::{Part, Row};
pub use report::{csv, markdown, shortfalls, table};
pub use subject::Kind;

/// Measures one kind of solids with so many rays of each kind, in so many rounds.
type Measure = fn(usize, usize) -> Part;

const SOLIDS: [Measure; 5] = [
    measure::part::<planes::Block>,
    measure::part::<planes::Convex>,
    measure::part::<cone::Cone>,
    measure::part::<ellipsoid::Ellipsoid>,
    measure::part::<torus::Torus>,
];

pub fn measure(rays: usize, rounds: usize) -> Vec<Part> {
    SOLIDS.iter().map(|measure| measure(rays, rounds)).collect()
}
