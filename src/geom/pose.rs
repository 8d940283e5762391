//! Rigid motions.

use super::ray::Line;
use super::vec3::Vec3;
use crate::scalar::{Number, Real, Scalar};

/// A rotation followed by a translation: where a solid's own frame lies in the scene.
///
/// ```
/// use scancsg::geom::{Pose, vec3};
///
/// let quarter = Pose::<f32>::rotation_z(core::f32::consts::FRAC_PI_2)?;
/// let pose = quarter.then(&Pose::<f32>::translation(vec3(0.0, 0.0, 3.0))?)?;
/// assert!((pose.point(vec3(2.0, 0.0, 0.0)) - vec3(0.0, 2.0, 3.0)).max_abs() < 1e-6);
/// # Ok::<(), scancsg::geom::PoseError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Pose<S: Scalar> {
    /// The images of the three axes: an orthonormal, right-handed frame.
    axes: [Vec3<S::Unit>; 3],
    translation: Vec3<S>,
}

/// Why a pose can't be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum PoseError {
    /// The angle or a coordinate is infinite or NaN.
    NotFinite,
    /// A coordinate of the translation is larger than [`Scalar::MAX_COORDINATE`].
    TooFar,
}

crate::error_text!(PoseError {
    NotFinite => "an angle or a coordinate of the pose is infinite or not a number",
    TooFar => "the pose shifts too far for its number type",
});

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
    ///
    /// # Errors
    /// [`PoseError`].
    pub fn translation(by: Vec3<S>) -> Result<Self, PoseError> {
        if !by.is_finite() {
            return Err(PoseError::NotFinite);
        }
        if !by.is_within_range() {
            return Err(PoseError::TooFar);
        }
        Ok(Self { translation: by, ..Self::IDENTITY })
    }

    /// A turn about the x axis, in radians, that takes y towards z.
    ///
    /// # Errors
    /// [`PoseError::NotFinite`].
    pub fn rotation_x(angle: S) -> Result<Self, PoseError> {
        let (sin, cos, [x, _, _]) = turn(angle)?;
        let y = Vec3::new(S::Unit::ZERO, cos, sin);
        let z = Vec3::new(S::Unit::ZERO, sin.negated(), cos);
        Ok(Self { axes: [x, y, z], translation: Vec3::ZERO })
    }

    /// A turn about the y axis, in radians, that takes z towards x.
    ///
    /// # Errors
    /// [`PoseError::NotFinite`].
    pub fn rotation_y(angle: S) -> Result<Self, PoseError> {
        let (sin, cos, [_, y, _]) = turn(angle)?;
        let z = Vec3::new(sin, S::Unit::ZERO, cos);
        let x = Vec3::new(cos, S::Unit::ZERO, sin.negated());
        Ok(Self { axes: [x, y, z], translation: Vec3::ZERO })
    }

    /// A turn about the z axis, in radians, that takes x towards y.
    ///
    /// # Errors
    /// [`PoseError::NotFinite`].
    pub fn rotation_z(angle: S) -> Result<Self, PoseError> {
        let (sin, cos, [_, _, z]) = turn(angle)?;
        let x = Vec3::new(cos, sin, S::Unit::ZERO);
        let y = Vec3::new(sin.negated(), cos, S::Unit::ZERO);
        Ok(Self { axes: [x, y, z], translation: Vec3::ZERO })
    }

    /// This pose first, then `next`.
    ///
    /// # Errors
    /// [`PoseError::TooFar`].
    pub fn then(&self, next: &Self) -> Result<Self, PoseError> {
        let axes = self.axes.map(|axis| next.turned(axis.map(S::wide_unit)).map(S::unit));
        let translation = next.point(self.translation);
        if translation.max_abs() <= S::MAX_COORDINATE {
            Ok(Self { axes, translation })
        } else {
            Err(PoseError::TooFar)
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
        self.turned(own.wide()).map(S::from_wide)
    }

    fn turned(&self, own: Vec3<S::Wide>) -> Vec3<S::Wide> {
        let [x, y, z] = self.axes.map(|axis| axis.map(S::wide_unit));
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
        self.turned_back(scene.wide()).map(S::from_wide)
    }

    pub(super) fn point_back_wide(&self, scene: Vec3<S::Wide>) -> Vec3<S::Wide> {
        self.turned_back(scene - self.translation.wide())
    }

    pub(super) fn turned_back(&self, scene: Vec3<S::Wide>) -> Vec3<S::Wide> {
        let [x, y, z] = self.axes.map(|axis| axis.map(S::wide_unit).dot(scene));
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

/// A sine and a cosine, and the axes that a turn starts from.
type Turn<S> = (<S as Scalar>::Unit, <S as Scalar>::Unit, [Vec3<<S as Scalar>::Unit>; 3]);

fn turn<S: Scalar>(angle: S) -> Result<Turn<S>, PoseError> {
    if !angle.is_finite() {
        return Err(PoseError::NotFinite);
    }
    let (sin, cos) = angle.wide().sin_cos();
    Ok((S::unit(sin), S::unit(cos), Pose::<S>::IDENTITY.axes))
}
