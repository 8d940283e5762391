//! Uploads: bytes, as those of a program, that go from the end that receives frames to the one that sends them.
//!
//! One packet is under way at a time. The device takes those bytes that it lacks next, and says after each packet
//! how many it has. So it needs no memory but for the bytes, and packets that come twice, late or never do no harm.

mod inbox;
mod sender;
mod take;
mod wire;

pub use inbox::Inbox;
pub use sender::{Outcome, Upload, UploadTask};
pub use take::take;
pub use wire::{Device, Refusal};

use crate::program::BytesError;

/// What a device says of bytes that are no program of its.
impl From<BytesError> for Refusal {
    fn from(error: BytesError) -> Self {
        match error {
            BytesError::Number => Self::Number,
            BytesError::Kind => Self::Kind,
            BytesError::Tree => Self::TooLarge,
            _ => Self::Invalid,
        }
    }
}
