//! Ray-cast solids on a microcontroller, one scanline at a time.
//!
//! A part is a typed expression of primitives. A picture of it is rendered row by row, and each row
//! goes through a serial line as a packet. The crate needs no allocator, no frame buffer and no global
//! state. It never panics. The same input gives the same bits on every target.
//!
//! | to | use |
//! |---|---|
//! | make parts, combine them, cast single rays at them | [`solid`] |
//! | build parts at run time | [`program`] |
//! | render pictures, with shading and pixels of your choice | [`render`] |
//! | cut parts open, know their volume and moments | [`inspect`] |
//! | send pictures through a serial line, and receive them | [`stream`] |
//! | evaluate, edit or bake B-splines | [`spline`] |
//! | place parts, describe rays | [`geom`] |
//! | choose a number type: `f32`, fixed point, `f64` on hosts | [`scalar`] |
//! | read lists of spans, or walk a boolean tree of your own | [`span`] |
//! | see how a picture scans a solid, or bound one | [`scan`] |
//! | draw on other crates' displays, use their vectors | [`interop`] |
//! | hand up errors of all kinds with `?` | [`Error`] |
//! | put a part into flash, and check it while compiling | [`constant!`] |
//!
//! ```
//! use scancsg::geom::vec3;
//! use scancsg::render::{Gray8, Lambert, Orthographic, Picture, Size};
//! use scancsg::solid::{Cylinder, Sphere};
//!
//! // A ball with a hole through it.
//! let ball = Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)?;
//! let bead = ball - Cylinder::<f32>::along_y(0.0, 0.0, 0.4, -2.0, 2.0)?;
//!
//! let camera = Orthographic::look_at(
//!     vec3(0.0, 3.0, 2.0), // from here
//!     vec3(0.0, 0.0, 0.0), // to here
//!     vec3(0.0, 1.0, 0.0), // with this direction upwards
//!     2.2,                 // units from the upper to the lower edge
//! )?;
//! let light = Lambert::new(vec3(-1.0, 2.0, 1.0), 0.2)?;
//! let mut picture = Picture::new(&bead, &camera, Size::new(12, 12)?, light, Gray8(0));
//!
//! let mut row = [Gray8(0); 12];
//! let mut art = Vec::new();
//! for y in 0..12 {
//!     picture.scanline(y)?.render(&mut row)?;
//!     let dots = row.iter().map(|pixel| char::from(b".:-=+*#%@"[usize::from(pixel.0) / 30]));
//!     art.push(dots.collect::<String>());
//! }
//! assert_eq!(art, [
//!     "............",
//!     "...*#=*+=...",
//!     "..#%:=**+=..",
//!     ".#%@:=***+:.",
//!     ".%@@:=***+-.",
//!     ".%@@@@%#*+-.",
//!     ".%@@@@%#*+-.",
//!     ".#%%%%%#*+-.",
//!     ".*#%%%#*+=:.",
//!     "..*###*+=-..",
//!     "...++++=:...",
//!     "............",
//! ]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The repository's `docs/architecture.md` has the structure, its reasons, the formulas and their
//! sources. `docs/numerics.md` has the measured errors.

#![no_std]

#[cfg(test)]
extern crate std;

mod error;
pub mod geom;
pub mod inspect;
pub mod interop;
mod numeric;
mod primitive;
pub mod program;
mod quadric;
mod query;
pub mod render;
pub mod scalar;
pub mod scan;
pub mod solid;
pub mod span;
pub mod spline;
pub mod stream;

pub(crate) use error::error_text;
pub use interop::Error;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

#[cfg(doctest)]
#[doc = include_str!("../docs/architecture.md")]
struct Architecture;

#[cfg(doctest)]
#[doc = include_str!("../docs/cookbook.md")]
struct Cookbook;

#[cfg(doctest)]
#[doc = include_str!("../docs/gallery.md")]
struct Gallery;

#[cfg(doctest)]
#[doc = include_str!("../docs/program.md")]
struct Programs;
