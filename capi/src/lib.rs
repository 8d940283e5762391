//! scancsg for programs in C: a static library, and the header `include/scancsg.h`.
//!
//! A scene is built from a table, or from the bytes of a program. A picture of it renders rows into the
//! caller's bytes, and rows become packets of the link. Single rays ask the scene itself. The caller owns all
//! memory: there is no allocator and no global state.
//!
//! Every function returns a [`Status`](status::Status). `README.md` begins at the beginning.
//!
//! The number type is chosen when this library is built. One program computes in one of them, and the header
//! has each name once.

#![no_std]
// C passes pointers, and names of functions are the linker's. What pointers must be is checked, as far as it
// can be, in `border.rs`, and said in the header.
#![allow(unsafe_code)]

// Its panic handler. A board has the one below.
#[cfg(not(target_os = "none"))]
extern crate std;

mod border;
pub mod capacity;
mod lent;
pub mod number;
pub mod packet;
mod part;
pub mod picture;
pub mod pixels;
pub mod ray;
pub mod scene;
pub mod status;
pub mod table;

/// Nothing here panics, and so the linker drops this. The tests of firmware look for it.
#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
