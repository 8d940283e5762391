//! Cameras and light for a part that isn't known beforehand: z points up, as in OpenSCAD, and the part is seen
//! from there where OpenSCAD sees it first.

use super::Scene;
use scancsg::geom::Vec3;
use scancsg::render::{CameraError, Orthographic, Perspective};
use scancsg::solid::Bounds;

/// A ball around the part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fit<S> {
    pub middle: Vec3<S>,
    pub radius: S,
}

impl<S: Scene> Fit<S> {
    /// The ball around some bounds, if the part has an end.
    pub fn of(bounds: &Bounds<S>) -> Option<Self> {
        bounds.ball().map(|(middle, radius)| Self { middle, radius })
    }

    fn times(&self, hundredths: i32) -> S {
        self.radius.times(S::hundredths(hundredths))
    }

    fn along() -> Vec3<S> {
        Vec3::from([-35, 74, -57].map(S::hundredths))
    }

    fn up() -> Vec3<S> {
        Vec3::from([0, 0, 100].map(S::hundredths))
    }

    /// Towards the light: from above, left of the camera.
    pub fn to_light() -> Vec3<S> {
        Vec3::from([-16, -48, 87].map(S::hundredths))
    }

    /// The camera without perspective, from an eye or from where it usually is. It shows the ball, and a bit more.
    pub fn orthographic(&self, eye: Option<Vec3<S>>) -> Result<Orthographic<S>, CameraError> {
        let along = eye.map_or_else(Self::along, |eye| self.middle - eye);
        Orthographic::look_along(along, self.middle, Self::up(), self.times(210))
    }

    /// The camera with perspective, which shows as much from 4.3 radii away.
    pub fn perspective(&self, eye: Option<Vec3<S>>) -> Result<Perspective<S>, CameraError> {
        let eye = eye.unwrap_or_else(|| self.middle - Self::along() * self.times(430));
        Perspective::look_at(eye, self.middle, Self::up(), S::hundredths(49))
    }
}
