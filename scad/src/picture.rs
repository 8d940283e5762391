//! Pictures of a part, rendered by all cores, and PNG files.

use crate::error::Error;
use crate::map::Vector;
use crate::scene::Scene;
use scancsg::geom::{OrthographicRays, vec3};
use scancsg::render::{Lambert, Orthographic, Picture, Pixel, Rgb, RowSource, Size};
use scancsg::scalar::Scalar;
use scancsg::solid::{Scan, Solid};
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;
use std::thread;

/// From where a part is seen: angles in degrees, as in OpenSCAD's `--camera`. Zero looks down from above with y
/// upwards in the picture; then the part is turned about x, y and z, in this order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Angles(pub [f64; 3]);

impl Default for Angles {
    /// OpenSCAD's first view.
    fn default() -> Self {
        Self([55.0, 0.0, 25.0])
    }
}

impl Angles {
    /// The directions to the right, upwards and towards the camera.
    #[must_use]
    pub fn axes(&self) -> [Vector; 3] {
        let [about_x, about_y, about_z] = self.0.map(f64::to_radians);
        let turned = |v: Vector| {
            let (sin, cos) = about_x.sin_cos();
            let v = vec3(v.x, v.y * cos - v.z * sin, v.y * sin + v.z * cos);
            let (sin, cos) = about_y.sin_cos();
            let v = vec3(v.x * cos + v.z * sin, v.y, v.z * cos - v.x * sin);
            let (sin, cos) = about_z.sin_cos();
            vec3(v.x * cos - v.y * sin, v.x * sin + v.y * cos, v.z)
        };
        [vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), vec3(0.0, 0.0, 1.0)].map(turned)
    }
}

/// A camera for a part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// From where it looks.
    pub angles: Angles,
    /// What is in the middle.
    pub target: Vector,
    /// How many units of the scene the picture is high.
    pub height: f64,
}

impl View {
    /// The whole part, with a margin of a twentieth.
    ///
    /// # Errors
    /// An [`Error`] for an empty part.
    pub fn of_all(scene: &Scene, angles: Angles, [width, height]: [u16; 2]) -> Result<Self, Error> {
        let corners = scene.corners().ok_or_else(|| Error::limit("the part is empty"))?;
        Ok(Self::of_box(corners, angles, [width, height]))
    }

    /// All of a box between two corners, with the same margin.
    #[must_use]
    pub fn of_box([low, high]: [Vector; 2], angles: Angles, [width, height]: [u16; 2]) -> Self {
        let half = (high - low) * 0.5;
        let [right, up, _] = angles.axes().map(|axis| {
            2.0 * (axis.x.abs() * half.x + axis.y.abs() * half.y + axis.z.abs() * half.z)
        });
        let fit = up.max(right * f64::from(height) / f64::from(width));
        Self { angles, target: (low + high) * 0.5, height: fit * 1.05 }
    }
}

/// A pixel of three times eight bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Rgb8(pub [u8; 3]);

impl Pixel for Rgb8 {
    fn shaded(color: Rgb, level: u8) -> Self {
        Self(
            [color.r, color.g, color.b]
                .map(|part| scancsg::render::pixel::scale(part, level) as u8),
        )
    }
}

/// What is behind the part.
pub const BACKGROUND: Rgb8 = Rgb8([24, 27, 32]);

/// Renders a part, as a scene or as a program, row by row on all cores, with `background` where nothing is seen.
///
/// # Errors
/// An [`Error`] for a size or a view that no picture has.
pub fn render<S, T, P>(
    part: &T,
    view: &View,
    [width, height]: [u16; 2],
    background: P,
) -> Result<Vec<P>, Error>
where
    S: Scalar,
    T: Solid<Scalar = S> + Scan<OrthographicRays<S>> + Sync,
    P: Pixel + Send + Sync,
{
    let size = Size::new(width, height).map_err(|error| Error::limit(error.to_string()))?;
    let mut pixels = vec![background; usize::from(width) * usize::from(height)];
    let cores = thread::available_parallelism().map_or(1, usize::from);
    // Every core takes every so-manieth row, so that all have as much to do.
    let mut shares: Vec<Vec<_>> = (0..cores).map(|_| Vec::new()).collect();
    for (index, row) in pixels.chunks_mut(width.into()).enumerate() {
        shares[index % cores].push((index as u16, row));
    }
    let done: Result<(), Error> = thread::scope(|scope| {
        let start = |share| scope.spawn(move || render_rows(part, view, size, background, share));
        let threads: Vec<_> = shares.into_iter().map(start).collect();
        threads.into_iter().try_for_each(|thread| {
            thread.join().map_err(|_| Error::limit("a thread of the picture has ended"))?
        })
    });
    done.map(|()| pixels)
}

/// Renders some rows.
pub(crate) fn render_rows<S, T, P>(
    part: &T,
    view: &View,
    size: Size,
    background: P,
    rows: Vec<(u16, &mut [P])>,
) -> Result<(), Error>
where
    S: Scalar,
    T: Solid<Scalar = S> + Scan<OrthographicRays<S>>,
    P: Pixel,
{
    let wrong = |error: &dyn std::fmt::Display| Error::limit(error.to_string());
    let [right, up, back] = view.angles.axes();
    let vector = |vector: Vector| vector.map(S::from_f64);
    let height = S::from_f64(view.height);
    let camera = Orthographic::look_along(vector(-back), vector(view.target), vector(up), height)
        .map_err(|error| wrong(&error))?;
    let towards = vector(back * 0.8 + up * 0.5 - right * 0.35);
    let light = Lambert::new(towards, S::from_f64(0.25)).map_err(|error| wrong(&error))?;
    let mut picture = Picture::new(part, &camera, size, light, background);
    rows.into_iter().try_for_each(|(y, row)| {
        RowSource::render(&mut picture, y, row).map_err(|error| wrong(&error))
    })
}

/// Writes a PNG file.
///
/// # Errors
/// An [`Error`] that names the file.
pub fn write_png(path: &Path, [width, height]: [u16; 2], pixels: &[Rgb8]) -> Result<(), Error> {
    let failed =
        |error: &dyn std::fmt::Display| Error::file(format!("{}: {error}", path.display()));
    let file = File::create(path).map_err(|error| failed(&error))?;
    let mut encoder = png::Encoder::new(BufWriter::new(file), width.into(), height.into());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::Fast);
    let mut writer = encoder.write_header().map_err(|error| failed(&error))?;
    let bytes: Vec<u8> = pixels.iter().flat_map(|pixel| pixel.0).collect();
    writer.write_image_data(&bytes).map_err(|error| failed(&error))?;
    writer.finish().map_err(|error| failed(&error))
}
