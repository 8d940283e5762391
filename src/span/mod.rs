//! Spans, lists of spans, and the boolean merge of two lists.
//!
//! A [`Span`] is a piece of a line that lies inside a solid: from the crossing where the line
//! enters to the one where it exits. The list of a line with a solid is sorted and *regularised*:
//! every span has a length, and there is a gap between any two. So a face that two solids share
//! leaves no trace in their union, and a solid minus itself is empty.

pub mod chain;
mod list;
mod merge;
mod room;
mod shape;
#[allow(clippy::module_inception)]
mod span;
pub mod walk;

pub use list::{SpanList, SpanStack, StackFull};
pub use merge::{Operation, merge};
pub(crate) use room::check_room;
pub use shape::Shape;
pub use span::{Crossing, Face, Span};
