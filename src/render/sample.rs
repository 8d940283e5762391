//! What a pixel sees.

use crate::geom::{Line, RayRow, Rays, Vec3};
use crate::scalar::{Number, Scalar};
use crate::scan::Scan;
use crate::solid::{Seen, Solid};
use crate::span::Face;
use crate::span::walk::{Hot, Step};

/// What a pixel sees: the input of a [`Shader`](super::Shader).
pub struct Sample<'a, T: Scan<R>, R: Rays> {
    pub(super) solid: &'a T,
    pub(super) view: &'a T::View,
    pub(super) row: &'a mut T::Row,
    pub(super) camera: &'a R,
    pub(super) rays: &'a R::Row,
    pub(super) x: i32,
    /// The surface that is seen.
    pub seen: Seen<T::Scalar>,
}

impl<T, R> Sample<'_, T, R>
where
    R: Rays,
    T: Solid<Scalar = R::Scalar> + Scan<R>,
{
    /// The pixel's ray; its direction has length 1 only for orthographic cameras.
    #[must_use]
    pub fn line(&self) -> Line<R::Scalar> {
        self.rays.line(self.x)
    }

    /// The normal of length 1 on the side of the surface that is seen.
    #[must_use]
    pub fn normal(&self) -> Vec3<R::Scalar> {
        let outward = self.solid.normal(self.seen.face, self.line().at(self.seen.t));
        if self.seen.inside { -outward } else { outward }
    }

    /// The scalar product of the normal on the side that is seen and another vector: of length 1,
    /// the cosine of the angle between them. As [`Solid::cosine`].
    #[must_use]
    #[inline]
    pub fn cosine(&self, to: Vec3<R::Scalar>) -> R::Scalar {
        let outward = self.solid.cosine(self.seen.face, || self.line().at(self.seen.t), to);
        if self.seen.inside { outward.negated() } else { outward }
    }

    /// The length of the ray inside the solid, in scene units.
    #[must_use]
    pub fn path_length(&mut self) -> R::Scalar {
        let Seen { mut t, inside, .. } = self.seen;
        let mut sum = if inside { t.minus(self.camera.start()) } else { R::Scalar::ZERO };
        while t < R::Scalar::HIGHEST {
            let Step { inside, next } =
                self.solid.step::<Hot>(self.view, self.row, self.x, t, Face(0));
            if inside {
                sum = sum.plus(next.t.minus(t));
            }
            t = next.t;
        }
        sum.times(R::Scalar::length(self.line().direction.to_array()))
    }
}
