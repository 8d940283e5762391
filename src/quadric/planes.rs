//! Two parallel planes.

use crate::geom::{Direction, Vec3};
use crate::scalar::{Number, Roots, Scalar};
use crate::span::{Crossing, Face, Span};

/// The points p with `low ≤ normal · p ≤ high`.
///
/// The offsets are stored as they were given, so planes with the same numbers cross every line at
/// the same bits. Face 0 is the plane at `low`, face 1 the one at `high`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Planes<S: Scalar> {
    pub(crate) normal: Direction<S>,
    pub(crate) low: S,
    pub(crate) high: S,
}

/// Where a line is between two planes, and which plane comes first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PlaneRoots<S> {
    /// The parameters of the low plane and of the high one, in this order.
    pub(crate) roots: Roots<S>,
    /// Whether the line meets the low plane before the high one.
    pub(crate) upwards: bool,
}

impl<S: Scalar> PlaneRoots<S> {
    /// A line along the planes.
    #[inline]
    pub(crate) fn along(inside: bool) -> Self {
        Self { roots: if inside { Roots::Everywhere } else { Roots::Outside }, upwards: true }
    }

    /// A line that crosses the low plane and the high one at these parameters.
    #[inline]
    pub(crate) fn across([low, high]: [S; 2], upwards: bool) -> Self {
        Self { roots: Roots::Between(low, high), upwards }
    }

    /// The planes in the order in which the line meets them.
    #[inline]
    pub(crate) fn faces(&self) -> [Face; 2] {
        let near = u16::from(!self.upwards);
        [Face(near), Face(1 - near)]
    }

    /// The part of the line between the planes.
    #[inline]
    pub(crate) fn span(&self) -> Option<Span<S>> {
        self.ends()?.checked()
    }

    /// The part of the line between the planes, also if rounding leaves it no length.
    #[inline]
    pub(crate) fn ends(&self) -> Option<Span<S>> {
        match self.roots {
            Roots::Outside => None,
            Roots::Everywhere => Some(Span::whole_line(Face(0))),
            Roots::Between(low, high) => {
                let (near, far) = if self.upwards { (low, high) } else { (high, low) };
                let [first, last] = self.faces();
                let enter = Crossing { t: near, face: first };
                Some(Span { enter, exit: Crossing { t: far, face: last } })
            }
        }
    }
}

impl<S: Scalar> Planes<S> {
    /// Where a line with `normal · p(t) = at_zero + t·speed` crosses the planes.
    #[inline]
    pub(crate) fn crossed(&self, at_zero: S::Wide, speed: S::Wide) -> PlaneRoots<S> {
        self.crossed_above([self.low, self.high].map(|offset| offset.wide() - at_zero), speed)
    }

    /// Where a line crosses the planes that are so far above it at t = 0.
    #[inline]
    pub(crate) fn crossed_above(&self, heights: [S::Wide; 2], speed: S::Wide) -> PlaneRoots<S> {
        if speed == S::Wide::ZERO {
            let [low, high] = heights;
            return PlaneRoots::along(self.has_between(low, high, S::Wide::ZERO));
        }
        PlaneRoots::across(S::quotients(heights, speed), speed > S::Wide::ZERO)
    }

    /// Whether a line along the planes is between them, by how far they are above it.
    ///
    /// One of the two planes belongs to the solid: the lower one as seen along the first coordinate
    /// axis that isn't parallel to them. So of two slabs on either side of a plane exactly one has
    /// it, whichever way their normals point.
    pub(crate) fn has_between<T: PartialOrd>(&self, low: T, high: T, zero: T) -> bool {
        if is_forward(&self.normal) {
            low <= zero && zero < high
        } else {
            low < zero && zero <= high
        }
    }

    /// The point of a face nearest to a point beside it.
    pub(crate) fn onto_face(&self, face: Face, near: Vec3<S>) -> Vec3<S> {
        let offset = if face.0 == 0 { self.low } else { self.high };
        self.normal.onto_plane(offset, near)
    }

    /// The point itself if it is between the planes, or else the nearest one that is.
    pub(crate) fn clamped(&self, point: Vec3<S>) -> Vec3<S> {
        let height = self.normal.dot(point);
        match () {
            () if height < self.low => self.onto_face(Face(0), point),
            () if height > self.high => self.onto_face(Face(1), point),
            () => point,
        }
    }

    /// The scalar product of a face's normal and a vector.
    #[inline]
    pub(crate) fn face_cosine(&self, face: Face, to: Vec3<S>) -> S {
        let cosine = self.normal.times(S::ONE).dot(to);
        if face.0 == 0 { cosine.negated() } else { cosine }
    }

    /// The normal of a face, which points outwards.
    pub(crate) fn face_normal(&self, face: Face) -> Vec3<S> {
        let normal = self.normal.times(S::ONE);
        if face.0 == 0 { -normal } else { normal }
    }
}

/// Whether a normal points along the first coordinate axis that isn't parallel to its plane, not
/// against it.
pub(super) fn is_forward<S: Scalar>(normal: &Direction<S>) -> bool {
    let mut coordinates = normal.vector().to_array().into_iter();
    coordinates
        .find(|coordinate| *coordinate != S::Unit::ZERO)
        .is_some_and(|coordinate| coordinate > S::Unit::ZERO)
}
