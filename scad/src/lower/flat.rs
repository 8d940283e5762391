//! Flat shapes that a node names: `circle`, `square`, `polygon`; and `offset`.

use super::{Lowering, Shape};
use crate::error::Error;
use crate::flat::{Disc, Flat, Join, Polygon, Text, offset};
use crate::map::Point;
use crate::parse::{Node, Value};

pub(super) fn circle(node: &Node) -> Result<Shape, Error> {
    let disc = Disc { center: [0.0; 2], radius: node.finite("r")? };
    if disc.radius <= 0.0 {
        return Ok(Shape::Flat(Flat::Empty));
    }
    Ok(Shape::Flat(match node.facets()? {
        Some(facets) => Flat::Polygon(Polygon::of_outline(disc.outline(facets))),
        None => Flat::Disc(disc),
    }))
}

pub(super) fn square(node: &Node) -> Result<Shape, Error> {
    let [width, height] = node.vector("size")?;
    if !(width > 0.0 && height > 0.0) {
        return Ok(Shape::Flat(Flat::Empty));
    }
    let [left, low] = if node.is_set("center") { [-width / 2.0, -height / 2.0] } else { [0.0; 2] };
    let [right, high] =
        if node.is_set("center") { [width / 2.0, height / 2.0] } else { [width, height] };
    let outline = vec![[left, low], [right, low], [right, high], [left, high]];
    Ok(Shape::Flat(Flat::Polygon(Polygon::of_outline(outline))))
}

pub(super) fn polygon(node: &Node) -> Result<Shape, Error> {
    let list = node.value("points").and_then(Value::list).ok_or_else(|| node.wrong("points"))?;
    let point = |value: &Value| value.vector().ok_or_else(|| node.wrong("points"));
    let points = list.iter().map(point).collect::<Result<Vec<Point>, _>>()?;
    let outlines = match node.value("paths") {
        None => vec![points],
        Some(paths) => {
            let index = |value: &Value| points.get(value.finite()? as usize).copied();
            let path = |value: &Value| value.list()?.iter().map(index).collect::<Option<Vec<_>>>();
            let outlines = paths.list().and_then(|paths| paths.iter().map(path).collect());
            outlines.ok_or_else(|| node.wrong("paths"))?
        }
    };
    let polygon = Polygon::of_outlines(&outlines);
    Ok(Shape::Flat(if polygon.parts().is_empty() { Flat::Empty } else { Flat::Polygon(polygon) }))
}

pub(super) fn text(node: &Node) -> Result<Shape, Error> {
    if !matches!(node.text("direction"), None | Some("ltr" | "")) {
        return Err(Error::not_modelled(node.line, "a text that doesn't run from left to right"));
    }
    let text = Text {
        text: node.text("text").unwrap_or_default(),
        size: node.number("size")?.unwrap_or(10.0),
        spacing: node.number("spacing")?.unwrap_or(1.0),
        font: node.text("font").unwrap_or_default(),
        halign: node.text("halign").unwrap_or("left"),
        valign: node.text("valign").unwrap_or("baseline"),
    };
    let set = crate::flat::text(&text);
    set.map(Shape::Flat)
        .ok_or_else(|| Error::not_modelled(node.line, "`text` where no font is installed"))
}

impl Lowering {
    pub(super) fn offset(&mut self, node: &Node) -> Result<Shape, Error> {
        let shape = self.flat_children(node)?;
        let (by, join) = match node.number("r")? {
            Some(by) => (by, Join::Round),
            None if node.is_set("chamfer") => (node.finite("delta")?, Join::Chamfer),
            None => (node.finite("delta")?, Join::Sharp),
        };
        let offset = offset(&shape, by, join);
        let what = "the chamfers of a shape that isn't convex";
        offset.map(Shape::Flat).ok_or_else(|| Error::not_modelled(node.line, what))
    }
}
