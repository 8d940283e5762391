//! Whole pictures, each as functions that render it, or some of it.

use crate::parts::Number;
use crate::scene::plate::{Plate, PlateScene};
use crate::scene::{Scene, Tee};
use core::hint::black_box;
use core::ops::Range;
use scancsg::render::{Gray8, Lambert, Picture, Size};

/// A picture: its view alone, its view and the row that the argument says, and all of it.
pub struct Frame {
    pub name: &'static str,
    pub view: extern "C" fn(u32),
    pub row: extern "C" fn(u32),
    pub frame: extern "C" fn(u32),
}

pub const WIDTH: u16 = 160;
pub const HEIGHT: u16 = 120;

fn light() -> Option<Lambert<Number>> {
    Lambert::new(Number::TO_LIGHT, Number::hundredths(15)).ok()
}

// The functions are named one by one, for `cargo xtask profile`.
macro_rules! frames {
    ($(
        $(#[$condition:meta])?
        $name:literal: $Part:ty = $part:expr, $camera:ident,
        $rows:ident, $view:ident, $row:ident, $frame:ident;
    )+) => {
        pub const FRAMES: &[Frame] =
            &[$($(#[$condition])? Frame { name: $name, view: $view, row: $row, frame: $frame },)+];

        $(
            $(#[$condition])?
            #[inline(never)]
            fn $rows(rows: Range<u16>) {
                static PART: $Part = $part;
                let (Ok(camera), Some(light)) = (Number::$camera(), light()) else { return };
                let Ok(size) = Size::new(WIDTH, HEIGHT) else { return };
                let mut picture = Picture::new(&PART, black_box(&camera), size, light, Gray8(0));
                picture.prepare();
                let mut pixels = [Gray8(0); WIDTH as usize];
                for y in rows {
                    let _ = picture.scanline(y).and_then(|mut row| row.render(&mut pixels));
                    black_box(&pixels);
                }
                black_box(&picture);
            }

            $(#[$condition])?
            #[inline(never)]
            extern "C" fn $view(_: u32) {
                $rows(0..0);
            }

            $(#[$condition])?
            #[inline(never)]
            extern "C" fn $row(y: u32) {
                let y = y as u16;
                $rows(y..y + 1);
            }

            $(#[$condition])?
            #[inline(never)]
            extern "C" fn $frame(_: u32) {
                $rows(0..HEIGHT);
            }
        )+
    };
}

frames! {
    "orthographic": Tee<Number> = Number::TEE, orthographic,
        orthographic_rows, orthographic_view, orthographic_row, orthographic_frame;
    "perspective": Tee<Number> = Number::TEE, perspective,
        perspective_rows, perspective_view, perspective_row, perspective_frame;
    "plate of 4 holes": Plate<Number, 4> = Number::PLATE, orthographic,
        plate_4_rows, plate_4_view, plate_4_row, plate_4_frame;
    "plate of 16 holes": Plate<Number, 16> = Number::PLATE, orthographic,
        plate_16_rows, plate_16_view, plate_16_row, plate_16_frame;
    // With its 65 cylinders, a picture doesn't fit 16 KB of RAM.
    #[cfg(not(board = "microbit"))]
    "plate of 64 holes": Plate<Number, 64> = Number::PLATE, orthographic,
        plate_64_rows, plate_64_view, plate_64_row, plate_64_frame;
}
