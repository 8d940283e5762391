//! What tests and benchmarks share: oracles that decide exactly, a brute-force caster, seeded
//! generators, vectors, units in the last place, and one table of limits.
//!
//! A failure inside is a panic, as in a test.

pub mod bspline;
pub mod bspline_table;
pub mod caster;
pub mod cone_oracle;
pub mod cylinder_table;
pub mod expect;
mod fnv;
pub mod gallery;
pub mod instances;
pub mod limits;
pub mod link;
pub mod number;
pub mod oracle;
pub mod quartic;
pub mod query;
pub mod random;
pub mod says;
pub mod surd;
pub mod turn;
pub mod ulp;
pub mod vector;
