//! What the report says of a firmware, against what was measured on a board.
//!
//! `tests/measured.txt` is what `cargo xtask part FILES.rs` printed of files that
//! `scancsg-scad tests/parts/NAME.csg --size 160x120 --firmware NAME.rs` wrote, with `--camera 0,0,0` for those that
//! end in `_top` and `--camera 80,0,60` for those that end in `_front`.

mod support;

use scancsg_scad::picture::{Angles, View};
use scancsg_scad::program::{FACES, NumberType, program};
use scancsg_scad::scene::Scene;
use scancsg_scad::{Model, lower, parse};
use std::error::Error;
use std::fs;
use support::reference::folder;

const SIZE: [u16; 2] = [160, 120];

/// How far a figure may be off, in parts of the measured one.
const TIME: f64 = 0.25;
const FLASH: f64 = 0.05;
const RAM: f64 = 0.2;

#[test]
fn estimates_are_near_what_was_measured() -> Result<(), Box<dyn Error>> {
    let mut count = 0;
    for line in include_str!("measured.txt").lines().filter(|line| !line.starts_with('#')) {
        let (name, figures) = line.split_once(' ').ok_or("no figures")?;
        let figures: Vec<f64> = figures.split(' ').map(str::parse).collect::<Result<_, _>>()?;
        let [flash, ram, view, rows] = figures[..] else {
            return Err("figures are missing".into());
        };
        let (part, camera) = match name.rsplit_once('_') {
            Some((part, "top")) => (part, [0.0, 0.0, 0.0]),
            Some((part, "front")) => (part, [80.0, 0.0, 60.0]),
            _ => (name, [55.0, 0.0, 25.0]),
        };
        let text = fs::read_to_string(folder().join(part).with_extension("csg"))?;
        let model = Model::of(lower(&parse(&text)?, false)?.tree)?;
        let made = program(&model, NumberType::F32, FACES)?;
        let seen = View::of_all(&Scene::of(&model)?, Angles(camera), SIZE)?;
        let time = made.work(&seen, SIZE)?.instructions(made.parts) as f64;
        let off = |estimated: f64, measured: f64| (estimated - measured) / measured;
        let all = [
            ("instructions", off(time, view + rows), TIME),
            ("flash", off(made.flash() as f64, flash), FLASH),
            ("RAM", off(made.ram() as f64, ram), RAM),
        ];
        for (what, off, most) in all {
            println!("{name:16} {what:12} {:+.1} %", off * 100.0);
            assert!(off.abs() <= most, "{name}: {what} {off:+.3}");
        }
        count += 1;
    }
    assert!(count >= 20, "{count} pictures");
    Ok(())
}
