//! The slab: what lies between two parallel planes. Three slabs make a box.

mod parallel;
mod pencil;

pub(super) use parallel::{EdgeOn, Ends, OrthographicRow, OrthographicView, faces};
pub(super) use pencil::{PerspectiveRow, PerspectiveView};

use super::intersect::{Intersect, Passage};
use super::leaf::leaf;
use super::{Shape, Solid};
use crate::geom::{Direction, Line, Vec3};
use crate::scalar::{ConstOps, FixedI32, Fraction, Number, Scalar};
use crate::span::{Crossing, Face, Span, SpanStack};

/// The points p with `low ≤ normal · p ≤ high`.
///
/// The offsets are stored as they were given, so two slabs with a plane in common cross every
/// line at the same bits there.
///
/// Face 0 is the plane at `low`, face 1 the one at `high`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Slab<S: Scalar> {
    pub(super) normal: Direction<S>,
    pub(super) low: S,
    pub(super) high: S,
}

/// Why a slab can't be made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SlabError {
    /// A coordinate or an offset is infinite or NaN.
    NotFinite,
    /// The normal is zero.
    ZeroNormal,
    /// The low offset is not below the high one.
    Empty,
    /// An offset is larger than [`Scalar::MAX_COORDINATE`].
    TooFar,
}

crate::error_text!(SlabError {
    NotFinite => "a coordinate or an offset of the slab is infinite or not a number",
    ZeroNormal => "the normal of the slab is zero",
    Empty => "the low offset of the slab is not below the high one",
    TooFar => "the slab is too far away for its number type",
});

macro_rules! constructors {
    ($([$($generics:tt)*] $Scalar:ty),+) => {$(
        impl<$($generics)*> Slab<$Scalar> {
            /// The points with `low ≤ x ≤ high`.
            ///
            /// # Errors
            /// [`SlabError::NotFinite`], [`SlabError::Empty`], [`SlabError::TooFar`].
            pub const fn along_x(low: $Scalar, high: $Scalar) -> Result<Self, SlabError> {
                Self::between(Direction::<$Scalar>::X, low, high)
            }

            /// The points with `low ≤ y ≤ high`.
            ///
            /// # Errors
            /// As [`along_x`](Self::along_x).
            pub const fn along_y(low: $Scalar, high: $Scalar) -> Result<Self, SlabError> {
                Self::between(Direction::<$Scalar>::Y, low, high)
            }

            /// The points with `low ≤ z ≤ high`.
            ///
            /// # Errors
            /// As [`along_x`](Self::along_x).
            pub const fn along_z(low: $Scalar, high: $Scalar) -> Result<Self, SlabError> {
                Self::between(Direction::<$Scalar>::Z, low, high)
            }

            /// The points with `low ≤ n·p ≤ high`, where n is `normal` brought to length 1.
            ///
            /// That is computed in `f64` or in integers of 128 bits: better in a constant.
            ///
            /// # Errors
            /// As [`along_x`](Self::along_x), and [`SlabError::ZeroNormal`].
            pub const fn new(
                normal: Vec3<$Scalar>,
                low: $Scalar,
                high: $Scalar,
            ) -> Result<Self, SlabError> {
                if !normal.has_finite_coordinates() {
                    return Err(SlabError::NotFinite);
                }
                match ConstOps::<$Scalar>::normalized([normal.x, normal.y, normal.z]) {
                    Some(normal) => Self::between(Direction::<$Scalar>::new(normal), low, high),
                    None => Err(SlabError::ZeroNormal),
                }
            }

            /// The slab of a normal.
            pub(super) const fn between(
                normal: Direction<$Scalar>,
                low: $Scalar,
                high: $Scalar,
            ) -> Result<Self, SlabError> {
                if !(ConstOps::<$Scalar>::is_finite(low) && ConstOps::<$Scalar>::is_finite(high)) {
                    return Err(SlabError::NotFinite);
                }
                if !ConstOps::<$Scalar>::is_below(low, high) {
                    return Err(SlabError::Empty);
                }
                if !(ConstOps::<$Scalar>::is_within_reach(low) && ConstOps::<$Scalar>::is_within_reach(high)) {
                    return Err(SlabError::TooFar);
                }
                Ok(Self { normal, low, high })
            }
        }
    )+};
}

constructors!([] f32, [] f64, [F: Fraction] FixedI32<F>);

