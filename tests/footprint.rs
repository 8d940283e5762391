//! The memory that a render needs: the figures of the README.

#![allow(clippy::unwrap_used)]

#[path = "../examples/scene/mod.rs"]
mod scene;

use core::mem::size_of_val;
use scancsg::render::{Gray8, Lambert, Picture, PixelFormat, Size};
use scancsg::solid::Shape;
use scancsg::span::SpanList;
use scancsg::stream::packet_capacity;

#[test]
fn a_render_of_tee_needs_little_memory() {
    let camera = scene::f32::orthographic().unwrap();
    let light = Lambert::new(scene::f32::TO_LIGHT, 0.15).unwrap();
    let size = Size::new(160, 120).unwrap();
    let picture = Picture::new(&scene::f32::TEE, &camera, size, light, Gray8(0));
    let scanline = picture.scanline(0).unwrap();
    let spans = SpanList::<f32, { <scene::Tee<f32> as Shape>::STACK }>::new();

    let sizes = [size_of_val(&picture), size_of_val(&scanline), size_of_val(&spans)];
    println!("picture, scanline, span list: {sizes:?} bytes");
    // Pointers are half as long on a microcontroller.
    assert!(sizes.iter().sum::<usize>() <= 2400, "{sizes:?}");
    assert_eq!(packet_capacity(160, PixelFormat::Gray8), 172);
}
