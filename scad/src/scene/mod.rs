//! A part as a [`Solid`] of scancsg that a host can see and measure: a tree whose size is known at run time only.
//!
//! It holds lists, so it isn't for a device. Pictures prune it as typed trees are pruned: once a picture, once a
//! row, and for each run of columns in which the same solids may be seen.

mod cone;
mod convex;
mod leaf;
mod scan;
mod walk;

use crate::error::Error;
use crate::map::Vector;
use crate::place::{Model, Placed};
use crate::tree::Tree;
use leaf::Leaf;
use scancsg::geom::Line;
use scancsg::render::Rgb;
use scancsg::solid::{Bounds, Solid};
use scancsg::span::walk::Step;
use scancsg::span::{Crossing, Face, Operation, Shape, Span, SpanStack};
use std::sync::Arc;
use walk::{All, Walk};

/// A part that can be seen, traced and measured.
#[derive(Debug, Clone)]
pub struct Scene {
    parts: Arc<Parts>,
}

#[derive(Debug)]
struct Parts {
    frames: Vec<[Vector; 3]>,
    leaves: Vec<Leaf>,
    /// Operands come before their operation; the last one is the part.
    nodes: Vec<Node>,
}

#[derive(Debug)]
enum Node {
    Leaf(usize),
    Union(Vec<usize>),
    Pair { operation: Operation, left: usize, right: usize },
}

impl Scene {
    /// The scene of a part.
    ///
    /// # Errors
    /// An [`Error`] for a solid out of the range of `f64` solids, or for more than 65,535 faces.
    pub fn of(model: &Model) -> Result<Self, Error> {
        let mut parts =
            Parts { frames: model.frames.clone(), leaves: Vec::new(), nodes: Vec::new() };
        parts.add(&model.tree, false)?;
        Ok(Self { parts: Arc::new(parts) })
    }

    /// The box around it: the lowest and the highest coordinates. None if it is empty.
    #[must_use]
    pub fn corners(&self) -> Option<[Vector; 2]> {
        self.parts.corners(self.parts.nodes.len().checked_sub(1)?)
    }
}

impl Parts {
    /// Adds a tree: one that is cut out, or one that isn't. None if it is empty.
    fn add(&mut self, tree: &Tree<Placed>, is_cut: bool) -> Result<Option<usize>, Error> {
        let node = match tree {
            Tree::Empty => return Ok(None),
            Tree::Solid(placed) => {
                let first = self.leaves.last().map_or(Some(0), Leaf::next_face);
                let first =
                    first.ok_or_else(|| Error::limit("the part has more than 65,535 faces"))?;
                let axes = self.frames.get(placed.frame).copied().unwrap_or(self.frames[0]);
                self.leaves.push(Leaf::of(placed, axes, first, is_cut)?);
                Node::Leaf(self.leaves.len() - 1)
            }
            Tree::Union(members) => {
                let members: Vec<_> = members
                    .iter()
                    .map(|member| self.add(member, is_cut))
                    .collect::<Result<_, _>>()?;
                Node::Union(members.into_iter().flatten().collect())
            }
            Tree::Intersection(members) => {
                let mut left = None;
                for member in members {
                    let Some(right) = self.add(member, is_cut)? else { return Ok(None) };
                    left = Some(match left {
                        None => right,
                        Some(left) => {
                            let operation = Operation::INTERSECTION;
                            self.push(Node::Pair { operation, left, right })
                        }
                    });
                }
                return Ok(left);
            }
            Tree::Difference(first, others) => {
                let Some(left) = self.add(first, is_cut)? else { return Ok(None) };
                let mut cutters = Vec::new();
                for other in others {
                    cutters.extend(self.add(other, !is_cut)?);
                }
                let right = match cutters[..] {
                    [] => return Ok(Some(left)),
                    [one] => one,
                    _ => self.push(Node::Union(cutters)),
                };
                Node::Pair { operation: Operation::DIFFERENCE, left, right }
            }
        };
        Ok(Some(self.push(node)))
    }

    fn push(&mut self, node: Node) -> usize {
        self.nodes.push(node);
        self.nodes.len() - 1
    }

    fn corners(&self, node: usize) -> Option<[Vector; 2]> {
        let each = |pick: fn(f64, f64) -> f64, a: Vector, b: Vector| {
            Vector::new(pick(a.x, b.x), pick(a.y, b.y), pick(a.z, b.z))
        };
        match self.nodes.get(node)? {
            Node::Leaf(leaf) => Some(self.leaves[*leaf].corners),
            Node::Union(members) => {
                let boxes = members.iter().filter_map(|member| self.corners(*member));
                boxes
                    .reduce(|[low, high], [l, h]| [each(f64::min, low, l), each(f64::max, high, h)])
            }
            Node::Pair { operation, left, right } => {
                let [low, high] = self.corners(*left)?;
                if *operation == Operation::DIFFERENCE {
                    return Some([low, high]);
                }
                let [l, h] = self.corners(*right)?;
                let [low, high] = [each(f64::max, low, l), each(f64::min, high, h)];
                (low.x < high.x && low.y < high.y && low.z < high.z).then_some([low, high])
            }
        }
    }

    fn leaf_of(&self, face: Face) -> Option<&Leaf> {
        let behind = self.leaves.partition_point(|leaf| leaf.first <= face.0);
        self.leaves.get(behind.checked_sub(1)?)
    }
}

/// The most spans of a line that are kept.
pub(crate) const SPANS: usize = 512;

impl Shape for Scene {
    type Scalar = f64;
    const SPANS: usize = SPANS;
    const FACES: u16 = u16::MAX;
}

impl Solid for Scene {
    fn spans(&self, line: &Line<f64>, first: Face, stack: &mut SpanStack<'_, f64>) {
        let mut walk = Walk::EMPTY;
        walk.reset(&self.parts);
        let Some(root) = walk.prune(&self.parts, &All).root else { return };
        walk.look_along(*line, 0);
        let mut asked = walk.on(&self.parts);
        let number =
            |crossing: Crossing<f64>| Crossing { face: first.offset(crossing.face.0), ..crossing };
        let Step { inside, mut next } = asked.step(root, f64::NEG_INFINITY);
        let from_there = Crossing { t: f64::NEG_INFINITY, face: Face(0) };
        let mut enter = inside.then_some(from_there);
        loop {
            match enter.take() {
                Some(enter) => {
                    let span = Span { enter: number(enter), exit: number(next) };
                    if stack.push(span).is_err() {
                        return;
                    }
                }
                None if next.t == f64::INFINITY => return,
                None => enter = Some(next),
            }
            next = asked.step(root, next.t).next;
        }
    }

    fn normal(&self, face: Face, at: Vector) -> Vector {
        self.parts.leaf_of(face).map_or(at * 0.0, |leaf| leaf.normal(face, at))
    }

    fn bounds(&self) -> Bounds<f64> {
        self.corners().map_or(Bounds::Unbounded, |[low, high]| Bounds::Box { low, high })
    }

    fn color(&self, face: Face) -> Option<Rgb> {
        self.parts.leaf_of(face).and_then(|leaf| leaf.color)
    }
}
