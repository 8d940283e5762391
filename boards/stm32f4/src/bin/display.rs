//! A part on a display of 240×240 pixels (ST7789, or ILI9341) at SPI1: half of a row is rendered while DMA
//! sends the other half. All memory for pixels is one row.

#![no_std]
#![no_main]

use core::mem::swap;
use embassy_executor::Spawner;
use embassy_futures::join::join;
use embassy_stm32::gpio::{Level, Output, Speed};
use embassy_stm32::mode::Async;
use embassy_stm32::spi::{Config, Spi, mode::Master};
use embassy_stm32::time::Hertz;
use embassy_stm32::{bind_interrupts, dma, peripherals};
use embassy_time::Timer;
use panic_halt as _;
use scancsg::Error;
use scancsg::interop::DisplayError;
use scancsg::render::{Lambert, Picture, Rgb565Be, RunSource, Size};
use scene::{Scene, Tee};

/// The part and its camera: put your own here.
#[path = "../../../../examples/scene/mod.rs"]
mod scene;

bind_interrupts!(struct Interrupts {
    DMA2_STREAM3 => dma::InterruptHandler<peripherals::DMA2_CH3>;
});

static TEE: Tee<f32> = f32::TEE;

const SIDE: u16 = 240;
const HALF: u16 = SIDE / 2;

/// A display's command, its parameters, and how long it takes in milliseconds.
const START: [(u8, &[u8], u64); 7] = [
    (0x01, &[], 150),                      // reset
    (0x11, &[], 120),                      // wake up
    (0x3A, &[0x55], 0),                    // 16 bits a pixel
    (0x21, &[], 0),                        // ST7789: colours are inverted. ILI9341: 0x20
    (0x2A, &[0, 0, 0, SIDE as u8 - 1], 0), // columns
    (0x2B, &[0, 0, 0, SIDE as u8 - 1], 0), // rows
    (0x29, &[], 0),                        // on
];
/// Pixels follow.
const PIXELS: u8 = 0x2C;

struct Display {
    spi: Spi<'static, Async, Master>,
    is_data: Output<'static>,
}

impl Display {
    async fn command(&mut self, command: u8, parameters: &[u8]) -> Result<(), DisplayError> {
        self.is_data.set_low();
        self.write(&[command]).await?;
        self.is_data.set_high();
        if parameters.is_empty() { Ok(()) } else { self.write(parameters).await }
    }

    async fn write(&mut self, bytes: &[u8]) -> Result<(), DisplayError> {
        self.spi.write(bytes).await.map_err(|_| DisplayError::Draw)
    }
}

#[embassy_executor::main]
async fn main(_spawner: Spawner) {
    let chip = embassy_stm32::init(Default::default());
    let mut config = Config::default();
    config.frequency = Hertz(8_000_000);
    let spi = Spi::new_txonly(chip.SPI1, chip.PA5, chip.PA7, chip.DMA2_CH3, Interrupts, config);
    let is_data = Output::new(chip.PC7, Level::Low, Speed::VeryHigh);
    // The display is the only one on its bus: it is always selected.
    let _select = Output::new(chip.PB6, Level::Low, Speed::Low);
    // What fails here fails at every start. This panic handler stops; others show the sentence.
    if let Err(error) = run(Display { spi, is_data }).await {
        panic!("{}", error.as_str());
    }
}

async fn run(mut display: Display) -> Result<(), Error> {
    for (command, parameters, milliseconds) in START {
        display.command(command, parameters).await?;
        Timer::after_millis(milliseconds).await;
    }
    let camera = f32::orthographic()?;
    let light = Lambert::new(f32::TO_LIGHT, f32::hundredths(15))?;
    let size = Size::new(SIDE, SIDE)?;
    show(&mut Picture::new(&TEE, &camera, size, light, [0; 2]), &mut display).await
}

/// Renders a half of a row while the other is sent.
async fn show(
    picture: &mut impl RunSource<Pixel = Rgb565Be>,
    display: &mut Display,
) -> Result<(), Error> {
    let mut halves = [[[0; 2]; HALF as usize]; 2];
    let [one, other] = &mut halves;
    let (mut full, mut empty) = (one, other);
    let mut ready = 0;
    display.command(PIXELS, &[]).await?;
    for y in 0..SIDE {
        for columns in [0..HALF, HALF..SIDE] {
            // The transfer begins, goes on during the rendering, and is waited for.
            let sent = full.as_flattened().get(..ready).unwrap_or_default();
            let rendering = async { picture.render_run(y, columns, empty) };
            let (written, rendered) = join(display.write(sent), rendering).await;
            written?;
            rendered?;
            swap(&mut full, &mut empty);
            ready = full.as_flattened().len();
        }
    }
    Ok(display.write(full.as_flattened()).await?)
}
