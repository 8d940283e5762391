//! A picture through the serial port of a Raspberry Pi Pico: GPIO 0 sends, GPIO 1 receives, 115,200 baud.
//!
//! On the host: `cargo run --release --example view -- --port /dev/ttyUSB0`.

#![no_std]
#![no_main]

use core::convert::Infallible;
use panic_halt as _;
use rp2040_hal as hal;

use hal::Clock;
use hal::uart::{UartConfig, UartPeripheral};
use scancsg::render::{Gray8, Lambert, Picture, RowSource, Size};
use scancsg::scalar::I16F16;
use scancsg::stream::{Looks, Patience, Predictive, Sender, serve};
use scene::{Scene, Tee};

/// The part and its camera: put your own here.
#[path = "../../../examples/scene/mod.rs"]
mod scene;

/// The boot loader of the flash chip.
#[unsafe(link_section = ".boot2")]
#[used]
static BOOT2: [u8; 256] = rp2040_boot2::BOOT_LOADER_GENERIC_03H;

/// The crystal of the board, in hertz.
const CRYSTAL: u32 = 12_000_000;

static TEE: Tee<I16F16> = I16F16::TEE;

const WIDTH: usize = 160;
const HEIGHT: u16 = 120;
/// Looks at the line that find nothing: about a second, and three of them.
const PATIENCE: Patience = Patience { ticks: 2_000_000, silences: 3 };

#[hal::entry]
fn main() -> ! {
    // What fails here fails at every start. This panic handler stops; others show the sentence.
    let Err(why) = run();
    panic!("{why}")
}

/// What is sent.
fn picture() -> Result<impl RowSource<Pixel = Gray8>, scancsg::Error> {
    let camera = I16F16::orthographic()?;
    let light = Lambert::new(I16F16::TO_LIGHT, I16F16::hundredths(15))?;
    let size = Size::new(WIDTH as u16, HEIGHT)?;
    Ok(Picture::new(&TEE, &camera, size, light, Gray8(0)))
}

fn run() -> Result<Infallible, &'static str> {
    let mut chip = hal::pac::Peripherals::take().ok_or("the chip is taken")?;
    let mut watchdog = hal::Watchdog::new(chip.WATCHDOG);
    let (xosc, resets) = (chip.XOSC, &mut chip.RESETS);
    let clocks = hal::clocks::init_clocks_and_plls(
        CRYSTAL, xosc, chip.CLOCKS, chip.PLL_SYS, chip.PLL_USB, resets, &mut watchdog,
    );
    let clocks = clocks.map_err(|_| "the clocks don't start")?;
    let sio = hal::Sio::new(chip.SIO);
    let pins = hal::gpio::Pins::new(chip.IO_BANK0, chip.PADS_BANK0, sio.gpio_bank0, resets);
    let pins = (pins.gpio0.into_function(), pins.gpio1.into_function());
    // 115,200 baud, 8 bits, no parity, one stop bit.
    let config = UartConfig::default();
    let uart = UartPeripheral::new(chip.UART0, pins, resets);
    let uart = uart.enable(config, clocks.peripheral_clock.freq());
    let mut uart = uart.map_err(|_| "the serial port can't have this rate")?;

    let mut picture = picture().map_err(scancsg::Error::as_str)?;
    let mut row = [Gray8(0); WIDTH];
    let mut sender = Sender::<_, 256>::new(Predictive::<Gray8, WIDTH>::new(), PATIENCE);
    let mut frame = 0;
    loop {
        // A frame that was not delivered is dropped, and the next one begins anew.
        let _ = serve(&mut picture, frame, &mut sender, &mut uart, &mut row, &mut Looks::new());
        frame = frame.wrapping_add(1);
    }
}
