//! A picture as a file of grey values (PGM) through GPIO 0 of a Raspberry Pi Pico, once after each start: with
//! RTIC, a row is rendered at the lowest priority while DMA sends the one before.
//!
//! The host needs no program of its own:
//!
//! ```text
//! stty -F /dev/ttyUSB0 115200 raw
//! head -c 19215 /dev/ttyUSB0 > part.pgm      # and start the board
//! ```

#![no_std]
#![no_main]

use panic_halt as _;
use rp2040_hal as hal;

use hal::Clock;
use hal::dma::{
    self, DMAExt, SingleChannel,
    single_buffer::{Config, Transfer},
};
use hal::gpio::{
    FunctionUart, Pin, PullDown,
    bank0::{Gpio0, Gpio1},
};
use hal::pac;
use hal::uart::{UartConfig, UartPeripheral, Writer};
use scancsg::render::{Lambert, Picture, RowSource, Size};
use scancsg::scalar::I16F16;
use scene::{Scene, Tee};

/// The part and its camera: put your own here.
#[path = "../../../../examples/scene/mod.rs"]
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
/// What a file of 160×120 grey values begins with.
const HEADER: &[u8; 15] = b"P5 160 120 255\n";

pub type Row = &'static mut [[u8; 1]; WIDTH];
type Channel = dma::Channel<dma::CH0>;
type Pins = (Pin<Gpio0, FunctionUart, PullDown>, Pin<Gpio1, FunctionUart, PullDown>);
type Port = Writer<pac::UART0, Pins>;

/// What the line does: whoever sends owns the row.
pub enum Line {
    Rests(Channel, Port),
    Sends(Transfer<Channel, Row, Port>),
}

#[rtic::app(device = pac)]
mod app {
    use super::*;

    #[shared]
    struct Shared {
        /// A row that is rendered, and waits for the line.
        full: Option<Row>,
        /// A row that was sent.
        empty: Option<Row>,
    }

    #[local]
    struct Local {
        line: Option<Line>,
        first: Row,
    }

    #[init(local = [one: [[u8; 1]; WIDTH] = [[0]; WIDTH], other: [[u8; 1]; WIDTH] = [[0]; WIDTH]])]
    fn init(context: init::Context) -> (Shared, Local) {
        let shared = Shared { full: None, empty: Some(context.local.other) };
        // What fails here fails at every start. This panic handler stops; others show the sentence.
        let line = open(context.device).unwrap_or_else(|why| panic!("{why}"));
        (shared, Local { line: Some(line), first: context.local.one })
    }

    /// Renders, whenever nothing else is to be done.
    #[idle(shared = [full, empty], local = [first])]
    fn idle(mut context: idle::Context) -> ! {
        let rendered = render(context.local.first, |row| {
            context.shared.full.lock(|full| *full = Some(row));
            // The line may be at rest.
            rtic::pend(pac::Interrupt::DMA_IRQ_0);
            // To sleep here would be wrong: the interrupt may have been already.
            loop {
                if let Some(row) = context.shared.empty.lock(Option::take) {
                    break row;
                }
            }
        });
        rendered.unwrap_or_else(|error| panic!("{}", error.as_str()));
        loop {
            core::hint::spin_loop();
        }
    }

    /// Gives the next row to DMA: when one has been sent, and when one has been rendered.
    #[task(binds = DMA_IRQ_0, shared = [full, empty], local = [line])]
    fn send(mut context: send::Context) {
        let (channel, port) = match context.local.line.take() {
            Some(Line::Sends(transfer)) if !transfer.is_done() => {
                *context.local.line = Some(Line::Sends(transfer));
                return;
            }
            Some(Line::Sends(mut transfer)) => {
                transfer.check_irq0();
                let (channel, row, port) = transfer.wait();
                context.shared.empty.lock(|empty| *empty = Some(row));
                (channel, port)
            }
            Some(Line::Rests(channel, port)) => (channel, port),
            None => return,
        };
        *context.local.line = Some(match context.shared.full.lock(Option::take) {
            Some(row) => Line::Sends(Config::new(channel, row, port).start()),
            None => Line::Rests(channel, port),
        });
    }
}

/// Renders all rows. `next` takes one that is rendered, and gives another.
fn render(mut row: Row, mut next: impl FnMut(Row) -> Row) -> Result<(), scancsg::Error> {
    let camera = I16F16::orthographic()?;
    let light = Lambert::new(I16F16::TO_LIGHT, I16F16::hundredths(15))?;
    let mut picture = Picture::new(&TEE, &camera, Size::new(WIDTH as u16, HEIGHT)?, light, [0]);
    for y in 0..HEIGHT {
        picture.render(y, row)?;
        row = next(row);
    }
    Ok(())
}

/// The serial port, which has sent the header, and a channel that interrupts when it is done.
fn open(mut chip: pac::Peripherals) -> Result<Line, &'static str> {
    let mut watchdog = hal::Watchdog::new(chip.WATCHDOG);
    let (xosc, resets) = (chip.XOSC, &mut chip.RESETS);
    let clocks = hal::clocks::init_clocks_and_plls(
        CRYSTAL,
        xosc,
        chip.CLOCKS,
        chip.PLL_SYS,
        chip.PLL_USB,
        resets,
        &mut watchdog,
    );
    let clocks = clocks.map_err(|_| "the clocks don't start")?;
    let sio = hal::Sio::new(chip.SIO);
    let pins = hal::gpio::Pins::new(chip.IO_BANK0, chip.PADS_BANK0, sio.gpio_bank0, resets);
    let pins = (pins.gpio0.into_function(), pins.gpio1.into_function());
    let uart = UartPeripheral::new(chip.UART0, pins, resets);
    let uart = uart.enable(UartConfig::default(), clocks.peripheral_clock.freq());
    let uart = uart.map_err(|_| "the serial port can't have this rate")?;
    uart.write_full_blocking(HEADER);
    let mut channel = chip.DMA.split(resets).ch0;
    channel.enable_irq0();
    let (_, port) = uart.split();
    Ok(Line::Rests(channel, port))
}
