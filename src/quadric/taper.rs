//! The wall of a cone or of its frustum.

use super::planes::Planes;
use crate::geom::{Direction, Vec3};
use crate::scalar::{ConstOps, Number, Scalar, per_scalar};

/// All points within a radius of a line through `base`, where the radius changes evenly from the plane
/// of one cap to that of the other. The line's direction, the axis, is the normal of these planes.
///
/// There is no apex in it, so both radii may be the same.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Taper<S: Scalar> {
    pub(crate) base: Vec3<S>,
    /// At the low cap and at the high one.
    pub(crate) radii: [S; 2],
    /// The way along the wall, of length 1: its part along the axis, and its part outwards.
    pub(crate) slant: [S::Unit; 2],
}

/// A ray in a cone's own frame, from `from` to `from + step` at t = 1: two coordinates across the axis,
/// times the slant's part along it, and what the distance from the axis may be, times the same. The ray is
/// inside where the third is larger than the length of the first two.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Conic<S: Scalar> {
    pub(crate) from: [S; 3],
    pub(crate) step: [S::Unit; 3],
}

per_scalar! { $S: impl[] Taper<$S> {
    /// As [`between`](Self::between), for constants.
    pub(crate) const fn from_caps(
        base: Vec3<$S>, [low, high]: [$S; 2], caps: &Planes<$S>,
    ) -> Option<Self> {
        type Ops<S> = ConstOps<S>;
        let way = [Ops::<$S>::difference(caps.high, caps.low), Ops::<$S>::difference(high, low)];
        match Ops::<$S>::normalized([way[0], way[1], Ops::<$S>::ZERO]) {
            Some([along, outward, _]) => {
                Some(Self { base, radii: [low, high], slant: [along, outward] })
            }
            None => None,
        }
    }
} }

impl<S: Scalar> Taper<S> {
    /// The wall with a radius at the low cap and one at the high cap; `None` if the caps and the radii
    /// coincide.
    pub(crate) fn between(base: Vec3<S>, radii: [S; 2], caps: &Planes<S>) -> Option<Self> {
        let [low, high] = radii;
        let [along, outward, _] =
            S::normalized([caps.high.minus(caps.low), high.minus(low), S::ZERO])?;
        Some(Self { base, radii, slant: [along, outward] })
    }

    /// The larger radius.
    pub(crate) fn widest(&self) -> S::Wide {
        let [low, high] = self.radii;
        low.max(high).wide()
    }

    /// The radius at an offset along the axis.
    fn radius_at(&self, caps: &Planes<S>, height: S) -> S {
        let [low, high] = self.radii.map(S::wide);
        let [first, last, at] = [caps.low, caps.high, height].map(S::wide);
        S::from_wide(low + (high - low) * ((at - first) / (last - first)))
    }

    /// The parts of the way from `base` to a point: along the axis, and across it.
    fn parts(&self, axis: &Direction<S>, point: Vec3<S>) -> (S, Vec3<S>) {
        let way = point - self.base;
        let along = axis.dot(way);
        (along, way - axis.times(along))
    }

    /// The point of the wall, between the caps, nearest to a point beside it.
    pub(crate) fn onto(&self, caps: &Planes<S>, near: Vec3<S>) -> Vec3<S> {
        let (axis, [cosine, sine]) = (&caps.normal, self.slant);
        let (along, across) = self.parts(axis, near);
        let height = axis.dot(near);
        let beyond = S::length(across.to_array()).minus(self.radius_at(caps, height));
        let shift = beyond.times_unit(cosine).times_unit(sine);
        let on_wall = height.plus(shift).max(caps.low).min(caps.high);
        let outward = S::with_length(across.to_array(), self.radius_at(caps, on_wall));
        let along = axis.times(along.plus(on_wall.minus(height)));
        self.base + (along + Vec3::from(outward))
    }

    /// The outward normal at a point of the wall. At the tip, it points along the axis.
    #[inline(always)]
    pub(crate) fn normal(&self, axis: &Direction<S>, at: Vec3<S>) -> Vec3<S> {
        let [cosine, sine] = self.slant;
        let (_, across) = self.parts(axis, at);
        let length = S::length(across.to_array());
        if length <= S::ZERO {
            return axis.times(if sine > S::Unit::ZERO { S::ONE.negated() } else { S::ONE });
        }
        let curvature = length.inverse();
        let outward = across.map(|part| part.scaled(curvature).times_unit(cosine));
        outward - axis.times(S::ONE.times_unit(sine))
    }
}
