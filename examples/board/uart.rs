//! The emulated boards' serial ports, polled: 115,200 baud, 8 data bits, no parity.

use core::ptr;
use embedded_io::ErrorKind;

/// So many looks at a line that takes no byte, and it has failed: about a minute on a core of 16 MHz,
/// and ten seconds or more in an emulator. Until it takes a byte again, a hundredth of that is enough.
const PATIENCE: u32 = 1 << 26;

/// The board's serial port.
pub struct Uart {
    /// The first byte need not wait for one before it.
    has_sent: bool,
    has_failed: bool,
}

/// The board's serial port, switched on.
pub fn uart() -> Uart {
    port::start();
    Uart { has_sent: false, has_failed: false }
}

impl Uart {
    /// Waits until the line has taken the byte before, but not for ever.
    fn wait(&mut self) -> Result<(), ErrorKind> {
        let looks = if self.has_failed { PATIENCE / 100 } else { PATIENCE };
        self.has_failed = self.has_sent && !(0..looks).any(|_| port::can_send());
        if self.has_failed { Err(ErrorKind::TimedOut) } else { Ok(()) }
    }
}

impl embedded_io::ErrorType for Uart {
    type Error = ErrorKind;
}

impl embedded_io::Write for Uart {
    fn write(&mut self, bytes: &[u8]) -> Result<usize, ErrorKind> {
        let Some(byte) = bytes.first() else { return Ok(0) };
        self.wait()?;
        port::send(*byte);
        self.has_sent = true;
        Ok(1)
    }

    fn flush(&mut self) -> Result<(), ErrorKind> {
        self.wait()
    }
}

impl embedded_io::ReadReady for Uart {
    fn read_ready(&mut self) -> Result<bool, ErrorKind> {
        Ok(port::has_received())
    }
}

impl embedded_io::Read for Uart {
    fn read(&mut self, bytes: &mut [u8]) -> Result<usize, ErrorKind> {
        let Some(byte) = bytes.first_mut() else { return Ok(0) };
        while !port::has_received() {}
        *byte = port::receive();
        Ok(1)
    }
}

/// A device register of 32 bits, or of 8.
struct Register<T>(usize, core::marker::PhantomData<T>);

impl<T: Copy> Register<T> {
    const fn at(address: usize) -> Self {
        Self(address, core::marker::PhantomData)
    }

    fn read(&self) -> T {
        // SAFETY: the addresses below are the device registers of the board that `cfg(board)` names.
        unsafe { ptr::read_volatile(self.0 as *const T) }
    }

    fn write(&self, value: T) {
        // SAFETY: as above.
        unsafe { ptr::write_volatile(self.0 as *mut T, value) }
    }
}

/// nRF51 UART0 (nRF51 Series Reference Manual, chapter 29).
#[cfg(board = "microbit")]
mod port {
    use super::Register;

    const START_RECEIVING: Register<u32> = Register::at(0x4000_2000);
    const START_SENDING: Register<u32> = Register::at(0x4000_2008);
    const RECEIVED: Register<u32> = Register::at(0x4000_2108);
    const SENT: Register<u32> = Register::at(0x4000_211C);
    const ENABLE: Register<u32> = Register::at(0x4000_2500);
    const TRANSMIT_PIN: Register<u32> = Register::at(0x4000_250C);
    const RECEIVE_PIN: Register<u32> = Register::at(0x4000_2514);
    const RECEIVE: Register<u32> = Register::at(0x4000_2518);
    const TRANSMIT: Register<u32> = Register::at(0x4000_251C);
    const BAUD_RATE: Register<u32> = Register::at(0x4000_2524);

    pub fn start() {
        // The pins to the micro:bit's USB interface.
        TRANSMIT_PIN.write(24);
        RECEIVE_PIN.write(25);
        BAUD_RATE.write(0x01D7_E000); // 115,200
        ENABLE.write(4);
        START_SENDING.write(1);
        START_RECEIVING.write(1);
    }

    /// Only true after a byte has been sent.
    pub fn can_send() -> bool {
        SENT.read() != 0
    }

    pub fn send(byte: u8) {
        SENT.write(0);
        TRANSMIT.write(byte.into());
    }

    pub fn has_received() -> bool {
        RECEIVED.read() != 0
    }

    pub fn receive() -> u8 {
        // Before the byte is read: reading lets the next one in, which sets it again.
        RECEIVED.write(0);
        RECEIVE.read() as u8
    }
}

