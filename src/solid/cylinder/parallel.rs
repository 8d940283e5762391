//! The cylinder along parallel rays.
//!
//! All rays have the same angle to the axis, so the view divides by it once: what is left for the
//! pixel is κ, the distance of its ray from the axis, which is affine in the column. The chord is
//! `middle ± √(r² − κ²) · stretch`, with an affine middle and `stretch` = 1/|d × axis|.

use super::{Cylinder, WALL, wall_span};
use crate::geom::{Affine, Extent, Parallel, Vec3};
use crate::scalar::{Number, Real, Scalar};
use crate::solid::row::{Blank, Leaf};
use crate::solid::slab::{self, EdgeOn};
use crate::solid::strip::{Rows, columns_within};
use crate::span::Span;

impl<S: Scalar> Leaf<Parallel<S>> for Cylinder<S> {
    type View = ParallelView<S>;
    type Row = ParallelRow<S>;

    fn seen_along(&self, rays: &Parallel<S>) -> ParallelView<S> {
        let axis = self.caps.normal.fine();
        let m = rays.forward.cross(axis);
        let steps = rays.steps(self.tube.base.fine());
        let moments = steps.map(|step| step.cross(axis));
        // An angle too small to divide by hardly moves a ray within the length of a scene.
        let across = m.max_abs().is_divisor().then(|| m.normalized()).flatten();
        let wall = if let Some(n) = across {
            let stretch = S::Fine::ONE / m.dot(n);
            let factor = S::factor(stretch);
            // What a ray through the axis gets; the root of a square need not be what was squared.
            let reach = S::leg(self.tube.radius, S::ZERO).unwrap_or(self.tube.radius);
            Wall::Across {
                distance: steps.map(|step| step.dot_compensated(n)),
                middle: moments.map(|moment| -moment.dot_compensated(n) * stretch),
                stretch: factor,
                reach: reach.stretched(factor),
            }
        } else {
            Wall::Along { moments }
        };
        ParallelView { wall, caps: self.caps.seen_along(rays), rows: self.rows(rays) }
    }

    fn in_row(&self, view: &ParallelView<S>, y: i32, columns: u32) -> (ParallelRow<S>, Extent) {
        if !view.rows.contains(y) {
            return (ParallelRow::BLANK, Extent::EMPTY);
        }
        let radius = self.tube.radius.fine();
        let beside = |length| columns_within::<S>(length, radius, columns);
        let caps = self.caps.parallel_row(&view.caps, y, columns);
        match (&view.wall, caps) {
            (Wall::Across { distance, middle, reach, .. }, caps) => {
                let [distance, middle] = [*distance, *middle].map(|of| Affine::row(of, y));
                let within_wall = beside(distance);
                let within_caps = match &caps {
                    slab::ParallelRow::Across(ends) => {
                        ends.columns(&view.caps, middle, *reach, columns)
                    }
                    slab::ParallelRow::EdgeOn(caps) => self.caps.columns(caps, columns),
                    slab::ParallelRow::Nowhere => Extent::EMPTY,
                };
                let (distance, middle) = (distance.middle, middle.middle);
                let row = match caps {
                    slab::ParallelRow::Across(caps) => {
                        ParallelRow::Across { distance, middle, caps }
                    }
                    slab::ParallelRow::EdgeOn(caps) => {
                        ParallelRow::EdgeOn { distance, middle, caps }
                    }
                    slab::ParallelRow::Nowhere => ParallelRow::Nowhere,
                };
                (row, within_wall.overlap(within_caps))
            }
            // The caps are then crossed almost at right angles.
            (Wall::Along { moments: [middle, right, down] }, slab::ParallelRow::Across(caps)) => {
                let moments = [
                    Affine::row([middle.x, right.x, down.x], y),
                    Affine::row([middle.y, right.y, down.y], y),
                    Affine::row([middle.z, right.z, down.z], y),
                ];
                let extent =
                    moments.map(beside).into_iter().fold(Extent::all(columns), Extent::overlap);
                (ParallelRow::Along { moments: moments.map(|moment| moment.middle), caps }, extent)
            }
            _ => (ParallelRow::BLANK, Extent::EMPTY),
        }
    }

    #[inline(always)]
    fn span(&self, view: &ParallelView<S>, row: &ParallelRow<S>, x: i32) -> Option<Span<S>> {
        if let (
            Wall::Across { distance: [_, right, _], middle: [_, along, _], stretch, .. },
            ParallelRow::Across { distance, middle, caps },
        ) = (&view.wall, row)
        {
            let distance = S::from_fine(distance.after_steps(*right, x));
            let half = S::leg(self.tube.radius, distance)?.stretched(*stretch);
            let middle = middle.after_steps(*along, x);
            let within_wall = wall_span(S::from_fine(middle - half), S::from_fine(middle + half))?;
            caps.span(&view.caps, x)?.overlap(within_wall)
        } else {
            self.rare_span(view, row, x)
        }
    }

