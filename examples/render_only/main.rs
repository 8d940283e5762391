//! Renders `tee`, and nothing else. As firmware its size is what rendering costs in flash: start-up,
//! scene, camera, rows, shading.

#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../board/mod.rs"]
mod board;
#[path = "../scene/mod.rs"]
mod scene;

use scancsg::Error;
use scancsg::render::{Gray8, Lambert, Picture, Size};
use scene::{Scene, Tee};

#[cfg(any(number = "f32", all(target_abi = "eabihf", not(number = "i16f16"))))]
type Number = f32;
#[cfg(not(any(number = "f32", all(target_abi = "eabihf", not(number = "i16f16")))))]
type Number = scancsg::scalar::I16F16;

const WIDTH: u16 = 160;
const HEIGHT: u16 = 120;

static TEE: Tee<Number> = Number::TEE;

/// The sum of all levels of the picture.
fn brightness() -> Result<u32, Error> {
    let camera = Number::orthographic()?;
    let light = Lambert::new(Number::TO_LIGHT, Number::hundredths(15))?;
    let size = Size::new(WIDTH, HEIGHT)?;
    let mut picture = Picture::new(&TEE, &camera, size, light, Gray8(0));
    let mut row = [Gray8(0); WIDTH as usize];
    let mut sum = 0;
    for y in 0..HEIGHT {
        picture.scanline(y)?.render(&mut row)?;
        sum += row.iter().map(|pixel| u32::from(pixel.0)).sum::<u32>();
    }
    Ok(sum)
}

#[cfg(target_os = "none")]
#[board::entry]
fn main() -> ! {
    let is_seen = brightness().is_ok_and(|sum| sum > 0);
    loop {
        board::finish(is_seen);
    }
}

#[cfg(not(target_os = "none"))]
fn main() {
    match brightness() {
        Ok(sum) => println!("{sum} levels of grey in all"),
        Err(error) => println!("{error}"),
    }
}
