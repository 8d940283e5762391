//! The crate as one page for a browser: it draws the gallery, and it receives frames.
//!
//! Built for `wasm32-unknown-unknown`, an instance of this module is one renderer or one receiver. The
//! page makes a new instance for each line that it opens. The functions of [`exports`] are all that it
//! calls; they take and return numbers, and pointers into the module's memory.

pub mod draw;
pub mod exports;
#[allow(dead_code)] // the list of scenes is all that is asked for
#[path = "../../examples/stream/gallery.rs"]
mod gallery;
pub mod pixels;
#[path = "../../examples/scene/mod.rs"]
mod scene;
pub mod view;
