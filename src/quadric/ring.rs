//! The solid torus.

use crate::geom::{Direction, Vec3};
use crate::scalar::Scalar;
use crate::span::{Crossing, Face, Span};

/// All points within `tube` of a circle of `radius` around `center`, in the plane across `axis`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ring<S: Scalar> {
    pub(crate) center: Vec3<S>,
    pub(crate) axis: Direction<S>,
    pub(crate) radius: S,
    pub(crate) tube: S,
}

impl<S: Scalar> Ring<S> {
    /// A point as seen from the centre; and the way to it from the nearest point of the circle.
    fn way(&self, point: Vec3<S>) -> [Vec3<S>; 2] {
        let from_center = point - self.center;
        let across = from_center - self.axis.times(self.axis.dot(from_center));
        let nearest = Vec3::from(S::with_length(across.to_array(), self.radius));
        [nearest, from_center - nearest]
    }

    /// The point of the surface nearest to a point beside it.
    pub(crate) fn onto(&self, near: Vec3<S>) -> Vec3<S> {
        let [nearest, way] = self.way(near);
        self.center + (nearest + Vec3::from(S::with_length(way.to_array(), self.tube)))
    }

    /// The outward normal at a point of the surface.
    pub(crate) fn normal(&self, at: Vec3<S>) -> Vec3<S> {
        let [_, way] = self.way(at);
        Vec3::from(S::with_length(way.to_array(), S::ONE))
    }
}

/// The spans between parameters in ascending order: each with a length, and with a gap between them.
pub(crate) fn regular<S: Scalar>(chords: [Option<[S; 2]>; 2]) -> [Option<Span<S>>; 2] {
    let span = |[enter, exit]: [S; 2]| {
        let [enter, exit] = [enter, exit].map(|t| Crossing { t, face: Face(0) });
        Span::new(enter, exit)
    };
    match chords {
        [Some([enter, one]), Some([other, exit])] if one >= other => [span([enter, exit]), None],
        chords => chords.map(|chord| chord.and_then(span)),
    }
}
