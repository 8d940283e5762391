//! Looking into parts.
//!
//! | to | use |
//! |---|---|
//! | cut a part open, with the cut faces in a colour of their own | [`section`] |

mod section;

pub use section::{Section, section};
