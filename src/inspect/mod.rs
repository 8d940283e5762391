//! Looking into parts: sections, and volume, centroid and moments.
//!
//! | to | use |
//! |---|---|
//! | cut a part open, with the cut faces in a colour of their own | [`section`] |
//! | know its volume, centroid, moments and extent | [`MassProperties`] |

mod lattice;
mod mass;
mod section;

pub use mass::{MassError, MassProperties};
pub use section::{Section, section};
