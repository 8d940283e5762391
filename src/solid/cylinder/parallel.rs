//! The cylinder along parallel rays.
//!
//! All rays have the same angle to the axis, so the view divides by it once: what is left for the
//! pixel is κ, the distance of its ray from the axis, which is affine in the column. The chord is
//! `middle ± √(r² − κ²) · stretch`, with an affine middle and `stretch` = 1/|d × axis|.

use super::{Cylinder, WALL, wall_span};
use crate::geom::{Parallel, Vec3};
use crate::scalar::Scalar;
use crate::solid::row::{ConvexRow, Leaf, Project, View};
use crate::solid::silhouette::{ParallelBall, Quadratic};
use crate::solid::slab;
use crate::span::Span;

impl<S: Scalar> Project<Parallel<S>> for Cylinder<S> {
    type View<'a> = ParallelView<S>;

    fn view(&self, rays: &Parallel<S>) -> ParallelView<S> {
        let axis = self.caps.normal.vector();
        let u = rays.center - self.tube.base;
        let m = rays.forward.cross(axis);
        let moments = [u, rays.right, rays.down].map(|step| step.cross(axis));
        // An angle whose square vanishes moves no ray of a scene by a rounding error.
        let across = m.length_squared().is_normal().then(|| m.normalized()).flatten();
        let wall = if let Some(n) = across {
            let stretch = S::ONE / m.dot(n);
            Wall::Across {
                distance: [u, rays.right, rays.down].map(|step| step.dot_compensated(n)),
                middle: moments.map(|moment| -moment.dot_compensated(n) * stretch),
                stretch,
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
pub struct ParallelView<S> {
    wall: Wall<S>,
    radius: S,
    caps: slab::ParallelView<S>,
    ball: ParallelBall<S>,
    columns: u32,
}

/// The wall: values in the middle of the picture, and their steps to the right and down.
#[derive(Debug, Clone, Copy)]
enum Wall<S> {
    Across {
        /// κ.
        distance: [S; 3],
        middle: [S; 3],
        stretch: S,
    },
    /// The camera looks along the axis: the vector from the axis to the ray, turned by 90°.
    Along { moments: [Vec3<S>; 3] },
}

impl<S: Scalar> View for ParallelView<S> {
    type Scalar = S;
    type Row<'a> = Leaf<ParallelRow<S>>;

    fn row(&self, y: S) -> Self::Row<'_> {
        let Self { radius, .. } = *self;
        let round = Quadratic::zero(radius).plus_square(S::ONE, radius, S::ZERO);
        let (wall, silhouette) = match self.wall {
            Wall::Across { distance, middle, stretch } => {
                let in_row = |[middle, right, down]: [S; 3]| [middle + down * y, right];
                let distance = in_row(distance);
                (
                    WallRow::Across { distance, middle: in_row(middle), stretch },
                    round.plus_square(-S::ONE, distance[0], distance[1]),
                )
            }
            Wall::Along { moments: [middle, right, down] } => {
                let moments = [middle + down * y, right];
                (WallRow::Along { moments }, round.plus_length(-S::ONE, moments[0], moments[1]))
            }
        };
        Leaf {
            row: ParallelRow { wall, radius_squared: radius * radius, caps: self.caps.slab_row(y) },
            extent: silhouette.extent(self.columns).overlap(self.ball.extent(y)),
        }
    }
}

/// A row of a cylinder, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct ParallelRow<S> {
    wall: WallRow<S>,
    radius_squared: S,
    caps: slab::ParallelRow<S>,
}

#[derive(Debug, Clone, Copy)]
enum WallRow<S> {
    Across { distance: [S; 2], middle: [S; 2], stretch: S },
    Along { moments: [Vec3<S>; 2] },
}

impl<S: Scalar> ConvexRow for ParallelRow<S> {
    type Scalar = S;
    const FACES: u16 = 3;

    #[inline]
    fn span(&self, x: S) -> Option<Span<S>> {
        let within_wall = match &self.wall {
            WallRow::Across { distance, middle, stretch } => {
                let distance = distance[0] + distance[1] * x;
                let discriminant = (self.radius_squared - distance * distance).positive()?;
                wall_span(middle[0] + middle[1] * x, discriminant.sqrt() * *stretch)?
            }
            WallRow::Along { moments: [middle, step] } => {
                let distance_squared = (*middle + *step * x).length_squared();
                (self.radius_squared - distance_squared).positive()?;
                Span::whole_line(WALL)
            }
        };
        self.caps.span(x)?.overlap(within_wall)
    }
}
