//! Solids that are built at run time: a tree of parts in postfix order, of a fixed capacity.
//!
//! | to | use |
//! |---|---|
//! | name what parts may be | [`leaves!`](crate::leaves) |
//! | build a tree | [`Program::new`], [`push`](Program::push), [`unite`](Program::unite), [`intersect`](Program::intersect), [`subtract`](Program::subtract) |
//! | add polyhedra of many faces, or change them | [`push_polyhedron`](Program::push_polyhedron), [`set_faces`](Program::set_faces) |
//! | change it | [`part_mut`](Program::part_mut), [`paint`](Program::paint), [`remove`](Program::remove) |
//! | move several parts together | [`add_pose`](Program::add_pose), [`place`](Program::place), [`set_pose`](Program::set_pose) |
//! | render it | a [`Picture`](crate::render::Picture), as of any solid |
//! | ask what one ray meets | [`Program::hit`], [`Program::trace`] |
//! | send it, or keep it | [`Program::to_bytes`], [`Program::from_bytes`]; in place, [`Program::read_bytes`] |
//!
//! A program is a solid: it can be an operand of a typed tree, and be [`Placed`](crate::solid::Placed),
//! [`Painted`](crate::solid::Painted) or [`Scaled`](crate::solid::Scaled). What isn't known at compile time is how
//! parts are combined. The work for a pixel is bounded by its capacities: in each turn of a walk at most all parts
//! are asked, and there are at most as many turns as the parts have crossings.
//!
//! Memory is the program, and in a picture the views and rows of all parts and of all
//! faces in the pool that there is room for.

mod build;
mod bytes;
mod dress;
mod faces;
mod in_place;
mod leaves;
mod picture;
mod pool;
mod ray;
mod same;
mod solid;
mod tree;

pub use build::{Program, ProgramError};
pub use bytes::{BytesError, Coded, Reader, Writer};
pub use picture::ProgramRow;
pub use ray::LineError;
