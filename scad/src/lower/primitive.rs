//! Solids that a node names: `cube`, `sphere`, `cylinder`, `polyhedron`.

use super::Shape;
use crate::error::Error;
use crate::flat::Disc;
use crate::hull::{Hull, hull_of_points};
use crate::map::{Vector, length};
use crate::parse::{Node, Value};
use crate::prism::convex_hull;
use crate::tree::{Form, Tree};
use scancsg::geom::vec3;
use std::sync::Arc;

pub(super) fn solid(form: Form, node: &Node) -> Shape {
    Shape::Solid(Tree::solid(form, node.line))
}

const EMPTY: Shape = Shape::Solid(Tree::Empty);

pub(super) fn cube(node: &Node) -> Result<Shape, Error> {
    let size = Vector::from(node.vector("size")?);
    if !(size.x > 0.0 && size.y > 0.0 && size.z > 0.0) {
        return Ok(EMPTY);
    }
    let low = if node.is_set("center") { size * -0.5 } else { size * 0.0 };
    let high = if node.is_set("center") { size * 0.5 } else { size };
    Ok(solid(Form::Cuboid([low, high]), node))
}

pub(super) fn sphere(node: &Node) -> Result<Shape, Error> {
    let radius = node.finite("r")?;
    if radius <= 0.0 {
        return Ok(EMPTY);
    }
    let Some(facets) = node.facets()? else {
        return Ok(solid(Form::Sphere { radius }, node));
    };
    // OpenSCAD's rings of corners: none is at a pole.
    let rings = facets.div_ceil(2);
    let ring = |index: usize| {
        let angle = std::f64::consts::PI * (index as f64 + 0.5) / rings as f64;
        let around = Disc { center: [0.0; 2], radius: radius * angle.sin() };
        let points = around.outline(facets).into_iter();
        points.map(move |[x, y]| vec3(x, y, radius * angle.cos()))
    };
    let corners: Vec<_> = (0..rings).flat_map(ring).collect();
    Ok(convex_hull(&corners).map_or(EMPTY, |form| solid(form, node)))
}

pub(super) fn cylinder(node: &Node) -> Result<Shape, Error> {
    let [height, lower, upper] = [node.finite("h")?, node.finite("r1")?, node.finite("r2")?];
    if height <= 0.0 || lower < 0.0 || upper < 0.0 || lower + upper <= 0.0 {
        return Ok(EMPTY);
    }
    let heights = if node.is_set("center") { [-height / 2.0, height / 2.0] } else { [0.0, height] };
    let Some(facets) = node.facets()? else {
        return Ok(solid(frustum([lower, upper], heights), node));
    };
    let ring = |(radius, z): (f64, f64)| {
        let points = Disc { center: [0.0; 2], radius }.outline(facets).into_iter();
        points.map(move |[x, y]| vec3(x, y, z))
    };
    if lower == upper {
        let polygon = Disc { center: [0.0; 2], radius: lower }.outline(facets);
        return Ok(solid(crate::prism::prism(&polygon, heights), node));
    }
    let corners: Vec<_> = [lower, upper].into_iter().zip(heights).flat_map(ring).collect();
    Ok(convex_hull(&corners).map_or(EMPTY, |form| solid(form, node)))
}

/// A cylinder or a cone.
pub(super) fn frustum(radii: [f64; 2], heights: [f64; 2]) -> Form {
    if radii[0] == radii[1] {
        Form::Cylinder { radius: radii[0], heights }
    } else {
        Form::Cone { radii, heights }
    }
}

/// A polyhedron is modelled if it is convex: if no corner is outside of the plane of a face, whichever way round
/// its corners are. What is closed and so is the convex hull of its corners.
pub(super) fn polyhedron(node: &Node) -> Result<Shape, Error> {
    let lists = |name: &str| node.value(name).and_then(Value::list).ok_or_else(|| node.wrong(name));
    let point =
        |value: &Value| value.vector().map(Vector::from).ok_or_else(|| node.wrong("points"));
    let points = lists("points")?.iter().map(point).collect::<Result<Vec<_>, _>>()?;
    let mut faces = Vec::new();
    for face in lists("faces").or_else(|_| lists("triangles"))? {
        let index = |value: &Value| points.get(value.finite()? as usize).copied();
        let corners: Option<Vec<Vector>> =
            face.list().and_then(|list| list.iter().map(index).collect());
        faces.push(corners.ok_or_else(|| node.wrong("faces"))?);
    }
    let used: Vec<Vector> = faces.iter().flatten().copied().collect();
    let hull = match hull_of_points(&used) {
        Some(Hull::Solid(hull)) => hull,
        None => {
            return Err(Error::not_modelled(node.line, "a `polyhedron` whose hull can't be found"));
        }
        Some(_) => return Ok(EMPTY),
    };
    let size = used.iter().map(|corner| length(*corner - used[0])).fold(0.0, f64::max);
    let is_outside = |face: &Vec<Vector>| {
        let plane = |(normal, offset): &(Vector, f64)| {
            face.iter().all(|corner| (normal.dot(*corner) - offset).abs() < 2e-6 * size)
        };
        hull.convex.planes.iter().any(plane)
    };
    let sliver = |face: &Vec<Vector>| {
        matches!(hull_of_points(face), Some(Hull::Segment(_) | Hull::Point(_)))
    };
    if !faces.iter().all(|face| is_outside(face) || sliver(face)) {
        return Err(Error::not_modelled(node.line, "a `polyhedron` that isn't convex"));
    }
    Ok(solid(Form::Convex(Arc::new(hull.convex)), node))
}
