//! What the display shows, and how it gets there.

pub mod part;
pub mod ssd1306;

use embedded_io::Write;
use part::{Crankshaft, Part};
use scancsg::geom::{OrthographicRays, Vec3};
use scancsg::render::{Bayer, Dithered, Gray8, Lambert, Orthographic, Picture, Size};
use scancsg::solid::Scan;
use ssd1306::{HEIGHT, ShowError, Ssd1306, WIDTH};

/// Shows the part on a display at the end of a bus.
pub fn show<S: Part, W: Write>(part: &Crankshaft<S>, bus: W) -> Result<(), ShowError<W::Error>>
where
    Crankshaft<S>: Scan<OrthographicRays<S>, Scalar = S>,
{
    let (camera, size, light) = seen::<S>().map_err(ShowError::Picture)?;
    let mut grey = Picture::new(part, &camera, size, light, Gray8(0));
    let mut memory = [Gray8(0); WIDTH as usize];
    Ssd1306::new(bus)?.show(&mut Dithered::new(&mut grey, Bayer::Eight, &mut memory))
}

/// From where the part is seen, how large, and in which light.
pub fn seen<S: Part>() -> Result<(Orthographic<S>, Size, Lambert<S>), scancsg::Error> {
    let up = Vec3::new(S::ZERO, S::ONE, S::ZERO);
    let camera = Orthographic::look_at(S::EYE, Vec3::ZERO, up, S::HEIGHT)?;
    let light = Lambert::new(S::TO_LIGHT, S::AMBIENT)?;
    Ok((camera, Size::new(WIDTH, HEIGHT)?, light))
}
