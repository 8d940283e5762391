//! Long lenses in fixed point: rays within 2⁻¹⁴ radians of a cylinder's axis.

use fixed::types::I16F16;
use scancsg::geom::vec3;
use scancsg::render::{Camera, Gray8, Perspective, Picture, Size, XRay};
use scancsg::scalar::Scalar;
use scancsg::solid::{Cylinder, Scan};

/// How many pixels see a thin rod beside the line of sight and along it.
fn covered<S: Scalar>(distance: i32, field: [i32; 2], pixels: u16) -> usize
where
    Cylinder<S>: Scan<<Perspective<S> as Camera>::Rays, Scalar = S>,
{
    let n = |thousandths| S::from_ratio(thousandths, 1000);
    let (x, ends) = (n(12), [n(-1000), n(1000)]);
    let rod = Cylinder::along(scancsg::geom::Axis::Z, [x, n(0)], n(10), ends[0], ends[1]).unwrap();
    let eye = vec3(n(0), n(0), S::from_int(distance));
    let field = S::from_ratio(field[0], field[1]);
    let camera =
        Perspective::look_at(eye, vec3(n(0), n(0), n(0)), vec3(n(0), n(1000), n(0)), field);
    let (camera, size) = (camera.unwrap(), Size::new(pixels, pixels).unwrap());
    let mut picture = Picture::new(&rod, &camera, size, XRay::new(S::ONE).unwrap(), Gray8(0));
    (0..pixels)
        .map(|y| {
            let mut row = picture.scanline(y).unwrap();
            (0..pixels).filter(|&x| row.seen(x).is_some()).count()
        })
        .sum()
}

#[test]
fn a_rod_along_the_line_of_sight_is_seen() {
    for (distance, field, pixels, tolerance) in
        [(400, [1, 1000], 48, 1), (100, [4, 1000], 240, 4), (20, [20, 1000], 240, 30)]
    {
        let [want, got] =
            [covered::<f32>(distance, field, pixels), covered::<I16F16>(distance, field, pixels)];
        assert!(want > 3 && want.abs_diff(got) <= tolerance, "{got} pixels, not {want}");
    }
}
