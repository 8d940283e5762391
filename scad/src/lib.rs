//! Reads OpenSCAD's parts.

mod arguments;
mod error;
pub mod flat;
pub mod hull;
mod lower;
pub mod map;
mod measure;
mod parse;
pub mod picture;
mod place;
mod prism;
mod read;
mod rust;
pub mod scene;
mod token;
mod tree;

pub use error::{Error, ErrorKind};
pub use lower::{Lowered, lower};
pub use measure::{Measures, measure};
pub use parse::{Argument, Modifiers, Node, Value, parse};
pub use place::{Body, Model, Placed};
pub use read::read;
pub use rust::rust;
pub use tree::{Convex, Counts, Form, Solid, Tree};
