//! The cylinder, seen from an eye.
//!
//! In a row, q = u × axis and m = d × axis are affine in the column, and so is k = u·m, because
//! all rays run through the eye. Both vectors are at right angles to the axis, so two coordinates
//! hold each of them.

use super::{Cylinder, WALL, wall_span};
use crate::geom::{Pencil, Vec3};
use crate::scalar::Scalar;
use crate::solid::row::{ConvexRow, Leaf, Project, View};
use crate::solid::silhouette::{PencilBall, Quadratic};
use crate::solid::slab;
use crate::span::Span;

impl<S: Scalar> Project<Pencil<S>> for Cylinder<S> {
    type View<'a> = PencilView<S>;

    fn view(&self, rays: &Pencil<S>) -> PencilView<S> {
        let axis = self.caps.normal.vector();
        let plane = &rays.plane;
        let convergence = rays.convergence;
        let u = plane.center - self.tube.base;
        let across = frame(axis);
        let flat = |moment: Vec3<S>| across.map(|side| side.dot(moment));
        let m = plane.forward.cross(axis);
        let [right, down] = [plane.right, plane.down].map(|step| {
            let moment = step.cross(axis);
            let k = step.dot_compensated(m) + convergence * u.dot_compensated(moment);
            (flat(moment), k)
        });
        let at_eye = u.cross(axis) - m * rays.distance;
        let (center, ball_radius) = self.bounding_ball();
        PencilView {
            moment: [flat(u.cross(axis)), right.0, down.0],
            turn: flat(m),
            reach: [u.dot_compensated(m), right.1, down.1],
            convergence,
            radius: self.tube.radius,
            eye_within: at_eye.length_squared() < self.tube.radius * self.tube.radius,
            caps: self.caps.view(rays),
            ball: PencilBall::new(center, ball_radius, rays),
            columns: plane.columns,
        }
    }
}

/// Two unit vectors that make a right-handed frame with `n`, a vector of length 1.
///
/// Duff et al., *Building an orthonormal basis, revisited*, Journal of Computer Graphics
/// Techniques 6 (2017), listing 3. Exact for coordinate axes.
fn frame<S: Scalar>(n: Vec3<S>) -> [Vec3<S>; 2] {
    let sign = if n.z < S::ZERO { -S::ONE } else { S::ONE };
    let a = -(S::ONE / (sign + n.z));
    let b = n.x * n.y * a;
    [
        Vec3::new(S::ONE + sign * n.x * n.x * a, sign * b, -sign * n.x),
        Vec3::new(b, sign + n.y * n.y * a, -n.y),
    ]
}

/// A cylinder, seen from an eye: values in the middle of the picture and their steps.
#[derive(Debug, Clone, Copy)]
pub struct PencilView<S> {
    /// q.
    moment: [[S; 2]; 3],
    /// m in the middle; its steps are those of q times `convergence`.
    turn: [S; 2],
    /// k.
    reach: [S; 3],
    convergence: S,
    radius: S,
    /// Whether the eye lies inside the infinite cylinder, and with it any ray along the axis.
    eye_within: bool,
    caps: slab::PencilView<S>,
    ball: PencilBall<S>,
    columns: u32,
}

impl<S: Scalar> View for PencilView<S> {
    type Scalar = S;
    type Row<'a> = Leaf<PencilRow<S>>;

    fn row(&self, y: S) -> Self::Row<'_> {
        let [middle, right, down] = self.moment;
        let convergence = self.convergence;
        let axes = [0, 1].map(|i| {
            let offset = down[i] * y;
            Affine {
                moment: [middle[i] + offset, right[i]],
                turn: [self.turn[i] + convergence * offset, convergence * right[i]],
            }
        });
        let reach = [self.reach[0] + self.reach[2] * y, self.reach[1]];
        let radius_squared = self.radius * self.radius;
        let [one, other] = axes.map(|axis| axis.turn.map(|turn| turn * self.radius));
        let silhouette = Quadratic::zero(self.radius)
            .plus_square(S::ONE, one[0], one[1])
            .plus_square(S::ONE, other[0], other[1])
            .plus_square(-S::ONE, reach[0], reach[1]);
        Leaf {
            row: PencilRow {
                axes,
                reach,
                radius_squared,
                eye_within: self.eye_within,
                caps: self.caps.slab_row(y),
            },
            extent: silhouette.extent(self.columns).overlap(self.ball.extent(y)),
        }
    }
}

/// One coordinate of q and of m in a row: in its middle, and the step to the right.
#[derive(Debug, Clone, Copy)]
struct Affine<S> {
    moment: [S; 2],
    turn: [S; 2],
}

/// A row of a cylinder, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PencilRow<S> {
    axes: [Affine<S>; 2],
    reach: [S; 2],
    radius_squared: S,
    eye_within: bool,
    caps: slab::PencilRow<S>,
}

impl<S: Scalar> ConvexRow for PencilRow<S> {
    type Scalar = S;
    const FACES: u16 = 3;

    #[inline]
    fn span(&self, x: S) -> Option<Span<S>> {
        let [(q0, m0), (q1, m1)] = [&self.axes[0], &self.axes[1]]
            .map(|axis| (axis.moment[0] + axis.moment[1] * x, axis.turn[0] + axis.turn[1] * x));
        let a = m0 * m0 + m1 * m1;
        let within_wall = if a.is_normal() {
            let k = self.reach[0] + self.reach[1] * x;
            let discriminant = (self.radius_squared * a - k * k).positive()?;
            let inverse = S::ONE / a;
            wall_span(-(q0 * m0 + q1 * m1) * inverse, discriminant.sqrt() * inverse)?
        } else if self.eye_within {
            Span::whole_line(WALL)
        } else {
            return None;
        };
        self.caps.span(x)?.overlap(within_wall)
    }
}
