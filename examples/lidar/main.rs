//! A lidar: a ring of beams, each a single ray, among cylinders that move from frame to frame.
//!
//! As firmware it sends eight bytes for each beam through the board's serial port: the bits of the
//! distance and of the strength, little-endian, or all ones where nothing is met. A host prints them.

#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../board/mod.rs"]
mod board;
mod world;

#[cfg(any(number = "f32", all(target_abi = "eabihf", not(number = "i16f16"))))]
type Number = f32;
#[cfg(not(any(number = "f32", all(target_abi = "eabihf", not(number = "i16f16")))))]
type Number = scancsg::scalar::I16F16;

#[cfg(target_os = "none")]
#[board::entry]
fn main() -> ! {
    let is_sent = world::sent::<Number>(&mut board::uart()).is_ok();
    loop {
        board::finish(is_sent);
    }
}

#[cfg(not(target_os = "none"))]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    for frame in 0..world::FRAMES {
        let things = world::things::<Number>(frame)?;
        print!("{frame:2}:");
        for index in 0..world::BEAMS {
            match world::measured(&things, world::beam(index))? {
                Some(echo) => print!(" {:.2}", echo.distance),
                None => print!(" -"),
            }
        }
        println!();
    }
    Ok(())
}