/// Arm PrimeCell UART, PL011 (Arm DDI 0183).
#[cfg(board = "lm3s6965")]
mod port {
    use super::Register;

    const DATA: Register<u32> = Register::at(0x4000_C000);
    const FLAGS: Register<u32> = Register::at(0x4000_C018);
    const BAUD_WHOLE: Register<u32> = Register::at(0x4000_C024);
    const BAUD_FRACTION: Register<u32> = Register::at(0x4000_C028);
    const LINE_CONTROL: Register<u32> = Register::at(0x4000_C02C);
    const CONTROL: Register<u32> = Register::at(0x4000_C030);
    /// Clock gates of the LM3S6965: the UART's and its pins'.
    const CLOCK_UART: Register<u32> = Register::at(0x400F_E104);
    const CLOCK_PINS: Register<u32> = Register::at(0x400F_E108);
    const RECEIVE_EMPTY: u32 = 1 << 4;
    const TRANSMIT_FULL: u32 = 1 << 5;

    pub fn start() {
        CLOCK_UART.write(CLOCK_UART.read() | 1);
        CLOCK_PINS.write(CLOCK_PINS.read() | 1);
        CONTROL.write(0);
        // 12.5 MHz / (16 · 115,200) = 6 + 50/64.
        BAUD_WHOLE.write(6);
        BAUD_FRACTION.write(50);
        LINE_CONTROL.write(0x70); // 8 bits, with FIFO
        CONTROL.write(0x301); // transmit and receive
    }

    pub fn can_send() -> bool {
        FLAGS.read() & TRANSMIT_FULL == 0
    }

    pub fn send(byte: u8) {
        DATA.write(byte.into());
    }

    pub fn has_received() -> bool {
        FLAGS.read() & RECEIVE_EMPTY == 0
    }

    pub fn receive() -> u8 {
        DATA.read() as u8
    }
}

/// Arm CMSDK APB UART (Arm DDI 0479, chapter 4.3), at its secure address on AN505.
#[cfg(any(board = "an386", board = "an505"))]
mod port {
    use super::Register;

    #[cfg(board = "an386")]
    const BASE: usize = 0x4000_4000;
    #[cfg(board = "an505")]
    const BASE: usize = 0x5020_0000;
    const DATA: Register<u32> = Register::at(BASE);
    const STATE: Register<u32> = Register::at(BASE + 4);
    const CONTROL: Register<u32> = Register::at(BASE + 8);
    const BAUD_DIVIDER: Register<u32> = Register::at(BASE + 0x10);
    const TRANSMIT_FULL: u32 = 1;
    const RECEIVE_FULL: u32 = 2;

    pub fn start() {
        BAUD_DIVIDER.write(217); // 25 MHz / 115,200
        CONTROL.write(3); // transmit and receive
    }

    pub fn can_send() -> bool {
        STATE.read() & TRANSMIT_FULL == 0
    }

    pub fn send(byte: u8) {
        DATA.write(byte.into());
    }

    pub fn has_received() -> bool {
        STATE.read() & RECEIVE_FULL != 0
    }

    pub fn receive() -> u8 {
        DATA.read() as u8
    }
}

/// NS16550A of QEMU's `virt`, which needs no set-up; resetting its FIFO would lose what the other end
/// sent before the start.
#[cfg(board = "virt")]
mod port {
    use super::Register;

    const DATA: Register<u8> = Register::at(0x1000_0000);
    const LINE_STATUS: Register<u8> = Register::at(0x1000_0005);
    const DATA_READY: u8 = 1;
    const TRANSMIT_EMPTY: u8 = 0x20;

    pub fn start() {}

    pub fn can_send() -> bool {
        LINE_STATUS.read() & TRANSMIT_EMPTY != 0
    }

    pub fn send(byte: u8) {
        DATA.write(byte);
    }

    pub fn has_received() -> bool {
        LINE_STATUS.read() & DATA_READY != 0
    }

    pub fn receive() -> u8 {
        DATA.read()
    }
}

/// No board is chosen, and mod.rs says so: one error is enough.
#[cfg(not(any(
    board = "microbit",
    board = "lm3s6965",
    board = "an386",
    board = "an505",
    board = "virt"
)))]
mod port {
    pub fn start() {}

    pub fn can_send() -> bool {
        true
    }

    pub fn send(_: u8) {}

    pub fn has_received() -> bool {
        false
    }

    pub fn receive() -> u8 {
        0
    }
}
