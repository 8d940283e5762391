//! Spans: the pieces of a line inside a solid, and the crossings between them.

use crate::scalar::Scalar;

/// The number of a face among all faces of a solid, counted from its first primitive on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Face(pub u16);

impl Face {
    /// The face `by` places further on.
    #[must_use]
    #[inline]
    pub const fn offset(self, by: u16) -> Self {
        Self(self.0.wrapping_add(by))
    }
}

/// Where a line passes through the surface of a solid.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Crossing<S> {
    /// The parameter on the line. The lowest and highest values of the type mean that the solid
    /// goes on for ever: no surface is there.
    pub t: S,
    /// The face that is crossed.
    pub face: Face,
}

impl<S: Scalar> Crossing<S> {
    /// No crossing.
    pub(crate) const NEVER: Self = Self { t: S::HIGHEST, face: Face(0) };
}

/// A piece of a line inside a solid.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Span<S> {
    /// Where the line enters.
    pub enter: Crossing<S>,
    /// Where it exits; at a larger parameter.
    pub exit: Crossing<S>,
}

impl<S: Scalar> Span<S> {
    /// The span between two crossings, or `None` if no length is left, or a parameter is NaN.
    #[must_use]
    #[inline]
    pub fn new(enter: Crossing<S>, exit: Crossing<S>) -> Option<Self> {
        (enter.t < exit.t).then_some(Self { enter, exit })
    }

    /// The span, if its crossings are in order.
    #[inline]
    pub(crate) fn checked(self) -> Option<Self> {
        Self::new(self.enter, self.exit)
    }

    /// Memory for a span.
    pub(crate) const ZEROS: Self = {
        let crossing = Crossing { t: S::ZERO, face: Face(0) };
        Self { enter: crossing, exit: crossing }
    };

    /// No piece of a line.
    pub(crate) const NOWHERE: Self = Self { enter: Crossing::NEVER, exit: Crossing::NEVER };

    /// Whether the span contains what is just behind `t`.
    #[inline]
    pub(crate) fn contains(&self, t: S) -> bool {
        self.enter.t <= t && t < self.exit.t
    }

    /// The whole line, which touches `face` nowhere.
    #[must_use]
    pub fn whole_line(face: Face) -> Self {
        Self { enter: Crossing { t: S::LOWEST, face }, exit: Crossing { t: S::HIGHEST, face } }
    }

    /// What two spans share. Where both begin or end together, the face is that of `self`.
    #[must_use]
    #[inline]
    pub fn overlap(self, other: Self) -> Option<Self> {
        let (enter, exit) = self.common_ends(other);
        Self::new(enter, exit)
    }

    /// The later beginning and the earlier end of two spans.
    #[inline]
    pub(crate) fn common_ends(self, other: Self) -> (Crossing<S>, Crossing<S>) {
        let enter = if other.enter.t > self.enter.t { other.enter } else { self.enter };
        let exit = if other.exit.t < self.exit.t { other.exit } else { self.exit };
        (enter, exit)
    }

    /// Cuts off what is beyond a crossing: what comes later if the line exits there, or else what comes
    /// earlier.
    #[inline(always)]
    pub(crate) fn cut(&mut self, at: Crossing<S>, exits: bool) {
        if exits {
            if at.t < self.exit.t {
                self.exit = at;
            }
        } else if at.t > self.enter.t {
            self.enter = at;
        }
    }

    /// The same span with its faces counted from `first` on.
    #[must_use]
    #[inline]
    pub(crate) fn with_faces_from(self, first: Face) -> Self {
        let renumber =
            |crossing: Crossing<S>| Crossing { face: first.offset(crossing.face.0), ..crossing };
        Self { enter: renumber(self.enter), exit: renumber(self.exit) }
    }
}
