//! Solids that are built at run time: a tree of parts in postfix order, of a fixed capacity.

mod build;
mod bytes;
mod in_place;
mod leaves;
mod picture;
mod ray;
mod solid;
mod tree;

pub use build::{Program, ProgramError};
pub use bytes::{BytesError, Coded, Reader, Writer};
pub use picture::ProgramRow;
pub use ray::LineError;
