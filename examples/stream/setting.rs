//! Where a part is: how it turns, and from where cameras see it.

use crate::scene::LAP;
use crate::scene::fit::Fit;
use crate::scene::pipe::PipeScene;
use crate::shading::Shading;
use scancsg::geom::{Pose, Vec3, vec3};
use scancsg::render::{CameraError, Orthographic, Perspective, ShadeError};
use scancsg::scalar::I16F16;

/// A number type that the example can be asked for.
pub trait Choice: PipeScene {
    fn nearest(number: f64) -> Self;
}

impl Choice for f32 {
    fn nearest(number: f64) -> Self {
        number as Self
    }
}

impl Choice for f64 {
    fn nearest(number: f64) -> Self {
        number
    }
}

impl Choice for I16F16 {
    fn nearest(number: f64) -> Self {
        Self::saturating_from_num(number)
    }
}

/// Where a part is.
pub enum Setting<S> {
    /// Around the origin, with y upwards: the scenes that have names.
    Named,
    /// Anywhere, with z upwards.
    Fitted(Fit<S>),
}

impl<S: Choice> Setting<S> {
    /// The part turned upright by an angle.
    pub fn turn(&self, angle: S) -> Result<Pose<S>, String> {
        let pose = match self {
            Self::Named => Pose::rotation_y(angle),
            Self::Fitted(fit) => Pose::rotation_z(angle).and_then(|turn| turn.around(fit.middle)),
        };
        pose.map_err(|error| error.to_string())
    }

    /// Where the camera is on its way around the part, this share of it.
    pub fn eye(&self, share: f64) -> Result<Vec3<S>, String> {
        let eye = S::eye(S::nearest(LAP * share)).map_err(|error| error.to_string())?;
        Ok(match self {
            Self::Named => eye,
            Self::Fitted(fit) => {
                let upright = vec3(eye.x, eye.z.negated(), eye.y);
                fit.middle + upright * fit.radius.times(S::hundredths(39))
            }
        })
    }

    /// The camera without perspective, from an eye or from where it usually is.
    pub fn orthographic(&self, eye: Option<Vec3<S>>) -> Result<Orthographic<S>, CameraError> {
        match (self, eye) {
            (Self::Named, None) => S::orthographic(),
            (Self::Named, Some(eye)) => S::orthographic_from(eye),
            (Self::Fitted(fit), eye) => fit.orthographic(eye),
        }
    }

    /// The camera with perspective.
    pub fn perspective(&self, eye: Option<Vec3<S>>) -> Result<Perspective<S>, CameraError> {
        match (self, eye) {
            (Self::Named, None) => S::perspective(),
            (Self::Named, Some(eye)) => S::perspective_from(eye),
            (Self::Fitted(fit), eye) => fit.perspective(eye),
        }
    }

    /// The shader that was asked for.
    pub fn shading(&self, shade: crate::args::Shade) -> Result<Shading<S>, ShadeError> {
        match self {
            Self::Named => Shading::new(shade, S::TO_LIGHT, S::hundredths),
            Self::Fitted(fit) => Shading::new(shade, Fit::to_light(), |hundredths| {
                fit.radius.times(S::from_ratio(hundredths, 260))
            }),
        }
    }
}
