//! Reads OpenSCAD's parts.

mod arguments;
mod error;
pub mod flat;
pub mod map;
mod parse;
mod token;
mod tree;

pub use error::{Error, ErrorKind};
pub use parse::{Argument, Modifiers, Node, Value, parse};
pub use tree::{Convex, Counts, Form, Solid, Tree};
