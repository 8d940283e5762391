//! Pixels: what a shaded sample becomes in the caller's row, and what a pixel type of yours needs.
//!
//! [`Pixel`] is the one trait that a picture asks for, [`Blend`] the one for smooth edges besides. How a
//! pixel goes over the link is not said here, but by [`WirePixel`](crate::stream::WirePixel).
//!
//! Everything here is integer arithmetic on eight-bit levels, so a pixel's bits depend on the
//! level and the colour alone, not on the number type of the scene.

mod blend;
mod bytes;
mod gray8;
mod level;
mod mono;
mod rgb565;
mod rgb888;
pub(crate) mod same_bits;

pub use blend::{Blend, mean};
pub use bytes::Rgb565Be;
pub use gray8::Gray8;
pub use level::{narrow, scale};
pub use mono::Mono;
pub use rgb565::Rgb565;
pub use rgb888::Rgb888;

use crate::solid::Rgb;

/// A pixel that a row can be made of.
///
/// Implement it for the colours of your display, and a picture renders into a row of them. [`Gray8`],
/// [`Rgb565`], [`Rgb888`] and [`Mono`] are ready; [`scale`] and [`narrow`] do the arithmetic of others.
///
/// ```
/// use scancsg::geom::vec3;
/// use scancsg::render::{Lambert, Orthographic, Picture, Pixel, Rgb, RowSource, Size};
/// use scancsg::solid::Sphere;
///
/// /// A pixel of a display that is black and white.
/// #[derive(Clone, Copy, PartialEq, Debug)]
/// struct Lit(bool);
///
/// impl Pixel for Lit {
///     fn shaded(color: Rgb, level: u8) -> Self {
///         Self(scancsg::render::pixel::scale(color.luma(), level) >= 128)
///     }
/// }
///
/// let ball = Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)?;
/// let (eye, target, up) = (vec3(0.0, 0.0, 5.0), vec3(0.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
/// let camera = Orthographic::look_at(eye, target, up, 2.0)?;
/// let light = Lambert::new(vec3(0.0, 0.0, 1.0), 0.5)?;
/// let mut picture = Picture::new(&ball, &camera, Size::new(4, 4)?, light, Lit(false));
/// let mut row = [Lit(false); 4];
/// picture.render(0, &mut row)?;
/// assert_eq!(row, [false, true, true, false].map(Lit));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a pixel",
    label = "not a pixel",
    note = "pixels are `Gray8`, `Mono`, `Rgb565`, `Rgb565Be`, `Rgb888`, or a type of yours that implements `Pixel`"
)]
pub trait Pixel: Copy {
    /// The pixel of a surface of this colour, lit with `level` (0 dark to 255 full).
    fn shaded(color: Rgb, level: u8) -> Self;
}
