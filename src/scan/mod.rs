//! What a picture asks of a solid, and what does the asking: stages, leaves, groups, bounds.
//!
//! A picture of a solid is made in stages, and each keeps what its argument decides:
//!
//! | stage | call | how often |
//! |---|---|---|
//! | view | [`Scan::view`] | once a picture |
//! | row | [`Scan::row`] | once a row |
//! | run of columns | [`Scan::enter`] | where what may be seen changes |
//! | pixel | [`Scan::contains`], [`Scan::step`] | as far as the pixel depends on it |
//!
//! A primitive implements [`Leaf`]: the spans of a column's ray. Everything else is built of leaves.
//! To see a solid of your own, wrap it in a [`ByLine`](crate::solid::ByLine): no trait of this module is
//! needed.

mod active;
pub mod bounds;
mod empty;
mod group;
mod leaf;
pub(crate) mod planes;
mod stage;
pub(crate) mod taper;

pub(crate) use active::view_each;
pub use active::{GroupRow, Member};
pub use empty::Empty;
pub(crate) use group::Active;
pub use leaf::{Kept, Leaf, LeafRow};
pub(crate) use leaf::{OPEN, leaf};
pub use planes::{FaceRows, FaceView, PoolRow};
pub use stage::{ColumnRun, Scan};
