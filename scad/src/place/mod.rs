//! From solids with maps to solids along the axes of a few turned frames.
//!
//! A `.csg` file has six digits, so faces that were meant to be one are two, a millionth apart, and a quarter turn
//! is nearly one. Here all solids whose axes are parallel come into one frame, quarter turns are exact, and
//! coordinates that differ by no more than the digits allow are made equal.

mod extent;
mod frames;
mod merge;
mod trim;

use crate::error::Error;
use crate::map::{Map, Vector, length};
use crate::tree::{Convex, Form, Solid, Tree};
use frames::{Frames, Turn, factor};
use scancsg::render::Rgb;
use std::sync::Arc;

/// A part whose solids are along the axes of frames.
#[derive(Debug, Clone)]
pub struct Model {
    /// The images of the three axes for each frame, of length 1, right-handed. The first frame is the scene's own.
    pub frames: Vec<[Vector; 3]>,
    /// The part.
    pub tree: Tree<Placed>,
}

/// A solid in a frame.
#[derive(Debug, Clone)]
pub struct Placed {
    /// The frame's index.
    pub frame: usize,
    /// What it is, in coordinates of the frame.
    pub body: Body,
    /// Its colour, if it has one.
    pub color: Option<Rgb>,
    /// The line that it comes from.
    pub line: usize,
}

/// A solid along the axes of its frame.
#[derive(Debug, Clone)]
pub enum Body {
    /// A box, by its lowest and its highest corner.
    Cuboid([Vector; 2]),
    /// A cylinder: the index of its axis, the other two coordinates in the order x, y, z, and where it ends.
    Cylinder {
        /// 0, 1 or 2.
        axis: usize,
        /// Where the axis is.
        at: [f64; 2],
        /// Its radius.
        radius: f64,
        /// From where to where.
        ends: [f64; 2],
    },
    /// A cone.
    Cone {
        /// 0, 1 or 2.
        axis: usize,
        /// Where the axis is.
        at: [f64; 2],
        /// The radii at both ends.
        radii: [f64; 2],
        /// From where to where.
        ends: [f64; 2],
    },
    /// A ball.
    Sphere {
        /// Its middle.
        center: Vector,
        /// Its radius.
        radius: f64,
    },
    /// A ring.
    Torus {
        /// 0, 1 or 2.
        axis: usize,
        /// Its middle.
        center: Vector,
        /// The radius of its middle line.
        ring: f64,
        /// The radius of the tube.
        tube: f64,
    },
    /// A convex polyhedron.
    Convex(Arc<Convex>),
    /// A round solid that is stretched or sheared.
    Stretched(Box<Form>, Box<Map>),
}

impl Model {
    /// Places the solids of a tree.
    ///
    /// # Errors
    /// An [`Error`] for coordinates that aren't finite.
    pub fn of(tree: Tree) -> Result<Self, Error> {
        let mut frames = Frames::default();
        // Boxes first: they need all three axes of a frame, cylinders one of them.
        tree.for_each(&mut |solid: &Solid| {
            if matches!(solid.form, Form::Cuboid(_)) {
                frames.note(&solid.map);
            }
        });
        let mut tree = tree.try_map(&mut |solid: Solid| {
            let is_finite = solid.map.columns.iter().all(|column| column.is_finite());
            if !is_finite || !solid.map.shift.is_finite() {
                return Err(Error::argument(
                    solid.line,
                    "a coordinate is infinite or not a number",
                ));
            }
            let (frame, body) = place(&mut frames, &solid);
            let placed = Placed { frame, body, color: solid.color, line: solid.line };
            Ok((!placed.body.is_flat()).then_some(placed))
        })?;
        let frames = frames.axes();
        merge::merge(&mut tree, frames.len());
        trim::trim(&mut tree, &frames);
        Ok(Self { frames, tree })
    }
}

