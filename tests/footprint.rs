//! The memory that a render needs: the figures of the README.

#![allow(clippy::unwrap_used)]

#[path = "../examples/scene/mod.rs"]
mod scene;

use scene::{Scene, Tee};

use core::mem::size_of_val;
use scancsg::geom::Rays;
use scancsg::render::{Camera, Gray8, Lambert, Picture, Size};
use scancsg::scalar::I16F16;
use scancsg::solid::Scan;
use scancsg::stream::{PixelFormat, packet_capacity};

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
    assert!(fixed <= 3584, "{fixed}");
    assert_eq!(packet_capacity(160, PixelFormat::Gray8), 172);
}
