//! `linear_extrude`: booleans of the plane become booleans of solids.

use super::primitive::frustum;
use super::{Lowering, Shape};
use crate::error::Error;
use crate::flat::{Disc, Flat, SIDES};
use crate::map::{Map, Point};
use crate::parse::{Node, Value};
use crate::prism::{convex_hull, edges, prism};
use crate::tree::{Form, Solid, Tree};
use scancsg::geom::vec3;

/// How many layers an extrusion has that grows by two factors: one to nothing; for each part of its volume that one
/// layer is too large by; and at most.
const LAYERS: f64 = 16.0;
const LAYERS_A_SHARE: f64 = 500.0;
const MOST_LAYERS: f64 = 64.0;

/// How far up, and by which factors the shape grows on its way.
#[derive(Debug, Clone, Copy)]
pub(super) struct Extrusion {
    pub(super) heights: [f64; 2],
    pub(super) scale: [f64; 2],
    pub(super) line: usize,
}

impl Lowering {
    pub(super) fn linear_extrude(&mut self, node: &Node) -> Result<Shape, Error> {
        if node.text("file").is_some_and(|file| !file.is_empty()) {
            return Err(Error::not_modelled(node.line, "the extrusion of a file"));
        }
        let shape = self.flat_children(node)?;
        let height = match node.number("height")? {
            Some(height) => height,
            None => node.number("h")?.unwrap_or(100.0),
        };
        if height <= 0.0 || shape.is_empty() {
            return Ok(Shape::Solid(Tree::Empty));
        }
        let twist = node.number("twist")?.unwrap_or(0.0);
        if twist != 0.0 && !is_round(&shape) {
            return Err(Error::not_modelled(node.line, "`linear_extrude` with a twist"));
        }
        let scale = match node.value("scale") {
            None => [1.0; 2],
            Some(Value::Number(_)) => [node.finite("scale")?; 2],
            Some(_) => node.vector("scale")?,
        };
        let heights =
            if node.is_set("center") { [-height / 2.0, height / 2.0] } else { [0.0, height] };
        let extrusion =
            Extrusion { heights, scale: scale.map(|factor| factor.max(0.0)), line: node.line };
        Ok(Shape::Solid(extrusion.of(&shape)))
    }
}

/// Whether it is made of discs around the origin: no twist changes it.
fn is_round(shape: &Flat) -> bool {
    match shape {
        Flat::Empty => true,
        Flat::Disc(disc) => disc.center == [0.0; 2],
        Flat::Ellipse(_) | Flat::Polygon(_) => false,
        Flat::Union(shapes) | Flat::Intersection(shapes) => shapes.iter().all(is_round),
        Flat::Difference(first, others) => is_round(first) && others.iter().all(is_round),
    }
}

impl Extrusion {
    /// The solid over a shape.
    pub(super) fn of(&self, shape: &Flat) -> Tree {
        let each = |shapes: &[Flat]| shapes.iter().map(|shape| self.of(shape)).collect::<Vec<_>>();
        match shape {
            Flat::Empty => Tree::Empty,
            Flat::Disc(disc) => self.of_disc(disc),
            Flat::Ellipse(map) if self.scale == [1.0; 2] => {
                let form = Form::Cylinder { radius: 1.0, heights: self.heights };
                let map = map.upright();
                Tree::Solid(Solid { form, map, color: None, line: self.line })
            }
            Flat::Ellipse(_) => self.of(&Flat::Polygon(shape.resolved())),
            Flat::Polygon(polygon) => {
                let pieces = polygon.convex_pieces();
                Tree::union(pieces.iter().flat_map(|piece| self.of_convex(piece)))
            }
            Flat::Union(shapes) => Tree::union(each(shapes)),
            Flat::Intersection(shapes) => Tree::intersection(each(shapes)),
            Flat::Difference(first, others) => Tree::difference(self.of(first), each(others)),
        }
    }

    fn of_disc(&self, disc: &Disc) -> Tree {
        let [x, y] = disc.center;
        let [factor, other] = self.scale;
        let is_straight = self.scale == [1.0; 2];
        // It grows from the origin: farther out, that makes an oblique cone.
        if !is_straight && (factor != other || disc.center != [0.0; 2]) {
            return Tree::union(self.of_convex(&disc.outline(SIDES)));
        }
        let form = frustum([disc.radius, disc.radius * factor], self.heights);
        let map = Map::translation(vec3(x, y, 0.0));
        Tree::Solid(Solid { form, map, color: None, line: self.line })
    }

    fn of_convex(&self, outline: &[Point]) -> Vec<Tree> {
        if self.scale == [1.0; 2] {
            return vec![Tree::solid(prism(outline, self.heights), self.line)];
        }
        let [low, high] = self.heights;
        let [u, v] = self.scale;
        let layers = self.layers(outline);
        let section = |layer: f64| {
            let at = layer / layers;
            let [u, v] = [u, v].map(|factor| 1.0 + (factor - 1.0) * at);
            let z = if layer == layers { high } else { low + (high - low) * at };
            outline.iter().map(move |[x, y]| vec3(x * u, y * v, z))
        };
        let layer = |index: u32| {
            let lower = f64::from(index);
            let corners: Vec<_> = section(lower).chain(section(lower + 1.0)).collect();
            Some(Tree::solid(convex_hull(&corners)?, self.line))
        };
        (0..layers as u32).filter_map(layer).collect()
    }

    /// How many layers there are, each of them the hull of its ends.
    ///
    /// A wall is a plane if both factors are equal, or its edge is along an axis. Else it is bent inwards, and the hull
    /// is too large by half of the tetrahedron that the ends of the wall span. That falls with the number of layers.
    fn layers(&self, outline: &[Point]) -> f64 {
        let [u, v] = self.scale;
        let wide = |[[ax, ay], [bx, by]]: [Point; 2]| ((bx - ax) * (by - ay)).abs();
        let excess = edges(outline).map(wide).sum::<f64>() * (u - v).abs() / 12.0;
        if excess == 0.0 {
            return 1.0;
        }
        let twice = edges(outline).map(|[[ax, ay], [bx, by]]| ax * by - ay * bx).sum::<f64>();
        let volume = twice.abs() / 2.0 * (1.0 / 3.0 + (u + v) / 6.0 + u * v / 3.0);
        let bend = (u - v).abs() / u.max(v).max(1.0);
        (bend * LAYERS).max(excess / volume * LAYERS_A_SHARE).ceil().clamp(1.0, MOST_LAYERS)
    }
}