    #[inline(always)]
    fn may_hold(&self, view: &ParallelView<S>, row: &ParallelRow<S>, x: i32, t: S) -> bool {
        match (&view.wall, row) {
            (
                Wall::Across { middle: [_, along, _], reach, .. },
                ParallelRow::Across { middle, .. },
            ) => {
                let middle = middle.after_steps(*along, x);
                S::from_fine(middle - *reach) <= t && t < S::from_fine(middle + *reach)
            }
            _ => true,
        }
    }
}

impl<S: Scalar> Cylinder<S> {
    /// The rows between the lowest and the highest point of balls around the middles of the caps.
    fn rows(&self, rays: &Parallel<S>) -> Rows {
        let axis = &self.caps.normal;
        let base = self.tube.base.fine();
        let (low, high) = (self.caps.low.fine(), self.caps.high.fine());
        let along = axis.dot_fine(base);
        let slope = axis.dot_fine(rays.down);
        let from_center = base - rays.center;
        let across = from_center.dot_compensated(rays.down);
        let ends = [low, high].map(|offset| across + slope * (offset - along));
        let radius = self.tube.radius.fine();
        let bounds = [ends[0].min(ends[1]) - radius, ends[0].max(ends[1]) + radius];
        let size = from_center.max_abs() + along.abs() + low.abs() + high.abs() + radius;
        // Three coordinates, each of which is as large as that.
        let size = size + size + size;
        Rows::between::<S>(Affine { middle: S::Fine::ZERO, step: rays.pitch }, bounds, size)
    }

    /// Of rays along the axis, or along the caps.
    #[inline(never)]
    fn rare_span(&self, view: &ParallelView<S>, row: &ParallelRow<S>, x: i32) -> Option<Span<S>> {
        match (&view.wall, row) {
            (
                Wall::Across { distance: [_, right, _], middle: [_, along, _], stretch, .. },
                ParallelRow::EdgeOn { distance, middle, caps },
            ) => {
                let distance = S::from_fine(distance.after_steps(*right, x));
                let half = S::leg(self.tube.radius, distance)?.stretched(*stretch);
                let middle = middle.after_steps(*along, x);
                let within_wall =
                    wall_span(S::from_fine(middle - half), S::from_fine(middle + half))?;
                self.caps.edge_on_span(caps, x)?.overlap(within_wall)
            }
            (Wall::Along { moments: [_, right, _] }, ParallelRow::Along { moments, caps }) => {
                let [mx, my, mz] = *moments;
                let vector = [(mx, right.x), (my, right.y), (mz, right.z)]
                    .map(|(middle, step)| S::from_fine(middle.after_steps(step, x)));
                if S::length(vector) < self.tube.radius {
                    caps.span(&view.caps, x)?.overlap(Span::whole_line(WALL))
                } else {
                    None
                }
            }
            _ => None,
        }
    }
}

/// A cylinder, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct ParallelView<S: Scalar> {
    wall: Wall<S>,
    caps: slab::ParallelView<S>,
    rows: Rows,
}

/// The wall: values in the middle of the picture, and their steps to the right and down.
#[derive(Debug, Clone, Copy)]
enum Wall<S: Scalar> {
    Nowhere,
    Across {
        /// κ.
        distance: [S::Fine; 3],
        middle: [S::Fine; 3],
        stretch: S::Factor,
        /// The longest half-chord.
        reach: S::Fine,
    },
    /// The camera looks along the axis: the vector from the axis to the ray, turned by 90°.
    Along {
        moments: [Vec3<S::Fine>; 3],
    },
}

impl<S: Scalar> Blank for ParallelView<S> {
    const BLANK: Self =
        Self { wall: Wall::Nowhere, caps: slab::ParallelView::BLANK, rows: Rows::BLANK };
}

/// A row of a cylinder, seen along parallel rays: values in the middle of the row.
#[derive(Debug, Clone, Copy)]
pub enum ParallelRow<S: Scalar> {
    /// It can't be seen.
    Nowhere,
    /// The rays cross the wall and the caps.
    Across {
        /// κ.
        distance: S::Fine,
        /// The middle of the chord.
        middle: S::Fine,
        /// Where the caps are crossed.
        caps: slab::Ends<S>,
    },
    /// The rays run along the axis.
    Along {
        /// The vector from the axis to the ray, turned by 90°.
        moments: [S::Fine; 3],
        /// Where the caps are crossed.
        caps: slab::Ends<S>,
    },
    /// The rays run along the caps, or almost.
    EdgeOn {
        /// κ.
        distance: S::Fine,
        /// The middle of the chord.
        middle: S::Fine,
        /// The caps.
        caps: EdgeOn<S>,
    },
}

impl<S: Scalar> Blank for ParallelRow<S> {
    const BLANK: Self = Self::Nowhere;
}
