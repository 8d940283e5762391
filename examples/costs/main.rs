//! Firmware that renders `tee`, and by Cargo feature uses one thing besides: what that costs in flash is the
//! difference. `cargo xtask sizes` measures it.

#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../board/mod.rs"]
mod board;
#[path = "../scene/mod.rs"]
mod scene;
mod uses;

#[cfg(any(number = "f32", all(target_abi = "eabihf", not(number = "i16f16"))))]
type Number = f32;
#[cfg(not(any(number = "f32", all(target_abi = "eabihf", not(number = "i16f16")))))]
type Number = scancsg::scalar::I16F16;

#[cfg(target_os = "none")]
#[board::entry]
fn main() -> ! {
    let is_seen = uses::all::<Number>().is_ok_and(|sum| sum > 0);
    board::log!(info, "something is seen: {=bool}", is_seen);
    loop {
        board::finish(is_seen);
    }
}

#[cfg(not(target_os = "none"))]
fn main() {
    println!("{:?}", uses::all::<Number>());
}
