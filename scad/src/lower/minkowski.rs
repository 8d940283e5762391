//! Minkowski sums of unions of convex solids.

use super::bodies::{Body, bodies, sampled};
use super::hull::hull_of_bodies;
use super::{Lowering, Operands, Shape};
use crate::error::Error;
use crate::flat::{Disc, Flat, Join, Polygon, hull_of_discs, offset};
use crate::map::{Map, length};
use crate::parse::Node;
use crate::tree::{Form, Solid, Tree};
use scancsg::geom::vec3;

/// The most pairs of convex operands.
const MOST_PAIRS: usize = 1_000;

impl Lowering {
    pub(super) fn minkowski(&mut self, node: &Node) -> Result<Shape, Error> {
        match Operands::of(self.children(node)?) {
            Operands::None => Ok(Shape::Nothing),
            Operands::Flat(flats) => {
                let mut flats = flats.into_iter().filter(|flat| !flat.is_empty());
                let first = flats.next().unwrap_or_default();
                Ok(Shape::Flat(flats.fold(first, |sum, next| flat_sum(&sum, &next))))
            }
            Operands::Solid(trees) => {
                let mut trees = trees.into_iter().filter(|tree| !matches!(tree, Tree::Empty));
                let first = trees.next().unwrap_or_default();
                let sum = trees.try_fold(first, |sum, next| solid_sum(&sum, &next, node.line));
                sum.map(Shape::Solid)
            }
        }
    }
}

/// Of convex pieces: the hulls of all sums of their discs. Of a disc, what an offset is.
fn flat_sum(a: &Flat, b: &Flat) -> Flat {
    for [shape, disc] in [[a, b], [b, a]] {
        if let Flat::Disc(Disc { center, radius }) = disc
            && let Some(grown) = offset(shape, *radius, Join::Round)
        {
            let shift = Map::translation(vec3(center[0], center[1], 0.0));
            return grown.mapped(&shift.flat());
        }
    }
    let [a, b] = [a, b].map(flat_pieces);
    let mut sums = Vec::new();
    for first in &a {
        for second in &b {
            let pairs = first.iter().flat_map(|p| second.iter().map(move |q| sum_of_discs(p, q)));
            sums.push(hull_of_discs(&pairs.collect::<Vec<_>>()));
        }
    }
    Flat::union(sums)
}

fn sum_of_discs(a: &Disc, b: &Disc) -> Disc {
    let center = [0, 1].map(|i| a.center[i] + b.center[i]);
    Disc { center, radius: a.radius + b.radius }
}

/// The discs of convex shapes that together are this one.
fn flat_pieces(shape: &Flat) -> Vec<Vec<Disc>> {
    match shape {
        Flat::Empty => Vec::new(),
        Flat::Disc(disc) => vec![vec![*disc]],
        Flat::Union(shapes) => shapes.iter().flat_map(flat_pieces).collect(),
        _ => {
            let polygon: Polygon = shape.resolved();
            let discs = |piece: Vec<_>| piece.into_iter().map(Disc::point).collect();
            polygon.convex_pieces().into_iter().map(discs).collect()
        }
    }
}

fn solid_sum(a: &Tree, b: &Tree, line: usize) -> Result<Tree, Error> {
    let [a, b] = [pieces(a, line)?, pieces(b, line)?];
    if a.len() * b.len() > MOST_PAIRS {
        return Err(Error::not_modelled(line, "a `minkowski` of so many solids"));
    }
    let mut sums = Vec::new();
    for first in &a {
        for second in &b {
            sums.push(sum(first, second, line)?);
        }
    }
    Ok(Tree::union(sums))
}

/// The convex solids that a union is made of.
fn pieces(tree: &Tree, line: usize) -> Result<Vec<Vec<Body>>, Error> {
    let cut =
        || Error::not_modelled(line, "a `minkowski` of solids that aren't unions of convex ones");
    match tree {
        Tree::Empty => Ok(Vec::new()),
        Tree::Solid(Solid { form: Form::Torus { .. }, .. }) => Err(cut()),
        Tree::Solid(_) => Ok(vec![bodies(tree).ok_or_else(cut)?]),
        Tree::Union(members) => {
            let each: Result<Vec<_>, _> =
                members.iter().map(|member| pieces(member, line)).collect();
            each.map(|each| each.concat())
        }
        Tree::Intersection(_) | Tree::Difference(..) => Err(cut()),
    }
}

/// The hull of the sums of all bodies.
fn sum(a: &[Body], b: &[Body], line: usize) -> Result<Tree, Error> {
    for [solid, other] in [[a, b], [b, a]] {
        if let [Body::Ball { center, radius }] = other
            && let Some(tree) = rounded_cylinder(solid, *radius, line)
        {
            let mut tree = tree;
            tree.place(&Map::translation(*center));
            return Ok(tree);
        }
    }
    let mut sums = Vec::new();
    for first in a {
        for second in b {
            sums.extend(sum_of_bodies(first, second));
        }
    }
    hull_of_bodies(&sums, line)
}

fn sum_of_bodies(a: &Body, b: &Body) -> Vec<Body> {
    match (*a, *b) {
        (Body::Point(p), Body::Point(q)) => vec![Body::Point(p + q)],
        (Body::Point(p), Body::Ball { center, radius })
        | (Body::Ball { center, radius }, Body::Point(p)) => {
            vec![Body::Ball { center: center + p, radius }]
        }
        (Body::Point(p), Body::Disc { center, axis, radius })
        | (Body::Disc { center, axis, radius }, Body::Point(p)) => {
            vec![Body::Disc { center: center + p, axis, radius }]
        }
        (Body::Ball { center: p, radius: r }, Body::Ball { center: q, radius: s }) => {
            vec![Body::Ball { center: p + q, radius: r + s }]
        }
        (
            Body::Disc { center: p, axis, radius: r },
            Body::Disc { center: q, axis: other, radius: s },
        ) if length(axis.cross(other)) < 1e-5 => {
            vec![Body::Disc { center: p + q, axis, radius: r + s }]
        }
        // Round in more than one way: points will do.
        _ => {
            let [a, b] = [a, b].map(|body| sampled(&[*body], 48, 128));
            a.iter().flat_map(|p| b.iter().map(move |q| Body::Point(*p + *q))).collect()
        }
    }
}

/// A cylinder with rounded edges: two cylinders, and a ring at either end.
fn rounded_cylinder(bodies: &[Body], by: f64, line: usize) -> Option<Tree> {
    let &[Body::Disc { center: from, axis, radius }, Body::Disc { center: to, radius: other, .. }] =
        bodies
    else {
        return None;
    };
    let height = (to - from).dot(axis);
    let is_straight = length(to - from - axis * height) < 1e-5 * height.abs();
    if !is_straight || (radius - other).abs() > 1e-5 * radius || by >= radius {
        return None;
    }
    let [u, v] = super::bodies::across(axis);
    let (low, high) = (height.min(0.0), height.max(0.0));
    let solid = |form: Form, shift: f64| {
        let map = Map { columns: [u, v, axis], shift: from + axis * shift };
        Tree::Solid(Solid { form, map, color: None, line })
    };
    let wide = Form::Cylinder { radius: radius + by, heights: [low, high] };
    let tall = Form::Cylinder { radius, heights: [low - by, high + by] };
    let ring = Form::Torus { ring: radius, tube: by };
    Some(Tree::union([
        solid(wide, 0.0),
        solid(tall, 0.0),
        solid(ring.clone(), low),
        solid(ring, high),
    ]))
}
