//! The faces of a convex solid along parallel rays: where rays enter and exit.
//!
//! Rays enter at the same faces and exit at the same faces all over the picture. How far an entered face
//! lies before an exited one is affine in the column, which gives the exact silhouette.

use crate::geom::{Affine, signed};
use crate::scalar::{Number, Real, Scalar};
use crate::scan::Empty;
use crate::scan::bounds::Steps;
use crate::span::{Crossing, Face, Span};

/// Where a row of parallel rays crosses up to `N` faces: those that rays enter at are the first, those that
/// they exit at the last.
#[derive(Debug, Clone, Copy)]
pub struct Crossings<S: Scalar, const N: usize> {
    ends: [End<S>; N],
    entering: u16,
    exiting: u16,
}

/// Where a face is crossed, in the middle of the row, and what half a column adds to that.
#[derive(Debug, Clone, Copy)]
struct End<S: Scalar> {
    at: Affine<S::Wide>,
    face: Face,
}

impl<S: Scalar, const N: usize> Empty for Crossings<S, N> {
    const EMPTY: Self = {
        let at = Affine { middle: S::Wide::ZERO, step: S::Wide::ZERO };
        Self { ends: [End { at, face: Face(0) }; N], entering: 0, exiting: 0 }
    };
}

impl<S: Scalar, const N: usize> Crossings<S, N> {
    /// Forgets all faces.
    pub(crate) fn clear(&mut self) {
        (self.entering, self.exiting) = (0, 0);
    }

    /// Adds a face.
    pub(crate) fn put(&mut self, at: Affine<S::Wide>, face: Face, exits: bool) {
        let place = if exits {
            self.exiting += 1;
            N.saturating_sub(self.exiting.into())
        } else {
            self.entering += 1;
            usize::from(self.entering) - 1
        };
        if let Some(end) = self.ends.get_mut(place) {
            *end = End { at, face };
        }
    }

    /// The faces that rays enter at, and those that they exit at.
    #[inline(always)]
    fn ends(&self) -> [&[End<S>]; 2] {
        let (entering, exiting) = (usize::from(self.entering), usize::from(self.exiting));
        [
            self.ends.get(..entering).unwrap_or_default(),
            self.ends.get(N.saturating_sub(exiting)..).unwrap_or_default(),
        ]
    }

    /// Where rays can be behind every face that they enter at, and before every one that they exit at.
    pub(crate) fn steps(&self, columns: u32) -> Steps {
        let way = |step| S::Wide::ZERO.after_steps(step, signed(columns)).abs();
        let [entering, exiting] = self.ends();
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
    pub(crate) fn between(&self, x: i32) -> Span<S> {
        let [entering, exiting] = self.ends();
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
