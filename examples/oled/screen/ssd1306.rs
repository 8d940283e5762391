//! The SSD1306, a controller of small displays with two colours, as far as pictures need it.

#![allow(dead_code)] // every user takes what it needs

use embedded_io::Write;
use scancsg::render::{Mono, RowSource};

/// Dots in a row, and rows.
pub const WIDTH: u16 = 128;
pub const HEIGHT: u16 = 64;
/// Rows in a page: a byte is eight dots, the uppermost one its lowest bit.
const PAGE: u16 = 8;
/// What comes before commands, and before dots.
const COMMANDS: u8 = 0x00;
const DOTS: u8 = 0x40;

/// Switches the display on: all rows from the upper left corner on, addresses that run through all pages
/// (SSD1306 data sheet, chapters 9 and 10).
#[rustfmt::skip]
const START: [u8; 16] = [
    COMMANDS,
    0xAE,             // off
    0xA8, 63,         // 64 rows
    0x20, 0x00,       // from page to page
    0x21, 0, 127,     // all columns
    0x22, 0, 7,       // all pages
    0xA1, 0xC8,       // the connector is at the top
    0x8D, 0x14,       // its own charge pump
];
/// Switches it on.
const ON: [u8; 2] = [COMMANDS, 0xAF];

/// Why nothing is shown.
#[derive(Debug)]
pub enum ShowError<E> {
    /// There is no picture.
    Picture(scancsg::Error),
    /// The bus takes no more.
    Bus(E),
}

/// The display at the end of a bus, on which each `write_all` is one message. With a HAL's I²C that is
/// `i2c.write(0x3C, bytes)`.
pub struct Ssd1306<W> {
    bus: W,
}

impl<W: Write> Ssd1306<W> {
    /// The display, switched on.
    pub fn new(mut bus: W) -> Result<Self, ShowError<W::Error>> {
        for message in [&START[..], &ON[..]] {
            bus.write_all(message).map_err(ShowError::Bus)?;
        }
        Ok(Self { bus })
    }

    /// Shows a picture, page by page: all memory is that of one row and one page.
    pub fn show(
        &mut self,
        picture: &mut impl RowSource<Pixel = Mono>,
    ) -> Result<(), ShowError<W::Error>> {
        let mut row = [Mono(false); WIDTH as usize];
        for first in (0..HEIGHT).step_by(usize::from(PAGE)) {
            let mut message = [0; 1 + WIDTH as usize];
            let [start, dots @ ..] = &mut message;
            *start = DOTS;
            for bit in 0..PAGE {
                let rendered = picture.render(first + bit, &mut row);
                rendered.map_err(|error| ShowError::Picture(error.into()))?;
                for (dots, Mono(is_lit)) in dots.iter_mut().zip(row) {
                    *dots |= u8::from(is_lit) << bit;
                }
            }
            self.bus.write_all(&message).map_err(ShowError::Bus)?;
        }
        self.bus.flush().map_err(ShowError::Bus)
    }
}

/// What the display shows after these messages, `#` for a lit dot.
#[cfg(not(target_os = "none"))]
pub fn dots(bus: &[u8]) -> String {
    let pages = bus.get(START.len() + ON.len()..).unwrap_or_default();
    let mut text = String::new();
    for message in pages.chunks_exact(1 + usize::from(WIDTH)) {
        for bit in 0..PAGE {
            let of_row = message.iter().skip(1).map(|dots| dots >> bit & 1 == 1);
            text.extend(of_row.map(|is_lit| if is_lit { '#' } else { '.' }));
            text.push('\n');
        }
    }
    text
}
