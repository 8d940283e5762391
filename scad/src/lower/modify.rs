//! What changes the place, size or colour of its children: `multmatrix`, `resize`, `color`.

use super::{Lowering, Shape, united};
use crate::arguments::is_tame;
use crate::error::Error;
use crate::flat::Flat;
use crate::map::Map;
use crate::parse::{Node, Value};
use crate::tree::Tree;
use scancsg::geom::vec3;
use scancsg::render::Rgb;

impl Lowering {
    pub(super) fn multmatrix(&mut self, node: &Node) -> Result<Shape, Error> {
        let map = matrix(node)?;
        placed(united(self.children(node)?), &map, node.line)
    }

    pub(super) fn color(&mut self, node: &Node) -> Result<Shape, Error> {
        let mut shape = united(self.children(node)?);
        // The outermost colour counts. OpenSCAD writes -1 for none.
        let parts: Option<[f64; 4]> =
            node.arguments.first().and_then(|argument| argument.value.vector());
        let [red, green, blue, _] = parts.ok_or_else(|| node.wrong("c"))?;
        let level = |part: f64| (part * 255.0).round().clamp(0.0, 255.0) as u8;
        let color = Rgb::new(level(red), level(green), level(blue));
        if let (Shape::Solid(tree), true) = (&mut shape, red >= 0.0) {
            tree.change_each(&mut |solid| solid.color = Some(color));
        }
        Ok(shape)
    }

    pub(super) fn resize(&mut self, node: &Node) -> Result<Shape, Error> {
        let shape = united(self.children(node)?);
        let wanted: [f64; 3] = node.vector("newsize")?;
        let auto: Vec<bool> = match node.value("auto") {
            Some(Value::List(list)) => {
                list.iter().map(|value| *value == Value::Bool(true)).collect()
            }
            _ => vec![node.is_set("auto"); 3],
        };
        let size = match &shape {
            Shape::Nothing => return Ok(shape),
            Shape::Flat(flat) => {
                let [low, high] = flat.resolved().bounds().unwrap_or_default();
                [high[0] - low[0], high[1] - low[1], 0.0]
            }
            Shape::Solid(tree) => {
                let [low, high] = super::bodies::bounds(tree)
                    .ok_or_else(|| Error::not_modelled(node.line, "the size of what is resized"))?;
                (high - low).to_array()
            }
        };
        let factor = |i: usize| (wanted[i] > 0.0 && size[i] > 0.0).then(|| wanted[i] / size[i]);
        let largest = (0..3).filter_map(factor).reduce(f64::max).unwrap_or(1.0);
        let is_auto = |i: usize| auto.get(i).copied().unwrap_or(false);
        let scale = [0, 1, 2].map(|i| factor(i).unwrap_or(if is_auto(i) { largest } else { 1.0 }));
        placed(shape, &scaling(scale), node.line)
    }
}

fn scaling([x, y, z]: [f64; 3]) -> Map {
    let columns = [vec3(x, 0.0, 0.0), vec3(0.0, y, 0.0), vec3(0.0, 0.0, z)];
    Map { columns, ..Map::IDENTITY }
}

/// The map of a `multmatrix`.
fn matrix(node: &Node) -> Result<Map, Error> {
    let wrong =
        || Error::argument(node.line, "the matrix isn't one of three or four rows of four numbers");
    let value = node.value("m").or(node.arguments.first().map(|argument| &argument.value));
    let rows = value.and_then(Value::list).ok_or_else(wrong)?;
    let mut rows = rows.iter().map(|row| row.vector::<4>().ok_or_else(wrong));
    let mut next = || rows.next().unwrap_or_else(|| Err(wrong()));
    let map = Map::of_rows([next()?, next()?, next()?]);
    match rows.next().transpose()? {
        None => Ok(map),
        Some([0.0, 0.0, 0.0, w]) if w != 0.0 => Ok(Map {
            columns: map.columns.map(|column| column * (1.0 / w)),
            shift: map.shift * (1.0 / w),
        }),
        Some(_) => Err(Error::not_modelled(node.line, "a projective matrix")),
    }
}

/// A shape behind a map. A map that makes it flat leaves nothing of it.
fn placed(shape: Shape, map: &Map, line: usize) -> Result<Shape, Error> {
    Ok(match shape {
        Shape::Nothing => Shape::Nothing,
        Shape::Flat(_) if map.flat().determinant() == 0.0 => Shape::Flat(Flat::Empty),
        Shape::Flat(flat) => {
            let flat = flat.mapped(&map.flat());
            let mut ends = flat.bounds().into_iter().flatten().flatten();
            if !ends.all(is_tame) {
                return Err(Error::argument(line, "the matrix makes a shape too large"));
            }
            Shape::Flat(flat)
        }
        Shape::Solid(_) if map.determinant() == 0.0 => Shape::Solid(Tree::Empty),
        Shape::Solid(mut tree) => {
            tree.place(map);
            Shape::Solid(tree)
        }
    })
}
