//! A board of yours: its serial port.

use embedded_io::{Read, ReadReady, Write};

/// The serial port, switched on: 115,200 baud, 8 data bits, no parity. Your HAL's will do; or
/// implement the three traits on its registers, as `uart.rs` does.
pub fn uart() -> impl Read + ReadReady + Write {
    compile_error!("examples/board/yours.rs: return your board's serial port here");
}
