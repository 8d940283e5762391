//! Reads OpenSCAD's parts.

mod arguments;
mod error;
pub mod flat;
pub mod hull;
mod lower;
pub mod map;
mod parse;
mod prism;
mod token;
mod tree;

pub use error::{Error, ErrorKind};
pub use lower::{Lowered, lower};
pub use parse::{Argument, Modifiers, Node, Value, parse};
pub use tree::{Convex, Counts, Form, Solid, Tree};
