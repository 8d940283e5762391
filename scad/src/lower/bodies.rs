//! Points, balls and discs that span what a solid fills: `hull` and `minkowski` are made of these.

use crate::flat::{Disc, SIDES};
use crate::map::{Map, SIX_DIGITS, Vector, length};
use crate::tree::{Form, Solid, Tree};
use scancsg::geom::vec3;
use std::f64::consts::{PI, TAU};

/// Something convex. A solid is the hull of some of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Body {
    Point(Vector),
    Ball {
        center: Vector,
        radius: f64,
    },
    /// Flat and round, across an axis of length 1.
    Disc {
        center: Vector,
        axis: Vector,
        radius: f64,
    },
}

/// The bodies that span a tree. `None` if they aren't known: an intersection, or a difference that takes
/// something of what spans its first operand.
pub(super) fn bodies(tree: &Tree) -> Option<Vec<Body>> {
    match tree {
        Tree::Empty => Some(Vec::new()),
        Tree::Solid(solid) => Some(of_solid(solid)),
        Tree::Union(members) => {
            let each: Option<Vec<_>> = members.iter().map(bodies).collect();
            each.map(|each| each.concat())
        }
        Tree::Difference(first, others) => {
            let bodies = bodies(first)?;
            let points = sampled(&bodies, SIDES, 256);
            let is_cut = |point: &Vector| others.iter().any(|other| contains(other, *point));
            (!points.iter().any(is_cut)).then_some(bodies)
        }
        Tree::Intersection(_) => None,
    }
}

/// The lowest and the highest coordinates of a tree, as far as its bodies are known.
pub(super) fn bounds(tree: &Tree) -> Option<[Vector; 2]> {
    let ends = bodies(tree)?.into_iter().map(|body| {
        let (center, reach) = match body {
            Body::Point(point) => (point, vec3(0.0, 0.0, 0.0)),
            Body::Ball { center, radius } => (center, vec3(radius, radius, radius)),
            Body::Disc { center, axis, radius } => {
                (center, axis.map(|part| radius * (1.0 - part * part).max(0.0).sqrt()))
            }
        };
        [center - reach, center + reach]
    });
    ends.reduce(|[low, high], [l, h]| {
        let low = vec3(low.x.min(l.x), low.y.min(l.y), low.z.min(l.z));
        [low, vec3(high.x.max(h.x), high.y.max(h.y), high.z.max(h.z))]
    })
}

fn of_solid(solid: &Solid) -> Vec<Body> {
    let map = &solid.map;
    match &solid.form {
        Form::Cuboid([low, high]) => {
            let pick = |i: usize, a: f64, b: f64, bit: usize| if i >> bit & 1 == 0 { a } else { b };
            let corner = |i| {
                vec3(
                    pick(i, low.x, high.x, 0),
                    pick(i, low.y, high.y, 1),
                    pick(i, low.z, high.z, 2),
                )
            };
            (0..8).map(|i| Body::Point(map.point(corner(i)))).collect()
        }
        Form::Convex(convex) => {
            convex.corners.iter().map(|corner| Body::Point(map.point(*corner))).collect()
        }
        Form::Sphere { radius } => match map.uniform_scale(SIX_DIGITS) {
            Some(scale) => vec![Body::Ball { center: map.shift, radius: radius * scale }],
            None => {
                let points = globe(1024).into_iter();
                points.map(|point| Body::Point(map.point(point * *radius))).collect()
            }
        },
        Form::Cylinder { radius, heights } => ends([*radius; 2], *heights, map),
        Form::Cone { radii, heights } => ends(*radii, *heights, map),
        Form::Torus { ring, tube } => {
            let level = |step: usize| {
                let (sin, cos) = (PI * (step as f64 / 16.0 - 0.5)).sin_cos();
                ends([ring + tube * cos; 2], [tube * sin; 2], map).into_iter().take(1)
            };
            (0..=16).flat_map(level).collect()
        }
    }
}

