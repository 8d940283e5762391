//! How the crate fits in with others: a file for each, and a feature of its name.
//!
//! | feature | what it does |
//! |---|---|
//! | `embedded-graphics` | draws pictures into any `DrawTarget`, in its colours |
//! | `mint` | turns vectors into those of `mint`, and back |
//! | `serde` | serialises vectors, lines, poses, sizes, colours, pixels, spans, hits and errors |
//! | `defmt` | logs every public type that holds data |

#[cfg(feature = "embedded-graphics")]
pub mod embedded_graphics;
mod error;
#[cfg(feature = "mint")]
pub mod mint;

pub use error::{DisplayError, Error};
