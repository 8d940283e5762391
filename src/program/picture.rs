//! Programs in pictures: which parts matter in a row and in a run of columns, and the walk through them.

use super::build::Program;
use super::tree::{Fold, hide, hide_all_but, shorten};
use crate::geom::Rays;
use crate::scalar::Scalar;
use crate::scan::{ColumnRun, Empty, FaceRows, FaceView, GroupRow, Member, PoolRow, Scan};
use crate::span::chain::{self, Chained, Link};
use crate::span::walk::{Cold, Hot, Path, Step};
use crate::span::{Face, Operation, Shape};

/// The rows of a program's parts, and the chains of those that matter.
#[derive(Debug, Clone, Copy)]
pub struct ProgramRow<D, const N: usize, F = ()> {
    parts: GroupRow<[Member<D>; N]>,
    /// The chain of the parts that may be seen in the band of rows.
    band: [Link; N],
    band_entry: u16,
    /// The same in the run of columns.
    run: [Link; N],
    run_entry: u16,
    /// The rows of the faces in the pool.
    faces: F,
}

impl<D: Empty, F: Empty, const N: usize> Empty for ProgramRow<D, N, F> {
    const EMPTY: Self = {
        let links = [Link { inside: 0, outside: 0 }; N];
        Self {
            parts: GroupRow::EMPTY,
            band: links,
            band_entry: 0,
            run: links,
            run_entry: 0,
            faces: F::EMPTY,
        }
    };
}

impl<R, L, const PARTS: usize, const POSES: usize, const SPANS: usize, const POOL: usize> Scan<R>
    for Program<L, PARTS, POSES, SPANS, POOL>
where
    L: Scan<R>,
    R: Rays<Scalar = L::Scalar>,
{
    type View = ([L::View; PARTS], [FaceView<L::Scalar>; POOL]);
    type Row = ProgramRow<L::Row, PARTS, FaceRows<L::Scalar, POOL>>;

    fn view(&self, rays: &R, (views, faces): &mut Self::View) {
        for (index, view) in views.iter_mut().enumerate() {
            let Some((part, _)) = self.in_place(index) else { break };
            match part.pose {
                Some(pose) => self.view_part(index, &rays.back_from(pose), view, faces),
                None => self.view_part(index, rays, view, faces),
            }
        }
    }

    fn is_in_rows(&self, (views, _): &Self::View, rows: [i32; 2]) -> bool {
        let mut parts = self.leaves().iter().zip(views);
        parts.any(|(leaf, view)| leaf.is_in_rows(view, rows))
    }

    fn row(&self, (views, face_views): &Self::View, y: i32, columns: u32, row: &mut Self::Row) {
        let ProgramRow { parts, band, band_entry, run, faces, .. } = row;
        if POOL > 0 {
            for (index, (leaf, view)) in self.leaves().iter().zip(views).enumerate() {
                let pool = PoolRow::new(&self.pool.faces, face_views, faces);
                if let Some(row) = parts.row_of(index) {
                    leaf.row_faces(view, pool, y, columns, row);
                }
            }
        }
        let parts = parts.as_slice_mut();
        let last = parts.band();
        if last != 0 {
            hide(parts.active(), run);
        }
        parts.set::<R, L>(self.leaves(), views, y, columns);
        if parts.band() != last {
            hide_all_but(parts.in_band(), band);
            *band_entry = self.tree().link(band, run);
            hide_all_but(core::iter::empty(), run);
        }
    }

    fn enter(row: &mut Self::Row, column: u32) -> ColumnRun {
        let ProgramRow { parts, band, band_entry, run, run_entry, .. } = row;
        let parts = parts.as_slice_mut();
        if parts.is_entered(column) {
            return ColumnRun {
                is_visible: *run_entry != Link::OUT,
                ..parts.enter::<R, L>(column)
            };
        }
        hide(parts.active(), run);
        let all = parts.enter::<R, L>(column);
        *run_entry = shorten(*band_entry, band, parts.active(), run);
        ColumnRun { is_visible: *run_entry != Link::OUT, ..all }
    }

    #[inline]
    fn contains<P: Path>(
        &self,
        views: &Self::View,
        row: &mut Self::Row,
        x: i32,
        t: L::Scalar,
    ) -> bool {
        let entry = row.run_entry;
        chain::contains(&mut OnRay { program: self, views, row, x, first: Face(0) }, entry, t)
    }

    #[inline]
    fn step<P: Path>(
        &self,
        views: &Self::View,
        row: &mut Self::Row,
        x: i32,
        t: L::Scalar,
        first: Face,
    ) -> Step<L::Scalar> {
        let entry = row.run_entry;
        chain::step(&mut OnRay { program: self, views, row, x, first }, entry, t)
    }
}

