//! A picture through the serial port of a NUCLEO-F411RE, which its USB port passes on: 115,200 baud.
//!
//! The sender is a future. While it waits for the line, other tasks run or the core sleeps.
//!
//! On the host: `cargo run --release --example view -- --port /dev/ttyACM0`.

#![no_std]
#![no_main]

use core::convert::Infallible;
use embassy_executor::Spawner;
use embassy_stm32::usart::{BufferedInterruptHandler, BufferedUart, Config};
use embassy_stm32::{bind_interrupts, peripherals};
use embassy_time::{Instant, Timer};
use panic_halt as _;
use scancsg::render::{Gray8, Lambert, Picture, Size};
use scancsg::stream::{AsyncClock, Patience, Predictive, Sender, serve_async};
use scene::{Scene, Tee};

/// The part and its camera: put your own here.
#[path = "../../../examples/scene/mod.rs"]
mod scene;

bind_interrupts!(struct Interrupts {
    USART2 => BufferedInterruptHandler<peripherals::USART2>;
});

static TEE: Tee<f32> = f32::TEE;

const WIDTH: usize = 160;
const HEIGHT: u16 = 120;
/// In milliseconds.
const PATIENCE: Patience = Patience { ticks: 1_000, silences: 3 };

/// Counts milliseconds.
struct Milliseconds;

impl AsyncClock for Milliseconds {
    fn now(&mut self) -> u32 {
        Instant::now().as_millis() as u32
    }

    async fn wait(&mut self, ticks: u32) {
        Timer::after_millis(ticks.into()).await;
    }
}

#[embassy_executor::main]
async fn main(_spawner: Spawner) {
    let chip = embassy_stm32::init(Default::default());
    let (mut to_send, mut received) = ([0; 256], [0; 64]);
    // A serial port with buffers: a read that is dropped loses nothing.
    let uart = BufferedUart::new(
        chip.USART2,
        chip.PA3,
        chip.PA2,
        &mut to_send,
        &mut received,
        Interrupts,
        Config::default(),
    );
    // What fails here fails at every start. This panic handler stops; others show the sentence.
    let Ok(uart) = uart else { panic!("the serial port can't have this rate") };
    let Err(error) = send(uart).await;
    panic!("{}", error.as_str());
}

async fn send(mut uart: BufferedUart<'_>) -> Result<Infallible, scancsg::Error> {
    let camera = f32::orthographic()?;
    let light = Lambert::new(f32::TO_LIGHT, f32::hundredths(15))?;
    let mut picture =
        Picture::new(&TEE, &camera, Size::new(WIDTH as u16, HEIGHT)?, light, Gray8(0));
    let mut row = [Gray8(0); WIDTH];
    let mut sender = Sender::<_, 256>::new(Predictive::<Gray8, WIDTH>::new(), PATIENCE);
    let mut frame = 0;
    loop {
        // A frame that was not delivered is dropped, and the next one begins anew.
        let _ =
            serve_async(&mut picture, frame, &mut sender, &mut uart, &mut row, &mut Milliseconds)
                .await;
        frame = frame.wrapping_add(1);
    }
}
