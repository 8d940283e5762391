//! The faces of a convex solid along parallel rays: where rays enter and exit.
//!
//! Rays enter at the same faces and exit at the same faces all over the picture. How far an entered face
//! lies before an exited one is affine in the column, which gives the exact silhouette.
//!
//! Crossings are slices, so that a solid's own array and a pool of several solids' faces share the code.

use crate::geom::{Affine, signed};
use crate::scalar::{Number, Real, Scalar};
use crate::scan::Empty;
use crate::scan::bounds::Steps;
use crate::span::{Crossing, Face, Span};

/// Where a face is crossed, in the middle of the row, and what half a column adds to that.
#[derive(Debug, Clone, Copy)]
pub struct End<S: Scalar> {
    pub(super) at: Affine<S::Wide>,
    face: Face,
}

impl<S: Scalar> Empty for End<S> {
    const EMPTY: Self =
        Self { at: Affine { middle: S::Wide::ZERO, step: S::Wide::ZERO }, face: Face(0) };
}

/// How many of a row's crossings are there: those where rays enter are the first of the slice, those where they
/// exit the last.
#[derive(Debug, Clone, Copy)]
pub struct Crossed {
    entering: u16,
    exiting: u16,
}

impl Crossed {
    /// No face is crossed.
    pub(crate) const NONE: Self = Self { entering: 0, exiting: 0 };

    /// Adds a face.
    pub(crate) fn put<S: Scalar>(
        &mut self,
        ends: &mut [End<S>],
        at: Affine<S::Wide>,
        face: Face,
        exits: bool,
    ) {
        let place = if exits {
            self.exiting += 1;
            ends.len().saturating_sub(self.exiting.into())
        } else {
            self.entering += 1;
            usize::from(self.entering) - 1
        };
        if let Some(end) = ends.get_mut(place) {
            *end = End { at, face };
        }
    }

    /// The faces that rays enter at, and those that they exit at.
    #[inline(always)]
    fn of<S: Scalar>(self, ends: &[End<S>]) -> [&[End<S>]; 2] {
        let (entering, exiting) = (usize::from(self.entering), usize::from(self.exiting));
        [
            ends.get(..entering).unwrap_or_default(),
            ends.get(ends.len().saturating_sub(exiting)..).unwrap_or_default(),
        ]
    }

    /// Where rays can be behind every face that they enter at, and before every one that they exit at.
    pub(crate) fn steps<S: Scalar>(self, ends: &[End<S>], columns: u32) -> Steps {
        let way = |step| S::Wide::ZERO.after_steps(step, signed(columns)).abs();
        let [entering, exiting] = self.of(ends);
        let mut steps = Steps::ALL;
        for End { at: enter, .. } in entering {
            for End { at: exit, .. } in exiting {
                let apart =
                    Affine { middle: enter.middle - exit.middle, step: enter.step - exit.step };
                let size =
                    enter.middle.abs() + exit.middle.abs() + way(enter.step) + way(exit.step);
                steps = steps.overlap(Steps::below::<S>(apart, size));
            }
        }
        steps
    }

    /// From the latest entry to the earliest exit, also if that is earlier.
    #[inline]
    pub(crate) fn between<S: Scalar>(self, ends: &[End<S>], x: i32) -> Span<S> {
        let [entering, exiting] = self.of(ends);
        let crossing = |end: &End<S>| Crossing { t: S::from_wide(end.at.at(x)), face: end.face };
        let mut common = Span::whole_line(Face(0));
        for end in entering {
            common.cut(crossing(end), false);
        }
        for end in exiting {
            common.cut(crossing(end), true);
        }
        common
    }
}
