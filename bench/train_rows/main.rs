//! Makes the start table of the coder of rows: what each probability is at the start of a payload.
//!
//! ```sh
//! cargo bench --package bench --bench train_rows           # bytes a frame, with the table as it is
//! cargo bench --package bench --bench train_rows -- FILE   # writes a better table, as start.rs
//! ```
//!
//! A probability's decisions don't depend on its start, apart from where payloads end. So the best start is
//! found by trying all of them, and after three rounds the payloads end where they did.

mod corpus;
#[path = "../../examples/stream/gallery.rs"]
mod gallery;
#[path = "../../examples/scene/mod.rs"]
mod scene;

// The coder, as it is: its insides are of no use to a user of the library.
#[path = "../../src/stream/codec/predictive/alphabet.rs"]
#[allow(dead_code)]
mod alphabet;
#[path = "../../src/stream/codec/predictive/model.rs"]
#[allow(dead_code)]
mod model;
#[path = "../../src/stream/codec/predictive/palette.rs"]
#[allow(dead_code)]
mod palette;
#[path = "../../src/stream/codec/predictive/range.rs"]
#[allow(dead_code)]
mod range;
#[path = "../../src/stream/codec/predictive/rows.rs"]
mod rows;
#[path = "../../src/stream/codec/predictive/start.rs"]
mod start;

use alphabet::{Alphabet, Levels};
use core::marker::PhantomData;
use corpus::{Pixels, Shown};
use model::{Model, SLOTS, Slot};
use palette::Palette;
use range::{Bins, Encoder, Interval};
use rows::{Line, Start};
use scancsg::render;
use std::error::Error;
use std::fmt::Write as _;

/// The bytes of the longest payload: a packet's contents, its fields and its checksum taken off.
const PAYLOAD: usize = 254 - 6 - 4;
/// What a packet has around its payload on the line.
const AROUND: usize = 6 + 4 + 2;
/// The most rows of a payload.
const ROWS: usize = 255;
/// A frame's header and end, without colours.
const ENDS: usize = 17 + 13;
/// After so many decisions, little is left of where a probability started.
const REMEMBERED: usize = 200;

/// Every payload's first decisions, of each probability.
type Decisions = Vec<Vec<Vec<bool>>>;

/// An encoder that is looked at.
struct Watched<'a> {
    encoder: Encoder<'a>,
    decisions: &'a mut Vec<(Slot, bool)>,
}

impl Bins for Watched<'_> {
    fn bin(&mut self, slot: Slot, bit: bool) -> bool {
        self.decisions.push((slot, bit));
        self.encoder.bin(slot, bit)
    }

    fn even(&mut self, bit: bool) -> bool {
        self.encoder.even(bit)
    }
}

struct Source<'a, P>(&'a [P]);

impl<P: Copy + PartialEq> Line<P> for Source<'_, P> {
    fn get(&self, x: usize) -> Option<P> {
        self.0.get(x).copied()
    }

    fn holds(&self, from: usize, to: usize, pixel: P) -> bool {
        self.0.get(from..to).unwrap_or_default().iter().all(|held| *held == pixel)
    }

    fn fill(&mut self, _: usize, _: usize, _: P) {}
}

/// Probabilities at the start of a payload.
fn starting(start: &[u8; SLOTS]) -> Model {
    let mut model = Model::EMPTY;
    model.restart(start);
    model
}

/// The bytes of a picture on the line, without its header and end.
fn encode<A: Alphabet>(
    mut alphabet: A,
    width: usize,
    pixels: &[A::Pixel],
    start: &[u8; SLOTS],
    seen: &mut Decisions,
) -> usize {
    let mut above = vec![A::kept(0); width];
    let mut rows = pixels.chunks_exact(width).peekable();
    let mut bytes = 0;
    while rows.peek().is_some() {
        let (mut model, mut interval) = (starting(start), Interval::ALL);
        let mut from = Start { left: alphabet.pixel(0), is_first: true };
        let (mut out, mut decisions) = ([0; PAYLOAD], Vec::new());
        let mut count = 0;
        while let Some(row) = rows.peek().filter(|_| count < ROWS) {
            let held = decisions.len();
            let encoder = Encoder::resume(&mut model, interval, &mut out);
            let mut coder = Watched { encoder, decisions: &mut decisions };
            rows::code(&mut coder, &mut alphabet, &mut above, &mut Source(row), from);
            let Some(end) = coder.encoder.fits() else {
                decisions.truncate(held);
                break;
            };
            interval = end;
            from = Start { left: row.first().copied().unwrap_or(from.left), is_first: false };
            count += 1;
            rows.next();
        }
        if count == 0 {
            // The row is sent otherwise.
            rows.next();
        }
        bytes += AROUND + interval.finish(&mut out);
        let mut first = vec![Vec::new(); SLOTS];
        for (slot, bit) in decisions {
            if let Some(first) = first.get_mut(slot).filter(|first| first.len() < REMEMBERED) {
                first.push(bit);
            }
        }
        for (slot, first) in seen.iter_mut().zip(first) {
            slot.extend(Some(first).filter(|first| !first.is_empty()));
        }
    }
    bytes
}

