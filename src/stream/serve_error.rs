//! Why a frame could not be delivered.

use core::fmt;

use super::error::EncodeError;
use crate::render::RowError;

/// Why [`serve`](super::serve) could not deliver a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum ServeError<E> {
    /// The row can't be rendered.
    Render(RowError),
    /// The packet can't be made.
    Encode(EncodeError),
    /// Writing to the line failed.
    Write(E),
    /// Reading answers from the line failed.
    Read(E),
    /// No more answers can come: the line's other end is closed.
    Closed,
}

impl<E> ServeError<E> {
    /// The error in words. Of a line's own error only that there is one:
    /// [`source`](core::error::Error::source) has the rest.
    #[must_use]
    pub const fn as_str(&self) -> &'static str {
        match self {
            Self::Render(error) => error.as_str(),
            Self::Encode(error) => error.as_str(),
            Self::Write(_) => "writing to the line failed",
            Self::Read(_) => "reading from the line failed",
            Self::Closed => "line is closed at its other end",
        }
    }
}

impl<E> fmt::Display for ServeError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

impl<E: core::error::Error + 'static> core::error::Error for ServeError<E> {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Write(error) | Self::Read(error) => Some(error),
            Self::Render(error) => Some(error),
            Self::Encode(error) => Some(error),
            Self::Closed => None,
        }
    }
}
