//! `rotate_extrude`: edges become frustums, circles rings.

use super::primitive::frustum;
use super::{Lowering, Shape};
use crate::error::Error;
use crate::flat::{Disc, Flat, Polygon};
use crate::map::{FlatMap, Map, Point, Vector};
use crate::parse::Node;
use crate::prism::{convex_hull, prism};
use crate::tree::{Form, Solid, Tree};
use i_overlay::core::overlay_rule::OverlayRule;
use scancsg::geom::vec3;
use std::f64::consts::TAU;

impl Lowering {
    pub(super) fn rotate_extrude(&mut self, node: &Node) -> Result<Shape, Error> {
        if node.text("file").is_some_and(|file| !file.is_empty()) {
            return Err(Error::not_modelled(node.line, "the extrusion of a file"));
        }
        let mut shape = self.flat_children(node)?;
        let Some([low, high]) = shape.bounds() else { return Ok(Shape::Solid(Tree::Empty)) };
        // To the left of the axis, it is what it mirrors.
        let is_left = low[0] < -1e-9 && high[0] <= 1e-9;
        if is_left {
            shape = shape.mapped(&FlatMap { columns: [[-1.0, 0.0], [0.0, 1.0]], shift: [0.0; 2] });
        }
        let degrees = node.number("angle")?.unwrap_or(360.0);
        let angle = if degrees.abs() < 360.0 { degrees.to_radians() } else { TAU };
        if let Some(facets) = node.facets()? {
            let facets = (facets as f64 * angle.abs() / TAU).ceil().max(1.0) as usize;
            let start = if is_left { TAU / 2.0 } else { 0.0 };
            return Ok(Shape::Solid(faceted(&shape, angle, facets, start, node.line)));
        }
        let reach = high[0].abs().max(low[0].abs());
        let [bottom, top] = [low[1], high[1]];
        let ring = revolved(&shape, node.line);
        if angle == TAU {
            return Ok(Shape::Solid(ring));
        }
        let heights = [bottom - reach * 0.1, top + reach * 0.1];
        let start = if is_left { TAU / 2.0 } else { 0.0 };
        let [from, to] = if angle > 0.0 { [start, start + angle] } else { [start + angle, start] };
        Ok(Shape::Solid(cut(ring, [from, to], reach * 1.1, heights, node.line)))
    }
}

/// What of a ring is between two angles.
fn cut(ring: Tree, [from, to]: [f64; 2], reach: f64, heights: [f64; 2], line: usize) -> Tree {
    let between = |from: f64, to: f64| {
        // Corners far enough out for the ring: of a pie in up to four pieces.
        let steps = ((to - from) / (TAU / 4.0)).ceil().max(1.0);
        let far = reach / ((to - from) / steps / 2.0).cos();
        let on_circle = |step: usize| {
            let (sin, cos) = (from + (to - from) * step as f64 / steps).sin_cos();
            let tidy = |part: f64| if part.abs() < 1e-12 { 0.0 } else { part };
            [far * tidy(cos), far * tidy(sin)]
        };
        let outline = (0..=steps as usize).map(on_circle);
        let corners: Vec<Point> = std::iter::once([0.0; 2]).chain(outline).collect();
        Tree::solid(prism(&corners, heights), line)
    };
    if to - from > TAU / 2.0 {
        Tree::difference(ring, [between(to, from + TAU)])
    } else {
        Tree::intersection([ring, between(from, to)])
    }
}

/// The solid that a shape passes through as it turns once around.
fn revolved(shape: &Flat, line: usize) -> Tree {
    let each =
        |shapes: &[Flat]| shapes.iter().map(|shape| revolved(shape, line)).collect::<Vec<_>>();
    match shape {
        Flat::Empty => Tree::Empty,
        Flat::Disc(Disc { center: [ring, height], radius }) => {
            let map = Map::translation(vec3(0.0, 0.0, *height));
            let form = match () {
                () if ring.abs() < 1e-9 * radius => Form::Sphere { radius: *radius },
                () if *ring > *radius => Form::Torus { ring: *ring, tube: *radius },
                () => return revolved(&Flat::Polygon(shape.resolved()), line),
            };
            Tree::Solid(Solid { form, map, color: None, line })
        }
        Flat::Ellipse(_) => revolved(&Flat::Polygon(shape.resolved()), line),
        Flat::Polygon(polygon) => {
            let pieces = right_half(polygon).convex_pieces();
            Tree::union(pieces.iter().map(|piece| revolved_convex(piece, line)))
        }
        Flat::Union(shapes) => Tree::union(each(shapes)),
        Flat::Intersection(shapes) => Tree::intersection(each(shapes)),
        Flat::Difference(first, others) => Tree::difference(revolved(first, line), each(others)),
    }
}

/// What of a polygon is to the right of the axis.
fn right_half(polygon: &Polygon) -> Polygon {
    let Some([low, high]) = polygon.bounds() else { return Polygon::default() };
    if low[0] >= 0.0 {
        return polygon.clone();
    }
    if low[0] > -1e-9 * high[0] {
        let on_axis = |[x, y]: Point| [x.max(0.0), y];
        let outlines: Vec<Vec<Point>> = polygon
            .parts()
            .iter()
            .flatten()
            .map(|outline| outline.iter().map(|point| on_axis(*point)).collect())
            .collect();
        return Polygon::of_outlines(&outlines);
    }
    let [right, top, bottom] = [high[0].abs() + 1.0, high[1] + 1.0, low[1] - 1.0];
    let half = vec![[0.0, bottom], [right, bottom], [right, top], [0.0, top]];
    polygon.combined(&Polygon::of_outline(half), OverlayRule::Intersect)
}

/// The edges that go up are outside, those that go down are inside: what the former sweep less what the latter do.
pub(super) fn revolved_convex(outline: &[Point], line: usize) -> Tree {
    let mut sides = [Vec::new(), Vec::new()];
    let size = outline.iter().flatten().fold(0.0f64, |size, part| size.max(part.abs()));
    for (from, to) in outline.iter().zip(outline.iter().cycle().skip(1)) {
        let (lower, upper, side) = if from[1] < to[1] { (from, to, 0) } else { (to, from, 1) };
        if upper[1] - lower[1] > 1e-9 * size && lower[0] + upper[0] > 0.0 {
            let form = frustum([lower[0], upper[0]], [lower[1], upper[1]]);
            sides[side].push(Tree::solid(form, line));
        }
    }
    let [outer, inner] = sides;
    Tree::difference(Tree::union(outer), inner)
}

/// The solid of so many flat steps.
fn faceted(shape: &Flat, angle: f64, facets: usize, start: f64, line: usize) -> Tree {
    let pieces = right_half(&shape.resolved()).convex_pieces();
    let at = |step: usize, [x, z]: Point| -> Vector {
        let (sin, cos) = (start + angle * step as f64 / facets as f64).sin_cos();
        vec3(x * cos, x * sin, z)
    };
    let mut wedges = Vec::new();
    for step in 0..facets {
        for piece in &pieces {
            let ends = piece.iter().flat_map(|point| [at(step, *point), at(step + 1, *point)]);
            let form = convex_hull(&ends.collect::<Vec<_>>());
            wedges.extend(form.map(|form| Tree::solid(form, line)));
        }
    }
    Tree::union(wedges)
}
