//! The shader that was asked for, as one type: a third of the renderers to compile.

use crate::args::Shade;
use scancsg::geom::{Rays, Vec3};
use scancsg::render::{Depth, Lambert, Sample, ShadeError, Shader, XRay};
use scancsg::scalar::Scalar;
use scancsg::solid::{Scan, Solid};

#[derive(Clone, Copy)]
pub enum Shading<S: Scalar> {
    Lambert(Lambert<S>),
    Depth(Depth<S>),
    Xray(XRay<S>),
}

impl<S: Scalar> Shading<S> {
    /// For a part that fits a ball of radius 2.6 around the camera's target; `length` makes lengths of hundredths.
    pub fn new(
        shade: Shade,
        to_light: Vec3<S>,
        length: impl Fn(i32) -> S,
    ) -> Result<Self, ShadeError> {
        Ok(match shade {
            Shade::Lambert => Self::Lambert(Lambert::new(to_light, S::from_ratio(15, 100))?),
            Shade::Depth => Self::Depth(Depth::new(length(-260), length(260))?),
            Shade::Xray => Self::Xray(XRay::new(length(400))?),
        })
    }
}

impl<S: Scalar> Shader<S> for Shading<S> {
    fn level<T, R>(&self, sample: Sample<'_, T, R>) -> u8
    where
        T: Solid<Scalar = S> + Scan<R>,
        R: Rays<Scalar = S>,
    {
        match self {
            Self::Lambert(shader) => shader.level(sample),
            Self::Depth(shader) => shader.level(sample),
            Self::Xray(shader) => shader.level(sample),
        }
    }
}
