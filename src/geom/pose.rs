//! Rigid motions.

use super::{Line, Vec3};
use crate::scalar::{Number, Real, Scalar};

/// A rotation followed by a translation: where a solid's own frame lies in the scene.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Pose<S: Scalar> {
    /// The images of the three axes: an orthonormal, right-handed frame.
    axes: [Vec3<S::Unit>; 3],
    translation: Vec3<S>,
}

impl<S: Scalar> Pose<S> {
    /// The pose that moves nothing.
    pub const IDENTITY: Self = {
        let (zero, one) = (S::Unit::ZERO, S::Unit::ONE);
        Self {
            axes: [
                Vec3::new(one, zero, zero),
                Vec3::new(zero, one, zero),
                Vec3::new(zero, zero, one),
            ],
            translation: Vec3::ZERO,
        }
    };

    /// A shift by `by`.
    #[must_use]
    pub const fn translation(by: Vec3<S>) -> Self {
        Self { translation: by, ..Self::IDENTITY }
    }

    /// A turn about the x axis, in radians, that takes y towards z.
    #[must_use]
    pub fn rotation_x(angle: S) -> Self {
        let (sin, cos, [x, _, _]) = turn(angle);
        let y = Vec3::new(S::Unit::ZERO, cos, sin);
        let z = Vec3::new(S::Unit::ZERO, sin.negated(), cos);
        Self { axes: [x, y, z], translation: Vec3::ZERO }
    }

    /// A turn about the y axis, in radians, that takes z towards x.
    #[must_use]
    pub fn rotation_y(angle: S) -> Self {
        let (sin, cos, [_, y, _]) = turn(angle);
        let z = Vec3::new(sin, S::Unit::ZERO, cos);
        let x = Vec3::new(cos, S::Unit::ZERO, sin.negated());
        Self { axes: [x, y, z], translation: Vec3::ZERO }
    }

    /// A turn about the z axis, in radians, that takes x towards y.
    #[must_use]
    pub fn rotation_z(angle: S) -> Self {
        let (sin, cos, [_, _, z]) = turn(angle);
        let x = Vec3::new(cos, sin, S::Unit::ZERO);
        let y = Vec3::new(sin.negated(), cos, S::Unit::ZERO);
        Self { axes: [x, y, z], translation: Vec3::ZERO }
    }

    /// This pose first, then `next`.
    #[must_use]
    pub fn then(&self, next: &Self) -> Self {
        let [x, y, z] = self.axes;
        Self {
            axes: [x, y, z].map(|axis| next.turned(axis.map(S::fine_unit)).map(S::unit)),
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
        self.turned(own.fine()).map(S::from_fine)
    }

    fn turned(&self, own: Vec3<S::Fine>) -> Vec3<S::Fine> {
        let [x, y, z] = self.axes.map(|axis| axis.map(S::fine_unit));
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
        self.turned_back(scene.fine()).map(S::from_fine)
    }

    pub(super) fn point_back_fine(&self, scene: Vec3<S::Fine>) -> Vec3<S::Fine> {
        self.turned_back(scene - self.translation.fine())
    }

    pub(super) fn turned_back(&self, scene: Vec3<S::Fine>) -> Vec3<S::Fine> {
        let [x, y, z] = self.axes.map(|axis| axis.map(S::fine_unit).dot(scene));
        Vec3::new(x, y, z)
    }

    /// A line of the scene, in the own frame; the parameter stays. In fixed point, its direction is
    /// rounded to the number type, so it is best a long one.
    #[must_use]
    pub fn line_back(&self, line: &Line<S>) -> Line<S> {
        Line {
            origin: self.point_back(line.origin),
            direction: self.direction_back(line.direction),
        }
    }
}

/// Sine and cosine of an angle, and the axes that a turn by it starts from.
fn turn<S: Scalar>(angle: S) -> (S::Unit, S::Unit, [Vec3<S::Unit>; 3]) {
    let (sin, cos) = angle.fine().sin_cos();
    (S::unit(sin), S::unit(cos), Pose::<S>::IDENTITY.axes)
}
