//! Columns of a picture, and numbers that change by the same step from one to the next.

use crate::scalar::Real;

/// A pixel's column: its index, and its centre counted from the middle of the picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Column {
    /// 0 at the left.
    pub index: u32,
    /// In half pixels from the middle of the picture, positive to the right.
    pub x: i32,
}

/// So many columns as a signed number, as far as there are half pixels for them.
#[inline]
pub(crate) fn signed(columns: u32) -> i32 {
    columns.min((1 << 30) - 1).cast_signed()
}

/// A number that changes by the same step from each half pixel to the next.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Affine<T> {
    /// In the middle of the row.
    pub middle: T,
    /// What half a pixel to the right adds.
    pub step: T,
}

impl<T: Real> Affine<T> {
    /// The row, `y` half pixels below the middle, of what is given in the middle of the picture and
    /// by its steps to the right and down.
    #[inline]
    #[must_use]
    pub fn row([middle, right, down]: [T; 3], y: i32) -> Self {
        Self { middle: middle.after_steps(down, y), step: right }
    }

    /// The number `x` half pixels to the right of the middle.
    #[inline]
    #[must_use]
    pub fn at(&self, x: i32) -> T {
        self.middle.after_steps(self.step, x)
    }

    /// The number on top of one that is the same everywhere.
    #[inline]
    pub(crate) fn above(&self, middle: T) -> Self {
        Self { middle: middle + self.middle, ..*self }
    }

    /// The sum of two numbers.
    #[inline]
    #[must_use]
    pub(crate) fn plus(&self, other: &Self) -> Self {
        Self { middle: self.middle + other.middle, step: self.step + other.step }
    }

    /// The difference of two numbers.
    #[inline]
    #[must_use]
    pub(crate) fn minus(&self, other: &Self) -> Self {
        Self { middle: self.middle - other.middle, step: self.step - other.step }
    }

    /// The same multiple of a number everywhere.
    #[inline]
    #[must_use]
    pub fn times(&self, factor: T) -> Self {
        Self { middle: self.middle * factor, step: self.step * factor }
    }
}

/// The columns, from `start` to before `end`, outside of which a solid can't be seen in a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Extent {
    /// The first column.
    pub start: u32,
    /// Behind the last column.
    pub end: u32,
}

impl Extent {
    /// No column.
    pub const EMPTY: Self = Self { start: 0, end: 0 };

    /// All columns of a row.
    #[must_use]
    pub const fn all(columns: u32) -> Self {
        Self { start: 0, end: columns }
    }

    /// Whether a column is inside.
    #[must_use]
    #[inline]
    pub const fn contains(self, index: u32) -> bool {
        self.start <= index && index < self.end
    }

    /// The columns of both.
    #[must_use]
    pub fn overlap(self, other: Self) -> Self {
        let (start, end) = (self.start.max(other.start), self.end.min(other.end));
        if start < end { Self { start, end } } else { Self::EMPTY }
    }
}
