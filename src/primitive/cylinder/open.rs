//! The open cylinder: a wall without caps.

use super::Cylinder;
use crate::geom::{Ray, Vec3};
use crate::quadric::meet;
use crate::query::seen_at;
use crate::scalar::Scalar;

/// The wall of a cylinder, without caps: a surface, not a solid, so it can't be combined.
///
/// It has the same extent as the [`Cylinder`] that it is made from.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CylinderWall<S: Scalar> {
    cylinder: Cylinder<S>,
}

/// Where a ray meets the wall first.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct WallHit<S> {
    /// The ray's parameter, ≥ 0.
    pub t: S,
    /// Where.
    pub point: Vec3<S>,
    /// The normal of length 1 of the face that is seen: (0, y, z)/r in the cylinder's own frame,
    /// and (0, −y, −z)/r where the inner face is seen.
    pub normal: Vec3<S>,
    /// Whether the inner face is seen.
    pub inner: bool,
}

impl<S: Scalar> CylinderWall<S> {
    /// The wall of a cylinder.
    #[must_use]
    pub const fn of(cylinder: &Cylinder<S>) -> Self {
        Self { cylinder: *cylinder }
    }

    /// The first point of the wall at t ≥ 0.
    ///
    /// Of the two points where the line meets the infinite cylinder, the first one counts that
    /// lies on the ray and between the ends. So a ray that runs through the tube without touching
    /// the wall meets nothing, one that looks in at an end sees the inner face, and so does one
    /// that starts inside. A tangent ray touches the outer face. The rim belongs to the wall.
    #[must_use]
    pub fn hit(&self, ray: &Ray<S>) -> Option<WallHit<S>> {
        let cylinder = &self.cylinder;
        let meet = |ray: &Ray<S>| meet::open_cylinder(&cylinder.wall, &cylinder.caps, ray.line());
        let points = meet(ray);
        let is_near = |t: Option<S>| t.is_some_and(|t| ray.is_near_start(t));
        let has_near = ray.is_moved() && points.into_iter().any(is_near);
        let own = ray.from_start();
        let [enter, exit] = if has_near { meet(&own) } else { points };
        let counted = |point, from_start| {
            if has_near && is_near(point) { (&own, from_start) } else { (ray, point) }
        };
        let [first, last] = points;
        [(counted(first, enter), false), (counted(last, exit), true)]
            .into_iter()
            .filter_map(|((ray, t), inner)| Some((ray, t?, inner)))
            .find(|&(ray, t, _)| t >= ray.start())
            .map(|(ray, t, inner)| self.seen(ray, t, inner))
    }

    fn seen(&self, ray: &Ray<S>, t: S, inner: bool) -> WallHit<S> {
        let Cylinder { wall, caps } = &self.cylinder;
        let [point, normal] = seen_at(ray.line(), t, inner, |near| {
            let point = caps.clamped(wall.onto(&caps.normal, near));
            [point, wall.normal(&caps.normal, point, |normal| normal)]
        });
        WallHit { t: ray.parameter(t), point, normal, inner }
    }
}
