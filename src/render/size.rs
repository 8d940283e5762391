//! The size of a picture.

/// Width and height of a picture in pixels; neither is zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "[u16; 2]", into = "[u16; 2]")
)]
pub struct Size {
    width: u16,
    height: u16,
}

crate::error_text! {
    /// Why a picture can't have a size.
    pub enum SizeError {
        /// The width or the height is zero.
        Zero => "the width or the height of the picture is zero",
    }
}

impl Size {
    /// A size in pixels.
    ///
    /// # Errors
    /// [`SizeError::Zero`].
    pub const fn new(width: u16, height: u16) -> Result<Self, SizeError> {
        if width == 0 || height == 0 {
            return Err(SizeError::Zero);
        }
        Ok(Self { width, height })
    }

    /// The number of columns.
    #[must_use]
    pub const fn width(self) -> u16 {
        self.width
    }

    /// The number of rows.
    #[must_use]
    pub const fn height(self) -> u16 {
        self.height
    }
}

/// Width and height.
impl TryFrom<[u16; 2]> for Size {
    type Error = SizeError;

    fn try_from([width, height]: [u16; 2]) -> Result<Self, SizeError> {
        Self::new(width, height)
    }
}

impl From<Size> for [u16; 2] {
    fn from(size: Size) -> Self {
        [size.width, size.height]
    }
}
