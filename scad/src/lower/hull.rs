//! The convex hull of bodies: exact for balls of one size, for what stands between two planes, and for what
//! is round about one axis. Other hulls get facets.

use super::bodies::{Body, across, bodies, sampled};
use super::extrude::Extrusion;
use super::revolve::revolved_convex;
use super::{Lowering, Operands, Shape};
use crate::error::Error;
use crate::flat::{Disc, Flat, hull_of_discs};
use crate::hull::{Hull, Polyhedron, hull_of_points};
use crate::map::{Map, Point, Vector, length};
use crate::parse::Node;
use crate::prism::convex_hull;
use crate::tree::{Form, Solid, Tree};
use scancsg::geom::vec3;

/// What counts as the same, in terms of the size.
const SAME: f64 = 1e-5;

impl Lowering {
    pub(super) fn hull(&mut self, node: &Node) -> Result<Shape, Error> {
        match Operands::of(self.children(node)?) {
            Operands::None => Ok(Shape::Nothing),
            Operands::Flat(flats) => {
                let discs: Vec<_> = flats.iter().flat_map(Flat::discs).collect();
                Ok(Shape::Flat(hull_of_discs(&discs)))
            }
            Operands::Solid(trees) => {
                let tree = Tree::union(trees);
                let what = "the hull of a cut solid whose corners are cut off";
                let bodies = bodies(&tree).ok_or_else(|| Error::not_modelled(node.line, what))?;
                hull_of_bodies(&bodies, node.line).map(Shape::Solid)
            }
        }
    }
}

/// The convex hull of bodies.
pub(super) fn hull_of_bodies(bodies: &[Body], line: usize) -> Result<Tree, Error> {
    let exact = of_points(bodies, line)
        .or_else(|| of_balls(bodies, line))
        .or_else(|| between_planes(bodies, line))
        .or_else(|| about_axis(bodies, line));
    if let Some(tree) = exact {
        return Ok(tree);
    }
    // As few facets as will do: a ray asks each of them.
    let balls = bodies.iter().filter(|body| matches!(body, Body::Ball { .. })).count();
    let on_ball = if balls > 8 { 256 } else { 512 };
    let form = convex_hull(&sampled(bodies, 96, on_ball))
        .ok_or_else(|| Error::not_modelled(line, "a hull that can't be found"))?;
    // The balls themselves are round.
    let round = bodies.iter().filter_map(|body| match body {
        Body::Ball { center, radius } => Some(ball(*center, *radius, line)),
        _ => None,
    });
    Ok(Tree::union(std::iter::once(Tree::solid(form, line)).chain(round)))
}

fn ball(center: Vector, radius: f64, line: usize) -> Tree {
    let map = Map::translation(center);
    Tree::Solid(Solid { form: Form::Sphere { radius }, map, color: None, line })
}

/// A cylinder from point to point.
fn rod(from: Vector, to: Vector, radius: f64, line: usize) -> Tree {
    let height = length(to - from);
    let axis = (to - from) * (1.0 / height);
    let [u, v] = across(axis);
    let map = Map { columns: [u, v, axis], shift: from };
    let form = Form::Cylinder { radius, heights: [0.0, height] };
    Tree::Solid(Solid { form, map, color: None, line })
}

fn of_points(bodies: &[Body], line: usize) -> Option<Tree> {
    let point = |body: &Body| if let Body::Point(point) = body { Some(*point) } else { None };
    let points: Vec<Vector> = bodies.iter().map(point).collect::<Option<_>>()?;
    match hull_of_points(&points)? {
        Hull::Solid(hull) => Some(Tree::solid(Form::Convex(hull.convex.into()), line)),
        _ => Some(Tree::Empty),
    }
}

/// Balls of one size: all that is within their radius of the hull of their middles. That is balls at its corners,
/// cylinders along its edges, and the hull of its faces, each moved outwards by the radius.
fn of_balls(bodies: &[Body], line: usize) -> Option<Tree> {
    let ball = |body: &Body| {
        if let Body::Ball { center, radius } = *body { Some((center, radius)) } else { None }
    };
    let balls: Vec<_> = bodies.iter().map(ball).collect::<Option<_>>()?;
    let radius = balls.first()?.1;
    if balls.iter().any(|(_, other)| (other - radius).abs() > SAME * radius) {
        return None;
    }
    let centers: Vec<Vector> = balls.into_iter().map(|(center, _)| center).collect();
    rounded(&centers, radius, line)
}

