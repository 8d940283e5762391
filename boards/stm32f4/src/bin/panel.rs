//! A part of one's own on a display of one's own, through its driver and `embedded-graphics`: an ST7789 at SPI1
//! of a NUCLEO-F411RE. Text and shapes of `embedded-graphics` can stand beside it.

#![no_std]
#![no_main]

use embassy_stm32::gpio::{Level, Output, Speed};
use embassy_stm32::spi::{Config, Spi};
use embassy_time::Delay;
use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
use embedded_hal_bus::spi::ExclusiveDevice;
use mipidsi::{Builder, interface::SpiInterface, models::ST7789, options::ColorInversion};
use panic_halt as _;
use scancsg::{geom::vec3, interop::embedded_graphics::show};

mod part {
    use scancsg::constant;
    use scancsg::geom::Axis;
    use scancsg::solid::{Cylinder, Difference, Painted, Rgb, Union};

    /// A disc with a hub, a bore and a mark.
    type Knob = Difference<Union<Cylinder<f32>, Cylinder<f32>>, Painted<[Cylinder<f32>; 2]>>;

    pub static KNOB: Knob = Difference::new(
        Union::new(
            constant!(Cylinder::<f32>::spanning(Axis::Y, -0.4..0.0, [0.0, 0.0], 1.0)),
            constant!(Cylinder::<f32>::spanning(Axis::Y, 0.0..0.6, [0.0, 0.0], 0.7)),
        ),
        Painted::new(
            constant![
                Cylinder::<f32>::spanning(Axis::Y, -1.0..1.0, [0.0, 0.0], 0.25),
                Cylinder::<f32>::spanning(Axis::Y, 0.5..1.0, [0.0, 0.5], 0.1),
            ],
            Rgb::new(235, 175, 70),
        ),
    );
}

#[embassy_executor::main]
async fn main(_spawner: embassy_executor::Spawner) {
    let chip = embassy_stm32::init(Default::default());
    let bus = Spi::new_blocking_txonly(chip.SPI1, chip.PA5, chip.PA7, Config::default());
    let select = Output::new(chip.PB6, Level::High, Speed::VeryHigh);
    let is_data = Output::new(chip.PC7, Level::Low, Speed::VeryHigh);
    let Ok(device) = ExclusiveDevice::new_no_delay(bus, select);
    let mut bytes = [0; 480];
    let panel = Builder::new(ST7789, SpiInterface::new(device, is_data, &mut bytes));
    let panel = panel.display_size(240, 240).invert_colors(ColorInversion::Inverted);
    let Ok(mut panel) = panel.init(&mut Delay) else { panic!("the display doesn't start") };
    let seen = [vec3(-2.0, -2.9, -5.0), vec3(0.0, 1.0, 0.0)]; // along, up
    let shown = show(&part::KNOB, seen, Rgb565::BLACK, &mut [Rgb565::BLACK; 240], &mut panel);
    shown.unwrap_or_else(|error| panic!("{}", error.as_str()));
}
