//! The link: packets, what each end makes of them, and lines with faults.

#[path = "../../examples/scene/mod.rs"]
mod scene;

mod document;
mod faults;
mod lengths;
mod lossy_line;
mod packets;
mod serve;
mod sessions;
mod upload;
