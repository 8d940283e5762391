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
            "text" => flat::text(node),
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

#[cfg(test)]
mod tests {
    use super::lower;
    use crate::error::{Error, ErrorKind};
    use crate::parse::parse;
    use crate::place::Model;
    use crate::scene::Scene;
    use crate::tree::Counts;
    use crate::{Measures, measure};

    fn measured(text: &str) -> Result<Option<Measures>, Error> {
        let tree = lower(&parse(text)?, false)?.tree;
        Ok(measure(&Scene::of(&Model::of(tree)?)?, 90))
    }

    fn volume(text: &str) -> Result<f64, Error> {
        Ok(measured(text)?.map_or(0.0, |measures| measures.volume))
    }

    #[track_caller]
    fn assert_volume(text: &str, want: f64) {
        let got = volume(text).unwrap_or_else(|error| panic!("{text}: {error}"));
        assert!((got - want).abs() <= want * 0.004, "{text}: {got}, not {want}");
    }

    const CUBE: &str = "cube(size = [1, 2, 3], center = false);";

    #[test]
    fn empty_operands_count() {
        assert_volume(&format!("difference() {{ group(); {CUBE} }}"), 0.0);
        assert_volume(&format!("intersection() {{ {CUBE} group(); }}"), 0.0);
        assert_volume(&format!("union() {{ group(); {CUBE} }}"), 6.0);
        assert_volume(&format!("minkowski() {{ group(); {CUBE} }}"), 6.0);
        assert_volume(&format!("hull() {{ group(); {CUBE} }}"), 6.0);
        assert_volume("cylinder($fn = 0, h = 0, r1 = 1, r2 = 1);", 0.0);
    }

    #[test]
    fn modifiers_say_what_is_an_operand() {
        let big = "cube(size = [9, 9, 9], center = true);";
        assert_volume(&format!("difference() {{ %{big} {CUBE} }}"), 6.0);
        assert_volume(&format!("group() {{ *{big} #{CUBE} }}"), 6.0);
        let scaled = "multmatrix([[2, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])";
        assert_volume(&format!("{scaled} {{ group() {{ !{CUBE} }} }} {big}"), 6.0);
        assert_volume(&format!("{scaled} {{ group() {{ {CUBE} }} }}"), 12.0);
    }

    #[test]
    fn the_first_child_decides_whether_a_node_is_flat() {
        let square = "square(size = [1, 1], center = false);";
        assert_volume(&format!("union() {{ {CUBE} {square} }}"), 6.0);
        assert_volume(
            &format!("linear_extrude(height = 2) {{ union() {{ group(); {square} {CUBE} }} }}"),
            2.0,
        );
        assert!(volume(square).is_err());
    }

    #[test]
    fn few_facets_are_meant() {
        let area = |n: f64| n / 2.0 * (std::f64::consts::TAU / n).sin();
        for facets in [3, 4, 6, 8] {
            let text =
                format!("cylinder($fn = {facets}, $fa = 12, $fs = 2, h = 2, r1 = 1, r2 = 1);");
            assert_volume(&text, 2.0 * area(f64::from(facets)));
        }
        for facets in [0, 9, 30] {
            let text =
                format!("cylinder($fn = {facets}, $fa = 12, $fs = 2, h = 2, r1 = 1, r2 = 1);");
            assert_volume(&text, std::f64::consts::TAU);
        }
    }

    #[test]
    fn solids_have_their_volumes() {
        let pi = std::f64::consts::PI;
        assert_volume("sphere($fn = 0, r = 2);", pi * 32.0 / 3.0);
        assert_volume("cylinder(h = 3, r1 = 2, r2 = 1, center = true);", pi * 7.0);
        assert_volume(
            "rotate_extrude() { multmatrix([[1, 0, 0, 3], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) { circle(r = 1); } }",
            6.0 * pi * pi,
        );
        assert_volume(
            "rotate_extrude(angle = 90) { polygon(points = [[1, 0], [3, 0], [3, 2]], paths = undef); }",
            (7.0 / 3.0) * pi,
        );
        assert_volume(
            "rotate_extrude(angle = -270) { polygon(points = [[-1, 0], [-3, 0], [-3, 2]], paths = undef); }",
            7.0 * pi,
        );
        assert_volume(
            "linear_extrude(height = 3, scale = [0.5, 0.5]) { square(size = [2, 2], center = true); }",
            7.0,
        );
        // Walls that bend inwards: less than the hull of both ends, which has 416.7.
        assert_volume(
            "linear_extrude(height = 10, scale = [0.5, 1]) { polygon(points = [[0, 0], [10, 0], [0, 10]], paths = undef); }",
            375.0,
        );
        assert_volume(
            "linear_extrude(height = 10, scale = [0.5, 1]) { circle($fn = 0, r = 5); }",
            pi * 187.5,
        );
        assert_volume(
            "linear_extrude(height = 3, center = true) { polygon(points = [[0, 0], [3, 0], [3, 3], [0, 3], [1, 1], [2, 1], [2, 2], [1, 2]], paths = [[0, 1, 2, 3], [4, 5, 6, 7]]); }",
            24.0,
        );
        let corners = "[[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]]";
        assert_volume(
            &format!(
                "polyhedron(points = {corners}, faces = [[0, 1, 2], [1, 0, 3], [2, 1, 3], [0, 2, 3]]);"
            ),
            4.0 / 3.0,
        );
        assert_volume(
            &format!("resize(newsize = [4, 0, 0], auto = [false, true, true]) {{ {CUBE} }}"),
            6.0 * 64.0,
        );
    }

