//! A picture as a file of grey values (PGM) through the serial port of an nRF52840 DK, once after each reset:
//! a row is rendered while DMA sends the one before.
//!
//! The host needs no program of its own:
//!
//! ```text
//! stty -F /dev/ttyACM0 115200 raw
//! head -c 19215 /dev/ttyACM0 > part.pgm      # and press RESET
//! ```

#![no_std]
#![no_main]

use core::mem::swap;
use embassy_executor::Spawner;
use embassy_futures::join::join;
use embassy_nrf::uarte::{Baudrate, Config, InterruptHandler, UarteTx};
use embassy_nrf::{bind_interrupts, peripherals};
use panic_halt as _;
use scancsg::Error;
use scancsg::render::{Lambert, Picture, RowSource, Size};
use scancsg::stream::LinkError;
use scene::{Scene, Tee};

/// The part and its camera: put your own here.
#[path = "../../../../examples/scene/mod.rs"]
mod scene;

bind_interrupts!(struct Interrupts {
    UARTE0 => InterruptHandler<peripherals::UARTE0>;
});

static TEE: Tee<f32> = f32::TEE;

const WIDTH: usize = 160;
const HEIGHT: u16 = 120;
/// What a file of 160×120 grey values begins with.
const HEADER: &[u8; 15] = b"P5 160 120 255\n";

#[embassy_executor::main]
async fn main(_spawner: Spawner) {
    let chip = embassy_nrf::init(Default::default());
    let mut config = Config::default();
    config.baudrate = Baudrate::Baud115200;
    let mut line = UarteTx::new(chip.UARTE0, Interrupts, chip.P0_06, config);
    // What fails here fails at every start. This panic handler stops; others show the sentence.
    if let Err(error) = run(&mut line).await {
        panic!("{}", error.as_str());
    }
}

async fn run(line: &mut UarteTx<'_>) -> Result<(), Error> {
    let camera = f32::orthographic()?;
    let light = Lambert::new(f32::TO_LIGHT, f32::hundredths(15))?;
    let size = Size::new(WIDTH as u16, HEIGHT)?;
    line.write(HEADER).await.map_err(|_| LinkError::Write)?;
    send(&mut Picture::new(&TEE, &camera, size, light, [0]), line).await
}

/// Renders a row while the one before is sent.
async fn send(
    picture: &mut impl RowSource<Pixel = [u8; 1]>,
    line: &mut UarteTx<'_>,
) -> Result<(), Error> {
    let mut rows = [[[0]; WIDTH]; 2];
    let [one, other] = &mut rows;
    let (mut full, mut empty) = (one, other);
    picture.render(0, full)?;
    for y in 1..HEIGHT {
        // The transfer begins, goes on during the rendering, and is waited for.
        let rendering = async { picture.render(y, empty) };
        let (written, rendered) = join(line.write(full.as_flattened()), rendering).await;
        written.map_err(|_| LinkError::Write)?;
        rendered?;
        swap(&mut full, &mut empty);
    }
    line.write(full.as_flattened()).await.map_err(|_| LinkError::Write)?;
    Ok(())
}
