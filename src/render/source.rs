//! Whatever renders rows in any order.

use super::{Blend, Palette, Picture, Pixel, RowError, Run, Shader, Size, SmoothPicture};
use crate::geom::Rays;
use crate::solid::{Scan, Solid};
use core::ops::Range;

/// A source of rows: renders any row in any order, and again to the same bits. Take it where your code sends,
/// shows or tests a picture.
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

/// A [`RowSource`] that also renders a part of a row, into the caller's slice.
///
/// So a row's memory can be two halves, and DMA sends one while the other is rendered. Whoever has memory
/// for two rows doesn't need it: `render` fills either.
///
/// ```
/// use scancsg::geom::vec3;
/// use scancsg::render::{Lambert, Orthographic, Picture, Rgb565Be, RowError, RunSource, Size};
/// use scancsg::solid::Sphere;
///
/// /// A display's DMA channel: owns the bytes while it sends them, and gives them back.
/// struct Channel(Option<&'static mut [Rgb565Be]>, Vec<u8>);
///
/// impl Channel {
///     /// Waits for the last transfer, begins another, and returns the memory of the last.
///     fn swap(&mut self, half: &'static mut [Rgb565Be]) -> Option<&'static mut [Rgb565Be]> {
///         self.1.extend_from_slice(half.as_flattened());
///         self.0.replace(half)
///     }
/// }
///
/// fn show<S>(picture: &mut S, dma: &mut Channel, mut half: &'static mut [Rgb565Be]) -> Result<(), RowError>
/// where
///     S: RunSource<Pixel = Rgb565Be>,
/// {
///     for y in 0..picture.size().height() {
///         for columns in [0..16, 16..32] {
///             picture.render_run(y, columns, half)?; // while the other half is sent
///             let Some(other) = dma.swap(half) else { return Ok(()) };
///             half = other;
///         }
///     }
///     Ok(())
/// }
///
/// let ball = Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)?;
/// let (eye, target, up) = (vec3(0.0, 0.0, 5.0), vec3(0.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
/// let camera = Orthographic::look_at(eye, target, up, 3.0)?;
/// let light = Lambert::new(vec3(0.0, 0.0, 1.0), 0.1)?;
/// let mut picture = Picture::new(&ball, &camera, Size::new(32, 24)?, light, [0; 2]);
///
/// // In firmware, two `static` arrays (of a `StaticCell`, say).
/// let [one, other] = [(); 2].map(|()| Box::leak(Box::new([[0; 2]; 16])));
/// let mut dma = Channel(Some(other), Vec::new());
/// show(&mut picture, &mut dma, one)?;
/// assert_eq!(dma.1.len(), 32 * 24 * 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait RunSource: RowSource {
    /// Renders the given columns of row `y`, with the bits that [`render`](RowSource::render) gives them.
    ///
    /// # Errors
    /// [`RowError::Index`], [`RowError::Range`]; [`RowError::Length`] if `pixels` is not as long as there are
    /// columns. Nothing is written then.
    fn render_run(
        &mut self,
        y: u16,
        columns: Range<u16>,
        pixels: &mut [Self::Pixel],
    ) -> Result<(), RowError>;
}

impl<S: RowSource + ?Sized> RowSource for &mut S {
    type Pixel = S::Pixel;

    fn size(&self) -> Size {
        (**self).size()
    }

    fn render(&mut self, y: u16, pixels: &mut [S::Pixel]) -> Result<(), RowError> {
        (**self).render(y, pixels)
    }

    fn palette(&self) -> Palette {
        (**self).palette()
    }
}

impl<S: RunSource + ?Sized> RunSource for &mut S {
    fn render_run(
        &mut self,
        y: u16,
        columns: Range<u16>,
        pixels: &mut [S::Pixel],
    ) -> Result<(), RowError> {
        (**self).render_run(y, columns, pixels)
    }
}

impl<T, R, H, P> RunSource for Picture<'_, T, R, H, P>
where
    R: Rays,
    T: Solid<Scalar = R::Scalar> + Scan<R>,
    H: Shader<R::Scalar>,
    P: Pixel,
{
    fn render_run(
        &mut self,
        y: u16,
        columns: Range<u16>,
        pixels: &mut [P],
    ) -> Result<(), RowError> {
        self.scanline(y)?.render_run(&Run { columns, is_background: false }, pixels)
    }
}

impl<T, R, H, P> RunSource for SmoothPicture<'_, '_, T, R, H, P>
where
    R: Rays,
    T: Solid<Scalar = R::Scalar> + Scan<R>,
    H: Shader<R::Scalar>,
    P: Blend,
{
    fn render_run(
        &mut self,
        y: u16,
        columns: Range<u16>,
        pixels: &mut [P],
    ) -> Result<(), RowError> {
        self.render_run(y, columns, pixels)
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
