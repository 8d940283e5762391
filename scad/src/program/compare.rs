//! How far a program is from its part: both are rendered, and their pictures compared.

use super::count::{PARTS, POSES, on_large_stack};
use super::leaf::Leaf;
use super::part::largest;
use super::write::rounded_down;
use super::{NumberType, program};
use crate::error::{Error, ErrorKind};
use crate::picture::{Angles, View, render, render_rows};
use crate::place::{Model, Placed};
use crate::scene::Scene;
use scancsg::program::Program;
use scancsg::render::{Pixel, Rgb, Size};
use scancsg::scalar::{I16F16, Scalar};
use std::collections::HashMap;

/// The size of the pictures.
const SIZE: [u16; 2] = [320, 240];

/// The most levels that a pixel may be off, and the most pixels, in parts of all, that may be off by more. Edges that
/// are half a pixel off are more than that.
const LEVELS: u8 = 2;
const PIXELS: f64 = 0.001;

/// How far a program is from its part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Deviation {
    /// In how many pixels of a picture of 320 × 240 they differ, in parts of all.
    pub pixels: f64,
    /// The line of what most of these pixels show; 0 without any.
    pub line: usize,
    /// The number type of the program.
    pub number: NumberType,
    /// The part so many times as large has more digits, and still fits.
    pub scale: Option<f64>,
}

impl Deviation {
    /// What to say of a program that isn't the part, as far as a picture shows: what differs, and what would help.
    ///
    /// ```
    /// use scancsg_scad::picture::Angles;
    /// use scancsg_scad::program::{FACES, NumberType, deviation};
    /// use scancsg_scad::{Model, lower, parse};
    ///
    /// let part = lower(&parse("cylinder(h = 0.001, r1 = 0.002, r2 = 0.001);")?, false)?;
    /// let model = Model::of(part.tree)?;
    /// let deviation = deviation(&model, NumberType::I16F16, FACES, Angles::default())?;
    /// let text = deviation.warning().ok_or("it is the same")?.to_string();
    /// assert!(text.contains("--scale"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn warning(&self) -> Option<Error> {
        let Self { pixels, line, number, scale } = *self;
        let helps = match (number, scale) {
            (NumberType::F32, _) => String::new(),
            (_, Some(scale)) => format!("; --scale {scale} or f32 may do"),
            (_, None) => "; f32 may do".into(),
        };
        let share = pixels * 100.0;
        let text = format!(
            "in {number}, {share:.2} % of a picture's pixels differ from the part's{helps}"
        );
        (pixels > PIXELS).then_some(Error { line, kind: ErrorKind::Limit(text) })
    }
}

/// Compares a program with its part, as seen from somewhere.
///
/// # Errors
/// As [`program`]; and an [`Error`] for more than 1,024 parts.
pub fn deviation(
    model: &Model,
    number: NumberType,
    faces: usize,
    angles: Angles,
) -> Result<Deviation, Error> {
    let (mut by_line, mut most) = (model.clone(), 0.0_f64);
    by_line.tree.change_each(&mut |solid: &mut Placed| {
        let [b, g, r, _] = (solid.line as u32).to_le_bytes();
        solid.color = Some(Rgb::new(r, g, b));
        most = most.max(largest(&solid.body));
    });
    let scene = Scene::of(&by_line)?;
    let made = program(&by_line, number, faces)?;
    let view = View::of_all(&scene, angles, SIZE)?;
    let wanted = render(&scene, &view, SIZE, Seen::default())?;
    let got = on_large_stack(|| match number {
        NumberType::F32 => seen::<f32>(&made.bytes, &view),
        NumberType::I16F16 => seen::<I16F16>(&made.bytes, &view),
    })?;
    let differing = got.iter().zip(&wanted).filter(|(got, wanted)| got.differs(wanted));
    let mut lines = HashMap::new();
    differing.for_each(|(got, wanted)| *lines.entry(wanted.line.max(got.line)).or_default() += 1);
    let count: u32 = lines.values().sum();
    let line = lines.into_iter().max_by_key(|(line, count)| (*count, *line));
    Ok(Deviation {
        pixels: f64::from(count) / wanted.len() as f64,
        line: line.map_or(0, |(line, _)| line as usize),
        number,
        scale: Some(rounded_down(number.most() / 2.0 / most)).filter(|scale| *scale > 1.0),
    })
}

/// What a pixel shows.
#[derive(Debug, Clone, Copy, Default)]
struct Seen {
    /// 0 where nothing is.
    line: u32,
    level: u8,
}

impl Seen {
    fn differs(&self, other: &Self) -> bool {
        (self.line == 0) != (other.line == 0) || self.level.abs_diff(other.level) > LEVELS
    }
}

impl Pixel for Seen {
    fn shaded(color: Rgb, level: u8) -> Self {
        Self { line: u32::from_be_bytes([0, color.r, color.g, color.b]), level }
    }
}

/// The picture of a program, in a thread whose stack has room for it.
fn seen<S: Scalar>(bytes: &[u8], view: &View) -> Result<Vec<Seen>, Error> {
    let wrong = |error: &dyn std::fmt::Display| Error::limit(error.to_string());
    let part = Program::<Leaf<S>, PARTS, POSES, 1>::from_bytes(bytes).map_err(|e| wrong(&e))?;
    let [width, height] = SIZE;
    let size = Size::new(width, height).map_err(|error| wrong(&error))?;
    let mut pixels = vec![Seen::default(); usize::from(width) * usize::from(height)];
    let rows = (0..height).zip(pixels.chunks_mut(width.into())).collect();
    render_rows(&part, view, size, Seen::default(), rows)?;
    Ok(pixels)
}
