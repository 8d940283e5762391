//! What firmware needs for a part, as Rust: its leaves, its capacities, its bytes, and a camera.

use super::Bytes;
use super::numbers::NumberType;
use crate::map::Vector;
use crate::picture::View;
use scancsg::scalar::{I16F16, Number as _};
use std::fmt::Write;

/// The text of a module: a type with room for the part, its bytes, and a camera that sees all of it.
///
/// ```
/// use scancsg_scad::picture::{Angles, View};
/// use scancsg_scad::program::{FACES, NumberType, firmware, program};
/// use scancsg_scad::scene::Scene;
/// use scancsg_scad::{Model, lower, parse};
///
/// let model = Model::of(lower(&parse("cube(size = [3, 2, 1]);")?, false)?.tree)?;
/// let view = View::of_all(&Scene::of(&model)?, Angles::default(), [160, 120])?;
/// let text = firmware(&program(&model, NumberType::F32, FACES)?, &view, 32);
/// assert!(text.contains("pub type Part = Program<Leaf<f32>, 1, 0, 32>;"));
/// # Ok::<(), scancsg_scad::Error>(())
/// ```
#[must_use]
pub fn firmware(part: &Bytes, view: &View, spans: usize) -> String {
    let (scalar, import) = match part.number {
        NumberType::F32 => ("f32", ""),
        NumberType::I16F16 => ("I16F16", "use scancsg::scalar::I16F16;\n"),
    };
    let names: String = part
        .kinds()
        .map(|kind| {
            format!(
                "        {kind:?}({}),
",
                kind.solid(part.faces)
            )
        })
        .collect();
    let [_, up, back] = view.angles.axes();
    let point = |point: Vector| {
        let [x, y, z] = point.to_array().map(|part_of| number(part.number, part_of));
        format!("[{x}, {y}, {z}]")
    };
    let mut text = format!(
        "// Made by scancsg-scad.\n\nuse scancsg::program::Program;\n{import}use scancsg::solid::*;\n\n\
         scancsg::leaves! {{\n    /// What the part is made of.\n    pub enum Leaf<S> {{\n{names}    }}\n}}\n\n\
         /// Room for the part.\n\
         pub type Part = Program<Leaf<{scalar}>, {}, {}, {spans}>;\n\n\
         /// Along what a camera looks that sees all of it, what is in the middle, and what is up.\n\
         pub const LOOK: [[{scalar}; 3]; 3] = [{}, {}, {}];\n\n\
         /// How high the camera's picture is.\n\
         pub const HEIGHT: {scalar} = {};\n\n\
         /// The part: `Part::from_bytes` reads it.\n\
         pub static BYTES: [u8; {}] = [",
        part.parts,
        part.poses,
        point(-back),
        point(view.target),
        point(up),
        number(part.number, view.height),
        part.bytes.len(),
    );
    for (index, byte) in part.bytes.iter().enumerate() {
        let _ = write!(text, "{}{byte},", if index % 24 == 0 { "\n    " } else { " " });
    }
    text + "\n];\n"
}

fn number(number_type: NumberType, number: f64) -> String {
    match number_type {
        NumberType::F32 => format!("{:?}", number as f32 + 0.0),
        NumberType::I16F16 => format!("I16F16::from_bits({})", I16F16::from_f64(number).to_bits()),
    }
}