impl<L: Shape, const PARTS: usize, const POSES: usize, const SPANS: usize, const POOL: usize>
    Program<L, PARTS, POSES, SPANS, POOL>
{
    /// Gets a part ready, along rays in its frame.
    fn view_part<R>(
        &self,
        index: usize,
        rays: &R,
        view: &mut L::View,
        faces: &mut [FaceView<L::Scalar>; POOL],
    ) where
        L: Scan<R>,
    {
        let Some(leaf) = self.leaves.get(index) else { return };
        leaf.view(rays, view);
        if POOL > 0 {
            let [start, end] = self.pool.range(index);
            if let (Some(of), Some(views)) =
                (self.pool.faces.get(start..end), faces.get_mut(start..end))
            {
                leaf.view_faces(rays, of, views, [start as u16, end as u16], view);
            }
        }
    }
}

/// The parts of a program on one ray.
struct OnRay<
    'a,
    R,
    L: Scan<R>,
    const PARTS: usize,
    const POSES: usize,
    const SPANS: usize,
    const POOL: usize,
> {
    program: &'a Program<L, PARTS, POSES, SPANS, POOL>,
    views: &'a ([L::View; PARTS], [FaceView<L::Scalar>; POOL]),
    row: &'a mut ProgramRow<L::Row, PARTS, FaceRows<L::Scalar, POOL>>,
    x: i32,
    first: Face,
}

impl<R, L, const PARTS: usize, const POSES: usize, const SPANS: usize, const POOL: usize>
    OnRay<'_, R, L, PARTS, POSES, SPANS, POOL>
where
    L: Scan<R>,
{
    /// A part, ready to be asked.
    #[inline(always)]
    fn part(&mut self, index: u16) -> Option<(&L, &L::View, &mut L::Row)> {
        let (index, (views, face_views)) = (usize::from(index), self.views);
        let (leaf, view) = (self.program.leaves.get(index)?, views.get(index)?);
        let row = self.row.parts.row_of(index)?;
        if POOL > 0 {
            let pool = PoolRow::new(&self.program.pool.faces, face_views, &mut self.row.faces);
            leaf.ray_faces(view, pool, self.x, row);
        }
        Some((leaf, view, row))
    }

    #[inline(always)]
    fn step_by<P: Path>(&mut self, index: u16, t: L::Scalar) -> Step<L::Scalar> {
        let (x, first) = (self.x, self.first.offset(index * L::FACES));
        let Some((leaf, view, row)) = self.part(index) else { return Step::OUTSIDE };
        leaf.step::<P>(view, row, x, t, first)
    }
}

impl<R, L, const PARTS: usize, const POSES: usize, const SPANS: usize, const POOL: usize>
    Chained<L::Scalar> for OnRay<'_, R, L, PARTS, POSES, SPANS, POOL>
where
    L: Scan<R>,
{
    #[inline(always)]
    fn link(&self, leaf: u16) -> Option<Link> {
        self.row.run.get(usize::from(leaf)).copied()
    }

    #[inline(always)]
    fn contains(&mut self, leaf: u16, t: L::Scalar) -> bool {
        let x = self.x;
        self.part(leaf).is_some_and(|(leaf, view, row)| leaf.contains::<Hot>(view, row, x, t))
    }

    #[inline(always)]
    fn step(&mut self, leaf: u16, t: L::Scalar) -> Step<L::Scalar> {
        self.step_by::<Hot>(leaf, t)
    }

    #[cold]
    #[inline(never)]
    fn tied(&mut self, t: L::Scalar) -> Face {
        let mut events = [Event::NONE; PARTS];
        let active = self.row.parts.as_slice_mut().active().next().unwrap_or(Link::OUT);
        let tree = self.program.tree();
        tree.fold(&mut events, &mut Tied { ray: self, t, active });
        events.first().map_or(Face(0), |event| event.face)
    }
}

/// What a parameter is to an operand.
#[derive(Clone, Copy)]
struct Event {
    before: bool,
    behind: bool,
    /// The face that is crossed, if one is.
    face: Face,
}

impl Event {
    const NONE: Self = Self { before: false, behind: false, face: Face(0) };
}

/// A parameter at which several parts are crossed.
struct Tied<'a, T, S> {
    ray: &'a mut T,
    t: S,
    /// The next part that may be seen.
    active: u16,
}

impl<R, L, const PARTS: usize, const POSES: usize, const SPANS: usize, const POOL: usize>
    Fold<Event> for Tied<'_, OnRay<'_, R, L, PARTS, POSES, SPANS, POOL>, L::Scalar>
where
    L: Scan<R>,
{
    fn leaf(&mut self, index: u16) -> Event {
        if index != self.active {
            return Event::NONE;
        }
        self.active = self.ray.row.parts.as_slice_mut().next_active(index);
        let step = self.ray.step_by::<Cold>(index, self.t.next_below());
        let crosses = step.next.t == self.t;
        // Of spans that are one unit apart, the next one may begin where one ends.
        let behind = if crosses { self.ray.contains(index, self.t) } else { step.inside };
        Event { before: step.inside, behind, face: step.next.face }
    }

    fn combine(&mut self, operation: Operation, left: Event, right: Event) -> Event {
        Event {
            before: operation.contains(left.before, right.before),
            behind: operation.contains(left.behind, right.behind),
            face: if left.before != left.behind { left.face } else { right.face },
        }
    }
}
