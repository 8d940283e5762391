//! Cutters that go on for ever, cut off where nothing is left to cut.

use super::{Body, Placed};
use crate::map::{Vector, length};
use crate::tree::Tree;

/// How many times as far out as the part itself a cutter may reach.
const MOST: f64 = 8.0;

/// Cuts off what of cutters, and of solids that are intersected with smaller ones, is far from the part.
pub(super) fn trim(tree: &mut Tree<Placed>, frames: &[[Vector; 3]]) {
    within(tree, frames, None);
}

/// A ball that nothing outside of matters to.
#[derive(Debug, Clone, Copy)]
struct Ball {
    center: Vector,
    radius: f64,
}

fn within(tree: &mut Tree<Placed>, frames: &[[Vector; 3]], ball: Option<Ball>) {
    match tree {
        Tree::Empty => {}
        Tree::Solid(solid) => {
            if let (Some(ball), Some(axes)) = (ball, frames.get(solid.frame)) {
                let center = Vector::from(axes.map(|axis| axis.dot(ball.center)));
                cut(&mut solid.body, center, ball.radius);
            }
        }
        Tree::Union(members) => members.iter_mut().for_each(|member| within(member, frames, ball)),
        Tree::Intersection(members) => {
            let balls = members.iter().filter_map(|member| around(member, frames));
            let least = balls.chain(ball).min_by(|a, b| a.radius.total_cmp(&b.radius));
            members.iter_mut().for_each(|member| within(member, frames, least));
        }
        Tree::Difference(first, others) => {
            within(first, frames, ball);
            let balls = around(first, frames).into_iter().chain(ball);
            let least = balls.min_by(|a, b| a.radius.total_cmp(&b.radius));
            others.iter_mut().for_each(|other| within(other, frames, least));
        }
    }
}

/// A ball around a tree.
fn around(tree: &Tree<Placed>, frames: &[[Vector; 3]]) -> Option<Ball> {
    match tree {
        Tree::Empty => None,
        Tree::Solid(solid) => {
            let [low, high] = solid.body.bounds();
            let axes = frames.get(solid.frame)?;
            let middle = (low + high) * 0.5;
            let center = axes[0] * middle.x + axes[1] * middle.y + axes[2] * middle.z;
            Some(Ball { center, radius: length(high - low) * 0.5 })
        }
        Tree::Union(members) => {
            let balls: Vec<_> =
                members.iter().filter_map(|member| around(member, frames)).collect();
            let sum = balls.iter().fold(Vector::new(0.0, 0.0, 0.0), |sum, ball| sum + ball.center);
            let center = sum * (1.0 / balls.len().max(1) as f64);
            let radius = balls.iter().map(|ball| length(ball.center - center) + ball.radius);
            Some(Ball { center, radius: radius.reduce(f64::max)? })
        }
        Tree::Intersection(members) => {
            let balls = members.iter().filter_map(|member| around(member, frames));
            balls.min_by(|a, b| a.radius.total_cmp(&b.radius))
        }
        Tree::Difference(first, _) => around(first, frames),
    }
}

fn cut(body: &mut Body, center: Vector, radius: f64) {
    let far = MOST * radius;
    let cut = |[low, high]: [&mut f64; 2], middle: f64| {
        // Both ends stay beyond the ball.
        *low = low.max(middle - far).min(*high);
        *high = high.min(middle + far).max(*low);
    };
    match body {
        Body::Cuboid([low, high]) => {
            if low.x < center.x + far && high.x > center.x - far {
                cut([&mut low.x, &mut high.x], center.x);
            }
            if low.y < center.y + far && high.y > center.y - far {
                cut([&mut low.y, &mut high.y], center.y);
            }
            if low.z < center.z + far && high.z > center.z - far {
                cut([&mut low.z, &mut high.z], center.z);
            }
        }
        Body::Cylinder { axis, ends: [low, high], .. } => {
            let middle = center.to_array()[*axis];
            if *low < middle + far && *high > middle - far {
                cut([low, high], middle);
            }
        }
        _ => {}
    }
}
