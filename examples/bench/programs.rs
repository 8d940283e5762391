//! Pictures of parts whose trees are built at run time, in RAM.

use crate::frames::{HEIGHT, WIDTH, light};
use crate::parts::Number;
use crate::scene::Scene;
use crate::scene::program::{field, tee};
use core::hint::black_box;
use core::ops::Range;
use scancsg::render::{Gray8, Picture, Size};

/// A picture of a program: the program alone, its view, and the row that the argument says.
pub struct Built {
    pub name: &'static str,
    pub program: extern "C" fn(u32),
    pub view: extern "C" fn(u32),
    pub row: extern "C" fn(u32),
    pub frame: extern "C" fn(u32),
}

// The functions are named one by one, for `cargo xtask profile`.
macro_rules! programs {
    ($($(#[$condition:meta])? $name:literal: $program:expr, $camera:ident,
        $rows:ident, $built:ident, $view:ident, $row:ident, $frame:ident;)+
    ) => {
        pub const PROGRAMS: &[Built] = &[$($(#[$condition])? Built {
            name: $name, program: $built, view: $view, row: $row, frame: $frame,
        },)+];

        $(
            $(#[$condition])?
            #[inline(never)]
            fn $rows(rows: Option<Range<u16>>) {
                let Ok(part) = black_box($program) else { return };
                let Some(rows) = rows else { return };
                let (Ok(camera), Some(light)) = (Number::$camera(), light()) else { return };
                let Ok(size) = Size::new(WIDTH, HEIGHT) else { return };
                let mut picture = Picture::new(&part, black_box(&camera), size, light, Gray8(0));
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
            extern "C" fn $built(_: u32) {
                $rows(None);
            }

            $(#[$condition])?
            #[inline(never)]
            extern "C" fn $view(_: u32) {
                $rows(Some(0..0));
            }

            $(#[$condition])?
            #[inline(never)]
            extern "C" fn $row(y: u32) {
                let y = y as u16;
                $rows(Some(y..y + 1));
            }

            $(#[$condition])?
            #[inline(never)]
            extern "C" fn $frame(_: u32) {
                $rows(Some(0..HEIGHT));
            }
        )+
    };
}

programs! {
    "program: tee": tee::<Number>(), orthographic,
        tee_rows, tee_program, tee_view, tee_row, tee_frame;
    // In fixed point, all of it is more than 256 KB of flash.
    #[cfg(not(number = "i16f16"))]
    "program: tee in perspective": tee::<Number>(), perspective,
        tee_p_rows, tee_p_program, tee_p_view, tee_p_row, tee_p_frame;
    "program: field of 16": field::<Number, 16>(), orthographic,
        field_16_rows, field_16_program, field_16_view, field_16_row, field_16_frame;
    #[cfg(not(any(board = "microbit", number = "i16f16")))]
    "program: field of 64": field::<Number, 64>(), orthographic,
        field_64_rows, field_64_program, field_64_view, field_64_row, field_64_frame;
    // No board has the 64 KB that it and its picture need.
    #[cfg(not(target_os = "none"))]
    "program: field of 256": field::<Number, 256>(), orthographic,
        field_256_rows, field_256_program, field_256_view, field_256_row, field_256_frame;
}
