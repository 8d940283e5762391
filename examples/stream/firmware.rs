//! The device as firmware: renders `tee`, sends it through the board's serial port and repairs it,
//! until the other end has all of it.
//!
//! It computes in `f32` where that is in hardware, and in fixed point elsewhere; `--cfg number="f32"`
//! and `--cfg number="i16f16"` among the compiler's flags choose. What it has to say goes to the
//! debugger's console, and with the feature `defmt` to its log, so that the serial line is the
//! picture's alone.

use crate::board::{self, Usage, log};
use crate::scene::{Scene, Tee};
use embedded_io::{Error, ErrorKind, Read, ReadReady, Write};
use number::Number;
use scancsg::render::{
    CameraError, Gray8, Lambert, Picture, RowError, ShadeError, Size, SizeError,
};
use scancsg::stream::{
    Delivery, Looks, Patience, PixelFormat, Predictive, Sender, ServeError, packet_capacity, serve,
};

const WIDTH: u16 = 160;
const HEIGHT: u16 = 120;
const PACKET: usize = packet_capacity(WIDTH, PixelFormat::Gray8);
/// How often a frame is sent to somebody who doesn't read it or doesn't answer. An emulated board's
/// seconds can be short, and its host busy.
const FRAMES: u16 = 12;

#[cfg(any(number = "f32", all(target_abi = "eabihf", not(number = "i16f16"))))]
mod number {
    pub type Number = f32;
    pub const NAME: &str = "f32";
}
#[cfg(not(any(number = "f32", all(target_abi = "eabihf", not(number = "i16f16")))))]
mod number {
    pub type Number = scancsg::scalar::I16F16;
    pub const NAME: &str = "I16F16";
}

static TEE: Tee<Number> = Number::TEE;

/// Some ten to thirty instructions a look: about three seconds on these boards.
const PATIENCE: Patience = Patience { ticks: 500_000, silences: 3 };

/// Why the picture was not delivered.
#[derive(Clone, Copy)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(not(feature = "defmt"), allow(dead_code))] // the console is told less than the log
enum Failure {
    Camera(CameraError),
    Light(ShadeError),
    Size(SizeError),
    Row(RowError),
    Line(ErrorKind),
    Sender(&'static str),
    Unheard,
}

impl Failure {
    fn from<E: Error>(error: &ServeError<E>) -> Self {
        match error {
            ServeError::Render(error) => Self::Row(*error),
            ServeError::Write(error) | ServeError::Read(error) => Self::Line(error.kind()),
            _ => Self::Sender(error.as_str()),
        }
    }

    const fn as_str(self) -> &'static str {
        match self {
            Self::Line(ErrorKind::TimedOut) => "nobody reads\n",
            Self::Unheard => "nobody answers\n",
            _ => "the picture can't be sent\n",
        }
    }
}

fn send(line: &mut (impl Read + ReadReady + Write)) -> Result<(), Failure> {
    log!(info, "{=u16}x{=u16} pixels in {=str}", WIDTH, HEIGHT, number::NAME);
    let camera = Number::orthographic().map_err(Failure::Camera)?;
    let light = Lambert::new(Number::TO_LIGHT, Number::hundredths(15)).map_err(Failure::Light)?;
    let size = Size::new(WIDTH, HEIGHT).map_err(Failure::Size)?;
    let mut picture = Picture::new(&TEE, &camera, size, light, Gray8(0));
    let mut pixels = [Gray8(0); WIDTH as usize];
    let mut sender =
        Sender::<_, PACKET>::new(Predictive::<Gray8, { WIDTH as usize }>::new(), PATIENCE);
    let mut outcome = Err(Failure::Unheard);
    for frame in 0..FRAMES {
        let before = sender.bytes_sent();
        let delivery =
            serve(&mut picture, frame, &mut sender, line, &mut pixels, &mut Looks::new());
        let bytes = sender.bytes_sent().wrapping_sub(before);
        let failure = match delivery {
            Ok(Delivery::Acknowledged { repairs }) => {
                log!(
                    info,
                    "frame {=u16}: {=u16} rows, {=u64} bytes, {=u16} repairs",
                    frame,
                    HEIGHT,
                    bytes,
                    repairs
                );
                return Ok(());
            }
            Ok(Delivery::Unheard) => Failure::Unheard,
            Err(error) => Failure::from(&error),
        };
        // The frame is dropped, and the next one begins anew.
        log!(warn, "frame {=u16}: {} after {=u64} bytes", frame, failure, bytes);
        outcome = Err(failure);
    }
    outcome
}

#[board::entry]
fn main() -> ! {
    board::paint();
    let mut port = board::uart();
    loop {
        let outcome = send(&mut port);
        let Usage { stack, room } = Usage::measure();
        log!(info, "stack: {=usize} of {=usize} bytes", stack, room);
        board::say("stack ");
        board::say_number(stack as u32);
        board::say(" of ");
        board::say_number(room as u32);
        board::say("\n");
        if let Err(why) = outcome {
            board::say(why.as_str());
        }
        board::finish(outcome.is_ok());
    }
}
