//! What a firmware takes that holds a part: flash and RAM of a Cortex-M4F, and instructions a pixel.
//!
//! The figures are those of the example `part`, as `cargo xtask part` measures them on an emulated MPS2-AN386. They
//! are sums: how often something is done times what it takes. What it takes was fitted, by least squares of the
//! relative error and with nothing below zero, to 26 pictures: of eleven parts of `tests/parts` and six others, some of
//! them from three sides. `tests/cost.rs` holds the sums to what was measured.

use super::Bytes;
use super::count::Work;
use super::kind::Kind;

const KINDS: usize = Kind::ALL.len();

/// Instructions for a pixel that shows the part: its shading, and what of the walk doesn't depend on the parts.
const SHADED: u64 = 400;
/// To read a scaled part, whose map is inverted in `f64`, and make it ready for a picture.
const SCALED: u64 = 170_000;
/// To make a part ready for a row.
const ROW: u64 = 1_150;
/// To compute the spans of a part's ray, in the order of [`Kind::ALL`]. A torus computes in `f64`, in software.
const RAY: [u64; KINDS] = [50, 90, 130, 35, 25_000, 200, 50, 130, 35, 25_000];
/// To ask a part once more, or for the first time, what its spans say.
const AGAIN: u64 = 90;
/// To ask a part where several are crossed at once; and to look at the tree there, for each of its parts.
const COLD: u64 = 340;
const TIED: u64 = 60;

impl Work {
    /// The instructions that a Cortex-M4F takes for the picture, with a program of so many parts.
    #[must_use]
    pub fn instructions(&self, parts: usize) -> u64 {
        let rays: u64 = self.rays.iter().zip(RAY).map(|(count, each)| count * each).sum();
        let asked_again = self.asked - self.rays.iter().sum::<u64>() - self.asked_cold;
        let scaled: u64 = Kind::ALL
            .iter()
            .zip(self.views)
            .filter(|(kind, _)| kind.is_scaled())
            .map(|(_, count)| count)
            .sum();
        self.shaded * SHADED
            + scaled * SCALED
            + self.rows.iter().sum::<u64>() * ROW
            + rays
            + asked_again * AGAIN
            + self.asked_cold * COLD
            + self.tied * parts as u64 * TIED
    }
}

/// Bytes of a firmware that reads a program of cylinders and renders it.
const BASE: usize = 24_700;
/// Bytes of code for each kind, in the order of [`Kind::ALL`].
const CODE: [usize; KINDS] =
    [0, 5_400, 2_000, 12_700, 17_500, 7_300, 10_000, 10_000, 10_000, 10_000];
/// Bytes of code for poses.
const POSES: usize = 1_200;
/// Of the memory of a picture, this share is in flash as well: what it is before the first row.
const EMPTY: f64 = 0.9;
/// Bytes of stack besides the program and the picture.
const STACK: usize = 1_400;

impl Bytes {
    /// Bytes of flash, with the program in it.
    #[must_use]
    pub fn flash(&self) -> usize {
        let code: usize = self.kinds().map(|kind| CODE[kind as usize]).sum();
        let poses = if self.poses > 0 { POSES } else { 0 };
        let empty = (self.memory().picture as f64 * EMPTY) as usize;
        BASE + code + poses + empty + self.bytes.len()
    }

    /// Bytes of RAM: the program, its picture, and the stack.
    #[must_use]
    pub fn ram(&self) -> usize {
        let memory = self.memory();
        2 * memory.program + memory.picture + STACK
    }
}
