//! A part on a display of 240×240 pixels (ST7789, or ILI9341) at SPI2 of an ESP32-C3: a row is rendered while
//! DMA sends the one before. Nothing is asynchronous: a transfer owns the port and its row, and gives both
//! back.

#![no_std]
#![no_main]

use esp_hal::delay::Delay;
use esp_hal::dma::DmaTxBuf;
use esp_hal::gpio::{Level, Output, OutputConfig};
use esp_hal::spi::master::{Config, Spi, SpiDma};
use esp_hal::time::Rate;
use esp_hal::{Blocking, dma_tx_buffer};
use panic_halt as _;
use scancsg::Error;
use scancsg::interop::DisplayError;
use scancsg::render::{Lambert, Picture, Rgb565Be, RowSource, Size};
use scancsg::scalar::I16F16;
use scene::{Scene, Tee};

/// The part and its camera: put your own here.
#[path = "../../../examples/scene/mod.rs"]
mod scene;

// What the boot loader reads of a program.
esp_bootloader_esp_idf::esp_app_desc!();

// The core has no floating point.
static TEE: Tee<I16F16> = I16F16::TEE;

const SIDE: u16 = 240;
const ROW_BYTES: usize = SIDE as usize * 2;

/// A display's command, its parameters, and how long it takes in milliseconds.
const START: [(u8, &[u8], u32); 7] = [
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

#[esp_hal::main]
fn main() -> ! {
    // What fails here fails at every start. This panic handler stops; others show the sentence.
    if let Err(error) = run() {
        panic!("{}", error.as_str());
    }
    // The display keeps what it shows.
    loop {
        core::hint::spin_loop();
    }
}

fn run() -> Result<(), Error> {
    // Errors of the port, too, are errors of the display.
    let chip = esp_hal::init(esp_hal::Config::default());
    let config = Config::default().with_frequency(Rate::from_mhz(40));
    let spi = Spi::new(chip.SPI2, config).map_err(|_| DisplayError::Draw)?;
    let mut spi = spi.with_sck(chip.GPIO6).with_mosi(chip.GPIO7);
    let mut is_data = Output::new(chip.GPIO10, Level::Low, OutputConfig::default());
    for (command, parameters, milliseconds) in START.into_iter().chain([(PIXELS, &[][..], 0)]) {
        is_data.set_low();
        spi.write(&[command]).map_err(|_| DisplayError::Draw)?;
        is_data.set_high();
        spi.write(parameters).map_err(|_| DisplayError::Draw)?;
        Delay::new().delay_millis(milliseconds);
    }
    // Only now: DMA can't read from flash, where the commands are.
    let spi = spi.with_dma(chip.DMA_CH0);
    let rows = [dma_tx_buffer!(ROW_BYTES), dma_tx_buffer!(ROW_BYTES)];
    let [Ok(one), Ok(other)] = rows else { return Err(DisplayError::Draw.into()) };

    let camera = I16F16::orthographic()?;
    let light = Lambert::new(I16F16::TO_LIGHT, I16F16::hundredths(15))?;
    let size = Size::new(SIDE, SIDE)?;
    show(&mut Picture::new(&TEE, &camera, size, light, [0; 2]), spi, [one, other])
}

/// Renders a row while the one before is sent.
fn show(
    picture: &mut impl RowSource<Pixel = Rgb565Be>,
    mut spi: SpiDma<'_, Blocking>,
    [mut full, mut empty]: [DmaTxBuf; 2],
) -> Result<(), Error> {
    picture.render(0, full.as_mut_slice().as_chunks_mut().0)?;
    for y in 1..SIDE {
        let transfer = spi.write_buffer(ROW_BYTES, full).map_err(|_| DisplayError::Draw)?;
        picture.render(y, empty.as_mut_slice().as_chunks_mut().0)?;
        let (port, sent) = transfer.wait();
        (spi, full, empty) = (port, empty, sent);
    }
    spi.write_buffer(ROW_BYTES, full).map_err(|_| DisplayError::Draw)?.wait();
    Ok(())
}
