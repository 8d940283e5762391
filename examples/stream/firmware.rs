//! The device: the smallest firmware that renders `tee`, sends it and repairs it.
//!
//! It is for no board in particular: it has no start-up code, and its serial port is two
//! addresses. So it is built and looked at, not run: `.ci/bare-metal` prints the sizes of its
//! sections and makes sure that no panic, no formatting, no allocator and no `f64` is in it.
//!
//! It computes in `f32` where that is in hardware, and in fixed point elsewhere; `--cfg number="f32"`
//! and `--cfg number="i16f16"` among the compiler's flags choose.

use crate::device::{Line, send_frame};
use crate::scene::{Scene, Tee};
use core::convert::Infallible;
use core::ptr;
use scancsg::render::{Gray8, Lambert, Picture, PixelFormat, Size};
use scancsg::solid::Shape;
use scancsg::span::SpanList;
use scancsg::stream::{Sender, packet_capacity};

const WIDTH: u16 = 160;
const HEIGHT: u16 = 120;
const SPANS: usize = Tee::<Number>::STACK;
const PACKET: usize = packet_capacity(WIDTH, PixelFormat::Gray8);

#[cfg(any(number = "f32", all(target_abi = "eabihf", not(number = "i16f16"))))]
type Number = f32;
#[cfg(not(any(number = "f32", all(target_abi = "eabihf", not(number = "i16f16")))))]
type Number = scancsg::scalar::I16F16;

static TEE: Tee<Number> = Number::TEE;

/// A serial port: a register to send, and one that holds a byte received, or more than 255.
struct Uart {
    transmit: *mut u32,
    receive: *const u32,
}

impl embedded_io::ErrorType for Uart {
    type Error = Infallible;
}

impl embedded_io::Write for Uart {
    fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
        for byte in bytes {
            // SAFETY: on a board, this is where its driver belongs; here it is never run.
            #[allow(unsafe_code)]
            unsafe {
                ptr::write_volatile(self.transmit, u32::from(*byte));
            }
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

impl Line for Uart {
    fn listen(&mut self) -> Result<Option<u8>, Infallible> {
        // SAFETY: as above.
        #[allow(unsafe_code)]
        let received = unsafe { ptr::read_volatile(self.receive) };
        Ok(u8::try_from(received).ok())
    }
}

fn render() -> Option<()> {
    let camera = Number::orthographic().ok()?;
    let light = Lambert::new(Number::TO_LIGHT, Number::hundredths(15)).ok()?;
    let size = Size::new(WIDTH, HEIGHT).ok()?;
    let picture = Picture::new(&TEE, &camera, size, light, Gray8(0));
    let mut spans = SpanList::<Number, SPANS>::new();
    let mut pixels = [Gray8(0); WIDTH as usize];
    let uart = Uart { transmit: 0x4000_C000 as *mut u32, receive: 0x4000_C004 as *const u32 };
    let mut sender = Sender::<_, PACKET>::new(uart);
    send_frame(&picture, 0, &mut sender, &mut spans, &mut pixels).ok().map(|_| ())
}

// SAFETY: the linker's entry point, and no other symbol of this name.
#[allow(unsafe_code)]
#[unsafe(no_mangle)]
extern "C" fn _start() -> ! {
    let _ = render();
    loop {}
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
