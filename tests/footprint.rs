//! The memory that a render needs: the figures of the README.

#![allow(clippy::unwrap_used)]

#[path = "../examples/scene/mod.rs"]
mod scene;

use scene::{Scene, Tee};

use core::mem::size_of_val;
use scancsg::geom::Parallel;
use scancsg::render::{Gray8, Lambert, Picture, PixelFormat, Size};
use scancsg::scalar::I16F16;
use scancsg::solid::Project;
use scancsg::stream::packet_capacity;

fn sizes<S: Scene>() -> [usize; 2]
where
    Tee<S>: Project<Parallel<S>, Scalar = S>,
{
    let camera = S::orthographic().unwrap();
    let light = Lambert::new(S::TO_LIGHT, S::hundredths(15)).unwrap();
    let size = Size::new(160, 120).unwrap();
    let tee = S::TEE;
    let picture = Picture::new(&tee, &camera, size, light, Gray8(0));
    let scanline = picture.scanline(0).unwrap();
    [size_of_val(&picture), size_of_val(&scanline)]
}

#[test]
fn a_render_of_tee_needs_little_memory() {
    let [single, fixed] = [sizes::<f32>(), sizes::<I16F16>()];
    println!("picture, scanline: {single:?} bytes in f32, {fixed:?} in I16F16");
    // Pointers are half as long on a microcontroller.
    assert!(single.iter().sum::<usize>() <= 1900, "{single:?}");
    assert!(fixed.iter().sum::<usize>() <= 3400, "{fixed:?}");
    assert_eq!(packet_capacity(160, PixelFormat::Gray8), 172);
}
