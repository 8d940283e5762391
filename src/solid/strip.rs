//! The columns of a row, and the rows of a picture, in which a solid can be seen along parallel
//! rays: where lengths that are affine in the pixel stay between bounds.
//!
//! Seen along parallel rays, a bounded solid lies in a strip of the picture for each of its
//! measures, and a row cuts a piece out of each strip.

use crate::geom::{Affine, Extent};
use crate::scalar::{Number, Real, Scalar};
use crate::solid::row::Blank;

/// The columns in which `low ≤ length ≤ high` may hold, where the length of a pixel and both bounds
/// are known as well as rounding errors of lengths up to `size` allow.
pub(super) fn columns_between<S: Scalar>(
    length: Affine<S::Fine>,
    [low, high]: [S::Fine; 2],
    size: S::Fine,
    columns: u32,
) -> Extent {
    match steps_between::<S>(length, [low, high], size) {
        Some([first, last]) => {
            // The centre of column c is at 2c + 1 − columns.
            let count = columns as i32;
            let start = (first.saturating_add(count) >> 1).clamp(0, count);
            let end = (last.saturating_add(count + 1) >> 1).clamp(0, count);
            if start < end {
                Extent { start: start as u32, end: end as u32 }
            } else {
                Extent::EMPTY
            }
        }
        None => Extent::EMPTY,
    }
}

/// The columns in which `|length| ≤ reach` may hold.
pub(super) fn columns_within<S: Scalar>(
    length: Affine<S::Fine>,
    reach: S::Fine,
    columns: u32,
) -> Extent {
    let size = reach + length.middle.abs();
    columns_between::<S>(length, [-reach, reach], size, columns)
}

/// The first and the last count of steps with which `low ≤ length ≤ high` may hold, or `None` if
/// there is none.
#[inline(never)] // once or twice a row is seldom
fn steps_between<S: Scalar>(
    length: Affine<S::Fine>,
    [low, high]: [S::Fine; 2],
    size: S::Fine,
) -> Option<[i32; 2]> {
    /// By so much quotients may be off: see [`Real::ratio`].
    const MARGIN: i32 = 3;
    let error = S::uncertainty(size);
    let (low, high) = (low - error - length.middle, high + error - length.middle);
    if !(low.is_finite() && high.is_finite()) {
        return Some([i32::MIN, i32::MAX]);
    }
    if length.step == S::Fine::ZERO {
        let is_between = low <= S::Fine::ZERO && S::Fine::ZERO <= high;
        return is_between.then_some([i32::MIN, i32::MAX]);
    }
    let [mut first, mut last] = [low, high].map(|way| way.ratio(length.step));
    if length.step < S::Fine::ZERO {
        (first, last) = (last, first);
    }
    let (first, last) = (first.saturating_sub(MARGIN), last.saturating_add(MARGIN));
    (first <= last).then_some([first, last])
}

/// The rows in which a solid can be seen.
#[derive(Debug, Clone, Copy)]
pub struct Rows {
    /// In pixels from the middle of the picture, rounded down.
    first: i16,
    last: i16,
}

impl Rows {
    pub(super) const ALL: Self = Self { first: i16::MIN, last: i16::MAX };

    /// The rows in which `low ≤ length ≤ high` may hold, as in [`columns_between`].
    pub(super) fn between<S: Scalar>(
        length: Affine<S::Fine>,
        bounds: [S::Fine; 2],
        size: S::Fine,
    ) -> Self {
        let pixels =
            |half_pixels: i32| (half_pixels >> 1).clamp(i16::MIN.into(), i16::MAX.into()) as i16;
        match steps_between::<S>(length, bounds, size) {
            Some([first, last]) => Self { first: pixels(first), last: pixels(last) },
            None => Self { first: 0, last: -1 },
        }
    }

    /// Whether the row `y` half pixels below the middle is among them.
    pub(super) fn contains(self, y: i32) -> bool {
        (i32::from(self.first)..=i32::from(self.last)).contains(&(y >> 1))
    }
}

impl Blank for Rows {
    const BLANK: Self = Self { first: 0, last: 0 };
}
