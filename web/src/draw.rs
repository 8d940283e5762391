//! Pictures of the gallery, in every format of the link.

use crate::gallery::{Assembly, Scene};
use crate::pixels::to_canvas;
use crate::scene::pipe::PipeScene;
use clap::ValueEnum;
use scancsg::geom::{OrthographicRays, PerspectiveRays, Pose, Rays};
use scancsg::render::pixel::{Blend, Pixel};
use scancsg::render::{
    self, Gray8, Lambert, Mono, Picture, Rgb565, Rgb888, RowSource, Size, SmoothColumn,
    SmoothPicture, Smoothing,
};
use scancsg::scalar::I16F16;
use scancsg::solid::{Placed, Rgb, Scan, Solid};
use scancsg::stream::PixelFormat;
use std::error::Error;
use std::f64::consts::TAU;

type Drawn = Result<(), Box<dyn Error>>;

/// What is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wish {
    /// Index into [`scenes`].
    pub scene: usize,
    /// Fixed point with 16 fraction bits; otherwise `f32`.
    pub is_fixed: bool,
    /// Rays through an eye; otherwise parallel ones.
    pub is_perspective: bool,
    /// The format that the picture would have on the link.
    pub format: PixelFormat,
    /// So many samples squared in a pixel at an edge. 0 or 1 is one sample in every pixel, as are all in
    /// [`PixelFormat::Mono`].
    pub smooth: u16,
    /// How far the part is turned about y: 1.0 is all around.
    pub turn: f64,
    /// Width and height in pixels.
    pub size: [u16; 2],
}

/// The scenes: their names, and what they are in words.
#[must_use]
pub fn scenes() -> Vec<[String; 2]> {
    let named = |name: &str, help: &str| [name.to_owned(), help.to_owned()];
    let gallery = Scene::value_variants().iter().filter_map(|scene| {
        let value = scene.to_possible_value()?;
        let help = value.get_help().map(ToString::to_string).unwrap_or_default();
        Some(named(value.get_name(), &help))
    });
    let first = [named("tee", "A pipe tee with flanges"), named("pipe", "A pipe along a B-spline")];
    first.into_iter().chain(gallery).collect()
}

/// Draws rows from the row `y` on into all of `canvas`.
///
/// # Errors
///
/// Anything that the crate refuses, in its words.
pub fn draw(wish: Wish, y: u16, canvas: &mut [u8]) -> Drawn {
    if wish.is_fixed { part::<I16F16>(wish, y, canvas) } else { part::<f32>(wish, y, canvas) }
}

/// A number type that can be asked for.
trait Choice: PipeScene {
    fn nearest(number: f64) -> Self;
}

impl Choice for f32 {
    fn nearest(number: f64) -> Self {
        number as Self
    }
}

impl Choice for I16F16 {
    fn nearest(number: f64) -> Self {
        Self::saturating_from_num(number)
    }
}

fn part<S: Choice>(wish: Wish, y: u16, canvas: &mut [u8]) -> Drawn {
    // As the example `stream` does it: a quarter of a pixel, in pictures of up to 480 rows.
    let tolerance = S::nearest(0.25 * (3.7 / f64::from(wish.size[1].min(480))));
    let is_painted = matches!(wish.format, PixelFormat::Rgb565 | PixelFormat::Rgb888);
    match (wish.scene, is_painted) {
        (0, false) => seen(wish, y, canvas, &S::TEE),
        (0, true) => seen(wish, y, canvas, &S::PAINTED_TEE),
        (1, false) => seen(wish, y, canvas, &S::pipe(tolerance)?),
        (1, true) => seen(wish, y, canvas, &S::painted_pipe(tolerance)?),
        (index, _) => {
            let scene = Scene::value_variants().get(index - 2).ok_or("there is no such scene")?;
            let assembly: Box<Assembly<S>> = Box::new(scene.build()?);
            seen(wish, y, canvas, &*assembly)
        }
    }
}

fn seen<S, T>(wish: Wish, y: u16, canvas: &mut [u8], part: &T) -> Drawn
where
    S: Choice,
    T: Solid<Scalar = S> + Scan<OrthographicRays<S>> + Scan<PerspectiveRays<S>>,
{
    if wish.is_perspective {
        turned(wish, y, canvas, part, &S::perspective()?)
    } else {
        turned(wish, y, canvas, part, &S::orthographic()?)
    }
}

