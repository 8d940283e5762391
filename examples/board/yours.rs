//! A board of yours: its serial port.

use embedded_io::{Read, ReadReady, Write};

/// The serial port, switched on: 115,200 baud, 8 data bits, no parity. Your HAL's will do; or
/// implement the three traits on its registers, as `uart.rs` does.
///
/// For a Cortex-M3 with Arm's PL011, which has a crate:
///
/// ```ignore
/// use arm_pl011_uart::{DataBits, LineConfig, PL011Registers, Parity, StopBits, Uart};
/// let registers = core::ptr::without_provenance_mut::<PL011Registers>(0x4000_C000);
/// // SAFETY: the UART's registers are here, and nothing else uses them.
/// let registers = unsafe { core::ptr::NonNull::new_unchecked(registers) };
/// // SAFETY: as above.
/// let mut uart = Uart::new(unsafe { arm_pl011_uart::UniqueMmioPointer::new(registers) });
/// let (data_bits, parity, stop_bits) = (DataBits::Bits8, Parity::None, StopBits::One);
/// let _ = uart.enable(LineConfig { data_bits, parity, stop_bits }, 115_200, 12_500_000); // 12.5 MHz
/// uart
/// ```
pub fn uart() -> impl Read + ReadReady + Write {
    compile_error!("examples/board/yours.rs: return your board's serial port here");
}