    #[test]
    fn hulls_and_sums_have_their_volumes() {
        let pi = std::f64::consts::PI;
        let moved = |x: f64, y: f64, what: &str| {
            format!(
                "multmatrix([[1, 0, 0, {x}], [0, 1, 0, {y}], [0, 0, 1, 0], [0, 0, 0, 1]]) {{ {what} }}"
            )
        };
        let disc = "cylinder(h = 2, r1 = 1, r2 = 1);";
        assert_volume(&format!("hull() {{ {disc} {} }}", moved(3.0, 0.0, disc)), 2.0 * (pi + 6.0));
        let ball = "sphere(r = 1);";
        assert_volume(
            &format!("hull() {{ {ball} {} }}", moved(3.0, 0.0, ball)),
            pi * (4.0 / 3.0 + 3.0),
        );
        assert_volume(
            &format!("hull() {{ {ball} {} {} }}", moved(3.0, 0.0, ball), moved(0.0, 3.0, ball)),
            9.0 + pi / 2.0 * (6.0 + 18f64.sqrt()) + pi * 4.0 / 3.0,
        );
        assert_volume(
            &format!("minkowski() {{ {CUBE} {ball} }}"),
            6.0 + 22.0 + 6.0 * pi + pi * 4.0 / 3.0,
        );
        assert_volume(&format!("minkowski() {{ {CUBE} {disc} }}"), 5.0 * (2.0 + 6.0 + pi));
        assert_volume(
            &format!(
                "hull() {{ {} cylinder(h = 1, r1 = 2, r2 = 2); }}",
                "cylinder(h = 3, r1 = 1, r2 = 1);"
            ),
            pi * (4.0 + 2.0 * 7.0 / 3.0),
        );
        // Facets: of a hull that is round in more than one way.
        assert_volume(
            &format!("hull() {{ {disc} {} }}", moved(3.0, 0.0, "cylinder(h = 4, r1 = 1, r2 = 1);")),
            18.0 + pi * 4.0,
        );
    }

    #[test]
    fn what_is_not_modelled_says_so_with_its_line() -> Result<(), Error> {
        let text = format!("{CUBE}\ngroup() {{\n\tsurface(file = \"a\");\n}}\n");
        let error = lower(&parse(&text)?, false).err();
        assert!(matches!(error, Some(Error { line: 3, kind: ErrorKind::NotModelled(_) })));
        let part = lower(&parse(&text)?, true)?;
        assert_eq!((part.skipped.len(), part.tree.counts().solids), (1, 1));
        let bent = "polyhedron(points = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [1, 1, 1], [0, 0, 4]], faces = [[0, 1, 2], [1, 0, 4], [0, 2, 4], [1, 4, 3], [4, 2, 3], [2, 1, 3]]);";
        assert!(matches!(
            lower(&parse(bent)?, false),
            Err(Error { kind: ErrorKind::NotModelled(_), .. })
        ));
        Ok(())
    }

    #[test]
    fn nested_operations_are_flattened() -> Result<(), Error> {
        let text = format!(
            "union() {{ group() {{ {CUBE} {CUBE} }} difference() {{ difference() {{ {CUBE} {CUBE} }} union() {{ {CUBE} {CUBE} }} }} }}"
        );
        let counts = lower(&parse(&text)?, false)?.tree.counts();
        assert_eq!(counts, Counts { solids: 6, operators: 5, levels: 2 });
        Ok(())
    }
}
