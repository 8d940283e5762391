//! The pictures that the start table is made from.

use crate::gallery::Scene as Gallery;
use crate::scene::Scene;
use crate::scene::pipe::PipeScene;
use crate::scene::plate::PlateScene;
use clap::ValueEnum;
use scancsg::geom::{OrthographicRays, PerspectiveRays, Rays};
use scancsg::render::{
    Blend, Camera, Depth, Gray8, Lambert, Picture, Rgb, Rgb565, Shader, Size, SmoothColumn,
    SmoothPicture, Smoothing, XRay,
};
use scancsg::solid::{Scan, Solid};
use std::error::Error;

/// The base colours of all the scenes.
pub const COLORS: [Rgb; 4] = [
    Rgb::new(150, 175, 200),
    Rgb::new(235, 175, 70),
    Rgb::new(205, 80, 65),
    Rgb::new(95, 165, 105),
];

/// The base colour of what isn't painted.
const WHITE: [Rgb; 1] = [Rgb::new(255, 255, 255)];

/// Samples across a pixel, of plain pictures and of smooth ones.
const SAMPLES: [u16; 2] = [1, 4];

pub struct Shown {
    pub name: String,
    pub width: usize,
    pub colors: &'static [Rgb],
    pub pixels: Pixels,
}

pub enum Pixels {
    Gray(Vec<Gray8>),
    Color(Vec<Rgb565>),
}

type Made<T> = Result<T, Box<dyn Error>>;

/// All of them: measured scenes in three sizes, and those of the gallery in one.
pub fn all() -> Made<Vec<Shown>> {
    let mut shown = Vec::new();
    let sizes = [[80, 60], [160, 120], [320, 240]];
    let tolerance = f32::hundredths(1);
    each::<Gray8, _>(&mut shown, "tee", &f32::TEE, &WHITE, &sizes)?;
    each::<Gray8, _>(&mut shown, "pipe", &f32::pipe(tolerance)?, &WHITE, &sizes)?;
    each::<Rgb565, _>(&mut shown, "tee", &f32::PAINTED_TEE, &COLORS[..2], &sizes)?;
    each::<Rgb565, _>(&mut shown, "pipe", &f32::painted_pipe(tolerance)?, &COLORS[..2], &sizes)?;
    let plate = <f32 as PlateScene<16>>::PLATE;
    each::<Gray8, _>(&mut shown, "plate", &plate, &WHITE, &sizes)?;
    each::<Rgb565, _>(&mut shown, "plate", &plate, &WHITE, &sizes)?;
    for scene in Gallery::value_variants() {
        let (name, solid) = (format!("{scene:?}"), scene.build::<f32>()?);
        each::<Gray8, _>(&mut shown, &name, &solid, &COLORS, &sizes[1..2])?;
        each::<Rgb565, _>(&mut shown, &name, &solid, &COLORS, &sizes[1..2])?;
    }
    Ok(shown)
}

/// The formats in which the pictures are.
trait Format: Blend {
    const NAME: &str;
    const BLACK: Self;

    fn pixels(pixels: Vec<Self>) -> Pixels;
}

impl Format for Gray8 {
    const NAME: &str = "Gray8";
    const BLACK: Self = Self(0);

    fn pixels(pixels: Vec<Self>) -> Pixels {
        Pixels::Gray(pixels)
    }
}

impl Format for Rgb565 {
    const NAME: &str = "Rgb565";
    const BLACK: Self = Self(0);

    fn pixels(pixels: Vec<Self>) -> Pixels {
        Pixels::Color(pixels)
    }
}

/// One solid, seen by both cameras.
fn each<P: Format, T>(
    shown: &mut Vec<Shown>,
    name: &str,
    solid: &T,
    colors: &'static [Rgb],
    sizes: &[[u16; 2]],
) -> Made<()>
where
    T: Solid<Scalar = f32> + Scan<OrthographicRays<f32>> + Scan<PerspectiveRays<f32>>,
{
    for [width, height] in sizes {
        let size = Size::new(*width, *height)?;
        let mut add = |view: &str, pixels: Vec<P>| {
            let name = format!("{name} {view} {width}x{height} {}", P::NAME);
            let pixels = P::pixels(pixels);
            shown.push(Shown { name, width: size.width().into(), colors, pixels });
        };
        shaded(&mut add, "orthographic", solid, &f32::orthographic()?, size)?;
        shaded(&mut add, "perspective", solid, &f32::perspective()?, size)?;
    }
    Ok(())
}

fn shaded<T, C, P: Format>(
    add: &mut impl FnMut(&str, Vec<P>),
    name: &str,
    solid: &T,
    camera: &C,
    size: Size,
) -> Made<()>
where
    T: Solid<Scalar = f32> + Scan<C::Rays>,
    C: Camera<Rays: Rays<Scalar = f32>>,
{
    let lambert = Lambert::new(f32::TO_LIGHT, 0.15)?;
    let depth = Depth::new(-2.6, 2.6)?;
    let xray = XRay::new(4.0)?;
    for n in SAMPLES {
        add(&format!("{name} lambert {n}"), rendered(solid, camera, lambert, size, n)?);
        add(&format!("{name} depth {n}"), rendered(solid, camera, depth, size, n)?);
        add(&format!("{name} xray {n}"), rendered(solid, camera, xray, size, n)?);
    }
    Ok(())
}

/// All pixels of a picture, row by row.
fn rendered<T, C, P>(
    solid: &T,
    camera: &C,
    shader: impl Shader<f32> + Copy,
    size: Size,
    samples: u16,
) -> Made<Vec<P>>
where
    T: Solid<Scalar = f32> + Scan<C::Rays>,
    C: Camera<Rays: Rays<Scalar = f32>>,
    P: Format,
{
    let background = P::BLACK;
    let [width, height] = [size.width(), size.height()].map(usize::from);
    let mut pixels = vec![background; width * height];
    let rows = (0..).zip(pixels.chunks_exact_mut(width));
    if samples > 1 {
        let mut columns = vec![SmoothColumn::EMPTY; width + 1];
        let smoothing = Smoothing::new(size, samples, &mut columns)?;
        let mut picture = SmoothPicture::new(solid, camera, smoothing, shader, background);
        for (y, row) in rows {
            picture.render(y, row)?;
        }
    } else {
        let mut picture = Picture::new(solid, camera, size, shader, background);
        for (y, row) in rows {
            picture.scanline(y)?.render(row)?;
        }
    }
    Ok(pixels)
}
