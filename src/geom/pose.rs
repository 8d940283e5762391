//! Rigid motions.

use super::{Line, Vec3};
use crate::scalar::Scalar;

/// A rotation followed by a translation: where a solid's own frame lies in the scene.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Pose<S> {
    /// The images of the three axes: an orthonormal, right-handed frame.
    axes: [Vec3<S>; 3],
    translation: Vec3<S>,
}

impl<S: Scalar> Pose<S> {
    /// The pose that moves nothing.
    pub const IDENTITY: Self = Self {
        axes: [
            Vec3::new(S::ONE, S::ZERO, S::ZERO),
            Vec3::new(S::ZERO, S::ONE, S::ZERO),
            Vec3::new(S::ZERO, S::ZERO, S::ONE),
        ],
        translation: Vec3::ZERO,
    };

    /// A shift by `by`.
    #[must_use]
    pub const fn translation(by: Vec3<S>) -> Self {
        Self { translation: by, ..Self::IDENTITY }
    }

    /// A turn about the x axis, in radians, that takes y towards z.
    #[must_use]
    pub fn rotation_x(angle: S) -> Self {
        let (sin, cos) = angle.sin_cos();
        let [x, ..] = Self::IDENTITY.axes;
        let y = Vec3::new(S::ZERO, cos, sin);
        let z = Vec3::new(S::ZERO, -sin, cos);
        Self { axes: [x, y, z], translation: Vec3::ZERO }
    }

    /// A turn about the y axis, in radians, that takes z towards x.
    #[must_use]
    pub fn rotation_y(angle: S) -> Self {
        let (sin, cos) = angle.sin_cos();
        let [_, y, _] = Self::IDENTITY.axes;
        let z = Vec3::new(sin, S::ZERO, cos);
        let x = Vec3::new(cos, S::ZERO, -sin);
        Self { axes: [x, y, z], translation: Vec3::ZERO }
    }

    /// A turn about the z axis, in radians, that takes x towards y.
    #[must_use]
    pub fn rotation_z(angle: S) -> Self {
        let (sin, cos) = angle.sin_cos();
        let [.., z] = Self::IDENTITY.axes;
        let x = Vec3::new(cos, sin, S::ZERO);
        let y = Vec3::new(-sin, cos, S::ZERO);
        Self { axes: [x, y, z], translation: Vec3::ZERO }
    }

    /// This pose first, then `next`.
    #[must_use]
    pub fn then(&self, next: &Self) -> Self {
        let [x, y, z] = self.axes;
        Self {
            axes: [next.direction(x), next.direction(y), next.direction(z)],
            translation: next.point(self.translation),
        }
    }

    /// A point of the own frame, in the scene's.
    #[must_use]
    pub fn point(&self, own: Vec3<S>) -> Vec3<S> {
        self.direction(own) + self.translation
    }

    /// A direction of the own frame, in the scene's.
    #[must_use]
    pub fn direction(&self, own: Vec3<S>) -> Vec3<S> {
        let [x, y, z] = self.axes;
        x * own.x + y * own.y + z * own.z
    }

    /// A point of the scene, in the own frame.
    #[must_use]
    pub fn point_back(&self, scene: Vec3<S>) -> Vec3<S> {
        self.direction_back(scene - self.translation)
    }

    /// A direction of the scene, in the own frame.
    #[must_use]
    pub fn direction_back(&self, scene: Vec3<S>) -> Vec3<S> {
        let [x, y, z] = self.axes;
        Vec3::new(x.dot(scene), y.dot(scene), z.dot(scene))
    }

    /// A line of the scene, in the own frame; the parameter stays.
    #[must_use]
    pub fn line_back(&self, line: &Line<S>) -> Line<S> {
        Line {
            origin: self.point_back(line.origin),
            direction: self.direction_back(line.direction),
        }
    }
}