/// The frame that a solid lies in, and the solid there.
fn place(frames: &mut Frames, solid: &Solid) -> (usize, Body) {
    let stretched = || (0, Body::Stretched(Box::new(solid.form.clone()), Box::new(solid.map)));
    let map = &solid.map;
    let lengths = map.columns.map(length).map(factor);
    let is_even = |a: f64, b: f64| (a - b).abs() < crate::map::SIX_DIGITS * (a + b);
    let [wide, other, high] = lengths;
    match &solid.form {
        Form::Sphere { radius } => match map.uniform_scale(2.0 * crate::map::SIX_DIGITS) {
            Some(scale) => {
                (0, Body::Sphere { center: map.shift, radius: digits(radius * factor(scale)) })
            }
            None => stretched(),
        },
        Form::Cuboid([low, high]) => match frames.turn(map) {
            Some(turn) => {
                let [a, b] = [turn.point(*low), turn.point(*high)];
                let pick = |pick: fn(f64, f64) -> f64| {
                    Vector::new(pick(a.x, b.x), pick(a.y, b.y), pick(a.z, b.z))
                };
                (turn.frame, Body::Cuboid([pick(f64::min), pick(f64::max)]))
            }
            None => (0, Body::Convex(Arc::new(sheared_box([*low, *high], map)))),
        },
        Form::Convex(convex) => match frames.turn_if_known(map) {
            Some(turn) => (turn.frame, Body::Convex(Arc::new(convex.mapped(&turn.map())))),
            None => (0, Body::Convex(Arc::new(convex.mapped(map)))),
        },
        Form::Cylinder { radius, heights } if is_even(wide, other) => {
            let Some(turn) = frames.turn_about_z(map) else { return stretched() };
            let (axis, at, ends, _) = along(&turn, *heights);
            (turn.frame, Body::Cylinder { axis, at, radius: digits(radius * wide), ends })
        }
        Form::Cone { radii, heights } if is_even(wide, other) => {
            let Some(turn) = frames.turn_about_z(map) else { return stretched() };
            let (axis, at, ends, is_reversed) = along(&turn, *heights);
            let [lower, upper] = radii.map(|radius| digits(radius * wide));
            let radii = if is_reversed { [upper, lower] } else { [lower, upper] };
            (turn.frame, Body::Cone { axis, at, radii, ends })
        }
        Form::Torus { ring, tube } if is_even(wide, other) && is_even(wide, high) => {
            let Some(turn) = frames.turn_about_z(map) else { return stretched() };
            let (axis, ..) = along(&turn, [0.0, 1.0]);
            let center = turn.point(Vector::new(0.0, 0.0, 0.0));
            let [ring, tube] = [ring, tube].map(|radius| digits(radius * wide));
            (turn.frame, Body::Torus { axis, center, ring, tube })
        }
        Form::Cylinder { .. } | Form::Cone { .. } | Form::Torus { .. } => stretched(),
    }
}

/// Which axis the own z axis lies along, where that is, between what heights, and whether these are in reverse order.
fn along(turn: &Turn, heights: [f64; 2]) -> (usize, [f64; 2], [f64; 2], bool) {
    let [from, to] = heights.map(|z| turn.point(Vector::new(0.0, 0.0, z)).to_array());
    let axis = turn.axis_of_z();
    let at = match axis {
        0 => [from[1], from[2]],
        1 => [from[0], from[2]],
        _ => [from[0], from[1]],
    };
    let ends = [from[axis].min(to[axis]), from[axis].max(to[axis])];
    (axis, at, ends, to[axis] < from[axis])
}

fn sheared_box([low, high]: [Vector; 2], map: &Map) -> Convex {
    let unit = |i: usize| Map::IDENTITY.columns[i];
    let faces = (0..3).flat_map(|i| [(-unit(i), -unit(i).dot(low)), (unit(i), unit(i).dot(high))]);
    let corner = |i: usize| {
        let pick = |a: f64, b: f64, bit: usize| if i >> bit & 1 == 0 { a } else { b };
        Vector::new(pick(low.x, high.x, 0), pick(low.y, high.y, 1), pick(low.z, high.z, 2))
    };
    Convex { planes: faces.collect(), corners: (0..8).map(corner).collect() }.mapped(map)
}

/// A length without what its last bits gained from sums and products: twelve digits.
fn digits(length: f64) -> f64 {
    let unit = 10f64.powi(11 - length.abs().max(1e-300).log10().floor() as i32);
    let rounded = (length * unit).round() / unit;
    if rounded.is_finite() { rounded } else { length }
}
