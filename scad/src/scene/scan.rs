//! A scene in pictures: which nodes can be seen in a row, and in a run of columns.

use super::walk::{Pruned, Walk};
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
    /// The columns in which each node may be seen.
    extents: Vec<Extent>,
    walk: Walk,
    root: Option<usize>,
}

impl<R: Outline> Empty for Row<R> {
    const EMPTY: Self =
        Self { parts: None, rays: None, extents: Vec::new(), walk: Walk::EMPTY, root: None };
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
        row.extents.clear();
        for node in &self.parts.nodes {
            let of = |index: usize| row.extents[index];
            let extent = match node {
                Node::Leaf(leaf) => match view.outlines.get(*leaf) {
                    Some(outline) if outline.is_in_rows([y; 2]) => outline.extent(y, columns),
                    _ => Extent::EMPTY,
                },
                Node::Union(members) => {
                    let seen = members.iter().map(|member| of(*member));
                    let seen = seen.filter(|extent| extent.start < extent.end);
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
            row.extents.push(extent);
        }
    }

    fn enter(row: &mut Row<R>, column: u32) -> ColumnRun {
        let Row { parts: Some(parts), extents, walk, root, .. } = row else {
            return ColumnRun::EMPTY;
        };
        // The next column in which something begins bounds the run, too.
        let later = extents.iter().map(|extent| extent.start).filter(|start| *start > column);
        let next = later.min().unwrap_or(u32::MAX);
        let visible = |node: usize| {
            let extent = extents[node];
            extent.contains(column).then_some(extent.end)
        };
        let Pruned { root: seen, until } = walk.prune(parts, &visible);
        *root = seen;
        ColumnRun { is_visible: seen.is_some(), until: until.min(next) }
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