/// All that is within a radius of the hull of points.
pub(super) fn rounded(points: &[Vector], radius: f64, line: usize) -> Option<Tree> {
    let all = |corners: &[Vector], edges: &[[usize; 2]], inner: Vec<Tree>| {
        let balls = corners.iter().map(|corner| ball(*corner, radius, line));
        let rods = edges.iter().map(|[a, b]| rod(corners[*a], corners[*b], radius, line));
        Tree::union(inner.into_iter().chain(rods).chain(balls))
    };
    match hull_of_points(points)? {
        Hull::Nothing => Some(Tree::Empty),
        Hull::Point(point) => Some(all(&[point], &[], Vec::new())),
        Hull::Segment(ends) => Some(all(&ends, &[[0, 1]], Vec::new())),
        Hull::Plane(normal) => {
            let outline = in_plane(points, normal)?;
            let sides = outline.iter().flat_map(|p| [*p - normal * radius, *p + normal * radius]);
            let slab = convex_hull(&sides.collect::<Vec<_>>())?;
            let count = outline.len();
            let edges: Vec<_> = (0..count).map(|i| [i, (i + 1) % count]).collect();
            Some(all(&outline, &edges, vec![Tree::solid(slab, line)]))
        }
        Hull::Solid(hull) => {
            let inner = match block(&hull) {
                Some((map, size)) => boxes(&map, size, radius, line),
                None => {
                    let faces = hull.faces.iter().zip(&hull.convex.planes);
                    let moved = faces.flat_map(|(face, (normal, _))| {
                        face.iter().map(|corner| hull.convex.corners[*corner] + *normal * radius)
                    });
                    vec![Tree::solid(convex_hull(&moved.collect::<Vec<_>>())?, line)]
                }
            };
            Some(all(&hull.convex.corners, &hull.edges, inner))
        }
    }
}

/// The corners of the hull of points that lie in a plane, in order.
fn in_plane(points: &[Vector], normal: Vector) -> Option<Vec<Vector>> {
    let ([u, v], from) = (across(normal), *points.first()?);
    let flat = |point: &Vector| [(*point - from).dot(u), (*point - from).dot(v)];
    let discs: Vec<Disc> = points.iter().map(|point| Disc::point(flat(point))).collect();
    let Flat::Polygon(hull) = hull_of_discs(&discs) else { return None };
    let corners = hull.convex()?.into_iter();
    Some(corners.map(|[x, y]| from + u * x + v * y).collect())
}

/// The frame and the size of a hull that is a box, with its lowest corner at the origin.
fn block(hull: &Polyhedron) -> Option<(Map, [f64; 3])> {
    if hull.convex.corners.len() != 8 || hull.faces.len() != 6 {
        return None;
    }
    let from = hull.convex.corners[0];
    let along: Vec<Vector> = hull
        .edges
        .iter()
        .filter(|edge| edge.contains(&0))
        .map(|[a, b]| hull.convex.corners[a + b] - from)
        .collect();
    let [x, mut y, mut z] = along.try_into().ok()?;
    if x.dot(y.cross(z)) < 0.0 {
        std::mem::swap(&mut y, &mut z);
    }
    let size = [x, y, z].map(length);
    let is_square = |a: Vector, b: Vector| a.dot(b).abs() < SAME * length(a) * length(b);
    let columns = [x * (1.0 / size[0]), y * (1.0 / size[1]), z * (1.0 / size[2])];
    (is_square(x, y) && is_square(y, z) && is_square(z, x))
        .then_some((Map { columns, shift: from }, size))
}

/// Three boxes, each longer by the radius along one axis.
fn boxes(map: &Map, size: [f64; 3], radius: f64, line: usize) -> Vec<Tree> {
    let grown = |axis: usize| {
        let by = [0, 1, 2].map(|i| if i == axis { radius } else { 0.0 });
        let high = [0, 1, 2].map(|i| size[i] + by[i]);
        let form = Form::Cuboid([-Vector::from(by), Vector::from(high)]);
        Tree::Solid(Solid { form, map: *map, color: None, line })
    };
    (0..3).map(grown).collect()
}

