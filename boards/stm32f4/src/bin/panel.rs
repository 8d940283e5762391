//! A part of one's own on a display of one's own, through its driver and `embedded-graphics`: an ST7789 at SPI1
//! of a NUCLEO-F411RE. Text and shapes of `embedded-graphics` can stand beside it.

#![no_std]
#![no_main]

use embassy_stm32::gpio::{Level, Output, Speed};
use embassy_stm32::spi::{Config, Spi};
use embassy_time::Delay;
use embedded_graphics_core::{pixelcolor::Rgb565, prelude::*};
use embedded_hal_bus::spi::ExclusiveDevice;
use mipidsi::{Builder, interface::SpiInterface, models::ST7789, options::ColorInversion};
use panic_halt as _;
use scancsg::interop::embedded_graphics::draw;

/// The part, and how it is seen.
mod part {
    use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
    use scancsg::geom::{Axis, vec3};
    use scancsg::render::{Lambert, Perspective, Picture, RowSource, Size};
    use scancsg::solid::{Cylinder, Difference, Painted, Rgb, Union};
    use scancsg::{Error, constant};

    pub const SIDE: u16 = 240;

    /// A disc with a hub, a bore and a mark.
    type Knob = Difference<Union<Cylinder<f32>, Cylinder<f32>>, Painted<[Cylinder<f32>; 2]>>;

    static KNOB: Knob = Difference::new(
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

    pub fn picture() -> Result<impl RowSource<Pixel = Rgb565>, Error> {
        let (eye, target, up) = (vec3(2.0, 3.0, 5.0), vec3(0.0, 0.1, 0.0), vec3(0.0, 1.0, 0.0));
        let camera = Perspective::look_at(eye, target, up, 0.4)?;
        let light = Lambert::new(vec3(-1.0, 2.0, 1.0), 0.2)?;
        Ok(Picture::new(&KNOB, &camera, Size::new(SIDE, SIDE)?, light, Rgb565::BLACK))
    }
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
    let panel = panel.display_size(part::SIDE, part::SIDE).invert_colors(ColorInversion::Inverted);
    let Ok(mut panel) = panel.init(&mut Delay) else { return };
    let Ok(mut picture) = part::picture() else { return };
    let (mut row, window) = ([Rgb565::BLACK; part::SIDE as usize], panel.bounding_box());
    let _ = draw(&mut picture, Point::zero(), &mut row, &mut panel, &window);
}
