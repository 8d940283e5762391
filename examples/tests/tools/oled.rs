//! What is on the bus, as a display would understand it.

#[path = "../../oled/screen/mod.rs"]
mod screen;

use scancsg::render::{Bayer, Gray8, Mono, Picture, RowSource};
use scancsg::scalar::I16F16;
use screen::part::Part;
use screen::ssd1306::{self, HEIGHT, WIDTH};

#[test]
fn each_dot_is_that_of_the_picture() {
    let mut bus = Vec::new();
    screen::show::<I16F16, _>(&I16F16::CRANKSHAFT, &mut bus).unwrap();
    let (camera, size, light) = screen::seen::<I16F16>().unwrap();
    let mut picture = Picture::new(&I16F16::CRANKSHAFT, &camera, size, light, Gray8(0));
    let mut row = [Gray8(0); WIDTH as usize];
    let mut want = String::new();
    for y in 0..HEIGHT {
        picture.render(y, &mut row).unwrap();
        let dots = (0..).zip(row).map(|(x, grey)| Bayer::Eight.dithered(x, y, grey));
        want.extend(dots.map(|Mono(is_lit)| if is_lit { '#' } else { '.' }));
        want.push('\n');
    }
    let lit = want.matches('#').count();
    assert!((500..4000).contains(&lit), "{lit} dots are lit");
    assert_eq!(ssd1306::dots(&bus), want);
    // Two messages of commands, and one for each page of 8 rows.
    assert_eq!(bus.len(), 16 + 2 + 8 * 129);
}
