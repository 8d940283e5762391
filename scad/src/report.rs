//! What the command says of a part.

use crate::console::{say, working};
use scancsg_scad::picture::{Angles, View};
use scancsg_scad::program::{Bytes, MOST_SPANS, NumberType};
use scancsg_scad::scene::Scene;
use scancsg_scad::{Counts, Error, Model, measure};
use std::time::Duration;

/// What a part is made of, and what it measures.
pub fn part(counts: Counts, model: &Model, scene: &Scene, pixels: u16, took: Duration) {
    say!("solids     {}", counts.solids);
    say!("operators  {}, on {} levels", counts.operators, counts.levels);
    say!("frames     {}", model.frames.len());
    say!("modelled   in {took:.1?}");
    match working("measuring", || measure(scene, pixels)) {
        None => say!("volume     none found: the part is thinner than a pixel of the pictures"),
        Some(measures) => {
            let digits = digits(measures.volume_error);
            say!("volume     {:.digits$} ± {:.digits$}", measures.volume, measures.volume_error);
            say!("from       {:?}", measures.low.to_array());
            say!("to         {:?}", measures.high.to_array());
            say!("spans      {} on a line at most", measures.spans);
        }
    }
}

/// How many digits behind the point say two of an error.
fn digits(error: f64) -> usize {
    (1.0 - error.max(1e-9).log10().floor()).clamp(0.0, 9.0) as usize
}

/// The picture of a device whose time is estimated.
const SIZE: [u16; 2] = [160, 120];

/// What a device needs for a program.
pub fn program(made: &Bytes, scene: &Scene, camera: Angles) -> Result<(), Error> {
    let kinds: Vec<String> = made
        .kinds()
        .map(|kind| format!("{} {}", made.kinds[kind as usize], kind.solid(made.faces)))
        .collect();
    say!("program    {} bytes, {}", made.bytes.len(), made.number);
    say!("parts      {}, poses {}", made.parts, made.poses);
    let mut lead = "kinds";
    for few in kinds.chunks(3) {
        say!("{lead:10} {}", few.join(", "));
        lead = "";
    }
    if let Some(corners) = scene.corners() {
        match working("tracing", || made.spans(corners))? {
            Some(spans) => say!("room       for {spans} spans of a single ray"),
            None => say!("room       {MOST_SPANS} spans of a single ray are too few"),
        }
    }
    let memory = made.memory();
    say!("RAM        about {} bytes", made.ram());
    say!("           {} the program, {} its picture", memory.program, memory.picture);
    if made.number == NumberType::F32 {
        let view = View::of_all(scene, camera, SIZE)?;
        let work = working("counting", || made.work(&view, SIZE))?;
        let [width, height] = SIZE;
        say!("flash      about {} bytes of a Cortex-M4F", made.flash());
        say!(
            "time       about {} instructions a pixel there",
            work.instructions(made.parts) / work.pixels
        );
        say!("           for {width} x {height} pixels; within a quarter");
    }
    Ok(())
}
