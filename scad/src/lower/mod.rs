//! From nodes to a tree of solids.

mod bodies;
mod extrude;
mod flat;
mod hull;
mod minkowski;
mod modify;
mod primitive;
mod revolve;

use crate::error::{Error, ErrorKind};
use crate::flat::Flat;
use crate::parse::Node;
use crate::tree::Tree;

/// What a part is made of, and what was left out.
#[derive(Debug, Clone, Default)]
pub struct Lowered {
    /// The part.
    pub tree: Tree,
    /// What isn't modelled and was left out, where that was asked for.
    pub skipped: Vec<Error>,
}

/// What a node stands for.
#[derive(Debug, Clone, Default)]
enum Shape {
    /// Nothing: it is neither flat nor solid.
    #[default]
    Nothing,
    Flat(Flat),
    Solid(Tree),
}

/// Makes solids of the nodes of a file.
///
/// What isn't modelled is an error, or is left out if `skip` says so.
///
/// ```
/// let nodes = scancsg_scad::parse("difference() { sphere(r = 2); cube(size = [1, 1, 9], center = true); }")?;
/// let part = scancsg_scad::lower(&nodes, false)?;
/// assert_eq!(part.tree.counts().solids, 2);
/// # Ok::<(), scancsg_scad::Error>(())
/// ```
///
/// # Errors
/// [`Error`], with the line.
pub fn lower(nodes: &[Node], skip: bool) -> Result<Lowered, Error> {
    let mut lowering = Lowering { skip, skipped: Vec::new() };
    let shape = match root(nodes) {
        // What is around a `!` has no say.
        Some(node) => lowering.node(node)?,
        None => {
            let shapes = lowering.each(nodes)?;
            united(shapes)
        }
    };
    let tree = match shape {
        Shape::Solid(tree) => tree,
        Shape::Nothing => Tree::Empty,
        Shape::Flat(_) => {
            return Err(Error::not_modelled(0, "a part that is flat: there is no solid in it"));
        }
    };
    Ok(Lowered { tree, skipped: lowering.skipped })
}

/// The node with a `!`, if there is one.
fn root(nodes: &[Node]) -> Option<&Node> {
    let present = nodes.iter().filter(|node| !node.modifiers.is_absent);
    present
        .into_iter()
        .find_map(|node| if node.modifiers.is_root { Some(node) } else { root(&node.children) })
}

struct Lowering {
    skip: bool,
    skipped: Vec<Error>,
}

impl Lowering {
    /// What a node stands for; nothing, for one that isn't modelled and may be left out.
    fn node(&mut self, node: &Node) -> Result<Shape, Error> {
        match self.modelled(node) {
            Err(error) if self.skip && matches!(error.kind, ErrorKind::NotModelled(_)) => {
                self.skipped.push(error);
                Ok(Shape::Nothing)
            }
            other => other,
        }
    }

    fn modelled(&mut self, node: &Node) -> Result<Shape, Error> {
        match node.name.as_str() {
            "group" | "union" | "render" | "assign" | "part" => Ok(united(self.children(node)?)),
            "intersection" => Ok(intersected(self.children(node)?)),
            "difference" => Ok(differing(self.children(node)?)),
            "multmatrix" => self.multmatrix(node),
            "color" => self.color(node),
            "resize" => self.resize(node),
            "cube" => primitive::cube(node),
            "sphere" => primitive::sphere(node),
            "cylinder" => primitive::cylinder(node),
            "polyhedron" => primitive::polyhedron(node),
            "circle" => flat::circle(node),
            "square" => flat::square(node),
            "polygon" => flat::polygon(node),
            "offset" => self.offset(node),
            "linear_extrude" => self.linear_extrude(node),
            "rotate_extrude" => self.rotate_extrude(node),
            "hull" => self.hull(node),
            "minkowski" => self.minkowski(node),
            other => Err(Error::not_modelled(node.line, format!("`{other}`"))),
        }
    }

    /// What the children of a node stand for, if they are operands.
    fn children(&mut self, node: &Node) -> Result<Vec<Shape>, Error> {
        self.each(&node.children)
    }

    fn each(&mut self, nodes: &[Node]) -> Result<Vec<Shape>, Error> {
        let operands = nodes.iter().filter(|node| !node.modifiers.is_absent);
        operands.map(|node| self.node(node)).collect()
    }

    /// The flat children of a node, united.
    fn flat_children(&mut self, node: &Node) -> Result<Flat, Error> {
        let shapes = self.children(node)?;
        let flat = |shape| if let Shape::Flat(flat) = shape { Some(flat) } else { None };
        Ok(Flat::union(shapes.into_iter().filter_map(flat)))
    }
}

/// Operands of one kind: that of the first child decides, and others don't count. Each is `None` if nothing is
/// there.
enum Operands {
    None,
    Flat(Vec<Flat>),
    Solid(Vec<Tree>),
}

impl Operands {
    fn of(shapes: Vec<Shape>) -> Self {
        let kind = shapes.iter().find(|shape| !matches!(shape, Shape::Nothing));
        match kind {
            Some(Shape::Flat(_)) => Self::Flat(
                shapes
                    .into_iter()
                    .filter_map(|shape| match shape {
                        Shape::Nothing => Some(Flat::Empty),
                        Shape::Flat(flat) => Some(flat),
                        Shape::Solid(_) => None,
                    })
                    .collect(),
            ),
            Some(Shape::Solid(_)) => Self::Solid(
                shapes
                    .into_iter()
                    .filter_map(|shape| match shape {
                        Shape::Nothing => Some(Tree::Empty),
                        Shape::Solid(tree) => Some(tree),
                        Shape::Flat(_) => None,
                    })
                    .collect(),
            ),
            _ => Self::None,
        }
    }
}

fn united(shapes: Vec<Shape>) -> Shape {
    match Operands::of(shapes) {
        Operands::None => Shape::Nothing,
        Operands::Flat(flats) => Shape::Flat(Flat::union(flats)),
        Operands::Solid(trees) => Shape::Solid(Tree::union(trees)),
    }
}

fn intersected(shapes: Vec<Shape>) -> Shape {
    match Operands::of(shapes) {
        Operands::None => Shape::Nothing,
        Operands::Flat(flats) => Shape::Flat(Flat::intersection(flats)),
        Operands::Solid(trees) => Shape::Solid(Tree::intersection(trees)),
    }
}

fn differing(shapes: Vec<Shape>) -> Shape {
    match Operands::of(shapes) {
        Operands::None => Shape::Nothing,
        Operands::Flat(flats) => {
            let mut flats = flats.into_iter();
            Shape::Flat(Flat::difference(flats.next().unwrap_or_default(), flats))
        }
        Operands::Solid(trees) => {
            let mut trees = trees.into_iter();
            Shape::Solid(Tree::difference(trees.next().unwrap_or_default(), trees))
        }
    }
}
