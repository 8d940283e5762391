//! The memory that a render needs: the figures of the README.

#![allow(clippy::unwrap_used, clippy::panic)]

#[path = "footprint/kinds.rs"]
mod kinds;
#[path = "../examples/scene/mod.rs"]
mod scene;

use kinds::{KINDS, Kind};
use scene::program::Part;
use scene::{Scene, Tee};

use core::mem::size_of_val;
use scancsg::geom::{OrthographicRays, Rays};
use scancsg::program::Program;
use scancsg::render::{Camera, Gray8, Lambert, Picture, Size};
use scancsg::scalar::I16F16;
use scancsg::solid::{Cuboid, Cylinder, Polyhedron, Pooled, Scan, Sphere};
use scancsg::stream::{PixelFormat, Plain, Predictive, Sender, packet_capacity, row_capacity};

fn size<S: Scene, C>(camera: &C) -> usize
where
    C: Camera<Rays: Rays<Scalar = S>>,
    Tee<S>: Scan<C::Rays, Scalar = S>,
{
    let light = Lambert::new(S::TO_LIGHT, S::hundredths(15)).unwrap();
    let size = Size::new(160, 120).unwrap();
    let tee = S::TEE;
    size_of_val(&Picture::new(&tee, camera, size, light, Gray8(0)))
}

#[test]
fn a_render_of_tee_needs_little_memory() {
    let single = size(&f32::orthographic().unwrap());
    let fixed = size(&I16F16::orthographic().unwrap());
    println!("picture: {single} bytes in f32, {fixed} in I16F16");
    // Pointers are half as long on a microcontroller.
    assert!(single <= 1280, "{single}");
    assert!(fixed <= 2048, "{fixed}");
    let single = size(&f32::perspective().unwrap());
    let fixed = size(&I16F16::perspective().unwrap());
    println!("in perspective: {single} bytes in f32, {fixed} in I16F16");
    assert!(single <= 2048, "{single}");
    assert!(fixed <= 2560, "{fixed}");
    assert_eq!(packet_capacity(160, PixelFormat::Gray8), 256);
    assert_eq!(row_capacity(160, PixelFormat::Gray8), 172);
    let sender = size_of::<Sender<Predictive<Gray8, 160>, 256>>();
    let plain = size_of::<Sender<Plain, 172>>();
    println!("sender: {sender} bytes, with plain rows {plain}");
    assert!(sender <= 1400, "{sender}");
}

/// The bytes of a program, and of its view and row.
fn bytes_of<P: Scan<OrthographicRays<f32>, Scalar = f32>>() -> usize {
    size_of::<P>() + size_of::<P::View>() + size_of::<P::Row>()
}

/// The same, a part.
fn bytes_of_a_part<L, const N: usize>() -> usize
where
    L: Scan<OrthographicRays<f32>, Scalar = f32>,
{
    bytes_of::<Program<L, N>>().div_ceil(N)
}

#[test]
fn programs_need_little_memory() {
    let of_cylinders = [
        bytes_of_a_part::<Cylinder<f32>, 16>(),
        bytes_of_a_part::<Cylinder<f32>, 64>(),
        bytes_of_a_part::<Cylinder<f32>, 256>(),
    ];
    let of_parts = [
        bytes_of_a_part::<Part<f32>, 16>(),
        bytes_of_a_part::<Part<f32>, 64>(),
        bytes_of_a_part::<Part<f32>, 256>(),
    ];
    println!("a part: {of_cylinders:?}, {of_parts:?}");
    // What primitives need, and 24 bytes.
    assert!(of_cylinders.iter().all(|bytes| *bytes <= 165), "{of_cylinders:?}");
    assert!(of_parts.iter().all(|bytes| *bytes <= 185), "{of_parts:?}");
}

scancsg::leaves! {
    /// As the scene's parts, and polyhedra of up to 24 faces in a pool.
    enum Pool<S> {
        Cylinder(Cylinder<S>),
        Cuboid(Cuboid<S>),
        Sphere(Sphere<S>),
        Faces(Pooled<S, 24>),
    }
}

scancsg::leaves! {
    /// The same, each with room for its faces.
    enum Own<S> {
        Cylinder(Cylinder<S>),
        Cuboid(Cuboid<S>),
        Sphere(Sphere<S>),
        Faces(Polyhedron<S, 24>),
    }
}

/// Of 64 parts, four have 24 faces.
#[test]
fn a_pool_of_faces_needs_memory_for_those_only() {
    let own = bytes_of::<Program<Own<f32>, 64>>();
    let pool = bytes_of::<Program<Pool<f32>, 64, 0, 32, 96>>();
    let none = bytes_of::<Program<Pool<f32>, 64>>();
    let without = bytes_of::<Program<Part<f32>, 64>>();
    println!(
        "own faces: {own} bytes, a pool: {pool}, an empty one: {none}, no polyhedra: {without}"
    );
    assert_eq!(none, without, "a leaf in the pool takes no more than a box");
    assert_eq!((pool - none).div_ceil(96), 58, "a face");
    assert!(pool <= 17_400 && own > 4 * pool, "{pool}, {own}");
}

/// The document's table names what there is, and never less.
#[test]
fn solids_need_no_more_than_the_document_says() {
    let document = include_str!("../docs/sizes.md");
    for Kind { name, number, bytes } in KINDS {
        let start = format!("| `{name}` | {number} |");
        let row = document.lines().find(|line| line.starts_with(&start));
        let cells = row.unwrap_or_else(|| panic!("docs/sizes.md has no {name} in {number}"));
        let said: Vec<usize> =
            cells.split('|').filter_map(|cell| cell.trim().parse().ok()).collect();
        assert_eq!(said.len(), bytes.len(), "{cells}");
        let is_enough = bytes.iter().zip(&said).all(|(bytes, said)| bytes <= said);
        assert!(is_enough, "{name}, {number}: {bytes:?}; `cargo xtask sizes --overwrite`");
    }
}
