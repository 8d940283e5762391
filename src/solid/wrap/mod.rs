//! Solids around other solids: colour, place, and solids of your own.

mod by_line;
mod nearby;
mod painted;
mod placed;
mod scaled;
mod wrapping;

pub use by_line::ByLine;
pub use painted::Painted;
pub use placed::Placed;
pub use scaled::Scaled;
pub use wrapping::Wrap;