/// The caps of a cylinder or a cone: discs, or points if they shrink to these or are mapped to ellipses.
fn ends(radii: [f64; 2], heights: [f64; 2], map: &Map) -> Vec<Body> {
    let [x, y, _] = map.columns;
    let (across, scale) = (x.cross(y), length(x));
    let is_round = (length(y) - scale).abs() < SIX_DIGITS * scale
        && x.dot(y).abs() < SIX_DIGITS * scale * scale;
    let axis = across * (1.0 / length(across));
    let cap = |(radius, height): (f64, f64)| -> Vec<Body> {
        let center = map.point(vec3(0.0, 0.0, height));
        if radius == 0.0 {
            return vec![Body::Point(center)];
        }
        if is_round {
            return vec![Body::Disc { center, axis, radius: radius * scale }];
        }
        let points = Disc { center: [0.0; 2], radius }.outline(SIDES).into_iter();
        points.map(|[u, v]| Body::Point(map.point(vec3(u, v, height)))).collect()
    };
    radii.into_iter().zip(heights).flat_map(cap).collect()
}

/// Points on bodies: so many on a disc's edge, and about so many on a ball.
pub(super) fn sampled(bodies: &[Body], on_disc: usize, on_ball: usize) -> Vec<Vector> {
    let globe = globe(on_ball);
    let points = |body: &Body| match *body {
        Body::Point(point) => vec![point],
        Body::Ball { center, radius } => {
            globe.iter().map(|point| center + *point * radius).collect()
        }
        Body::Disc { center, axis, radius } => {
            let [u, v] = across(axis);
            let outline = Disc { center: [0.0; 2], radius }.outline(on_disc).into_iter();
            outline.map(|[x, y]| center + u * x + v * y).collect()
        }
    };
    bodies.iter().flat_map(points).collect()
}

/// About so many points on the unit ball, on circles of latitude.
fn globe(count: usize) -> Vec<Vector> {
    let levels = ((count as f64 / 2.0).sqrt() as usize).max(2);
    let level = |step: usize| {
        let (sin, cos) = (PI * (step as f64 / levels as f64 - 0.5)).sin_cos();
        let around = if step.is_multiple_of(levels) { 1 } else { 2 * levels };
        (0..around).map(move |turn| {
            let (s, c) = (TAU * turn as f64 / around as f64).sin_cos();
            vec3(cos * c, cos * s, sin)
        })
    };
    (0..=levels).flat_map(level).collect()
}

/// Two directions of length 1 across an axis and each other, with the axis right-handed.
pub(super) fn across(axis: Vector) -> [Vector; 2] {
    let least = if axis.x.abs() < 0.6 { vec3(1.0, 0.0, 0.0) } else { vec3(0.0, 1.0, 0.0) };
    let u = least - axis * axis.dot(least);
    let u = u * (1.0 / length(u));
    [u, axis.cross(u)]
}

/// Whether a point is inside of a tree by more than what six digits can move it.
fn contains(tree: &Tree, point: Vector) -> bool {
    match tree {
        Tree::Empty => false,
        Tree::Solid(solid) => is_inside(solid, point),
        Tree::Union(members) => members.iter().any(|member| contains(member, point)),
        Tree::Intersection(members) => members.iter().all(|member| contains(member, point)),
        Tree::Difference(first, others) => {
            contains(first, point) && !others.iter().any(|other| contains(other, point))
        }
    }
}

fn is_inside(solid: &Solid, point: Vector) -> bool {
    let [x, y, z] = solid.map.columns;
    let from = point - solid.map.shift;
    let by = 1.0 / solid.map.determinant();
    let own = vec3(from.dot(y.cross(z)), from.dot(z.cross(x)), from.dot(x.cross(y))) * by;
    let around = own.x.hypot(own.y);
    let is_between = |[low, high]: [f64; 2], at: f64| {
        let room = SIX_DIGITS * (low.abs() + high.abs());
        low + room < at && at < high - room
    };
    match &solid.form {
        Form::Cuboid([low, high]) => {
            is_between([low.x, high.x], own.x)
                && is_between([low.y, high.y], own.y)
                && is_between([low.z, high.z], own.z)
        }
        Form::Cylinder { radius, heights } => {
            is_between(*heights, own.z) && is_between([-radius, *radius], around)
        }
        Form::Cone { radii: [lower, upper], heights: [low, high] } => {
            let radius = lower + (upper - lower) * (own.z - low) / (high - low);
            is_between([*low, *high], own.z) && is_between([-radius, radius], around)
        }
        Form::Sphere { radius } => is_between([-radius, *radius], length(own)),
        Form::Torus { ring, tube } => is_between([-tube, *tube], (around - ring).hypot(own.z)),
        Form::Convex(convex) => convex.planes.iter().all(|(normal, offset)| {
            normal.dot(own) < offset - SIX_DIGITS * (offset.abs() + length(own))
        }),
    }
}