/// Discs and points in two planes across their axis, the same in both: a prism over the hull of the discs.
fn between_planes(bodies: &[Body], line: usize) -> Option<Tree> {
    let axis = bodies.iter().find_map(|body| match body {
        Body::Disc { axis, .. } => Some(*axis),
        _ => None,
    })?;
    let [u, v] = across(axis);
    let flat = |body: &Body| match *body {
        Body::Point(point) => Some((point, 0.0)),
        Body::Disc { center, axis: other, radius } => {
            (length(other.cross(axis)) < SAME).then_some((center, radius))
        }
        Body::Ball { .. } => None,
    };
    let placed: Vec<(Vector, f64)> = bodies.iter().map(flat).collect::<Option<_>>()?;
    let heights: Vec<f64> = placed.iter().map(|(center, _)| center.dot(axis)).collect();
    let low = heights.iter().copied().reduce(f64::min)?;
    let high = heights.iter().copied().reduce(f64::max)?;
    let size = placed.iter().map(|(center, radius)| center.max_abs() + radius).fold(0.0, f64::max);
    let is_same = |a: f64, b: f64| (a - b).abs() < SAME * size;
    let level = |height: f64| -> Vec<Disc> {
        let at = placed.iter().zip(&heights).filter(|(_, own)| is_same(**own, height));
        at.map(|((center, radius), _)| Disc {
            center: [center.dot(u), center.dot(v)],
            radius: *radius,
        })
        .collect()
    };
    let [lower, upper] = [level(low), level(high)];
    let is_disc = |a: &Disc, b: &Disc| {
        is_same(a.radius, b.radius)
            && is_same(a.center[0], b.center[0])
            && is_same(a.center[1], b.center[1])
    };
    let has_all =
        |some: &[Disc], all: &[Disc]| some.iter().all(|a| all.iter().any(|b| is_disc(a, b)));
    // What is between is in the prism if it is in both ends.
    let all: Vec<Disc> = placed
        .iter()
        .map(|(center, radius)| Disc { center: [center.dot(u), center.dot(v)], radius: *radius })
        .collect();
    if is_same(low, high) || !(has_all(&all, &lower) && has_all(&all, &upper)) {
        return None;
    }
    let extrusion = Extrusion { heights: [low, high], scale: [1.0; 2], line };
    let mut tree = extrusion.of(&hull_of_discs(&lower));
    tree.place(&Map { columns: [u, v, axis], shift: vec3(0.0, 0.0, 0.0) });
    Some(tree)
}

/// Discs and balls around one axis: the frustums of the hull of their profile, and the balls.
fn about_axis(bodies: &[Body], line: usize) -> Option<Tree> {
    let center = |body: &Body| match *body {
        Body::Point(center) | Body::Ball { center, .. } | Body::Disc { center, .. } => center,
    };
    let from = center(bodies.first()?);
    let disc_axis = bodies.iter().find_map(|body| match body {
        Body::Disc { axis, .. } => Some(*axis),
        _ => None,
    });
    let far = bodies
        .iter()
        .map(|body| center(body) - from)
        .max_by(|a, b| length(*a).total_cmp(&length(*b)))?;
    let axis = disc_axis.or_else(|| far.normalized())?;
    let size = length(far)
        + bodies
            .iter()
            .map(|body| match body {
                Body::Point(_) => 0.0,
                Body::Ball { radius, .. } | Body::Disc { radius, .. } => *radius,
            })
            .fold(0.0, f64::max);
    let mut profile = Vec::new();
    for body in bodies {
        let offset = center(body) - from;
        let z = offset.dot(axis);
        if length(offset - axis * z) > SAME * size {
            return None;
        }
        match *body {
            Body::Point(_) => profile.push(Disc::point([0.0, z])),
            Body::Ball { radius, .. } => profile.push(Disc { center: [0.0, z], radius }),
            Body::Disc { axis: other, radius, .. } if length(other.cross(axis)) < SAME => {
                profile.extend([[-radius, z], [radius, z]].map(Disc::point));
            }
            Body::Disc { .. } => return None,
        }
    }
    let hull = hull_of_discs(&profile);
    let parts = match hull {
        Flat::Union(parts) => parts,
        other => vec![other],
    };
    let [u, v] = across(axis);
    let frame = Map { columns: [u, v, axis], shift: from };
    let solids = parts.into_iter().filter_map(|part| match part {
        Flat::Polygon(polygon) => {
            let outline = right_half(polygon.convex()?);
            Some(revolved_convex(&outline, line))
        }
        Flat::Disc(disc) => Some(ball(vec3(0.0, 0.0, disc.center[1]), disc.radius, line)),
        _ => None,
    });
    let mut tree = Tree::union(solids);
    tree.place(&frame);
    Some(tree)
}

/// The right half of a profile, as an outline that begins and ends on the axis. Going up, it is convex: its
/// corners are in the order of their heights.
fn right_half(outline: Vec<Point>) -> Vec<Point> {
    let ends =
        |pick: fn(f64, f64) -> f64| outline.iter().map(|[_, z]| *z).reduce(pick).unwrap_or(0.0);
    let [low, high] = [ends(f64::min), ends(f64::max)];
    let mut right: Vec<Point> = outline.iter().copied().filter(|[x, _]| *x > 0.0).collect();
    right.sort_by(|a, b| a[1].total_cmp(&b[1]));
    [vec![[0.0, low]], right, vec![[0.0, high]]].concat()
}
