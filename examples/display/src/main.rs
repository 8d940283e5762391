//! A part beside text and shapes of `embedded-graphics`, as a device would show it.
//!
//! The upper display is one of colours, as a small TFT has them; the lower one is black and white, as an OLED
//! is. Both are simulated, and written into a PNG file:
//!
//! ```text
//! cargo run --package display -- display.png
//! ```

use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::{BinaryColor, Rgb565};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::{PrimitiveStyle, Rectangle};
use embedded_graphics::text::Text;
use embedded_graphics_simulator::{OutputSettingsBuilder, SimulatorDisplay};
use scancsg::constant;
use scancsg::geom::{Axis, vec3};
use scancsg::interop::embedded_graphics::draw;
use scancsg::render::{self, Bayer, Dithered, Gray8, Lambert, Mono, Perspective, Picture, Rgb};
use scancsg::solid::{Cylinder, Difference, Painted, Union};
use std::error::Error;

/// A knob: a disc with a hub, a bore and a mark.
type Knob = Difference<Union<Cylinder<f32>, Cylinder<f32>>, Painted<[Cylinder<f32>; 2]>>;

const KNOB: Knob = Difference::new(
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

/// Edges of the window that the part is drawn in.
const SIDE: u16 = 64;

fn camera() -> Result<Perspective<f32>, Box<dyn Error>> {
    let (eye, target, up) = (vec3(2.0, 3.0, 5.0), vec3(0.0, 0.1, 0.0), vec3(0.0, 1.0, 0.0));
    Ok(Perspective::look_at(eye, target, up, 0.4)?)
}

fn show_colors(display: &mut SimulatorDisplay<Rgb565>) -> Result<(), Box<dyn Error>> {
    let style = MonoTextStyle::new(&FONT_6X10, Rgb565::WHITE);
    Text::new("volume\n 42 dB", Point::new(76, 28), style).draw(display)?;
    let frame = PrimitiveStyle::with_stroke(Rgb565::CSS_STEEL_BLUE, 1);
    display.bounding_box().into_styled(frame).draw(display)?;

    let (size, light) = (render::Size::new(SIDE, SIDE)?, Lambert::new(vec3(-1.0, 2.0, 1.0), 0.2)?);
    let mut picture = Picture::new(&KNOB, &camera()?, size, light, Rgb565::BLACK);
    let mut row = [Rgb565::BLACK; SIDE as usize];
    let window = Rectangle::new(Point::new(2, 2), Size::new(66, 60));
    draw(&mut picture, Point::new(4, 0), &mut row, display, &window)?;
    Ok(())
}

fn show_dots(display: &mut SimulatorDisplay<BinaryColor>) -> Result<(), Box<dyn Error>> {
    let style = MonoTextStyle::new(&FONT_6X10, BinaryColor::On);
    Text::new("volume\n 42 dB", Point::new(76, 28), style).draw(display)?;

    let (size, light) = (render::Size::new(SIDE, SIDE)?, Lambert::new(vec3(-1.0, 2.0, 1.0), 0.2)?);
    let mut grey = Picture::new(&KNOB, &camera()?, size, light, Gray8(0));
    let (mut memory, mut row) = ([Gray8(0); SIDE as usize], [Mono(false); SIDE as usize]);
    let mut picture = Dithered::new(&mut grey, Bayer::Eight, &mut memory);
    let window = display.bounding_box();
    draw(&mut picture, Point::new(4, 0), &mut row, display, &window)?;
    Ok(())
}

/// What both displays show, one above the other.
fn shown() -> Result<SimulatorDisplay<embedded_graphics::pixelcolor::Rgb888>, Box<dyn Error>> {
    let size = Size::new(128, 64);
    let mut colors = SimulatorDisplay::new(size);
    show_colors(&mut colors)?;
    let mut dots = SimulatorDisplay::new(size);
    show_dots(&mut dots)?;

    let mut both = SimulatorDisplay::new(Size::new(128, 130));
    let area = Rectangle::new(Point::zero(), size);
    both.fill_contiguous(&area, area.points().map(|at| colors.get_pixel(at).into()))?;
    let below = area.translate(Point::new(0, 66));
    both.fill_contiguous(&below, area.points().map(|at| dots.get_pixel(at).into()))?;
    Ok(both)
}

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).unwrap_or_else(|| "display.png".to_owned());
    let settings = OutputSettingsBuilder::new().scale(3).build();
    shown()?.to_rgb_output_image(&settings).save_png(&path)?;
    println!("{path}: both displays");
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use embedded_graphics::pixelcolor::Rgb888;

    /// How many pixels of an area aren't black.
    fn lit(display: &SimulatorDisplay<Rgb888>, corner: [i32; 2], size: [u32; 2]) -> usize {
        let area = Rectangle::new(corner.into(), size.into());
        area.points().filter(|at| display.get_pixel(*at) != Rgb888::BLACK).count()
    }

    #[test]
    fn the_part_stands_beside_the_text() -> Result<(), Box<dyn Error>> {
        let shown = shown()?;
        for top in [0, 66] {
            // Half of the dots and more are dark.
            assert!(lit(&shown, [4, top + 2], [64, 60]) > 400);
            assert!(lit(&shown, [76, top + 18], [40, 24]) > 100);
            assert_eq!(lit(&shown, [70, top + 44], [50, 16]), 0);
        }
        assert_eq!(lit(&shown, [0, 64], [128, 2]), 0);
        Ok(())
    }
}
