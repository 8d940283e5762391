//! Sends the picture of the part through the serial port, again and again.

#![no_std]
#![no_main]

use core::convert::Infallible;
use panic_halt as _;
use part::{WIDTH, picture};
use scancsg::render::Gray8;
use scancsg::stream::{Looks, Patience, Predictive, Sender, serve};

mod port;

/// Looks at the line that find nothing: about a second at 16 MHz, and three of them.
const PATIENCE: Patience = Patience { ticks: 500_000, silences: 3 };

#[cortex_m_rt::entry]
fn main() -> ! {
    let _ = run();
    // What fails at the start fails at every start: stop.
    loop {
        core::hint::spin_loop();
    }
}

fn run() -> Result<Infallible, scancsg::Error> {
    let mut line = port::open();
    let mut picture = picture()?;
    let mut row = [Gray8(0); WIDTH];
    let mut sender = Sender::<_, 256>::new(Predictive::<Gray8, WIDTH>::new(), PATIENCE);
    let mut frame = 0;
    loop {
        // A frame that was not delivered is dropped, and the next one begins anew.
        let _ = serve(&mut picture, frame, &mut sender, &mut line, &mut row, &mut Looks::new());
        frame = frame.wrapping_add(1);
    }
}
