//! What the examples need of a board: a serial port, a console, an instruction counter, the stack's
//! high-water mark, and a way to end.
//!
//! The board is chosen by `--cfg board="…"`, which `examples/build.rs` gives for each target. A board
//! of yours is `--cfg board="yours"`, which wins over that one: `yours.rs` is for its serial port, and
//! the top-level `memory.x` for its memory.

#![allow(dead_code, unused_imports, unused_macros)] // every example takes what it needs
#![allow(unsafe_code)] // registers are addresses

#[cfg_attr(board = "yours", path = "silent.rs")]
mod console;
mod counter;
mod log;
mod stack;
#[cfg_attr(board = "yours", path = "yours.rs")]
mod uart;

pub use console::{finish, say, say_number};
pub use counter::Counter;
pub(crate) use log::log;
pub use stack::{Usage, paint};
pub use uart::uart;

#[cfg(target_arch = "arm")]
pub use cortex_m_rt::entry;
#[cfg(target_arch = "riscv32")]
pub use riscv_rt::entry;

#[cfg(not(any(
    board = "microbit",
    board = "lm3s6965",
    board = "an386",
    board = "an505",
    board = "virt",
    board = "yours"
)))]
compile_error!(
    "no board is chosen, or none that is known. `examples/build.rs` chooses one for each target by \
     `--cfg board=\"…\"`: microbit, lm3s6965, an386, an505 or virt; \"yours\" is a board of yours \
     (README, \"On your board\")."
);
