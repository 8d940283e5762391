//! The memory map is the HAL's.

fn main() {
    println!("cargo:rustc-link-arg-bins=-Tlinkall.x");
}
