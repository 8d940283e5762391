//! The part, and the picture of it: what the firmware sends, and the test on the host renders.

#![cfg_attr(not(test), no_std)]

use scancsg::geom::{Axis, vec3};
use scancsg::render::{Gray8, Lambert, Orthographic, Picture, RowSource, Size};
use scancsg::solid::{Cuboid, Cylinder, Difference, Union};
use scancsg::{Error, constant};

/// The picture's width in pixels.
pub const WIDTH: usize = 160;
/// The picture's height in pixels.
pub const HEIGHT: u16 = 120;

/// A foot with a bearing on it, drilled through, and two screw holes.
type Part = Difference<Union<Cuboid<f32>, Cylinder<f32>>, [Cylinder<f32>; 3]>;

/// It lies in flash. A wrong radius is a compile error.
static PART: Part = Difference::new(
    Union::new(
        constant!(Cuboid::<f32>::spanning(-2.0..2.0, -1.0..-0.6, -1.0..1.0)), // x, y, z
        // Along z, from, to, its middle in x and y, its radius.
        constant!(Cylinder::<f32>::spanning(Axis::Z, -0.8..0.8, [0.0, 0.2], 1.0)),
    ),
    constant![
        Cylinder::<f32>::spanning(Axis::Z, -2.0..2.0, [0.0, 0.2], 0.6),
        Cylinder::<f32>::spanning(Axis::Y, -2.0..0.0, [-1.5, 0.0], 0.25), // x and z
        Cylinder::<f32>::spanning(Axis::Y, -2.0..0.0, [1.5, 0.0], 0.25),
    ],
);

/// What is sent: the part, seen from the upper right.
///
/// # Errors
/// If the camera, the light or the size can't be.
pub fn picture() -> Result<impl RowSource<Pixel = Gray8>, Error> {
    let (eye, target, up) = (vec3(3.0, 3.0, 5.0), vec3(0.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
    let camera = Orthographic::look_at(eye, target, up, 4.0)?; // shows 4 units of height
    let light = Lambert::new(vec3(0.2, 1.0, 0.5), 0.15)?;
    let size = Size::new(WIDTH as u16, HEIGHT)?;
    Ok(Picture::new(&PART, &camera, size, light, Gray8(0)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::{env, fs};

    /// FNV-1a of 32 bits.
    fn hash(row: &[Gray8]) -> u32 {
        row.iter().fold(0x811C_9DC5, |hash, pixel| {
            (hash ^ u32::from(pixel.0)).wrapping_mul(0x0100_0193)
        })
    }

    /// Each row has the bits that it had: `src/rows.txt` has a line for each of them.
    ///
    /// If you meant to change the picture, `UPDATE_ROWS=1 cargo host-test` writes that file, and `part.pgm` to
    /// look at.
    #[test]
    fn rows_are_as_they_were() -> Result<(), Box<dyn std::error::Error>> {
        let mut picture = picture()?;
        let mut row = [Gray8(0); WIDTH];
        let (mut rows, mut pgm) = (String::new(), format!("P5 {WIDTH} {HEIGHT} 255\n").into_bytes());
        for y in 0..HEIGHT {
            picture.render(y, &mut row)?;
            rows += &format!("{y:03} {:08x}\n", hash(&row));
            pgm.extend(row.map(|pixel| pixel.0));
        }
        if env::var_os("UPDATE_ROWS").is_some() {
            fs::write("src/rows.txt", &rows)?;
            fs::write("part.pgm", &pgm)?;
        }
        let golden = fs::read_to_string("src/rows.txt")?;
        let changed: Vec<&str> =
            rows.lines().filter(|row| !golden.lines().any(|line| line == *row)).collect();
        assert!(changed.is_empty(), "rows that have changed: {changed:?}");
        assert_eq!(rows.lines().count(), golden.lines().count());
        Ok(())
    }
}
