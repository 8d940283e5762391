//! Whole pictures, each as functions that render it, or some of it.

use crate::parts::Number;
use crate::scene::housing::{Housing, HousingScene};
use crate::scene::plate::{Plate, PlateScene};
use crate::scene::{Scene, Tee};
use core::hint::black_box;
use core::iter::StepBy;
use core::ops::Range;
use scancsg::geom::{RayRow, Rays};
use scancsg::render::{Camera, Gray8, Lambert, Picture, Size};
use scancsg::scalar::{Number as _, Scalar as _};
use scancsg::solid::{Cuboid, Cylinder, Seen, Shape, Solid, first_seen};
use scancsg::span::{Face, SpanList};

/// A picture: its view alone, its view and the row that the argument says, and all of it, or one row of so
/// many as the argument says.
pub struct Frame {
    pub name: &'static str,
    pub view: extern "C" fn(u32),
    pub row: extern "C" fn(u32),
    pub frame: extern "C" fn(u32),
    /// The pixel of the middle row that the argument says, by asking every primitive about its line, as
    /// about any line; what is done once for a picture is done as well, and alone for a column beyond.
    pub naive: extern "C" fn(u32),
}

pub const WIDTH: u16 = 160;
pub const HEIGHT: u16 = 120;

/// The centre of a pixel, in half pixels from the middle of the picture.
fn from_middle(index: u16, count: u16) -> i32 {
    2 * i32::from(index) + 1 - i32::from(count)
}

pub fn light() -> Option<Lambert<Number>> {
    Lambert::new(Number::TO_LIGHT, Number::hundredths(15)).ok()
}

// The functions are named one by one, for `cargo xtask profile`.
macro_rules! frames {
    ($(
        $(#[$condition:meta])?
        $name:literal: $Part:ty = $part:expr, $camera:ident,
        $rows:ident, $view:ident, $row:ident, $frame:ident, $naive:ident;
    )+) => {
        pub const FRAMES: &[Frame] =
            &[$($(#[$condition])? Frame {
                name: $name, view: $view, row: $row, frame: $frame, naive: $naive,
            },)+];

        $(
            $(#[$condition])?
            #[inline(never)]
            fn $rows(rows: StepBy<Range<u16>>) {
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
                $rows((0..0).step_by(1));
            }

            $(#[$condition])?
            #[inline(never)]
            extern "C" fn $row(y: u32) {
                let y = y as u16;
                $rows((y..y + 1).step_by(1));
            }

            $(#[$condition])?
            #[inline(never)]
            extern "C" fn $frame(every: u32) {
                $rows((0..HEIGHT).step_by(every.max(1) as usize));
            }

            $(#[$condition])?
            #[inline(never)]
            extern "C" fn $naive(x: u32) {
                static PART: $Part = $part;
                let (Ok(camera), Ok(size)) = (Number::$camera(), Size::new(WIDTH, HEIGHT)) else { return };
                let rays = black_box(&camera).rays(size);
                let lines = rays.row(from_middle(HEIGHT / 2, HEIGHT));
                let mut list = SpanList::<Number, { <$Part as Shape>::STACK }>::new();
                let to_light = black_box(Number::TO_LIGHT);
                if x < u32::from(WIDTH) {
                    let line = lines.line(from_middle(x as u16, WIDTH));
                    black_box(&PART).spans(&line, Face(0), &mut list.stack());
                    let seen = first_seen(list.as_slice(), rays.start());
                    black_box(seen.map(|Seen { t, face, inside }| {
                        let outward = PART.normal(face, line.at(t));
                        let cosine = outward.dot(to_light);
                        if inside { cosine.negated() } else { cosine }.to_level()
                    }));
                }
            }
        )+
    };
}

frames! {
    "orthographic": Tee<Number> = Number::TEE, orthographic,
        orthographic_rows, orthographic_view, orthographic_row, orthographic_frame, orthographic_naive;
    "perspective": Tee<Number> = Number::TEE, perspective,
        perspective_rows, perspective_view, perspective_row, perspective_frame, perspective_naive;
    "housing": Housing<Number> = Number::HOUSING, orthographic,
        housing_rows, housing_view, housing_row, housing_frame, housing_naive;
    "box": Cuboid<Number> = Number::BOX, orthographic,
        box_rows, box_view, box_row, box_frame, box_naive;
    "cylinder": Cylinder<Number> = Number::ROD, orthographic,
        rod_rows, rod_view, rod_row, rod_frame, rod_naive;
    "plate of 1 hole": Plate<Number, 1> = Number::PLATE, orthographic,
        plate_1_rows, plate_1_view, plate_1_row, plate_1_frame, plate_1_naive;
    "plate of 4 holes": Plate<Number, 4> = Number::PLATE, orthographic,
        plate_4_rows, plate_4_view, plate_4_row, plate_4_frame, plate_4_naive;
    "plate of 16 holes": Plate<Number, 16> = Number::PLATE, orthographic,
        plate_16_rows, plate_16_view, plate_16_row, plate_16_frame, plate_16_naive;
    // With its 65 cylinders, a picture doesn't fit 16 KB of RAM.
    #[cfg(not(board = "microbit"))]
    "plate of 64 holes": Plate<Number, 64> = Number::PLATE, orthographic,
        plate_64_rows, plate_64_view, plate_64_row, plate_64_frame, plate_64_naive;
}
