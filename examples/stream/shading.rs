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
    /// For a part that fits a ball of radius 2.6 around the origin; `hundredths` makes numbers.
    pub fn new(
        shade: Shade,
        to_light: Vec3<S>,
        hundredths: impl Fn(i32) -> S,
    ) -> Result<Self, ShadeError> {
        Ok(match shade {
            Shade::Lambert => Self::Lambert(Lambert::new(to_light, hundredths(15))?),
            Shade::Depth => Self::Depth(Depth::new(hundredths(-260), hundredths(260))?),
            Shade::Xray => Self::Xray(XRay::new(hundredths(400))?),
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
