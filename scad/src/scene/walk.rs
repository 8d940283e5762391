//! The walk along a line through what of a part may be met there.

use super::leaf::{NOWHERE, into_frame};
use super::{Node, Parts};
use scancsg::geom::{Line, vec3};
use scancsg::scan::Kept;
use scancsg::span::walk::{
    Cold, Members, Operands, Path, Side, Step, contains, step, step_of_union,
};
use scancsg::span::{Face, Operation, Span};

/// The nodes that matter in a run of columns, and the spans of one line with their solids.
#[derive(Debug, Clone)]
pub(super) struct Walk {
    nodes: Vec<Active>,
    /// Of unions, each in one piece.
    members: Vec<usize>,
    /// The line that is asked for, by a number of its own, in the scene and in the frames.
    number: i64,
    line: Line<f64>,
    lines: Vec<(i64, Line<f64>)>,
    /// Of each solid, those of the line with that number.
    kept: Vec<(i64, [Span<f64>; 2])>,
}

#[derive(Debug, Clone, Copy)]
enum Active {
    Leaf(usize),
    Union { from: usize, to: usize },
    Pair { operation: Operation, left: usize, right: usize },
}

/// What a pruned tree begins with, and up to which column it holds.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pruned {
    pub(super) root: Option<usize>,
    pub(super) until: u32,
}

/// What may be seen in a run of columns.
pub(super) trait Visible {
    /// Up to which column a node may be seen. None, if it may not.
    fn until(&self, node: usize) -> Option<u32>;

    /// The members of a union among which all are that may be seen.
    fn members<'a>(&'a self, union: usize, all: &'a [usize]) -> &'a [usize];
}

/// Everything, for ever.
pub(super) struct All;

impl Visible for All {
    fn until(&self, _: usize) -> Option<u32> {
        Some(u32::MAX)
    }

    fn members<'a>(&'a self, _: usize, all: &'a [usize]) -> &'a [usize] {
        all
    }
}

const NO_LINE: i64 = i64::MIN;

impl Walk {
    pub(super) const EMPTY: Self = Self {
        nodes: Vec::new(),
        members: Vec::new(),
        number: NO_LINE,
        line: Line { origin: vec3(0.0, 0.0, 0.0), direction: vec3(0.0, 0.0, 1.0) },
        lines: Vec::new(),
        kept: Vec::new(),
    };

    /// Forgets all lines: for another part or another row.
    pub(super) fn reset(&mut self, parts: &Parts) {
        self.number = NO_LINE;
        self.lines.clear();
        self.lines.resize(parts.frames.len(), (NO_LINE, self.line));
        self.kept.clear();
        self.kept.resize(parts.leaves.len(), (NO_LINE, [NOWHERE; 2]));
    }

    /// Keeps the nodes that may be met.
    pub(super) fn prune(&mut self, parts: &Parts, visible: &impl Visible) -> Pruned {
        self.nodes.clear();
        self.members.clear();
        let mut until = u32::MAX;
        let last = parts.nodes.len().checked_sub(1);
        let root = last.and_then(|last| self.keep(parts, last, visible, &mut until));
        Pruned { root, until }
    }

    fn keep(
        &mut self,
        parts: &Parts,
        node: usize,
        visible: &impl Visible,
        until: &mut u32,
    ) -> Option<usize> {
        *until = visible.until(node)?.min(*until);
        let active = match &parts.nodes[node] {
            Node::Leaf(leaf) => Active::Leaf(*leaf),
            Node::Union(all) => {
                let all = visible.members(node, all).iter();
                let kept = all.filter_map(|member| self.keep(parts, *member, visible, until));
                let kept: Vec<usize> = kept.collect();
                match kept[..] {
                    [] => return None,
                    [one] => return Some(one),
                    _ => {
                        let from = self.members.len();
                        self.members.extend(kept);
                        Active::Union { from, to: self.members.len() }
                    }
                }
            }
            Node::Pair { operation, left, right } => {
                let left = self.keep(parts, *left, visible, until)?;
                match self.keep(parts, *right, visible, until) {
                    Some(right) => Active::Pair { operation: *operation, left, right },
                    None if operation.contains(true, false) => return Some(left),
                    None => return None,
                }
            }
        };
        self.nodes.push(active);
        Some(self.nodes.len() - 1)
    }

    /// Whether the line with this number is the one that is asked for.
    pub(super) fn looks_along(&self, number: i64) -> bool {
        self.number == number
    }

    /// From here on, another line is asked for.
    pub(super) fn look_along(&mut self, line: Line<f64>, number: i64) {
        self.line = line;
        self.number = number;
    }

    /// What answers along the line.
    pub(super) fn on<'a>(&'a mut self, parts: &'a Parts) -> Asked<'a> {
        Asked { parts, walk: self }
    }
}

/// A line through a part.
pub(super) struct Asked<'a> {
    parts: &'a Parts,
    walk: &'a mut Walk,
}

impl Asked<'_> {
    /// What lies behind `t` in a node.
    pub(super) fn step(&mut self, node: usize, t: f64) -> Step<f64> {
        match self.walk.nodes[node] {
            Active::Leaf(leaf) => self.spans(leaf).behind(t, Face(0)),
            Active::Union { from, to } => {
                step_of_union::<Cold, _>(Those { asked: self, from, to }, t)
            }
            Active::Pair { operation, left, right } => {
                step::<Cold, _>(Two { asked: self, operation, nodes: [left, right] }, t)
            }
        }
    }

    /// Whether the line is inside a node just behind `t`.
    pub(super) fn contains(&mut self, node: usize, t: f64) -> bool {
        match self.walk.nodes[node] {
            Active::Leaf(leaf) => self.spans(leaf).contain(t),
            Active::Union { from, to } => {
                (from..to).any(|index| self.contains(self.walk.members[index], t))
            }
            Active::Pair { operation, left, right } => {
                contains::<Cold, _>(Two { asked: self, operation, nodes: [left, right] }, t)
            }
        }
    }

    fn spans(&mut self, leaf: usize) -> &[Span<f64>; 2] {
        let Walk { number, line, lines, kept, .. } = &mut *self.walk;
        let solid = &self.parts.leaves[leaf];
        let (asked, spans) = &mut kept[leaf];
        if *asked != *number {
            *asked = *number;
            let (of, own) = &mut lines[solid.frame];
            if *of != *number {
                *of = *number;
                *own = if solid.frame == 0 { *line } else { into_frame(&solid.axes, line) };
            }
            *spans = solid.spans(own);
        }
        spans
    }
}

struct Two<'a, 'b> {
    asked: &'a mut Asked<'b>,
    operation: Operation,
    nodes: [usize; 2],
}

impl Operands<f64> for Two<'_, '_> {
    fn operation(&self) -> Operation {
        self.operation
    }

    fn has(&self, _: Side) -> bool {
        true
    }

    fn contains<P: Path>(&mut self, side: Side, t: f64) -> bool {
        self.asked.contains(self.nodes[side as usize], t)
    }

    fn step<P: Path>(&mut self, side: Side, t: f64) -> Step<f64> {
        self.asked.step(self.nodes[side as usize], t)
    }
}

struct Those<'a, 'b> {
    asked: &'a mut Asked<'b>,
    from: usize,
    to: usize,
}

impl Members<f64> for Those<'_, '_> {
    fn is_single(&self) -> bool {
        self.to - self.from == 1
    }

    fn unite<P: Path>(&mut self, t: f64) -> Step<f64> {
        let mut all = Step::OUTSIDE;
        for index in self.from..self.to {
            all.unite(self.asked.step(self.asked.walk.members[index], t));
        }
        all
    }
}
