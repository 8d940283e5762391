//! Reads parts of OpenSCAD for [`scancsg`]: `.csg` files as they are, `.scad` files through an installed `openscad`.
//!
//! ```
//! use scancsg_scad::picture::{Angles, BACKGROUND, View, render};
//! use scancsg_scad::scene::Scene;
//! use scancsg_scad::{Model, lower, parse};
//!
//! let nodes = parse("difference() { cube(size = [3, 2, 1]); cylinder(h = 9, r1 = 1, r2 = 1); }")?;
//! let part = lower(&nodes, false)?; // a tree of solids
//! let model = Model::of(part.tree)?; // along the axes of a few frames
//! let scene = Scene::of(&model)?; // a solid that can be seen and traced
//! let view = View::of_all(&scene, Angles::default(), [64, 48])?;
//! assert_eq!(render(&scene, &view, [64, 48], BACKGROUND)?.len(), 64 * 48);
//! # Ok::<(), scancsg_scad::Error>(())
//! ```
//!
//! `README.md` says what is modelled, and how.

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
pub mod program;
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
