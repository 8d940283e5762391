//! The device as firmware: renders `tee`, sends it through the board's serial port and repairs it,
//! until the other end has all of it.
//!
//! It computes in `f32` where that is in hardware, and in fixed point elsewhere; `--cfg number="f32"`
//! and `--cfg number="i16f16"` among the compiler's flags choose. What it has to say goes to the
//! debugger's console, so that the serial line is the picture's alone.

use crate::board::{self, Uart, Usage};
use crate::device::{Delivery, Line, send_frame};
use crate::scene::{Scene, Tee};
use core::convert::Infallible;
use scancsg::render::{Gray8, Lambert, Picture, PixelFormat, Size};
use scancsg::stream::{Sender, packet_capacity};

const WIDTH: u16 = 160;
const HEIGHT: u16 = 120;
const PACKET: usize = packet_capacity(WIDTH, PixelFormat::Gray8);
/// How often a frame is sent to somebody who doesn't answer.
const FRAMES: u16 = 4;

#[cfg(any(number = "f32", all(target_abi = "eabihf", not(number = "i16f16"))))]
type Number = f32;
#[cfg(not(any(number = "f32", all(target_abi = "eabihf", not(number = "i16f16")))))]
type Number = scancsg::scalar::I16F16;

static TEE: Tee<Number> = Number::TEE;

impl Line for Uart {
    fn listen(&mut self) -> Result<Option<u8>, Infallible> {
        // Some ten to thirty instructions a look: about a second on these boards.
        Ok((0..500_000).find_map(|_| self.receive()))
    }
}

fn send() -> Option<Delivery> {
    let camera = Number::orthographic().ok()?;
    let light = Lambert::new(Number::TO_LIGHT, Number::hundredths(15)).ok()?;
    let size = Size::new(WIDTH, HEIGHT).ok()?;
    let picture = Picture::new(&TEE, &camera, size, light, Gray8(0));
    let mut pixels = [Gray8(0); WIDTH as usize];
    let mut sender = Sender::<_, PACKET>::new(Uart::new());
    let mut delivery = Delivery::Unheard;
    for frame in 0..FRAMES {
        delivery = send_frame(&picture, frame, &mut sender, &mut pixels).ok()?;
        if delivery == Delivery::Acknowledged {
            break;
        }
    }
    Some(delivery)
}

#[board::entry]
fn main() -> ! {
    board::paint();
    let delivery = send();
    let Usage { stack, room } = Usage::measure();
    board::say("stack ");
    board::say_number(stack as u32);
    board::say(" of ");
    board::say_number(room as u32);
    board::say("\n");
    board::exit(delivery == Some(Delivery::Acknowledged))
}
