//! Pictures of a part, rendered by all cores, and PNG files.

use crate::error::Error;
use crate::map::Vector;
use crate::scene::Scene;
use scancsg::geom::vec3;
use scancsg::render::{Lambert, Orthographic, Picture, Pixel, Rgb, RowSource, Size};
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

/// Renders a part, row by row, on all cores, with `background` where nothing is seen.
///
/// # Errors
/// An [`Error`] for a size or a view that no picture has.
pub fn render<P: Pixel + Send + Sync>(
    scene: &Scene,
    view: &View,
    [width, height]: [u16; 2],
    background: P,
) -> Result<Vec<P>, Error> {
    let wrong = |error: &dyn std::fmt::Display| Error::limit(error.to_string());
    let size = Size::new(width, height).map_err(|error| wrong(&error))?;
    let [right, up, back] = view.angles.axes();
    let camera = Orthographic::look_along(-back, view.target, up, view.height)
        .map_err(|error| wrong(&error))?;
    let light =
        Lambert::new(back * 0.8 + up * 0.5 - right * 0.35, 0.25).map_err(|error| wrong(&error))?;
    let mut pixels = vec![background; usize::from(width) * usize::from(height)];
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let mut rows: Vec<(u16, &mut [P])> = (0..).zip(pixels.chunks_mut(width.into())).collect();
    // Every core takes every so-manieth row, so that all have as much to do.
    let mut shares: Vec<Vec<_>> = (0..cores).map(|_| Vec::new()).collect();
    for (index, row) in rows.drain(..).enumerate() {
        shares[index % cores].push(row);
    }
    thread::scope(|scope| {
        for share in shares {
            let (camera, light) = (&camera, light);
            scope.spawn(move || {
                let mut picture = Picture::new(scene, camera, size, light, background);
                for (y, row) in share {
                    // The index and the length are right; a row that can't be is background.
                    let _ = RowSource::render(&mut picture, y, row);
                }
            });
        }
    });
    Ok(pixels)
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
