//! What the display shows: `tee`, in dots.

use super::scene::{Scene, Tee};
use super::ssd1306::{HEIGHT, ShowError, Ssd1306, WIDTH};
use embedded_io::Write;
use scancsg::geom::OrthographicRays;
use scancsg::render::{Bayer, Dithered, Gray8, Lambert, Orthographic, Picture, Size};
use scancsg::solid::Scan;

/// Shows the part on a display at the end of a bus.
pub fn show<S: Scene, W: Write>(part: &Tee<S>, bus: W) -> Result<(), ShowError<W::Error>>
where
    Tee<S>: Scan<OrthographicRays<S>, Scalar = S>,
{
    let (camera, size, light) = seen::<S>().map_err(ShowError::Picture)?;
    let mut grey = Picture::new(part, &camera, size, light, Gray8(0));
    let mut memory = [Gray8(0); WIDTH as usize];
    Ssd1306::new(bus)?.show(&mut Dithered::new(&mut grey, Bayer::Eight, &mut memory))
}

/// From where the part is seen, how large, and in which light.
fn seen<S: Scene>() -> Result<(Orthographic<S>, Size, Lambert<S>), scancsg::Error> {
    let light = Lambert::new(S::TO_LIGHT, S::hundredths(15))?;
    Ok((S::orthographic()?, Size::new(WIDTH, HEIGHT)?, light))
}
