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

fn size<S: Scene>() -> usize
where
    Tee<S>: Project<Parallel<S>, Scalar = S>,
{
    let camera = S::orthographic().unwrap();
    let light = Lambert::new(S::TO_LIGHT, S::hundredths(15)).unwrap();
    let size = Size::new(160, 120).unwrap();
    let tee = S::TEE;
    size_of_val(&Picture::new(&tee, &camera, size, light, Gray8(0)))
}

#[test]
fn a_render_of_tee_needs_little_memory() {
    let [single, fixed] = [size::<f32>(), size::<I16F16>()];
    println!("picture: {single} bytes in f32, {fixed} in I16F16");
    // Pointers are half as long on a microcontroller.
    assert!(single <= 1280, "{single}");
    assert!(fixed <= 2048, "{fixed}");
    assert_eq!(packet_capacity(160, PixelFormat::Gray8), 172);
}
