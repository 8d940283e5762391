//! Shading: from what a pixel's ray meets to a level of light.

use super::sample::Sample;
use crate::geom::{Rays, Vec3};
use crate::scalar::{Number, Scalar};
use crate::scan::Scan;
use crate::solid::Solid;

/// Turns what a pixel sees into a level, 0 (dark) to 255.
///
/// It is asked only for pixels that see a surface; the colour of the surface and the pixel format
/// are applied to the level afterwards.
#[diagnostic::on_unimplemented(
    message = "`{Self}` doesn't shade parts whose numbers are `{S}`",
    label = "no shader of this number type",
    note = "a part, its camera, its light and its rays have one number type: all `f32`, say, or all `I16F16`"
)]
pub trait Shader<S: Scalar> {
    /// The level of a pixel.
    fn level<T, R>(&self, sample: Sample<'_, T, R>) -> u8
    where
        T: Solid<Scalar = S> + Scan<R>,
        R: Rays<Scalar = S>;
}

crate::error_text! {
    /// Why a shader can't be set up.
    pub enum ShadeError {
        /// The direction to the light is zero, infinite or NaN.
        LightDirection => "the direction to the light is zero, infinite or not a number",
        /// The ambient light is not between 0 and 1.
        Ambient => "the ambient light is not between 0 and 1",
        /// The range of depths is empty, infinite or NaN.
        DepthRange => "the range of depths is empty, infinite or not a number",
        /// The thickness that is shown white is not a positive finite number.
        Thickness => "the thickness shown white is not a positive number",
    }
}

/// One directional light and ambient light, on a matt surface.
///
/// The level is `ambient + (1 − ambient) · max(0, n·l)` (Lambert's cosine law), n the normal on
/// the seen side and l the direction to the light.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Lambert<S> {
    to_light: Vec3<S>,
    ambient: S,
    /// 1 − ambient.
    diffuse: S,
}

impl<S: Scalar> Lambert<S> {
    /// A light in the direction `to_light` (of any length), and ambient light between 0 and 1.
    ///
    /// # Errors
    /// [`ShadeError::LightDirection`], [`ShadeError::Ambient`].
    pub fn new(to_light: Vec3<S>, ambient: S) -> Result<Self, ShadeError> {
        if !to_light.is_finite() {
            return Err(ShadeError::LightDirection);
        }
        let to_light = to_light.wide().normalized().ok_or(ShadeError::LightDirection)?;
        if !(S::ZERO <= ambient && ambient <= S::ONE) {
            return Err(ShadeError::Ambient);
        }
        let to_light = to_light.map(S::from_wide);
        Ok(Self { to_light, ambient, diffuse: S::ONE.minus(ambient) })
    }
}

impl<S: Scalar> Shader<S> for Lambert<S> {
    fn level<T, R>(&self, sample: Sample<'_, T, R>) -> u8
    where
        T: Solid<Scalar = S> + Scan<R>,
        R: Rays<Scalar = S>,
    {
        let cosine = sample.cosine(self.to_light);
        self.ambient.plus(self.diffuse.times(cosine.max(S::ZERO))).to_level()
    }
}

/// The depth of the seen surface: white at `near`, black at `far`.
///
/// Depths are in scene units along the viewing direction, counted from the plane through the
/// camera's target; nearer is negative.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Depth<S: Scalar> {
    far: S,
    /// 1/(far − near).
    inverse_range: S::Scale,
}

impl<S: Scalar> Depth<S> {
    /// White at depth `near`, black at depth `far`.
    ///
    /// # Errors
    /// [`ShadeError::DepthRange`].
    pub fn new(near: S, far: S) -> Result<Self, ShadeError> {
        let inverse_range = S::Wide::ONE / (far.wide() - near.wide());
        if near < far && far.is_finite() && near.is_finite() && inverse_range.is_finite() {
            Ok(Self { far, inverse_range: S::scale(inverse_range) })
        } else {
            Err(ShadeError::DepthRange)
        }
    }
}

impl<S: Scalar> Shader<S> for Depth<S> {
    fn level<T, R>(&self, sample: Sample<'_, T, R>) -> u8
    where
        T: Solid<Scalar = S> + Scan<R>,
        R: Rays<Scalar = S>,
    {
        self.far.minus(sample.seen.t).scaled(self.inverse_range).to_level()
    }
}

/// The length of the ray's way inside the solid: the longer, the brighter, and white from a given
/// thickness on. Cavities count for nothing. Only pixels that see a surface are shaded: an
/// orthographic camera inside an endless slab, looking along it, shows the background.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct XRay<S: Scalar> {
    /// 1/thickness.
    inverse_thickness: S::Scale,
}

impl<S: Scalar> XRay<S> {
    /// White where the ray is inside for `thickness` units of the scene or more.
    ///
    /// # Errors
    /// [`ShadeError::Thickness`].
    pub fn new(thickness: S) -> Result<Self, ShadeError> {
        let inverse_thickness = S::Wide::ONE / thickness.wide();
        if thickness > S::ZERO && thickness.is_finite() && inverse_thickness.is_finite() {
            Ok(Self { inverse_thickness: S::scale(inverse_thickness) })
        } else {
            Err(ShadeError::Thickness)
        }
    }
}

impl<S: Scalar> Shader<S> for XRay<S> {
    fn level<T, R>(&self, mut sample: Sample<'_, T, R>) -> u8
    where
        T: Solid<Scalar = S> + Scan<R>,
        R: Rays<Scalar = S>,
    {
        sample.path_length().scaled(self.inverse_thickness).to_level()
    }
}
