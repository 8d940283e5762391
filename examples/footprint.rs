//! The smallest firmware that renders `tee` and sends it: what the crate costs in flash.
//!
//! It is built for bare metal and looked at, not run: it has no start-up code, and its "UART" is
//! one address. `.ci/bare-metal` builds it, prints the sizes of its sections, and makes sure that
//! there is no panic, no formatting, no allocator and no `f64` in it. On a host it only says so.

#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
mod scene;

#[cfg(target_os = "none")]
mod firmware {
    use super::scene;
    use core::convert::Infallible;
    use scancsg::render::{Gray8, Lambert, Orthographic, Picture, PixelFormat, Size};
    use scancsg::solid::Shape;
    use scancsg::span::SpanList;
    use scancsg::stream::{FrameHeader, Sender, packet_capacity};

    const WIDTH: u16 = 160;
    const HEIGHT: u16 = 120;
    const SPANS: usize = <scene::Tee<f32> as Shape>::STACK;
    const PACKET: usize = packet_capacity(WIDTH, PixelFormat::Gray8);

    static TEE: scene::Tee<f32> = scene::f32::TEE;

    /// A transmit register.
    struct Uart(*mut u32);

    impl embedded_io::ErrorType for Uart {
        type Error = Infallible;
    }

    impl embedded_io::Write for Uart {
        fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
            for byte in bytes {
                // SAFETY: never run; on a board, this is where the UART's driver belongs.
                #[allow(unsafe_code)]
                unsafe {
                    self.0.write_volatile(u32::from(*byte));
                }
            }
            Ok(bytes.len())
        }

        fn flush(&mut self) -> Result<(), Infallible> {
            Ok(())
        }
    }

    fn render() -> Option<()> {
        let camera: Orthographic<f32> = scene::f32::orthographic().ok()?;
        let light = Lambert::new(scene::f32::TO_LIGHT, 0.15).ok()?;
        let size = Size::new(WIDTH, HEIGHT).ok()?;
        let picture = Picture::new(&TEE, &camera, size, light, Gray8(0));
        let mut spans = SpanList::<f32, SPANS>::new();
        let mut pixels = [Gray8(0); WIDTH as usize];
        let mut sender = Sender::<_, PACKET>::new(Uart(0x4000_C000 as *mut u32));
        let format = PixelFormat::Gray8;
        sender.begin(FrameHeader { frame: 0, width: WIDTH, height: HEIGHT, format }).ok()?;
        for scanline in picture.scanlines() {
            scanline.render(&mut spans, &mut pixels).ok()?;
            sender.row(scanline.y(), &pixels).ok()?;
        }
        sender.end().ok()
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
}

#[cfg(not(target_os = "none"))]
fn main() {
    println!("This example is for bare metal: see .ci/bare-metal.");
}
