//! What the examples need of a board: a serial port, an instruction counter, the stack's high-water
//! mark, and a way to end.
//!
//! The board is chosen by `--cfg board="…"`, which `.cargo/config.toml` gives for each target. For a
//! board of yours, replace `memory.x` and [`Uart`]: your HAL's serial port will do.

#![allow(dead_code, unsafe_code)] // every example takes what it needs; registers are addresses

mod counter;
mod stack;
mod uart;

pub use counter::Counter;
pub use stack::{Usage, paint};
pub use uart::Uart;

#[cfg(target_arch = "arm")]
pub use cortex_m_rt::entry;
#[cfg(target_arch = "riscv32")]
pub use riscv_rt::entry;

#[cfg(not(any(
    board = "microbit",
    board = "lm3s6965",
    board = "an386",
    board = "an505",
    board = "virt"
)))]
compile_error!(
    "no board is chosen. .cargo/config.toml chooses one for each target by `--cfg board=\"…\"`: \
     microbit, lm3s6965, an386, an505 or virt. If it does, a RUSTFLAGS variable has replaced its \
     flags: use CARGO_TARGET_<TRIPLE>_RUSTFLAGS instead"
);

/// Writes text to the emulator's or the debugger's console.
pub fn say(text: &str) {
    use semihosting::io::Write;
    if let Ok(mut console) = semihosting::io::stderr() {
        let _ = console.write_all(text.as_bytes());
    }
}

/// Writes a number in decimal, without `core::fmt`.
pub fn say_number(number: u32) {
    let mut digits = [0; 10];
    let mut rest = number;
    let mut first = digits.len();
    for (place, digit) in digits.iter_mut().enumerate().rev() {
        *digit = b'0' + (rest % 10) as u8;
        rest /= 10;
        first = place;
        if rest == 0 {
            break;
        }
    }
    let digits = digits.get(first..).unwrap_or_default();
    say(core::str::from_utf8(digits).unwrap_or_default());
}

/// Ends the program, and with it the emulator.
pub fn exit(is_good: bool) -> ! {
    semihosting::process::exit(i32::from(!is_good))
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    say("panic\n");
    exit(false)
}
