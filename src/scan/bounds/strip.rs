//! The columns of a row, and the rows of a picture, in which a solid can be seen along parallel
//! rays: where lengths that are affine in the pixel stay between bounds.
//!
//! Seen along parallel rays, a bounded solid lies in a strip of the picture for each of its
//! measures, and a row cuts a piece out of each strip.

use crate::geom::{Affine, Extent, signed};
use crate::scalar::{Number, Real, Scalar};
use crate::scan::Empty;

/// Pixels next to each other, by their half pixels from the middle of the picture: none, if the last
/// one is before the first.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Steps {
    first: i32,
    last: i32,
}

/// By so much quotients may be off: see [`Real::ratio`].
const MARGIN: i32 = 3;

impl Steps {
    pub(crate) const NONE: Self = Self { first: i32::MAX, last: i32::MIN };
    pub(crate) const ALL: Self = Self { first: i32::MIN, last: i32::MAX };

    /// Where `low ≤ length ≤ high` may hold, if the length of a pixel and both bounds are known as
    /// well as rounding errors of lengths up to `size` allow.
    #[inline(never)] // once or twice a row is seldom
    pub(crate) fn between<S: Scalar>(
        length: Affine<S::Wide>,
        low: S::Wide,
        high: S::Wide,
        size: S::Wide,
    ) -> Self {
        let error = S::uncertainty(size);
        let (low, high) = (low - error - length.middle, high + error - length.middle);
        // Not so if either is infinite or NaN, nor if they are too far apart.
        if !(high - low).is_finite() {
            return Self::ALL;
        }
        if length.step == S::Wide::ZERO {
            let is_between = low <= S::Wide::ZERO && S::Wide::ZERO <= high;
            return if is_between { Self::ALL } else { Self::NONE };
        }
        let [mut first, mut last] = [low, high].map(|way| way.ratio(length.step));
        if length.step < S::Wide::ZERO {
            (first, last) = (last, first);
        }
        Self::from_to(first, last)
    }

    /// Where `length ≤ 0` may hold; `size` as for [`between`](Self::between).
    pub(crate) fn below<S: Scalar>(length: Affine<S::Wide>, size: S::Wide) -> Self {
        // The length at −count steps or at +count steps is the lowest there is: beyond it nothing is.
        let most = S::Wide::from_int(i32::from(i16::MAX));
        let lowest = -(length.middle.abs() + (length.step * most).abs() + size);
        Self::between::<S>(length, lowest, S::Wide::ZERO, size)
    }

    /// Where `|length| ≤ reach` may hold.
    #[inline]
    pub(crate) fn within<S: Scalar>(length: Affine<S::Wide>, reach: S::Wide) -> Self {
        Self::between::<S>(length, -reach, reach, reach + length.middle.abs())
    }

    /// From one pixel to another, each by a quotient.
    pub(crate) fn from_to(first: i32, last: i32) -> Self {
        Self { first: first.saturating_sub(MARGIN), last: last.saturating_add(MARGIN) }
    }

    /// Where a length isn't negative, of which every bit counts.
    pub(crate) fn not_below<T: Real>(length: Affine<T>) -> Self {
        let Affine { middle, step } = length;
        if step == T::ZERO {
            return if middle < T::ZERO { Self::NONE } else { Self::ALL };
        }
        let at = (-middle).ratio(step);
        if step > T::ZERO {
            Self { first: at.saturating_sub(MARGIN), ..Self::ALL }
        } else {
            Self { last: at.saturating_add(MARGIN), ..Self::ALL }
        }
    }

    /// What is in both.
    #[inline]
    pub(crate) fn overlap(self, other: Self) -> Self {
        Self { first: self.first.max(other.first), last: self.last.min(other.last) }
    }

    /// Those of so many columns.
    #[inline]
    pub(crate) fn columns(self, columns: u32) -> Extent {
        // The centre of column c is at 2c + 1 − columns.
        let count = signed(columns);
        let start = (self.first.clamp(-count, count) + count) >> 1;
        let end = (self.last.clamp(-count - 1, count - 1) + count + 1) >> 1;
        if start < end { Extent { start: start as u32, end: end as u32 } } else { Extent::EMPTY }
    }

    /// Whether none of so many columns is among them.
    #[inline]
    pub(crate) fn are_beside(self, columns: u32) -> bool {
        let count = signed(columns);
        self.first.max(-count) > self.last.min(count)
    }
}

/// The rows in which a solid can be seen.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rows {
    /// In pixels from the middle of the picture, rounded down.
    first: i16,
    last: i16,
}

impl Rows {
    pub(crate) const ALL: Self = Self { first: i16::MIN, last: i16::MAX };

    /// The same, counted in half pixels.
    pub(crate) fn of(Steps { first, last }: Steps) -> Self {
        let pixels =
            |half_pixels: i32| (half_pixels >> 1).clamp(i16::MIN.into(), i16::MAX.into()) as i16;
        Self { first: pixels(first), last: pixels(last) }
    }

    /// Whether any row from the first to the last of two is among them, in half pixels below the middle.
    #[inline]
    pub(crate) fn meet(self, rows: [i32; 2]) -> bool {
        let [first, last] = rows.map(|y| y >> 1);
        // Both together: one branch is predicted more often than two.
        (i32::from(self.first) <= last) & (first <= i32::from(self.last))
    }
}

impl Empty for Rows {
    const EMPTY: Self = Self { first: 0, last: 0 };
}
