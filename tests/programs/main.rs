//! Programs: trees that are built at run time, and their form as bytes.

#[macro_use]
extern crate testkit;

mod bytes;
mod hostile;
mod pooled;
mod trees;
