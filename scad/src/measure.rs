//! Volume and extent, by integration of spans.

use crate::map::Vector;
use crate::scene::{SPANS, Scene};
use scancsg::geom::vec3;
use scancsg::render::{CameraError, Gray8, Lambert, Orthographic, Picture, Size};
use scancsg::span::SpanList;

/// What a part measures, in cubes of its unit of length and in that unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measures {
    /// Its volume.
    pub volume: f64,
    /// How far it may be off: as far as those volumes are apart that every other row and column of the three pictures
    /// say alone.
    pub volume_error: f64,
    /// The lowest coordinates that were found.
    pub low: Vector,
    /// The highest coordinates that were found.
    pub high: Vector,
    /// The most spans of a line.
    pub spans: usize,
}

/// Measures a part by the lines through the pixels of three square pictures along the axes. None if it is empty.
///
/// ```
/// use scancsg_scad::{Model, lower, measure, parse, scene::Scene};
///
/// let part = lower(&parse("difference() { cube(size = [3, 2, 1]); cube(size = [1, 1, 9]); }")?, false)?;
/// let measures = measure(&Scene::of(&Model::of(part.tree)?)?, 100).ok_or("empty")?;
/// assert!((measures.volume - 5.0).abs() < 0.05);
/// assert_eq!(measures.high.x, 3.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn measure(scene: &Scene, pixels: u16) -> Option<Measures> {
    let along = [0, 1, 2].map(|axis| along_axis(scene, axis, pixels).ok().flatten());
    let [x, y, z] = along;
    let (x, y, z) = (x?, y?, z?);
    let volumes = [x.volumes, y.volumes, z.volumes];
    let volume = volumes.iter().flatten().sum::<f64>() / 12.0;
    let most = |pick: fn(f64, f64) -> f64| volumes.iter().flatten().copied().reduce(pick);
    let off = most(f64::max)? - most(f64::min)?;
    Some(Measures {
        volume,
        volume_error: off,
        low: vec3(x.ends[0], y.ends[0], z.ends[0]),
        high: vec3(x.ends[1], y.ends[1], z.ends[1]),
        spans: x.spans.max(y.spans).max(z.spans),
    })
}

const GOLDEN: f64 = 0.618_033_988_749_894_8;

/// By how many pixels the pictures along the three axes are shifted.
const BESIDE: [[f64; 2]; 3] = [[0.13, 0.29], [0.37, 0.11], [0.23, 0.41]];

struct Along {
    /// Of even columns and rows, of odd columns, of odd rows, of odd columns and rows.
    volumes: [f64; 4],
    ends: [f64; 2],
    spans: usize,
}

fn along_axis(scene: &Scene, axis: usize, pixels: u16) -> Result<Option<Along>, CameraError> {
    let Some([low, high]) = scene.corners() else { return Ok(None) };
    let (middle, size) = ((low + high) * 0.5, (high - low).to_array());
    let unit = |axis: usize| Vector::from([0, 1, 2].map(|i| if i == axis % 3 { 1.0 } else { 0.0 }));
    // Turned, so that no edge along an axis has all pixels of a row on one side: the golden ratio's slope.
    let (sin, cos) = GOLDEN.atan().sin_cos();
    let [across, up] = [size[(axis + 1) % 3], size[(axis + 2) % 3]];
    let pixel = across.max(up) / f64::from(pixels.clamp(2, 8_000));
    let count = |length: f64| (length / pixel).ceil() as u16 + 2;
    let [columns, rows] = [count(across * cos + up * sin), count(up * cos + across * sin)];
    // Beside the middle, lest pixels on both sides of a symmetric part say the same, and are wrong alike.
    let [u, v] = BESIDE[axis % 3].map(|pixels| pixels * pixel);
    let target = middle + unit(axis + 1) * u + unit(axis + 2) * v;
    let upwards = unit(axis + 2) * cos + unit(axis + 1) * sin;
    let camera = Orthographic::look_along(unit(axis), target, upwards, pixel * f64::from(rows))?;
    let Ok(size) = Size::new(columns, rows) else { return Ok(None) };
    let light = Lambert::new(vec3(0.0, 0.0, 1.0), 1.0).map_err(|_| CameraError::NotFinite)?;
    let mut picture = Picture::new(scene, &camera, size, light, Gray8(0));
    let mut list = SpanList::<f64, SPANS>::new();
    let mut found = Along { volumes: [0.0; 4], ends: [f64::INFINITY, f64::NEG_INFINITY], spans: 0 };
    let from = middle.to_array()[axis];
    for y in 0..rows {
        let Ok(mut row) = picture.scanline(y) else { return Ok(None) };
        for x in 0..size.width() {
            let spans = row.spans(x, &mut list);
            let share = &mut found.volumes[usize::from(x % 2 + 2 * (y % 2))];
            found.spans = found.spans.max(spans.len());
            for span in spans {
                *share += (span.exit.t - span.enter.t) * 4.0 * pixel * pixel;
                found.ends[0] = found.ends[0].min(from + span.enter.t);
                found.ends[1] = found.ends[1].max(from + span.exit.t);
            }
        }
    }
    Ok((found.spans > 0).then_some(found))
}

#[cfg(test)]
mod tests {
    use crate::scene::Scene;
    use crate::{Model, lower, measure, parse};
    use std::error::Error;
    use std::f64::consts::PI;

    /// Also where the three axes say the same: a cube, a ball.
    #[test]
    fn the_error_is_one() -> Result<(), Box<dyn Error>> {
        let parts = [
            ("cube(size = [4, 4, 4]);", 64.0),
            ("cube(size = [3, 2, 1]);", 6.0),
            ("cube(size = [9, 0.5, 0.5]);", 2.25),
            ("sphere(r = 2);", 32.0 / 3.0 * PI),
            ("cylinder(h = 3, r1 = 1, r2 = 1);", 3.0 * PI),
            ("cylinder(h = 3, r1 = 1, r2 = 0);", PI),
            ("difference() { cube(size = [4, 4, 4]); cube(size = [2, 2, 2]); }", 56.0),
        ];
        for (text, exact) in parts {
            let scene = Scene::of(&Model::of(lower(&parse(text)?, false)?.tree)?)?;
            for pixels in (20..=140).step_by(15).chain([400]) {
                let measures = measure(&scene, pixels).ok_or("empty")?;
                let (off, said) = ((measures.volume - exact).abs(), measures.volume_error);
                assert!(off <= said, "{text} by {pixels}: {off} off, and it says {said}");
                assert!(pixels < 400 || said < 0.002 * exact, "{text}: it says {said}");
            }
        }
        Ok(())
    }
}
