//! Whatever renders rows in any order.

use super::{Blend, Palette, Picture, Pixel, RowError, Shader, Size, SmoothPicture};
use crate::geom::Rays;
use crate::solid::{Scan, Solid};

/// Renders rows of pixels in any order, and each one again to the same bits: what a sender, a display or
/// a test takes, whatever picture it gets.
///
/// [`Picture`] and [`SmoothPicture`] are such sources. A `&mut dyn RowSource<Pixel = Gray8>` is one too, so
/// that code around several kinds of pictures is compiled once.
///
/// ```
/// use scancsg::geom::vec3;
/// use scancsg::render::{Gray8, Lambert, Orthographic, Picture, RowError, RowSource, Size};
/// use scancsg::solid::Sphere;
///
/// /// Rows that are not rendered at all: a test card.
/// struct Stripes(Size);
///
/// impl RowSource for Stripes {
///     type Pixel = Gray8;
///
///     fn size(&self) -> Size {
///         self.0
///     }
///
///     fn render(&mut self, _: u16, pixels: &mut [Gray8]) -> Result<(), RowError> {
///         (0..).zip(pixels).for_each(|(x, pixel)| *pixel = Gray8(x * 16));
///         Ok(())
///     }
/// }
///
/// fn brightest(source: &mut dyn RowSource<Pixel = Gray8>) -> Result<u8, RowError> {
///     let mut row = [Gray8(0); 16];
///     let mut brightest = 0;
///     for y in 0..source.size().height() {
///         source.render(y, &mut row)?;
///         brightest = row.iter().fold(brightest, |most, pixel| most.max(pixel.0));
///     }
///     Ok(brightest)
/// }
///
/// let size = Size::new(16, 12)?;
/// let ball = Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)?;
/// let (eye, target, up) = (vec3(0.0, 0.0, 5.0), vec3(0.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
/// let camera = Orthographic::look_at(eye, target, up, 3.0)?;
/// let light = Lambert::new(vec3(0.0, 0.0, 1.0), 1.0)?; // all of it ambient
/// assert_eq!(brightest(&mut Picture::new(&ball, &camera, size, light, Gray8(0)))?, 255);
/// assert_eq!(brightest(&mut Stripes(size))?, 240);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait RowSource {
    /// What a row is made of.
    type Pixel;

    /// The size in pixels.
    fn size(&self) -> Size;

    /// Renders row `y`, counted from the top, into `pixels`.
    ///
    /// # Errors
    /// [`RowError::Index`], [`RowError::Range`]; [`RowError::Length`] if `pixels` is not as long as the
    /// picture is wide. Nothing is written then.
    fn render(&mut self, y: u16, pixels: &mut [Self::Pixel]) -> Result<(), RowError>;

    /// The colours of the surfaces, before they are lit. None unless the source says some.
    fn palette(&self) -> Palette {
        Palette::EMPTY
    }
}

impl<T, R, H, P> RowSource for Picture<'_, T, R, H, P>
where
    R: Rays,
    T: Solid<Scalar = R::Scalar> + Scan<R>,
    H: Shader<R::Scalar>,
    P: Pixel,
{
    type Pixel = P;

    fn size(&self) -> Size {
        self.size()
    }

    fn render(&mut self, y: u16, pixels: &mut [P]) -> Result<(), RowError> {
        self.scanline(y)?.render(pixels)
    }

    fn palette(&self) -> Palette {
        self.palette()
    }
}

impl<T, R, H, P> RowSource for SmoothPicture<'_, '_, T, R, H, P>
where
    R: Rays,
    T: Solid<Scalar = R::Scalar> + Scan<R>,
    H: Shader<R::Scalar>,
    P: Blend,
{
    type Pixel = P;

    fn size(&self) -> Size {
        self.size()
    }

    fn render(&mut self, y: u16, pixels: &mut [P]) -> Result<(), RowError> {
        self.render(y, pixels)
    }

    fn palette(&self) -> Palette {
        self.palette()
    }
}