fn turned<S, T, C>(wish: Wish, y: u16, canvas: &mut [u8], part: &T, camera: &C) -> Drawn
where
    S: Choice,
    C: render::Camera<Rays: Rays<Scalar = S>>,
    T: Solid<Scalar = S> + Scan<C::Rays>,
{
    let [width, height] = wish.size;
    let size = Size::new(width, height)?;
    let light = Lambert::new(S::TO_LIGHT, S::hundredths(15))?;
    let turned = Placed::new(part, Pose::rotation_y(S::nearest(TAU * wish.turn))?);
    if wish.smooth < 2 || wish.format == PixelFormat::Mono {
        let mut picture = Picture::new(&turned, camera, size, light, Every::BLACK);
        return rows(&mut picture, wish.format, y, canvas);
    }
    let mut columns = vec![SmoothColumn::EMPTY; usize::from(width) + 1];
    let smoothing = Smoothing::new(size, wish.smooth, &mut columns)?;
    let mut picture = SmoothPicture::new(&turned, camera, smoothing, light, Every::BLACK);
    rows(&mut picture, wish.format, y, canvas)
}

fn rows(
    source: &mut dyn RowSource<Pixel = Every>,
    format: PixelFormat,
    y: u16,
    canvas: &mut [u8],
) -> Drawn {
    let width = usize::from(source.size().width());
    let mut pixels = vec![Every::BLACK; width];
    for (y, canvas) in (y..).zip(canvas.chunks_exact_mut(4 * width)) {
        source.render(y, &mut pixels)?;
        to_canvas(format, &bytes(format, &pixels), canvas);
    }
    Ok(())
}

/// The row as it would be on the link.
fn bytes(format: PixelFormat, pixels: &[Every]) -> Vec<u8> {
    match format {
        PixelFormat::Gray8 => pixels.iter().map(|pixel| pixel.gray.0).collect(),
        PixelFormat::Rgb565 => {
            pixels.iter().flat_map(|pixel| pixel.rgb565.0.to_le_bytes()).collect()
        }
        PixelFormat::Rgb888 => pixels.iter().flat_map(|pixel| pixel.rgb888.0).collect(),
        _ => {
            let byte = |eight: &[Every]| {
                (0..)
                    .zip(eight)
                    .fold(0, |byte, (x, pixel)| byte | u8::from(pixel.mono.0) << (7 - x))
            };
            pixels.chunks(8).map(byte).collect()
        }
    }
}

/// A pixel in every format at once: a quarter of the renderers to compile. Each has the bits that it
/// has alone.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Every {
    gray: Gray8,
    rgb565: Rgb565,
    rgb888: Rgb888,
    mono: Mono,
}

impl Every {
    const BLACK: Self =
        Self { gray: Gray8(0), rgb565: Rgb565(0), rgb888: Rgb888([0; 3]), mono: Mono(false) };
}

impl Pixel for Every {
    fn shaded(color: Rgb, level: u8) -> Self {
        Self {
            gray: Gray8::shaded(color, level),
            rgb565: Rgb565::shaded(color, level),
            rgb888: Rgb888::shaded(color, level),
            mono: Mono::shaded(color, level),
        }
    }
}

impl Blend for Every {
    type Sum = (u16, [u16; 3], [u16; 3]);
    const EMPTY: Self::Sum = (Gray8::EMPTY, Rgb565::EMPTY, Rgb888::EMPTY);

    fn add_to(self, (gray, rgb565, rgb888): &mut Self::Sum) {
        self.gray.add_to(gray);
        self.rgb565.add_to(rgb565);
        self.rgb888.add_to(rgb888);
    }

    fn mean((gray, rgb565, rgb888): Self::Sum, count: u16) -> Self {
        Self {
            gray: Gray8::mean(gray, count),
            rgb565: Rgb565::mean(rgb565, count),
            rgb888: Rgb888::mean(rgb888, count),
            // Has no mean, and is not asked for it.
            mono: Mono(false),
        }
    }
}