fn size(shown: &Shown, start: &[u8; SLOTS], seen: &mut Decisions) -> usize {
    match &shown.pixels {
        Pixels::Gray(pixels) => {
            ENDS + encode(Levels::<u8>(PhantomData), shown.width, pixels, start, seen)
        }
        Pixels::Color(pixels) => {
            let palette = Palette::<_, 4>::new(shown.colors);
            let colors = 3 * shown.colors.len();
            ENDS + colors + encode(palette, shown.width, pixels, start, seen)
        }
    }
}

/// What these decisions cost in bits, from a start on.
fn cost(payloads: &[Vec<bool>], start: u8, bits: &[f32]) -> f32 {
    let mut sum = 0.0;
    for decisions in payloads {
        let mut model = starting(&[start; SLOTS]);
        for bit in decisions {
            let probability = model.of(0);
            let yes = probability.yes() as usize;
            sum += bits.get(if *bit { yes } else { 4096 - yes }).copied().unwrap_or(0.0);
            probability.learn(*bit);
        }
    }
    sum
}

fn train(seen: &Decisions) -> [u8; SLOTS] {
    let bits: Vec<f32> = (0..=4096).map(|part| -(part as f32 / 4096.0).log2()).collect();
    let mut table = [128; SLOTS];
    for (start, payloads) in table.iter_mut().zip(seen).filter(|(_, all)| !all.is_empty()) {
        let of = |start: &u8| cost(payloads, *start, &bits);
        let best = |all: &mut dyn Iterator<Item = u8>| all.min_by(|a, b| of(a).total_cmp(&of(b)));
        let about = best(&mut (1..=u8::MAX).step_by(8)).unwrap_or(128);
        *start =
            best(&mut (about.saturating_sub(7).max(1)..=about.saturating_add(7))).unwrap_or(about);
    }
    table
}

/// The geometric mean of the pictures in a format.
fn mean(sizes: &[(&str, usize)], format: &str) -> f64 {
    let logs: Vec<f64> = sizes
        .iter()
        .filter(|(name, _)| name.contains(format))
        .map(|(_, size)| (*size as f64).ln())
        .collect();
    (logs.iter().sum::<f64>() / logs.len() as f64).exp()
}

fn main() -> Result<(), Box<dyn Error>> {
    let pictures = corpus::all()?;
    let path = std::env::args().skip(1).find(|word| word != "--bench");
    let mut table = start::START;
    let mut seen = vec![Vec::new(); SLOTS];
    if path.is_some() {
        for _ in 0..3 {
            seen = vec![Vec::new(); SLOTS];
            pictures.iter().for_each(|shown| {
                size(shown, &table, &mut seen);
            });
            table = train(&seen);
        }
    }
    let sizes: Vec<(&str, usize)> = pictures
        .iter()
        .map(|shown| (shown.name.as_str(), size(shown, &table, &mut seen)))
        .collect();
    sizes.iter().for_each(|(name, size)| println!("{name}: {size}"));
    for format in ["Gray8", "Rgb565"] {
        println!("geometric mean of {format}: {:.1}", mean(&sizes, format));
    }
    if let Some(path) = path {
        std::fs::write(path, source(&table)?)?;
    }
    Ok(())
}

/// The table as a file of the library.
fn source(table: &[u8; SLOTS]) -> Result<String, std::fmt::Error> {
    let mut text = String::from(
        "//! What every probability is at the start of a payload, in 256ths.\n//!\n\
         //! Made by `cargo bench --package bench --bench train_rows -- src/stream/codec/predictive/start.rs`\n\
         //! from 504 pictures.\n\n\
         use super::model::SLOTS;\n\n\
         #[rustfmt::skip]\npub(super) static START: [u8; SLOTS] = [\n",
    );
    for line in table.chunks(20) {
        let words: Vec<String> = line.iter().map(u8::to_string).collect();
        writeln!(text, "    {},", words.join(", "))?;
    }
    text.push_str("];\n");
    Ok(text)
}
