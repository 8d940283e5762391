//! Whole pictures on this host: row by row, as the crate renders them, against other ways to the
//! same picture; and how the time grows with the number of primitives.
//!
//! `cargo bench --package bench --bench render -- --help`

#![allow(clippy::unwrap_used)]

mod methods;
#[path = "../../examples/scene/mod.rs"]
mod scene;
#[path = "../timing.rs"]
#[allow(dead_code)] // of what a table of single rays needs
mod timing;

use clap::Parser;
use methods::Frame;
use scancsg::geom::{OrthographicRays, PerspectiveRays, Rays};
use scancsg::render::{Camera, Gray8, Size};
use scancsg::scalar::I16F16;
use scancsg::solid::{Scan, Shape, Solid};
use scene::plate::{Plate, PlateScene};
use scene::{Scene, Tee};
use std::hint::black_box;
use std::process::ExitCode;
use timing::{Pass, Rounds};

/// Measures how long whole pictures take, in nanoseconds per pixel on one thread.
///
/// Three ways are timed by turns: `rows` is how the crate renders, `lists` takes the same rows but
/// merges the list of all spans in every pixel, `naive` asks every primitive about every pixel's
/// line. Times, and their ratios, are those of the fastest turns.
#[derive(Parser)]
#[command(
    name = "render",
    bin_name = "cargo bench --package bench --bench render --",
    max_term_width = 80
)]
struct Args {
    /// Smaller pictures, and fewer rounds
    #[arg(long)]
    quick: bool,

    /// Passed by `cargo bench`, and not by `cargo test --all-targets`, which must be quick
    #[arg(long, hide = true)]
    bench: bool,
}

/// A scene, and three ways to its picture.
struct Subject {
    scene: String,
    camera: &'static str,
    number: &'static str,
    size: Size,
    /// Rows, lists, naive.
    frames: [Frame; 3],
}

/// Frames of a turn: with one alone, branches would be predicted as the other ways took them.
const FRAMES: usize = 8;

/// The most spans that a line needs memory for.
const SPANS: usize = <Plate<f32, 64> as Shape>::STACK;

impl Subject {
    fn new<S, T, C>(
        scene: &str,
        camera: &'static str,
        solid: impl Fn() -> T + Copy + 'static,
        view: C,
        size: Size,
    ) -> Self
    where
        S: Scene,
        C: Camera<Rays: Rays<Scalar = S>> + Copy + 'static,
        T: Solid<Scalar = S> + Scan<C::Rays>,
    {
        let number = std::any::type_name::<S>();
        Self {
            scene: scene.to_owned(),
            camera,
            number: if number == "f32" { "f32" } else { "I16F16" },
            size,
            frames: [
                methods::rows(solid, view, size),
                methods::lists::<_, _, _, SPANS>(solid, view, size),
                methods::naive::<_, _, _, SPANS>(solid, view, size),
            ],
        }
    }

    fn tees<S: Scene>(size: Size) -> [Self; 2]
    where
        Tee<S>: Scan<OrthographicRays<S>, Scalar = S> + Scan<PerspectiveRays<S>, Scalar = S>,
    {
        [
            Self::new("tee", "orthographic", || S::TEE, S::orthographic().unwrap(), size),
            Self::new("tee", "perspective", || S::TEE, S::perspective().unwrap(), size),
        ]
    }

    fn plate<S: PlateScene<N>, const N: usize>(size: Size) -> Self
    where
        Plate<S, N>: Scan<OrthographicRays<S>, Scalar = S>,
    {
        let holes = if N == 1 { "plate, 1 hole".into() } else { format!("plate, {N} holes") };
        Self::new(&holes, "orthographic", || S::PLATE, S::orthographic().unwrap(), size)
    }

    fn pixels(&self) -> usize {
        usize::from(self.size.width()) * usize::from(self.size.height())
    }

    fn picture(&self, way: usize) -> Vec<Gray8> {
        let mut pixels = vec![Gray8(0); self.pixels()];
        self.frames[way](&mut pixels);
        pixels
    }

