//! The serial port: 115,200 baud, 8 bits, no parity.
//!
//! Put your HAL's port here: whatever implements `Read`, `ReadReady` and `Write` of `embedded-io` 0.7. As it
//! stands, it is that of a board which QEMU emulates (MPS2 AN386; its UART is Arm DDI 0479, chapter 4.3).

use core::convert::Infallible;
use embedded_io::{ErrorType, Read, ReadReady, Write};

/// The port, switched on.
pub fn open() -> impl Read + ReadReady + Write {
    CONTROL.write(3); // send and receive
    BAUD_DIVIDER.write(217); // 25 MHz / 115,200
    Port
}

struct Port;

impl ErrorType for Port {
    type Error = Infallible;
}

impl Write for Port {
    fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
        let Some(byte) = bytes.first() else { return Ok(0) };
        while STATE.read() & TRANSMIT_FULL != 0 {}
        DATA.write((*byte).into());
        Ok(1)
    }

    fn flush(&mut self) -> Result<(), Infallible> {
        while STATE.read() & TRANSMIT_FULL != 0 {}
        Ok(())
    }
}

impl ReadReady for Port {
    fn read_ready(&mut self) -> Result<bool, Infallible> {
        Ok(STATE.read() & RECEIVE_FULL != 0)
    }
}

impl Read for Port {
    fn read(&mut self, bytes: &mut [u8]) -> Result<usize, Infallible> {
        let Some(byte) = bytes.first_mut() else { return Ok(0) };
        while STATE.read() & RECEIVE_FULL == 0 {}
        *byte = DATA.read() as u8;
        Ok(1)
    }
}

const DATA: Register = Register(0x4000_4000);
const STATE: Register = Register(0x4000_4004);
const CONTROL: Register = Register(0x4000_4008);
const BAUD_DIVIDER: Register = Register(0x4000_4010);
const TRANSMIT_FULL: u32 = 1;
const RECEIVE_FULL: u32 = 2;

struct Register(usize);

impl Register {
    fn read(&self) -> u32 {
        // SAFETY: the constants above are the addresses of the UART's registers.
        unsafe { core::ptr::read_volatile(self.0 as *const u32) }
    }

    fn write(&self, value: u32) {
        // SAFETY: as above.
        unsafe { core::ptr::write_volatile(self.0 as *mut u32, value) }
    }
}
