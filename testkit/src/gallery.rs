//! The pictures of `docs/gallery.md`: a part as the example `stream` shows it, held to the example's golden hash.

use crate::fnv::fnv;
use scancsg::geom::{OrthographicRays, Vec3, vec3};
use scancsg::render::{Lambert, Orthographic, Picture, Rgb565, Size};
use scancsg::solid::{Scan, Solid};

const GOLDEN: &str = include_str!("../../examples/tests/gallery.txt");
const VIEW: Vec3<f32> = vec3(-0.519_615_24, -0.5, -0.692_820_3);
const WIDTH: u16 = 64;
const HEIGHT: u16 = 48;

/// Panics unless a part's picture has the hash that `examples/tests/gallery.txt` has for this scene.
pub fn shows<T>(part: &T, scene: &str)
where
    T: Solid<Scalar = f32> + Scan<OrthographicRays<f32>>,
{
    let golden = GOLDEN.lines().find_map(|line| line.strip_prefix(&format!("{scene} ortho ")));
    let golden = golden.and_then(|hashes| hashes.split(' ').next());
    let hash = hash(part).map(|hash| format!("{hash:08x}"));
    assert_eq!(hash.ok().as_deref(), golden, "not the gallery's picture of {scene}");
}

/// The hash of the pixels, with eight bits a colour.
fn hash<T>(part: &T) -> Result<u32, scancsg::Error>
where
    T: Solid<Scalar = f32> + Scan<OrthographicRays<f32>>,
{
    let camera = Orthographic::look_along(VIEW, Vec3::ZERO, vec3(0.0, 1.0, 0.0), 4.4)?;
    let light = Lambert::new(vec3(0.25, 0.85, 0.45), 0.15)?;
    let size = Size::new(WIDTH, HEIGHT)?;
    let mut picture = Picture::new(part, &camera, size, light, Rgb565::default());
    let mut row = [Rgb565::default(); WIDTH as usize];
    let mut bytes = Vec::new();
    for y in 0..HEIGHT {
        picture.scanline(y)?.render(&mut row)?;
        for Rgb565(bits) in row {
            for (shift, most) in [(11, 31), (5, 63), (0, 31)] {
                let level = u32::from(bits) >> shift & most;
                bytes.push((level * 255 + most / 2) / most);
            }
        }
    }
    Ok(fnv(bytes))
}