    /// How much of the picture shows the solid, in per cent, once all ways show the same. Rounding
    /// is another for single lines, so that edges, and levels by one, may differ.
    fn checked_cover(&self) -> Result<f64, String> {
        let [rows, lists, naive] = [0, 1, 2].map(|way| self.picture(way));
        let fails =
            |what: String| format!("{}, {}, {}: {what}", self.scene, self.camera, self.number);
        if rows != lists {
            return Err(fails("the rows don't show what the lists of all spans show".into()));
        }
        let is_same = |(a, b): &(&Gray8, &Gray8)| a.0.abs_diff(b.0) <= 1;
        let same = rows.iter().zip(&naive).filter(is_same).count();
        if same * 100 < self.pixels() * 99 {
            let of = self.pixels();
            return Err(fails(format!("only {same} of {of} pixels agree with the naive caster's")));
        }
        let covered = rows.iter().filter(|pixel| pixel.0 > 0).count();
        Ok(100.0 * covered as f64 / self.pixels() as f64)
    }

    /// For a clock: every way in turn, a few frames at a time, as they follow each other in use.
    fn passes(self) -> impl Iterator<Item = (Pass, usize)> {
        let count = self.pixels();
        self.frames.into_iter().map(move |frame| {
            let pixels = std::cell::RefCell::new(vec![Gray8(0); count]);
            let pass = move || {
                for _ in 0..FRAMES {
                    frame(&mut pixels.borrow_mut());
                    black_box(&pixels);
                }
            };
            (Box::new(pass) as Pass, FRAMES * count)
        })
    }
}

/// What else the machine does, also for long, is left out.
fn fastest(times: &Rounds, pass: usize) -> f64 {
    times.of_pass(pass).fold(f64::INFINITY, f64::min)
}

/// Times subjects together, and prints a line for each.
fn measure(subjects: Vec<Subject>, rounds: usize) -> Result<Rounds, String> {
    let mut labels = Vec::new();
    for subject in &subjects {
        let Subject { scene, camera, number, .. } = subject;
        let cover = subject.checked_cover()?;
        labels.push(format!("{scene:15} {camera:12} {number:6} {cover:5.0} %"));
    }
    let times = Rounds::of(subjects.into_iter().flat_map(Subject::passes).collect(), rounds);
    for (i, label) in labels.into_iter().enumerate() {
        let [rows, lists, naive] = [0, 1, 2].map(|way| fastest(&times, 3 * i + way));
        println!(
            "{label}{rows:7.1}{lists:9.1} {:4.1}x{naive:9.1} {:4.1}x",
            lists / rows,
            naive / rows,
        );
    }
    Ok(times)
}

/// Four plates of a number type; returns how many times longer 64 holes take than 4.
fn measure_plates<S>(size: Size, rounds: usize) -> Result<f64, String>
where
    S: PlateScene<1> + PlateScene<4> + PlateScene<16> + PlateScene<64>,
    Plate<S, 1>: Scan<OrthographicRays<S>, Scalar = S>,
    Plate<S, 4>: Scan<OrthographicRays<S>, Scalar = S>,
    Plate<S, 16>: Scan<OrthographicRays<S>, Scalar = S>,
    Plate<S, 64>: Scan<OrthographicRays<S>, Scalar = S>,
{
    let plates = vec![
        Subject::plate::<S, 1>(size),
        Subject::plate::<S, 4>(size),
        Subject::plate::<S, 16>(size),
        Subject::plate::<S, 64>(size),
    ];
    let times = measure(plates, rounds)?;
    Ok(fastest(&times, 9) / fastest(&times, 3)) // three ways for each
}

fn run(args: &Args) -> Result<(), String> {
    let quick = args.quick || !args.bench;
    let (width, height, rounds) = if quick { (80, 60, 5) } else { (160, 120, 31) };
    let size = Size::new(width, height).map_err(|error| error.to_string())?;
    println!(
        "ns per pixel of {width}x{height} pixels, Gray8, Lambert; fastest of {rounds} rounds\n"
    );
    println!(
        "{:15} {:12} {:6}{:>8}{:>7}{:>9} {:>5}{:>9} {:>5}",
        "scene", "camera", "number", "covered", "rows", "lists", "/rows", "naive", "/rows"
    );
    measure(Subject::tees::<f32>(size).into(), rounds)?;
    measure(Subject::tees::<I16F16>(size).into(), rounds)?;
    let single = measure_plates::<f32>(size, rounds)?;
    let fixed = measure_plates::<I16F16>(size, rounds)?;
    println!(
        "\nAims: 12 ns or less for the rows of tee, orthographic, in f32; a plate of 64\n\
         holes less than 1.5 times as long as one of 4: {single:.2} in f32, {fixed:.2} in I16F16."
    );
    Ok(())
}

fn main() -> ExitCode {
    match run(&Args::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("render: {message}");
            ExitCode::FAILURE
        }
    }
}
