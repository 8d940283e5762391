//! A scene in pictures: which nodes can be seen in a row, and in a run of columns.

use super::walk::{Pruned, Visible, Walk};
use super::{Node, Parts, Scene};
use scancsg::geom::{Extent, RayRow};
use scancsg::scan::bounds::{Outline, Silhouette};
use scancsg::scan::{ColumnRun, Empty, Scan};
use scancsg::solid::Bounds;
use scancsg::span::walk::{Path, Step};
use scancsg::span::{Face, Operation};
use std::sync::Arc;

/// What a camera sees of each solid.
pub struct View<R: Outline> {
    rays: Option<R>,
    outlines: Vec<R::Silhouette>,
}

impl<R: Outline> Empty for View<R> {
    const EMPTY: Self = Self { rays: None, outlines: Vec::new() };
}

/// A row of a scene.
pub struct Row<R: Outline> {
    parts: Option<Arc<Parts>>,
    rays: Option<R::Row>,
    seen: Seen,
    /// The columns in which some solid begins, in ascending order.
    starts: Vec<u32>,
    walk: Walk,
    root: Option<usize>,
}

/// What of a scene may be seen in a row.
struct Seen {
    column: u32,
    /// The columns in which each node may be seen.
    extents: Vec<Extent>,
    /// Where in the list below the members of each union are that may be seen.
    ranges: Vec<[usize; 2]>,
    members: Vec<usize>,
}

impl Seen {
    const NOTHING: Self =
        Self { column: 0, extents: Vec::new(), ranges: Vec::new(), members: Vec::new() };
}

impl Visible for Seen {
    fn until(&self, node: usize) -> Option<u32> {
        let extent = self.extents[node];
        extent.contains(self.column).then_some(extent.end)
    }

    fn members<'a>(&'a self, union: usize, _: &'a [usize]) -> &'a [usize] {
        let [from, to] = self.ranges[union];
        &self.members[from..to]
    }
}

impl<R: Outline> Empty for Row<R> {
    const EMPTY: Self = Self {
        parts: None,
        rays: None,
        seen: Seen::NOTHING,
        starts: Vec::new(),
        walk: Walk::EMPTY,
        root: None,
    };
}

impl<R: Outline<Scalar = f64>> Scan<R> for Scene {
    type View = View<R>;
    type Row = Row<R>;

    fn view(&self, rays: &R, view: &mut View<R>) {
        view.rays = Some(*rays);
        let outline = |[low, high]: [_; 2]| rays.outline(&Bounds::Box { low, high });
        view.outlines = self.parts.leaves.iter().map(|leaf| outline(leaf.corners)).collect();
    }

    fn row(&self, view: &View<R>, y: i32, columns: u32, row: &mut Row<R>) {
        row.rays = view.rays.map(|rays| rays.row(y));
        row.parts = Some(Arc::clone(&self.parts));
        row.walk.reset(&self.parts);
        let Seen { extents, ranges, members, .. } = &mut row.seen;
        extents.clear();
        ranges.clear();
        members.clear();
        row.starts.clear();
        for node in &self.parts.nodes {
            let of = |index: usize| extents[index];
            let first = members.len();
            let extent = match node {
                Node::Leaf(leaf) => match view.outlines.get(*leaf) {
                    Some(outline) if outline.is_in_rows([y; 2]) => outline.extent(y, columns),
                    _ => Extent::EMPTY,
                },
                Node::Union(all) => {
                    members.extend(all.iter().filter(|member| !is_empty(of(**member))));
                    let seen = members[first..].iter().map(|member| of(*member));
                    let joined = seen.reduce(|a, b| Extent {
                        start: a.start.min(b.start),
                        end: a.end.max(b.end),
                    });
                    joined.unwrap_or(Extent::EMPTY)
                }
                Node::Pair { operation: Operation::INTERSECTION, left, right } => {
                    of(*left).overlap(of(*right))
                }
                Node::Pair { left, .. } => of(*left),
            };
            if !is_empty(extent) {
                row.starts.push(extent.start);
            }
            ranges.push([first, members.len()]);
            extents.push(extent);
        }
        row.starts.sort_unstable();
    }

    fn enter(row: &mut Row<R>, column: u32) -> ColumnRun {
        let Row { parts: Some(parts), seen, starts, walk, root, .. } = row else {
            return ColumnRun::EMPTY;
        };
        // The next column in which something begins bounds the run, too.
        let later = starts.partition_point(|start| *start <= column);
        let next = starts.get(later).copied().unwrap_or(u32::MAX);
        seen.column = column;
        let Pruned { root: kept, until } = walk.prune(parts, seen);
        *root = kept;
        ColumnRun { is_visible: kept.is_some(), until: until.min(next) }
    }

    fn contains<P: Path>(&self, _: &View<R>, row: &mut Row<R>, x: i32, t: f64) -> bool {
        look(row, x);
        row.root.is_some_and(|root| row.walk.on(&self.parts).contains(root, t))
    }

    fn step<P: Path>(
        &self,
        _: &View<R>,
        row: &mut Row<R>,
        x: i32,
        t: f64,
        first: Face,
    ) -> Step<f64> {
        look(row, x);
        let Some(root) = row.root else { return Step::OUTSIDE };
        let mut step = row.walk.on(&self.parts).step(root, t);
        step.next.face = first.offset(step.next.face.0);
        step
    }
}

fn look<R: Outline<Scalar = f64>>(row: &mut Row<R>, x: i32) {
    let number = i64::from(x);
    if let (Some(rays), false) = (&row.rays, row.walk.looks_along(number)) {
        row.walk.look_along(rays.line(x), number);
    }
}

fn is_empty(extent: Extent) -> bool {
    extent.start >= extent.end
}
