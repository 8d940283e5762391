//! What doesn't depend on the kind of solid: errors, constructors, pixels, runs of rows.

mod compile_errors;
mod errors;
mod formats;
mod pixels;
mod readable;
mod runs;
mod umbrella;
