//! The cylinder along parallel rays.
//!
//! All rays have the same angle to the axis, so the view divides by it once: what is left for the
//! pixel is κ, the distance of its ray from the axis, which is affine in the column. The chord is
//! `middle ± √(r² − κ²) · stretch`, with an affine middle and `stretch` = 1/|d × axis|.

use super::{Cylinder, WALL, wall_span};
use crate::geom::{Affine, Parallel, Vec3};
use crate::scalar::{Number, Real, Scalar};
use crate::solid::row::{ConvexRow, Leaf, Project, View};
use crate::solid::silhouette::{ParallelBall, constant, extent, vector_row};
use crate::solid::slab;
use crate::span::Span;

impl<S: Scalar> Project<Parallel<S>> for Cylinder<S> {
    type View<'a> = ParallelView<S>;

    fn view(&self, rays: &Parallel<S>) -> ParallelView<S> {
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
        ParallelView {
            wall,
            radius: self.tube.radius,
            caps: self.caps.view(rays),
            ball: ParallelBall::new(center, ball_radius, rays),
            columns: rays.columns,
        }
    }
}

/// A cylinder, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct ParallelView<S: Scalar> {
    wall: Wall<S>,
    radius: S,
    caps: slab::ParallelView<S>,
    ball: ParallelBall<S>,
    columns: u32,
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

impl<S: Scalar> View for ParallelView<S> {
    type Scalar = S;
    type Row<'a> = Leaf<ParallelRow<S>>;

    fn row(&self, y: i32) -> Self::Row<'_> {
        let radius = [constant(self.radius.plus(S::BLUR).fine())];
        let (wall, silhouette) = match self.wall {
            Wall::Across { distance, middle, stretch } => {
                let distance = Affine::row(distance, y);
                let middle = Affine::row(middle, y);
                let silhouette = extent(&radius, &[distance], self.columns);
                (WallRow::Across { distance, middle, stretch }, silhouette)
            }
            Wall::Along { moments } => {
                let moments = vector_row(moments, y);
                (WallRow::Along { moments }, extent(&radius, &moments, self.columns))
            }
        };
        Leaf {
            row: ParallelRow { wall, radius: self.radius, caps: self.caps.slab_row(y) },
            extent: silhouette.overlap(self.ball.extent(y)),
        }
    }
}

/// A row of a cylinder, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct ParallelRow<S: Scalar> {
    wall: WallRow<S>,
    radius: S,
    caps: slab::ParallelRow<S>,
}

#[derive(Debug, Clone, Copy)]
enum WallRow<S: Scalar> {
    Across { distance: Affine<S::Fine>, middle: Affine<S::Fine>, stretch: S::Factor },
    Along { moments: [Affine<S::Fine>; 3] },
}

impl<S: Scalar> ConvexRow for ParallelRow<S> {
    type Scalar = S;
    const FACES: u16 = 3;

    #[inline]
    fn span(&self, x: i32) -> Option<Span<S>> {
        let within_wall = match &self.wall {
            WallRow::Across { distance, middle, stretch } => {
                let half = S::leg(self.radius, S::from_fine(distance.at(x)))?.stretched(*stretch);
                let middle = middle.at(x);
                wall_span(S::from_fine(middle - half), S::from_fine(middle + half))?
            }
            WallRow::Along { moments } => {
                let distance = S::length(moments.map(|part| S::from_fine(part.at(x))));
                if distance < self.radius { Span::whole_line(WALL) } else { return None }
            }
        };
        self.caps.span(x)?.overlap(within_wall)
    }
}
