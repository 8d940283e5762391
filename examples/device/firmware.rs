//! The loop of the device.
//!
//! It computes in `f32` where that is in hardware, and in fixed point elsewhere; `--cfg number="f32"`
//! and `--cfg number="i16f16"` among the compiler's flags choose.

use crate::board::{self, Usage, log};
use crate::part::{BYTES, Leaf, Part};
use crate::scene::Scene;
use crate::scene::fit::Fit;
use embedded_io::{Read, ReadReady, Write};
use number::{Number, ONE};
use scancsg::Error;
use scancsg::constant;
use scancsg::geom::Vec3;
use scancsg::render::{Gray8, Lambert, Picture, Size};
use scancsg::solid::{Solid, Sphere};
use scancsg::stream::{
    Delivery, Inbox, Looks, Patience, PixelFormat, Predictive, Refusal, Sender, packet_capacity,
    serve, take,
};

const WIDTH: u16 = 160;
const HEIGHT: u16 = 120;
const PACKET: usize = packet_capacity(WIDTH, PixelFormat::Gray8);

#[cfg(any(number = "f32", all(target_abi = "eabihf", not(number = "i16f16"))))]
mod number {
    pub type Number = f32;
    pub const ONE: Number = 1.0;
    /// The number type, as in a program's header.
    pub const CODE: u8 = 32;
}
#[cfg(not(any(number = "f32", all(target_abi = "eabihf", not(number = "i16f16")))))]
mod number {
    pub type Number = scancsg::scalar::I16F16;
    pub const ONE: Number = Number::ONE;
    /// The number type, as in a program's header.
    pub const CODE: u8 = 16;
}

/// Some ten to thirty instructions a look: about three seconds on these boards.
const PATIENCE: Patience = Patience { ticks: 500_000, silences: 3 };

type Device = Sender<Predictive<Gray8, { WIDTH as usize }>, PACKET>;

/// Sends the picture of a part. An error if the part has none: it has no end, or is too far away.
#[inline(never)]
fn show(
    part: &Part<Number>,
    frame: u16,
    sender: &mut Device,
    line: &mut (impl Read + ReadReady + Write),
) -> Result<&'static str, Error> {
    let fit = Fit::of(&part.bounds()).ok_or(Refusal::Invalid)?;
    let camera = fit.orthographic(None)?;
    let light = Lambert::new(Fit::to_light(), Number::hundredths(15))?;
    let size = Size::new(WIDTH, HEIGHT)?;
    let mut picture = Picture::new(part, &camera, size, light, Gray8(0));
    let mut row = [Gray8(0); WIDTH as usize];
    Ok(match serve(&mut picture, frame, sender, line, &mut row, &mut Looks::new()) {
        Ok(Delivery::Acknowledged { .. }) => "a picture was sent\n",
        Ok(Delivery::Unheard) => "nobody answers\n",
        Err(_) => "the picture can't be sent\n",
    })
}

/// What a program has before a part has come: there is none without a solid.
const BALL: Sphere<Number> = constant!(Sphere::<Number>::new(Vec3::ZERO, ONE));

/// Waits for a part, and sends its picture.
fn answer(
    inbox: &mut Inbox<'_>,
    part: &mut Part<Number>,
    frame: u16,
    sender: &mut Device,
    line: &mut (impl Read + ReadReady + Write),
) -> &'static str {
    let said = match take(inbox, line, &mut Looks::new()) {
        Ok(bytes) => match part.read_bytes(bytes) {
            Ok(()) => show(part, frame, sender, line).map_err(|_| Refusal::Invalid),
            Err(error) => Err(error.into()),
        },
        Err(_) => return "the line failed\n",
    };
    said.unwrap_or_else(|why| {
        inbox.refuse(why);
        "a part was refused\n"
    })
}

#[board::entry]
fn main() -> ! {
    board::paint();
    let mut line = board::uart();
    let mut memory = [0; BYTES];
    let mut inbox = Inbox::new(&mut memory, number::CODE);
    let mut part = Part::new(Leaf::Sphere(BALL));
    let mut sender = Device::new(Predictive::new(), PATIENCE);
    let mut frame = 0;
    loop {
        let said = answer(&mut inbox, &mut part, frame, &mut sender, &mut line);
        frame = frame.wrapping_add(1);
        let Usage { stack, room } = Usage::measure();
        log!(info, "{=str} stack: {=usize} of {=usize} bytes", said, stack, room);
        board::say(said);
        board::say("stack ");
        board::say_number(stack as u32);
        board::say(" of ");
        board::say_number(room as u32);
        board::say("\n");
    }
}
