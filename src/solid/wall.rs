//! The open cylinder: a wall without caps.

use super::cylinder::Cylinder;
use super::hit::seen_at;
use super::intersect::Intersect;
use crate::geom::{Ray, Vec3};
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

impl<S: Intersect> CylinderWall<S> {
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
        let points = S::meet_wall(&self.cylinder, ray.line());
        let is_near = |t: &Option<S>| t.is_some_and(|t| ray.is_near_start(t));
        if ray.is_moved() && points.iter().any(is_near) {
            let ray = ray.from_start();
            return self.seen(&ray, S::meet_wall(&self.cylinder, ray.line()));
        }
        self.seen(ray, points)
    }

    /// What the ray sees of where its line enters and exits.
    fn seen(&self, ray: &Ray<S>, [enter, exit]: [Option<S>; 2]) -> Option<WallHit<S>> {
        let Cylinder { tube, caps } = &self.cylinder;
        let (t, inner) = [(enter, false), (exit, true)]
            .into_iter()
            .filter_map(|(t, inner)| Some((t?, inner)))
            .find(|&(t, _)| t >= ray.start())?;
        let [point, normal] = seen_at(ray.line(), t, inner, |near| {
            let point = tube.onto(&caps.normal, near);
            [point, tube.normal(&caps.normal, point, |normal| normal)]
        });
        Some(WallHit { t: ray.parameter(t), point, normal, inner })
    }
}
