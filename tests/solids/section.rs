//! Sections in pictures: the cut faces are flat, and in a colour of their own.

use crate::scene::{PaintedTee, Scene};
use scancsg::geom::{OrthographicRays, Ray, RayRow, Rays, Vec3, vec3};
use scancsg::inspect::{Section, section};
use scancsg::render::{Camera, Lambert, Orthographic, Picture, Rgb565, Size};
use scancsg::scalar::I16F16;
use scancsg::solid::{RayCast, Rgb, Scan, Slab, Solid};
use scancsg::span::SpanList;
use testkit::number::{Tested, coordinates};

const RED: Rgb = Rgb::new(255, 0, 0);

/// What is in front of z = 0.
fn front<S: Tested>() -> Slab<S> {
    S::slab_along(2, S::ZERO, S::near(9.0)).unwrap()
}

/// Whether a point of the plane z = 0 is in `tee`: there it is rectangles.
fn is_cut(x: f64, y: f64) -> bool {
    let (x, across) = (x.abs(), y.abs());
    let body = x < 2.0 && across < 1.0
        || 1.7 < x && x < 2.0 && across < 1.6
        || x < 0.8 && 0.0 < y && y < 2.0;
    let bores = across < 0.7 || x < 0.5 && 0.0 < y || (across - 1.3).abs() < 0.15;
    body && !bores
}

/// Along the cut plane's normal, a pixel is in the cut's colour if and only if its point of the plane is in the
/// part, and its normal is that of the plane. All others see what they saw, or what is behind.
fn cut_faces_are_flat_and_red<S: Tested + Scene>()
where
    Section<PaintedTee<S>, Slab<S>>: Scan<OrthographicRays<S>> + Solid<Scalar = S>,
{
    let open = section(S::PAINTED_TEE, front::<S>(), RED);
    let up = vec3(S::ZERO, S::ONE, S::ZERO);
    let back = vec3(S::ZERO, S::ZERO, S::near(-1.0));
    let camera = Orthographic::look_along(back, Vec3::ZERO, up, S::near(4.4)).unwrap();
    // Odd numbers, so that no pixel's middle is on an edge.
    let size = Size::new(97, 89).unwrap();
    let rays = camera.rays(size);
    // All of it ambient: a pixel is in its colour.
    let light = Lambert::new(vec3(S::ZERO, S::ZERO, S::ONE), S::ONE).unwrap();
    let mut picture = Picture::new(&open, &camera, size, light, Rgb565(0));
    let mut list = SpanList::<S, 64>::new();
    let mut pixels = [Rgb565(0); 97];
    let (mut cut, mut other) = (0, 0);
    for row in 0..89 {
        picture.scanline(row).unwrap().render(&mut pixels).unwrap();
        for (column, pixel) in (0i32..).zip(pixels) {
            let line = rays.row(2 * i32::from(row) + 1 - 89).line(2 * column + 1 - 97);
            let [x, y, _] = coordinates(line.origin);
            let is_red = pixel == Rgb565(0xf800);
            assert_eq!(is_red, is_cut(x, y), "{x} {y}: {pixel:?}");
            let start = vec3(line.origin.x, line.origin.y, S::near(5.0));
            let Some(hit) = open.hit(&Ray::new(start, back).unwrap(), &mut list) else {
                assert_eq!(pixel, Rgb565(0), "{x} {y}");
                continue;
            };
            assert_eq!(open.color(hit.face) == Some(RED), is_red, "{x} {y}: {hit:?}");
            let depth = hit.point.z.to_f64();
            if is_red {
                assert_eq!(hit.normal, vec3(S::ZERO, S::ZERO, S::ONE));
                assert_eq!(depth, 0.0);
                cut += 1;
            } else {
                assert!(depth < 0.0, "{x} {y}: {hit:?}");
                other += 1;
            }
        }
    }
    assert!(cut > 500 && other > 1000, "{cut} {other}");
}

#[test]
fn cut_faces_are_flat_and_red_f32() {
    cut_faces_are_flat_and_red::<f32>();
}

#[test]
fn cut_faces_are_flat_and_red_f64() {
    cut_faces_are_flat_and_red::<f64>();
}

#[test]
fn cut_faces_are_flat_and_red_fixed() {
    cut_faces_are_flat_and_red::<I16F16>();
}

/// The same, for the eye: `#` is cut, `.` is behind the cut.
#[test]
fn a_section_of_tee() {
    let open = section(f32::PAINTED_TEE, front::<f32>(), RED);
    let (back, up) = (vec3(0.0, 0.0, -1.0), vec3(0.0, 1.0, 0.0));
    let camera = Orthographic::look_along(back, Vec3::ZERO, up, 4.4).unwrap();
    let light = Lambert::new(vec3(0.0, 0.0, 1.0), 1.0).unwrap();
    let mut picture = Picture::new(&open, &camera, Size::new(44, 22).unwrap(), light, Rgb565(0));
    let mut pixels = [Rgb565(0); 44];
    let rows = (0..22).map(|y| {
        picture.scanline(y).unwrap().render(&mut pixels).unwrap();
        let of = |pixel: &Rgb565| match pixel.0 {
            0 => ' ',
            0xf800 => '#',
            _ => '.',
        };
        pixels[12..].iter().map(of).collect::<String>().trim_end().to_owned()
    });
    let expected = [
        "",
        "      ##....##",
        "      ##....##",
        "#     ##....##    ##",
        ".     ........    ..",
        "#     ##....##    ##",
        "########....########",
        "########....########",
        "....................",
        "....................",
        "....................",
        "....................",
        "....................",
        "....................",
        "####################",
        "####################",
        "#                 ##",
        ".                 ..",
        "#                 ##",
        "",
        "",
        "",
    ];
    assert_eq!(rows.collect::<Vec<_>>(), expected);
}
