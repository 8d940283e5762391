//! A frame of `tee`, coded for the link in packets of a few rows.

use crate::frames::{HEIGHT, WIDTH};
use crate::parts::Number;
use crate::scene::{Scene, Tee};
use core::hint::black_box;
use scancsg::render::{Gray8, Lambert, Palette, Picture, Size};
use scancsg::stream::{Coding, Predictive, RowCoding};

/// So many rows are a packet.
const ROWS: u16 = 6;
/// So many packets are a frame.
pub const PACKETS: u16 = HEIGHT / ROWS;

static TEE: Tee<Number> = Number::TEE;

/// Renders the rows of a packet, and gives them to `take`.
#[inline(always)]
fn rows(packet: u32, mut take: impl FnMut(&[Gray8])) {
    let (Ok(camera), Ok(light)) =
        (Number::orthographic(), Lambert::new(Number::TO_LIGHT, Number::hundredths(15)))
    else {
        return;
    };
    let Ok(size) = Size::new(WIDTH, HEIGHT) else { return };
    let mut picture = Picture::new(&TEE, black_box(&camera), size, light, Gray8(0));
    let mut pixels = [Gray8(0); WIDTH as usize];
    let first = packet as u16 * ROWS;
    for y in first..first + ROWS {
        let _ = picture.scanline(y).and_then(|mut row| row.render(&mut pixels));
        take(black_box(&pixels));
    }
}

/// Renders the rows of this packet.
#[inline(never)]
pub extern "C" fn rendered(packet: u32) {
    rows(packet, |_| {});
}

/// Renders the rows of this packet, and codes them.
#[inline(never)]
pub extern "C" fn coded(packet: u32) {
    let mut coding = Predictive::<Gray8, { WIDTH as usize }>::new();
    coding.begin_frame(&Palette::EMPTY);
    coding.begin();
    let mut payload = [0; 244];
    rows(packet, |pixels| {
        black_box(coding.push(pixels, &mut payload));
    });
    black_box(coding.finish(&mut payload));
}
