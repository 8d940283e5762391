//! The cylinder along parallel rays.
//!
//! All rays have the same angle to the axis, so the view divides by it once: what is left for the
//! pixel is κ, the distance of its ray from the axis, which is affine in the column. The chord is
//! `middle ± √(r² − κ²) · stretch`, with an affine middle and `stretch` = 1/|d × axis|.

use super::{Cylinder, WALL, wall_span};
use crate::geom::{Affine, Extent, Parallel, Vec3};
use crate::scalar::{Number, Real, Scalar};
use crate::solid::row::Leaf;
use crate::solid::silhouette::{ParallelBall, constant, extent, vector_row};
use crate::solid::slab;
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
            Wall::Across {
                distance: steps.map(|step| step.dot_compensated(n)),
                middle: moments.map(|moment| -moment.dot_compensated(n) * stretch),
                stretch: S::factor(stretch),
            }
        } else {
            Wall::Along { moments }
        };
        let (center, ball_radius) = self.bounding_ball();
        let ball = ParallelBall::new(center, ball_radius, rays);
        ParallelView { wall, caps: self.caps.seen_along(rays), ball }
    }

    fn in_row(&self, view: &ParallelView<S>, y: i32) -> (ParallelRow<S>, Extent) {
        let radius = [constant(self.tube.radius.plus(S::BLUR).fine())];
        let columns = view.caps.columns;
        let (wall, silhouette) = match view.wall {
            Wall::Across { distance, middle, .. } => {
                let [distance, middle] = [distance, middle].map(|of| Affine::row(of, y));
                let silhouette = extent(&radius, &[distance], columns);
                let row = WallRow::Across { distance: distance.middle, middle: middle.middle };
                (row, silhouette)
            }
            Wall::Along { moments } => {
                let moments = vector_row(moments, y);
                (WallRow::Along { moments }, extent(&radius, &moments, columns))
            }
        };
        let row = ParallelRow { wall, caps: self.caps.parallel_row(&view.caps, y) };
        (row, silhouette.overlap(view.ball.extent(y)))
    }

    #[inline]
    fn span(&self, view: &ParallelView<S>, row: &ParallelRow<S>, x: i32) -> Option<Span<S>> {
        let within_wall = match (&view.wall, &row.wall) {
            (
                Wall::Across { distance: [_, right, _], middle: [_, along, _], stretch },
                WallRow::Across { distance, middle },
            ) => {
                let distance = S::from_fine(distance.after_steps(*right, x));
                let half = S::leg(self.tube.radius, distance)?.stretched(*stretch);
                let middle = middle.after_steps(*along, x);
                wall_span(S::from_fine(middle - half), S::from_fine(middle + half))?
            }
            (_, WallRow::Along { moments }) => {
                let distance = S::length(moments.map(|part| S::from_fine(part.at(x))));
                if distance < self.tube.radius { Span::whole_line(WALL) } else { return None }
            }
            _ => return None,
        };
        Leaf::<Parallel<S>>::span(&self.caps, &view.caps, &row.caps, x)?.overlap(within_wall)
    }
}

/// A cylinder, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct ParallelView<S: Scalar> {
    wall: Wall<S>,
    caps: slab::ParallelView<S>,
    ball: ParallelBall<S>,
}

/// The wall: values in the middle of the picture, and their steps to the right and down.
#[derive(Debug, Clone, Copy)]
enum Wall<S: Scalar> {
    Across {
        /// κ.
        distance: [S::Fine; 3],
        middle: [S::Fine; 3],
        stretch: S::Factor,
    },
    /// The camera looks along the axis: the vector from the axis to the ray, turned by 90°.
    Along { moments: [Vec3<S::Fine>; 3] },
}

/// A row of a cylinder, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct ParallelRow<S: Scalar> {
    wall: WallRow<S>,
    caps: slab::ParallelRow<S>,
}

/// The wall: values in the middle of the row.
#[derive(Debug, Clone, Copy)]
enum WallRow<S: Scalar> {
    Across { distance: S::Fine, middle: S::Fine },
    Along { moments: [Affine<S::Fine>; 3] },
}