impl<S: Scalar> Slab<S> {
    /// Where a line with `normal · p(t) = at_zero + t·speed` passes the planes.
    #[inline]
    pub(super) fn passage(&self, at_zero: S::Wide, speed: S::Wide) -> Passage<S> {
        self.passed([self.low, self.high].map(|offset| offset.wide() - at_zero), speed)
    }

    /// Where a line passes the planes that are so far above it at t = 0.
    #[inline]
    pub(super) fn passed(&self, heights: [S::Wide; 2], speed: S::Wide) -> Passage<S> {
        if speed == S::Wide::ZERO {
            return Passage::Along { inside: self.holds(heights) };
        }
        Passage::Across { at: S::quotients(heights, speed), upwards: speed > S::Wide::ZERO }
    }

    /// Whether a line along the planes is inside.
    ///
    /// One of the two planes belongs to the slab: the lower one as seen along the first
    /// coordinate axis that isn't parallel to them. So of two slabs on either side of a plane,
    /// exactly one has it, whichever way their normals point.
    fn holds(&self, [low, high]: [S::Wide; 2]) -> bool {
        let zero = S::Wide::ZERO;
        self.has(low <= zero, low < zero) && self.has(zero < high, zero <= high)
    }

    /// What counts for a plane: the first answer if the lower one belongs to the slab, or else
    /// the second.
    pub(super) fn has<T>(&self, lower: T, upper: T) -> T {
        let is_forward = self
            .normal
            .vector()
            .to_array()
            .into_iter()
            .find(|coordinate| *coordinate != S::Unit::ZERO)
            .is_some_and(|coordinate| coordinate > S::Unit::ZERO);
        if is_forward { lower } else { upper }
    }

    /// The point of a face nearest to a point beside it.
    pub(super) fn onto_face(&self, face: Face, near: Vec3<S>) -> Vec3<S> {
        let offset = if face.0 == 0 { self.low } else { self.high };
        near + self.normal.times(offset.minus(self.normal.dot(near)))
    }

    /// The point itself if it is between the planes, or else the nearest one that is.
    pub(super) fn clamped(&self, point: Vec3<S>) -> Vec3<S> {
        let height = self.normal.dot(point);
        match () {
            () if height < self.low => self.onto_face(Face(0), point),
            () if height > self.high => self.onto_face(Face(1), point),
            () => point,
        }
    }

    #[inline]
    pub(super) fn face_cosine(&self, face: Face, to: Vec3<S>) -> S {
        let cosine = self.normal.times(S::ONE).dot(to);
        if face.0 == 0 { cosine.negated() } else { cosine }
    }

    pub(super) fn face_normal(&self, face: Face) -> Vec3<S> {
        let normal = self.normal.times(S::ONE);
        if face.0 == 0 { -normal } else { normal }
    }
}

impl<S: Scalar> Passage<S> {
    /// The part of the line between the planes.
    #[inline]
    pub(super) fn span(self) -> Option<Span<S>> {
        self.ends()?.checked()
    }

    /// Where the line is between the planes, also if rounding leaves that no length.
    #[inline]
    pub(super) fn ends(self) -> Option<Span<S>> {
        match self {
            Self::Along { inside } => inside.then_some(Span::whole_line(Face(0))),
            Self::Across { at: [low, high], upwards } => {
                let (near, far) = if upwards { (low, high) } else { (high, low) };
                let enter = Crossing { t: near, face: Face(u16::from(!upwards)) };
                let exit = Crossing { t: far, face: Face(u16::from(upwards)) };
                Some(Span { enter, exit })
            }
        }
    }
}

impl<S: Scalar> Shape for Slab<S> {
    type Scalar = S;
    const SPANS: usize = 1;
    const STACK: usize = 1;
    const FACES: u16 = 2;
}

impl<S: Intersect> Solid for Slab<S> {
    fn spans(&self, line: &Line<S>, first: Face, stack: &mut SpanStack<'_, S>) {
        if let Some(span) = S::pass(self, line).span() {
            stack.put(span.with_faces_from(first));
        }
    }

    fn onto(&self, face: Face, near: Vec3<S>) -> Vec3<S> {
        self.onto_face(face, near)
    }

    fn normal(&self, face: Face, _: Vec3<S>) -> Vec3<S> {
        self.face_normal(face)
    }

    fn cosine(&self, face: Face, _: impl FnOnce() -> Vec3<S>, to: Vec3<S>) -> S {
        self.face_cosine(face, to)
    }
}

leaf!([S: Scalar] Slab<S>);
