//! Renders a part that `scancsg-scad --firmware` made: a program in flash, read into RAM. As firmware it says how
//! many instructions that takes, and how much stack; `cargo xtask part FILE.rs` builds it with a file.

#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../board/mod.rs"]
mod board;

/// What the file says.
mod made {
    include!(env!("SCANCSG_PART"));
}

use core::hint::black_box;
use core::ops::Range;
use made::{BYTES, HEIGHT as VIEW_HEIGHT, LOOK, Part};
use scancsg::Error;
use scancsg::geom::Vec3;
use scancsg::render::{Gray8, Lambert, Orthographic, Picture, Size};

const WIDTH: u16 = 160;
const HEIGHT: u16 = 120;

/// Renders some rows. The sum of their levels.
#[inline(never)]
fn rows(rows: Range<u16>) -> Result<u32, Error> {
    let part = Part::from_bytes(black_box(&BYTES))?;
    let [along, target, up] = LOOK.map(Vec3::from);
    let camera = Orthographic::look_along(along, target, up, VIEW_HEIGHT)?;
    // From where the camera is.
    let light = Lambert::new(-along, Default::default())?;
    let size = Size::new(WIDTH, HEIGHT)?;
    let mut picture = Picture::new(&part, black_box(&camera), size, light, Gray8(0));
    picture.prepare();
    let mut pixels = [Gray8(0); WIDTH as usize];
    let mut sum = 0;
    for y in rows {
        picture.scanline(y)?.render(&mut pixels)?;
        sum += pixels.iter().map(|pixel| u32::from(pixel.0)).sum::<u32>();
    }
    black_box(&picture);
    Ok(sum)
}

#[cfg(target_os = "none")]
#[board::entry]
fn main() -> ! {
    use board::{Counter, Usage, say, say_number};
    extern "C" fn view(_: u32) {
        let _ = black_box(rows(0..0));
    }
    extern "C" fn row(y: u32) {
        let _ = black_box(rows(y as u16..y as u16 + 1));
    }
    board::paint();
    let is_seen = rows(0..HEIGHT).is_ok_and(|sum| sum > 0);
    let report = |name: &str, count: u32| {
        say(name);
        say(" ");
        say_number(count);
        say("\n");
    };
    report("stack", Usage::measure().stack as u32);
    let counter = Counter::start();
    let of_view = counter.instructions(view, 0);
    let of_row = |y: u16| counter.instructions(row, y.into()).saturating_sub(of_view);
    report("view", of_view);
    report("rows", (0..HEIGHT).map(of_row).fold(0, u32::saturating_add));
    loop {
        board::finish(is_seen);
    }
}

#[cfg(not(target_os = "none"))]
fn main() {
    match rows(0..HEIGHT) {
        Ok(sum) => println!("{sum} levels of grey in all"),
        Err(error) => println!("{error}"),
    }
}
